// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.python3;

import java.lang.reflect.Array;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Member;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Parameter;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Queries of the Python package about Java objects. Public because Python calls it. Any thread. */
public final class Members {
    private static final String METHOD = "method";
    private static final String VALUE = "value";

    private Members() {
    }

    /** Returns {@code method}, or {@code value} for a field or property; empty for an unknown name. */
    public static String kind(Object of, String name) {
        if (Arrays.stream(of.getClass().getMethods()).anyMatch(one -> one.getName().equals(name))) {
            return METHOD;
        }
        return field(of.getClass(), name) != null || getter(of.getClass(), name) != null ? VALUE : "";
    }

    /** Returns a field or property, see {@link #kind}. */
    public static Object value(Object of, String name) throws IllegalAccessException, InvocationTargetException {
        Field field = field(of.getClass(), name);
        return field != null ? field.get(of) : getter(of.getClass(), name).invoke(of);
    }

    /** @throws IllegalArgumentException if the field or property doesn't exist or is read-only */
    public static void assign(Object of, String name, Object value)
        throws IllegalAccessException, InvocationTargetException {
        Field field = field(of.getClass(), name);
        Method setter = Arrays.stream(of.getClass().getMethods())
            .filter(one -> one.getName().equals("set" + capital(name)) && one.getParameterCount() == 1).findFirst()
            .orElse(null);
        if (field != null && !Modifier.isFinal(field.getModifiers())) {
            field.set(of, value);
        } else if (setter != null) {
            setter.invoke(of, value);
        } else {
            throw new IllegalArgumentException(name + " of " + of.getClass().getSimpleName() + " can't be assigned");
        }
    }

    private static Field field(Class<?> type, String name) {
        return Arrays.stream(type.getFields()).filter(one -> one.getName().equals(name)).findFirst().orElse(null);
    }

    private static Method getter(Class<?> type, String name) {
        return Arrays.stream(type.getMethods()).filter(one -> one.getParameterCount() == 0
            && (one.getName().equals("get" + capital(name)) || one.getName().equals("is" + capital(name)))).findFirst()
            .orElse(null);
    }

    private static String capital(String name) {
        return name.isEmpty() ? name : name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1);
    }

    /** Returns the names of all public methods and fields except those of Object, sorted. */
    public static List<String> names(Class<?> type) {
        return Stream.concat(Arrays.stream(type.getMethods()).filter(one -> one.getDeclaringClass() != Object.class)
            .map(Method::getName),
            Arrays.stream(type.getFields()).map(Field::getName)).distinct().sorted().collect(Collectors.toList());
    }

    /** Returns the names of the public methods and fields that the class itself declares, sorted. */
    public static List<String> ownNames(Class<?> type) {
        return Stream.of(type.getDeclaredMethods(), type.getDeclaredFields()).flatMap(Arrays::stream)
            .filter(one -> Modifier.isPublic(one.getModifiers()) && !one.isSynthetic()).map(Member::getName)
            .distinct().sorted().collect(Collectors.toList());
    }

    /** Returns a class by its full name; null if there is none. */
    public static Class<?> find(String className) {
        try {
            return Class.forName(className, false, Members.class.getClassLoader());
        } catch (ClassNotFoundException | LinkageError e) {
            return null;
        }
    }

    /** Returns the full name of a class, or of an object's class. */
    public static String typeName(Object of) {
        return of instanceof Class ? ((Class<?>) of).getName() : className(of);
    }

    /** Returns the signatures of a method, such as {@code drive(speed: float, radius: float)}, shortest first. */
    public static List<String> methods(Class<?> type, String name) {
        return calls(Arrays.stream(type.getMethods()).filter(one -> one.getName().equals(name)), name);
    }

    /** Returns the signatures of the constructors. */
    public static List<String> constructors(Class<?> type) {
        return calls(Arrays.stream(type.getConstructors()), type.getSimpleName());
    }

    private static List<String> calls(Stream<? extends Executable> all, String name) {
        return all.map(one -> name + Arrays.stream(one.getParameters()).map(Members::described)
            .collect(Collectors.joining(", ", "(", ")")))
            .distinct().sorted((a, b) -> a.length() != b.length() ? a.length() - b.length() : a.compareTo(b))
            .collect(Collectors.toList());
    }

    private static String described(Parameter parameter) {
        return (parameter.isNamePresent() ? documented(parameter.getName()) + ": " : "") + python(parameter.getType());
    }

    /** Returns the name of a parameter as in the docs: mass for newMass. */
    private static String documented(String name) {
        String plain = name.replaceAll("^new(?=[A-Z])", "");
        return plain.length() > 1 && Character.isUpperCase(plain.charAt(1)) ? plain
            : plain.substring(0, 1).toLowerCase(Locale.ROOT) + plain.substring(1);
    }

    /** Returns Python's name of a type. */
    private static String python(Class<?> type) {
        if (type == double.class || type == float.class) {
            return "float";
        } else if (type == int.class || type == long.class || type == short.class || type == byte.class) {
            return "int";
        } else if (type == boolean.class) {
            return "bool";
        }
        return type == String.class ? "str" : type.isArray() || List.class.isAssignableFrom(type) ? "list"
            : type.getSimpleName();
    }

    /** Returns the simple names of a class and its superclasses, nearest first. */
    public static List<String> lineage(Object of) {
        List<String> names = new ArrayList<>();
        for (Class<?> type = of.getClass(); type != null; type = type.getSuperclass()) {
            names.add(type.getSimpleName());
        }
        return names;
    }

    /** Returns the full class name of an object. */
    public static String className(Object of) {
        return of.getClass().getName();
    }

    /** Returns numpy's type of an array of numbers or booleans, such as {@code <f4}; null for any other object. */
    public static String numberType(Object array) {
        switch (String.valueOf(array.getClass().getComponentType())) {
            case "float":
                return "<f4";
            case "double":
                return "<f8";
            case "int":
                return "<i4";
            case "long":
                return "<i8";
            case "short":
                return "<i2";
            case "boolean":
                return "|b1";
            default:
                return null;
        }
    }

    /** Returns an array of numbers or booleans as bytes for numpy, low byte first. */
    public static byte[] bytes(Object array) {
        int length = Array.getLength(array);
        ByteBuffer out = ByteBuffer.allocate(length * Double.BYTES).order(ByteOrder.LITTLE_ENDIAN);
        if (array instanceof float[]) {
            out.asFloatBuffer().put((float[]) array);
            return Arrays.copyOf(out.array(), length * Float.BYTES);
        } else if (array instanceof double[]) {
            out.asDoubleBuffer().put((double[]) array);
            return out.array();
        } else if (array instanceof int[]) {
            out.asIntBuffer().put((int[]) array);
            return Arrays.copyOf(out.array(), length * Integer.BYTES);
        } else if (array instanceof long[]) {
            out.asLongBuffer().put((long[]) array);
            return out.array();
        } else if (array instanceof short[]) {
            out.asShortBuffer().put((short[]) array);
            return Arrays.copyOf(out.array(), length * Short.BYTES);
        }
        for (int i = 0; i < length; i++) {
            out.put(i, (byte) (Array.getBoolean(array, i) ? 1 : 0));
        }
        return Arrays.copyOf(out.array(), length);
    }
}
