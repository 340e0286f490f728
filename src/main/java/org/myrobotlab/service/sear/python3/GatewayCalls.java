// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.python3;

import java.lang.reflect.Array;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * Calls through the gateway. Selects the method that fits the arguments best. Accepts whole numbers for other number
 * types and lists for arrays, and returns arrays of numbers as bytes. Public because Python calls it. Any thread.
 */
public final class GatewayCalls {
    /** Prefix of bytes that encode an array of numbers; the three letters of numpy's type follow. */
    private static final byte[] NUMBERS = "\0numpy".getBytes(StandardCharsets.US_ASCII);
    private static final int NO = 1000;

    private GatewayCalls() {
    }

    /**
     * Calls a method.
     *
     * @throws NoSuchMethodException if none fits
     * @throws Throwable the method's exception
     */
    public static Object call(Object of, String name, List<?> arguments) throws Throwable {
        Method method = best(Arrays.stream(of.getClass().getMethods())
            .filter(one -> one.getName().equals(name)), arguments);
        return invoke(method, of, arguments);
    }

    /** Calls a static method. */
    public static Object callStatic(String className, String name, List<?> arguments) throws Throwable {
        Method method = best(Arrays.stream(Class.forName(className).getMethods())
            .filter(one -> one.getName().equals(name) && Modifier.isStatic(one.getModifiers())), arguments);
        return invoke(method, null, arguments);
    }

    private static Object invoke(Method method, Object of, List<?> arguments) throws Throwable {
        method.trySetAccessible();    // the class may not be public, as for Java's own lists
        try {
            return packed(method.invoke(of, converted(method, arguments)));
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    /** Creates an object of a class. */
    public static Object create(String className, List<?> arguments) throws Throwable {
        Constructor<?> maker = best(Arrays.stream(Class.forName(className).getConstructors()), arguments);
        try {
            return maker.newInstance(converted(maker, arguments));
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }

    private static <T extends Executable> T best(Stream<T> all, List<?> arguments) throws NoSuchMethodException {
        T best = null;
        int least = NO;
        for (T one : (Iterable<T>) all::iterator) {
            int distance = distance(one.getParameterTypes(), arguments);
            if (distance < least) {
                least = distance;
                best = one;
            }
        }
        if (best == null) {
            throw new NoSuchMethodException();
        }
        return best;
    }

    private static int distance(Class<?>[] types, List<?> arguments) {
        if (types.length != arguments.size()) {
            return NO;
        }
        int sum = 0;
        for (int i = 0; i < types.length; i++) {
            sum += distance(types[i], arguments.get(i));
        }
        return sum;
    }

    private static int distance(Class<?> type, Object value) {
        if (value == null) {
            return type.isPrimitive() ? NO : 0;
        } else if (type.isPrimitive() || Number.class.isAssignableFrom(type)) {
            return numberDistance(type, value);
        } else if (type.isInstance(value)) {
            return type == Object.class ? 3 : type == value.getClass() ? 0 : 1;
        }
        return type.isArray() && value instanceof List && ((List<?>) value).stream()
            .allMatch(one -> distance(type.getComponentType(), one) < NO) ? 2 : NO;
    }

    private static int numberDistance(Class<?> type, Object value) {
        if (type == boolean.class || value instanceof Boolean) {
            return type == boolean.class && value instanceof Boolean ? 0 : NO;
        } else if (value instanceof Double || value instanceof Float) {
            return type == double.class || type == Double.class ? 0 : type == float.class
                || type == Float.class ? 1 : NO;
        } else if (value instanceof Number) {
            return type == int.class || type == Integer.class ? 0 : type == long.class || type == Long.class ? 1
                : type == char.class ? NO : 2;
        }
        return NO;
    }

    private static Object[] converted(Executable call, List<?> arguments) {
        Class<?>[] types = call.getParameterTypes();
        Object[] converted = new Object[types.length];
        for (int i = 0; i < types.length; i++) {
            converted[i] = converted(types[i], arguments.get(i));
        }
        return converted;
    }

    private static Object converted(Class<?> type, Object value) {
        if (value instanceof Number && (type.isPrimitive() || Number.class.isAssignableFrom(type))) {
            return number(type, (Number) value);
        } else if (type.isArray() && value instanceof List) {
            List<?> list = (List<?>) value;
            Object array = Array.newInstance(type.getComponentType(), list.size());
            for (int i = 0; i < list.size(); i++) {
                Array.set(array, i, converted(type.getComponentType(), list.get(i)));
            }
            return array;
        }
        return value;
    }

    private static Number number(Class<?> type, Number value) {
        if (type == double.class || type == Double.class) {
            return value.doubleValue();
        } else if (type == float.class || type == Float.class) {
            return value.floatValue();
        } else if (type == long.class || type == Long.class) {
            return value.longValue();
        } else if (type == int.class || type == Integer.class) {
            long whole = value.longValue();    // Python in Java's process passes each whole number as a long
            if (whole != (int) whole) {
                throw new IllegalArgumentException("a value is " + whole + ", legal: whole numbers from "
                    + Integer.MIN_VALUE + " to " + Integer.MAX_VALUE);
            }
            return (int) whole;
        } else if (type == short.class || type == Short.class) {
            return value.shortValue();
        } else if (type == byte.class || type == Byte.class) {
            return value.byteValue();
        }
        return value;
    }

    /** Returns an array of numbers as bytes, any other answer unchanged. */
    private static Object packed(Object answer) {
        String type = answer == null || !answer.getClass().isArray() ? null : Members.numberType(answer);
        if (type == null) {
            return answer;
        }
        byte[] numbers = Members.bytes(answer);
        byte[] packed = Arrays.copyOf(NUMBERS, NUMBERS.length + type.length() + numbers.length);
        System.arraycopy(type.getBytes(StandardCharsets.US_ASCII), 0, packed, NUMBERS.length, type.length());
        System.arraycopy(numbers, 0, packed, NUMBERS.length + type.length(), numbers.length);
        return packed;
    }
}
