package org.myrobotlab.embedded.web;

import java.lang.reflect.Method;
import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.List;
import org.myrobotlab.embedded.Json;
import org.myrobotlab.embedded.Methods;

/** Finds what a call with arguments from JSON means in Java. */
final class JsonCall {
    /** Characters of the arguments, and as many of the reason, in a message. */
    private static final int LONGEST = 500;

    private JsonCall() {
    }

    /**
     * The arguments as a method of that name takes them.
     *
     * @throws IllegalArgumentException if there is no such method
     */
    static Object[] arguments(Class<?> type, String method, List<?> json) {
        Object[] plain = json.toArray();
        if (Methods.find(type, method, plain) != null) {
            return plain;
        }
        String reason = "";
        for (Method one : type.getMethods()) {
            if (one.getName().equals(method) && one.getParameterCount() == plain.length && !one.isBridge()) {
                try {
                    return converted(one.getGenericParameterTypes(), plain);
                } catch (IllegalArgumentException e) {
                    reason = ": " + shortened(e.getMessage().split("\n")[0]);
                }
            }
        }
        throw new IllegalArgumentException(type.getSimpleName() + " has no method " + method + " for the arguments "
            + shortened(Json.write(json)) + reason);
    }

    private static String shortened(String text) {
        return text.length() <= LONGEST ? text : text.substring(0, LONGEST) + "...";
    }

    private static Object[] converted(Type[] types, Object... plain) {
        Object[] converted = Arrays.copyOf(plain, plain.length);
        for (int i = 0; i < types.length; i++) {
            if (plain[i] == null && types[i] instanceof Class && ((Class<?>) types[i]).isPrimitive()) {    // what JavaScript makes of NaN, not 0
                throw new IllegalArgumentException("argument " + (i + 1) + " is null, legal: a value of type " + types[i].getTypeName());
            }
            converted[i] = Json.convert(plain[i], types[i]);
        }
        return converted;
    }
}
