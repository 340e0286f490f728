// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.script;

import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.SEAR.grammar.Parameter;

/** Python 2.7 literals in ASCII, escaped so that no text of a project can become code. Any thread. */
final class PythonText {
    private static final Set<String> TAKEN = Set.of("and", "as", "assert", "break", "class", "continue", "def", "del",
        "elif", "else", "except", "exec", "finally", "for", "from", "global", "if", "import", "in",
        "is", "lambda", "not", "or", "pass", "print", "raise", "return", "try", "while",
        "with", "yield", "none", "true", "false", "sear", "python", "runtime", "java", "javax", "org", "com",
            "sys", "sleep");
    private static final int ASCII = 0x7f;
    private static final double EXACT = 1e9;
    private static final int LONGEST_VARIABLE = 40;

    private PythonText() {
    }

    /** Returns the literal of a text, number, truth value, None, list or dictionary; numbers as in files. */
    static String literal(Object value) {
        if (value == null) {
            return "None";
        }
        if (value instanceof Boolean) {
            return (Boolean) value ? "True" : "False";
        }
        if (value instanceof Double) {
            return number((Double) value);
        }
        if (value instanceof Collection) {
            return ((Collection<?>) value).stream().map(PythonText::literal)
                .collect(Collectors.joining(", ", "[", "]"));
        }
        if (value instanceof Map) {
            return ((Map<?, ?>) value).entrySet().stream().map(e -> literal(e.getKey()) + ": " + literal(e.getValue()))
                .collect(Collectors.joining(", ", "{", "}"));
        }
        return value instanceof Integer ? value.toString() : text(value.toString());
    }

    /** Returns plain digits if Python reads them as a small whole number or a fraction, otherwise an exponent. */
    private static String number(double value) {
        return value == Math.rint(value) && Math.abs(value) >= EXACT ? Double.toString(value) : Parameter.format(value);
    }

    private static String text(String value) {
        StringBuilder out = new StringBuilder();
        boolean plain = true;
        for (int i = 0; i < value.length(); i++) {
            char c = value.charAt(i);
            plain &= c < ASCII;
            if (c == '"' || c == '\\') {
                out.append('\\').append(c);
            } else if (c >= ' ' && c < ASCII) {
                out.append(c);
            } else if (Character.isHighSurrogate(c) && i + 1 < value.length()
                && Character.isLowSurrogate(value.charAt(i + 1))) {
                out.append(String.format(Locale.ROOT, "\\U%08x", value.codePointAt(i++)));
            } else {
                out.append(c < ' ' ? String.format(Locale.ROOT, "\\x%02x", (int) c)
                    : String.format(Locale.ROOT, "\\u%04x", (int) c));
            }
        }
        return (plain ? "\"" : "u\"") + out + '"';
    }

    /** Unique variable names that avoid names with another meaning. */
    static final class Variables {
        private final Set<String> given = new HashSet<>();

        Variables(Collection<String> imported) {
            given.addAll(imported);
        }

        /** Returns a free name similar to the object's name. */
        String of(String name, String type) {
            String letters = name.replaceAll("[^A-Za-z0-9]+", "_").replaceAll("^_+|_+$", "");
            String start = letters.isEmpty() ? decapitalised(type) : letters;
            start = Character.isDigit(start.charAt(0)) ? decapitalised(type) + start : decapitalised(start);
            start = start.substring(0, Math.min(start.length(), LONGEST_VARIABLE));
            String variable = start;
            for (int i = 2; TAKEN.contains(variable.toLowerCase(Locale.ROOT)) || !given.add(variable); i++) {
                variable = start + "_" + i;
            }
            return variable;
        }

        private static String decapitalised(String text) {
            boolean acronym = text.length() > 1 && Character.isUpperCase(text.charAt(1));
            return acronym ? text.toLowerCase(Locale.ROOT) : Character.toLowerCase(text.charAt(0)) + text.substring(1);
        }
    }

    /** Returns the import statements. */
    static List<String> imports(Map<String, ? extends Collection<String>> classesByPackage) {
        return classesByPackage.entrySet().stream()
            .map(e -> "from " + e.getKey() + " import " + e.getValue().stream().sorted()
            .collect(Collectors.joining(", "))).collect(Collectors.toList());
    }
}
