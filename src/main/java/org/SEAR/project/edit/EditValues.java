// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.problems.ProblemList;

/**
 * Values of parameters from pages and scripts: a text (or number, or True and False) for a value, a map for a group, a
 * list for a list, null or an empty text for the default. Continues after a problem, so that all problems are reported.
 * One use.
 */
final class EditValues {
    private final String file;
    private final ProblemList problems;

    /** @param file its name in problems */
    EditValues(String file, ProblemList problems) {
        this.file = file;
        this.problems = problems;
    }

    /** Returns the values of an object or group by element, as texts like in its file; unset parameters are absent. */
    static Map<String, Object> of(Object object) {
        Map<String, Object> values = new LinkedHashMap<>();
        for (Parameter parameter : ParameterTable.of(object.getClass()).getParameters()) {
            Object value = valueOf(object, parameter);
            if (value != null) {
                values.put(parameter.getName(), value);
            }
        }
        return values;
    }

    private static Object valueOf(Object object, Parameter parameter) {
        List<Object> all = new ArrayList<>();
        parameter.values(object).forEach(
            value -> all.add(parameter.getKind() == Parameter.Kind.GROUP ? of(value) : Parameter.format(value)));
        return parameter.isList() ? all : all.isEmpty() ? null : all.get(0);
    }

    /**
     * Sets parameters of an object or group.
     *
     * @param path prefix of their names in problems
     */
    void set(Object object, Map<?, ?> values, String path) {
        ParameterTable table = ParameterTable.of(object.getClass());
        for (Map.Entry<?, ?> one : values.entrySet()) {
            String name = String.valueOf(one.getKey());
            Parameter parameter = table.find(name);
            if (parameter == null) {
                problems.add(file, 0, path + name, text(one.getValue()), "no such parameter, but "
                    + String.join(", ", table.names()));
            } else {
                set(object, table, parameter, one.getValue(), path + name);
            }
        }
    }

    private void set(Object object, ParameterTable table, Parameter parameter, Object wanted, String path) {
        if (isNone(wanted)) {
            if (parameter.isRequired()) {
                problems.add(file, 0, path, "", parameter.legal());
            } else {
                parameter.set(object, parameter.get(table.newInstance()));
            }
        } else if (parameter.isList()) {
            setList(object, parameter, wanted, path);
        } else {
            Object value = value(parameter, wanted, path);
            if (value != null) {
                parameter.set(object, value);
            }
        }
    }

    private static boolean isNone(Object wanted) {
        return wanted == null || wanted instanceof CharSequence && wanted.toString().trim().isEmpty();
    }

    private void setList(Object object, Parameter parameter, Object wanted, String path) {
        List<?> entries = wanted instanceof List ? (List<?>) wanted : List.of(wanted);
        if (entries.size() > parameter.getMaxEntries()) {
            problems.add(file, 0, path, entries.size() + " entries", "at most " + parameter.getMaxEntries());
            return;
        }
        List<Object> values = new ArrayList<>();
        for (int i = 0; i < entries.size(); i++) {
            boolean missing = isNone(entries.get(i)) && parameter.getTextRule() != TextRule.DRAWING;
            Object value = missing ? null : value(parameter, entries.get(i), path + "#" + i);
            if (value == null) {
                problems.add(file, 0, path + "#" + i, text(entries.get(i)), parameter.legal());
                return;
            }
            values.add(value);
        }
        parameter.set(object, values);
    }

    /** Parses a single value; reports an invalid one and returns null. */
    private Object value(Parameter parameter, Object wanted, String path) {
        if (parameter.getKind() == Parameter.Kind.GROUP) {
            if (!(wanted instanceof Map)) {
                problems.add(file, 0, path, text(wanted), parameter.legal());
                return null;
            }
            Object group = ParameterTable.of(parameter.getType()).newInstance();
            requireAll(group, (Map<?, ?>) wanted, path + ".");
            set(group, (Map<?, ?>) wanted, path + ".");
            return group;
        }
        try {
            return parameter.parse(text(wanted));
        } catch (IllegalArgumentException e) {
            problems.add(file, 0, path, text(wanted), parameter.legal());
            return null;
        }
    }

    private void requireAll(Object group, Map<?, ?> wanted, String path) {
        for (Parameter parameter : ParameterTable.of(group.getClass()).getParameters()) {
            if (parameter.isRequired() && !wanted.containsKey(parameter.getName())) {
                problems.add(file, 0, path + parameter.getName(), "", parameter.legal());
            }
        }
    }

    /** Returns the text of a value in a file: 1.0 is 1, Python's True is true. */
    private static String text(Object value) {
        if (value instanceof Float) {
            return Parameter.format(Double.parseDouble(value.toString()));
        }
        return Parameter.format(value);
    }

    /**
     * Reports each parameter that the request sets although its value has changed since the client read it.
     *
     * @param was the values that the client has read
     */
    void refuseStale(Object object, Map<?, ?> wanted, Map<?, ?> was) {
        Map<String, Object> now = of(object);
        for (Map.Entry<?, ?> seen : was.entrySet()) {
            String name = String.valueOf(seen.getKey());
            Object present = now.get(name);
            if (wanted.containsKey(seen.getKey()) && !same(present, seen.getValue())
                && !same(present, wanted.get(seen.getKey()))) {
                problems.add(file, 0, name, text(wanted.get(seen.getKey())), "a value based on the present one, "
                    + text(present) + ", since another page or a script has changed it meanwhile");
            }
        }
    }

    private static boolean same(Object present, Object other) {
        if (isNone(other)) {
            return present == null || present instanceof List && ((List<?>) present).isEmpty();
        }
        return present instanceof String ? present.equals(text(other)) : Objects.equals(present, other);
    }
}
