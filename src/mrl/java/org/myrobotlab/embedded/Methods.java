// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Finds the public method that fits a name and arguments, and calls it. Any thread. */
public final class Methods {
    private static final Map<String, Method> FOUND = new ConcurrentHashMap<>();
    private static final Map<Class<?>, Class<?>> BOXES = Map.of(boolean.class, Boolean.class, byte.class, Byte.class,
        char.class, Character.class,
        short.class, Short.class, int.class, Integer.class, long.class, Long.class, float.class, Float.class,
            double.class, Double.class);
    private static final int UNFIT = -1;
    private static final int EXACT = 4;
    private static final int ASSIGNABLE = 3;
    private static final int WIDER = 2;
    private static final int ANYTHING = 1;
    private static final Class<?>[] WIDTHS = {Byte.class, Short.class, Integer.class, Long.class, Float.class,
        Double.class};

    private Methods() {
    }

    /** Returns the best fitting method; null if none fits. */
    public static Method find(Class<?> type, String name, Object... args) {
        StringBuilder key = new StringBuilder(type.getName()).append('.').append(name);
        for (Object arg : args) {
            key.append(',').append(arg == null ? "null" : arg.getClass().getName());
        }
        return FOUND.computeIfAbsent(key.toString(), unused -> search(type, name, args));
    }

    private static Method search(Class<?> type, String name, Object... args) {
        Method best = null;
        int bestFit = UNFIT;
        for (Method method : type.getMethods()) {
            if (!method.getName().equals(name) || method.getParameterCount() != args.length || method.isBridge()) {
                continue;
            }
            int fit = fit(method.getParameterTypes(), args);
            if (fit > bestFit || fit == bestFit && fit != UNFIT && isCloser(method, best)) {
                best = method;
                bestFit = fit;
            }
        }
        if (best != null && !Modifier.isPublic(best.getDeclaringClass().getModifiers())) {
            best.setAccessible(true);
        }
        return best;
    }

    private static boolean isCloser(Method method, Method than) {
        return method.getDeclaringClass() != than.getDeclaringClass() && than.getDeclaringClass()
            .isAssignableFrom(method.getDeclaringClass()) || method.toString().compareTo(than.toString()) < 0
            && method.getDeclaringClass() == than.getDeclaringClass();
    }

    private static int fit(Class<?>[] types, Object... args) {
        int sum = 0;
        for (int i = 0; i < types.length; i++) {
            int one = fit(types[i], args[i]);
            if (one == UNFIT) {
                return UNFIT;
            }
            sum += one;
        }
        return sum;
    }

    private static int fit(Class<?> type, Object arg) {
        Class<?> boxed = BOXES.getOrDefault(type, type);
        if (arg == null) {
            return type.isPrimitive() ? UNFIT : ANYTHING;
        }
        if (boxed == arg.getClass()) {
            return EXACT;
        }
        if (boxed.isInstance(arg)) {
            return boxed == Object.class ? ANYTHING : ASSIGNABLE;
        }
        int from = Arrays.asList(WIDTHS).indexOf(arg.getClass());
        return from >= 0 && Arrays.asList(WIDTHS).indexOf(boxed) > from ? WIDER : UNFIT;
    }

    /**
     * Calls a method with arguments for which {@link #find} has found it.
     *
     * @throws InvocationTargetException wraps the exception that the method threw
     */
    public static Object call(Object target, Method method, Object... args) throws InvocationTargetException {
        Class<?>[] types = method.getParameterTypes();
        Object[] converted = new Object[types.length];
        for (int i = 0; i < types.length; i++) {
            converted[i] = widen(types[i], args[i]);
        }
        try {
            return method.invoke(target, converted);
        } catch (IllegalAccessException e) {
            throw new IllegalStateException(method + " can't be reached", e);
        } catch (InvocationTargetException e) {
            OutOfMemory.report(e.getCause());
            throw e;
        }
    }

    private static Object widen(Class<?> type, Object arg) {
        Class<?> boxed = BOXES.getOrDefault(type, type);
        if (boxed.isInstance(arg) || !(arg instanceof Number)) {
            return arg;
        }
        Number number = (Number) arg;
        if (boxed == Double.class) {
            return number.doubleValue();
        }
        if (boxed == Float.class) {
            return number.floatValue();
        }
        if (boxed == Long.class) {
            return number.longValue();
        }
        if (boxed == Integer.class) {
            return number.intValue();
        }
        return boxed == Short.class ? (Object) number.shortValue() : number;
    }
}
