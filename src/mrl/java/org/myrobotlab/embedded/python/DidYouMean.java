// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.myrobotlab.embedded.NearestName;
import org.python.core.PyFunction;
import org.python.core.PyObject;

/** Suggestions for unknown names. Any thread that runs Python. */
public final class DidYouMean {
    private static final Pattern NO_NAME = Pattern.compile("name '(\\w+)' is not defined");
    private static final Pattern NO_ATTRIBUTE = Pattern.compile("'([\\w.$]+)'(?: object)? has no attribute '(\\w+)'");
    private static final String OBJECTS = "org.SEAR.POJOs.";
    private static final String SEAR = "org.myrobotlab.service.SEAR";
    private static final String SERVICES = "org.myrobotlab.service";

    private DidYouMean() {
    }

    /** Returns a hint line for an undefined name; else empty. */
    static String name(String message, Scope scope) {
        Matcher name = NO_NAME.matcher(message);
        if (!name.find()) {
            return "";
        }
        String wanted = name.group(1);
        if (wanted.equals("exit") || wanted.equals("quit")) {
            return "\na script ends after its last line; sys.exit() ends it earlier";
        }
        String module = WrongNames.ofPython(wanted);
        if (!module.isEmpty()) {
            return module;
        }
        String service = serviceOf(wanted, scope);
        if (!service.isEmpty()) {
            return service;
        }
        String imported = WrongNames.used(wanted);
        String called = imported.isEmpty() ? methodOf(wanted, scope) : imported;
        return called.isEmpty() ? line(NearestName.of(wanted, scope.names())) : called;
    }

    /** Returns a hint line for a missing member of a Java object; else empty. */
    static String member(String message, Scope scope) {
        Matcher attribute = NO_ATTRIBUTE.matcher(message);
        if (!attribute.find()) {
            return "";
        }
        try {
            String called = attribute.group(1).startsWith(OBJECTS) ? callOf(attribute.group(2), attribute.group(1), scope) : "";
            return called.isEmpty() ? line(NearestName.member(attribute.group(2), Class.forName(attribute.group(1)))) : called;
        } catch (ClassNotFoundException e) {
            return ""; // a class that the script defines
        }
    }

    /** Suggests the script's variable for a service that is written by its type, as robot for sear. */
    private static String serviceOf(String wanted, Scope scope) {
        String found = "";
        for (String one : scope.names()) {
            Class<?> type = scope.objectTypeOf(one);
            boolean isType = type != null && type.getPackageName().equals(SERVICES) && type.getSimpleName().equalsIgnoreCase(wanted);
            boolean isVariable = isType && !scope.valueOf(one).invoke("getName").toString().equals(one);
            found = isType && (found.isEmpty() || isVariable) ? one : found;
        }
        return found.isEmpty() || wanted.equals(wanted.toUpperCase(Locale.ROOT)) ? ""
            : "\ndid you mean " + found + ", this script's name for its service " + scope.objectTypeOf(found).getSimpleName() + "?";
    }

    /**
     * Suggests the service's call for a call of an object: sear.drive("rover", ...) for rover.drive(...), or a reading
     * for ping.getDistance().
     */
    private static String callOf(String wanted, String type, Scope scope) throws ClassNotFoundException {
        Class<?> service = Class.forName(SEAR);
        String simple = type.substring(type.lastIndexOf('.') + 1);
        String owner = scope.names().stream().filter(one -> service.equals(scope.objectTypeOf(one))).reduce((one, other) ->
            other.equals("sear") ? other : one).orElse("");
        String call = wanted.equals("get" + simple) || wanted.equals("read") || wanted.equals("getValue") ? "get" + simple + "Result" : wanted;
        if (Arrays.stream(service.getMethods()).noneMatch(method -> method.getName().equals(call))
            || Arrays.stream(service.getSuperclass().getMethods()).anyMatch(method -> method.getName().equals(call))) {
            return "";
        }
        return owner.isEmpty() ? "\n" + call + " is a method of the service SEAR, but the object before the dot is a " + simple
            : "\n" + call + " is a method of the service and takes the name: did you mean " + owner + "." + call + "(...)?";
    }

    private static String line(String question) {
        return question.isEmpty() ? "" : "\n" + question;
    }

    /** Returns "; did you mean onScan?" for a missing function of the script; empty without a similar one. */
    static String function(String wanted, PyObject variables) {
        Set<String> functions = new TreeSet<>();
        for (PyObject name : variables.invoke("keys").asIterable()) {
            if (variables.__finditem__(name) instanceof PyFunction) {
                functions.add(name.toString());
            }
        }
        String question = NearestName.of(wanted, functions);
        return question.isEmpty() ? "" : "; " + question;
    }

    /** Suggests the object of a method that was called without one: sear.simSleep(1) for simSleep(1). */
    private static String methodOf(String wanted, Scope scope) {
        for (String owner : scope.names()) {
            Class<?> type = scope.objectTypeOf(owner);
            if (type == null || !type.getName().matches("org\\.(SEAR|myrobotlab)\\..*")) {
                continue;
            }
            for (Method method : type.getMethods()) {
                if (method.getName().equalsIgnoreCase(wanted)) {
                    return "\ndid you mean " + owner + "." + method.getName() + "?";
                }
            }
        }
        return "";
    }
}
