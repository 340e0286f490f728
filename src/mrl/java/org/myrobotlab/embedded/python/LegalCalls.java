// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.lang.reflect.Executable;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.Parameter;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Lists the legal calls of a Java constructor or method after a call with wrong arguments. Any thread. */
final class LegalCalls {
    private static final Pattern REFUSED = Pattern.compile("^([\\w.$]+)\\(\\): (?:expected .* args?; got (\\d+)"
        + "|(\\d+)\\w\\w arg can't be coerced to (.+))$");
    private static final int MOST = 12;
    private static final Map<String, String> WORDS = words();

    private LegalCalls() {
    }

    private static Map<String, String> words() {
        Map<String, String> words = new LinkedHashMap<>();
        words.put("double", "a number, without quotation marks");
        words.put("float", words.get("double"));
        words.put("int", "a whole number from " + Integer.MIN_VALUE + " to " + Integer.MAX_VALUE + ", without quotation marks");
        words.put("long", "a whole number, without quotation marks");
        words.put("String", "a string in quotation marks");
        words.put("boolean", "True or False");
        return words;
    }

    /**
     * Lists the legal calls for Jython's error about arguments that don't fit.
     *
     * @param line the script's line; may be empty
     * @return lines to append to the error; empty for another error
     */
    static String lines(String message, String line, Scope scope) {
        Matcher refused = REFUSED.matcher(message);
        if (!refused.find()) {
            return "";
        }
        String name = refused.group(1);
        Map<Executable, String> calls = name.contains(".") ? constructors(name) : methods(name, line, scope);
        if (calls.isEmpty()) {
            return "";
        }
        String simple = name.substring(name.lastIndexOf('.') + 1);
        return hint(refused, simple, line, new GivenValues(simple, line, scope), calls) + "\nlegal: "
            + sorted(calls).stream().limit(MOST).collect(Collectors.joining("\n       "));
    }

    private static String hint(Matcher refused, String name, String line, GivenValues values, Map<Executable, String> calls) {
        Set<String> meant = new TreeSet<>();
        calls.forEach((call, written) -> Stream.ofNullable(values.inOrderOf(call, written)).forEach(meant::add));
        if (!meant.isEmpty()) {
            return "\nthe arguments are in the wrong order: did you mean " + String.join(" or ", meant) + "?";
        }
        if (values.hasDecimalComma(line)) {
            return "\nwrite decimals with a point, as 0.5: a comma starts the next argument";
        }
        if (refused.group(3) != null) {
            String wrong = values.wrong(Integer.parseInt(refused.group(3)), refused.group(4));
            return wrong.isEmpty() ? "\nargument " + refused.group(3) + " must be " + word(refused.group(4)) : "\n" + wrong;
        }
        return line.matches(".*\\b" + Pattern.quote(name) + "\\(.*\\b\\w+\\s*=[^=].*")
            ? "\narguments have no names: write only their values, in this order" : "";
    }

    private static String word(String types) {
        return Arrays.stream(types.split(", ")).map(type -> WORDS.getOrDefault(type, "a " + type.substring(type.lastIndexOf('.') + 1))).distinct()
            .collect(Collectors.joining(", or "));
    }

    /** Returns the text before the brackets, by constructor. */
    private static Map<Executable, String> constructors(String type) {
        try {
            Class<?> made = Class.forName(type);
            return named(Arrays.stream(made.getConstructors()).filter(maker -> maker.getParameterCount() > 0), made.getSimpleName());
        } catch (ClassNotFoundException | LinkageError e) {
            return Map.of();
        }
    }

    /**
     * Returns the text before the brackets, by method: of the objects that the line names, else of all objects of the
     * script.
     */
    private static Map<Executable, String> methods(String name, String line, Scope scope) {
        Matcher called = Pattern.compile("(\\w+)\\." + Pattern.quote(name) + "\\(").matcher(line);
        Set<String> owners = new TreeSet<>();
        while (called.find()) {
            owners.add(called.group(1));
        }
        owners.retainAll(scope.names());
        Map<Executable, String> calls = new LinkedHashMap<>();
        for (String owner : owners.isEmpty() ? scope.names() : owners) {
            Class<?> type = scope.typeOf(owner);
            if (type != null) {
                calls.putAll(named(Arrays.stream(type.getMethods()).filter(method -> method.getName().equals(name)), owner + "." + name));
            }
        }
        return calls;
    }

    private static Map<Executable, String> named(Stream<? extends Executable> all, String name) {
        return all.filter(one -> Modifier.isPublic(one.getModifiers()) && !(one instanceof Method && ((Method) one).isBridge()))
            .collect(Collectors.toMap(one -> one, one -> name));
    }

    private static Set<String> sorted(Map<Executable, String> calls) {
        return calls.entrySet().stream().map(one -> one.getValue() + Arrays.stream(one.getKey().getParameters()).map(LegalCalls::nameOf)
            .collect(Collectors.joining(", ", "(", ")"))).sorted(Comparator.comparing(String::length).thenComparing(Comparator.naturalOrder()))
            .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    /** Returns the parameter's name as in the docs: mass for newMass. */
    private static String nameOf(Parameter parameter) {
        String name = parameter.getName().replaceAll("^new([A-Z])", "$1");
        return name.length() > 1 && Character.isUpperCase(name.charAt(1)) ? name : Character.toLowerCase(name.charAt(0)) + name.substring(1);
    }
}
