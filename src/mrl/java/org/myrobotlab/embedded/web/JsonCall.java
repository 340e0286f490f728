// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import java.lang.reflect.Method;
import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.List;
import org.myrobotlab.embedded.Json;
import org.myrobotlab.embedded.Methods;

/** Converts the arguments of a JSON call to Java. */
final class JsonCall {
    /** Limits of the arguments and of the reason in a message, in characters. */
    private static final int LONGEST = 500;

    private JsonCall() {
    }

    /**
     * Returns the arguments in the types of a method of that name.
     *
     * @throws IllegalArgumentException if no method fits
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
            // JavaScript sends NaN as null; must not become 0
            if (plain[i] == null && types[i] instanceof Class && ((Class<?>) types[i]).isPrimitive()) {
                throw new IllegalArgumentException("argument " + (i + 1) + " is null, legal: a value of type "
                    + types[i].getTypeName());
            }
            converted[i] = Json.convert(plain[i], types[i]);
        }
        return converted;
    }
}
