// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.script;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.SearObject;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;

/** Values of an object's parameters, without its parts: a robot's components and wheels. Any thread. */
final class ScriptValues {
    private ScriptValues() {
    }

    private static boolean isStructure(Parameter parameter) {
        return parameter.getTextRule() == TextRule.COMPONENT || SearObject.class.isAssignableFrom(parameter.getType());
    }

    /** Returns the parameters in which two objects of one class differ, in order. */
    static List<Parameter> differences(Object one, Object other) {
        List<Parameter> different = new ArrayList<>();
        for (Parameter parameter : ParameterTable.of(one.getClass()).getParameters()) {
            if (!isStructure(parameter) && !same(parameter, parameter.get(one), parameter.get(other))) {
                different.add(parameter);
            }
        }
        return different;
    }

    private static boolean same(Parameter parameter, Object one, Object other) {
        if (one == null || other == null) {
            return one == other;
        }
        if (one instanceof List) {
            List<?> first = (List<?>) one;
            List<?> second = (List<?>) other;
            boolean same = first.size() == second.size();
            for (int i = 0; same && i < first.size(); i++) {
                same = same(parameter, first.get(i), second.get(i));
            }
            return same;
        }
        return parameter.getKind() == Parameter.Kind.GROUP ? differences(one, other).isEmpty() : one.equals(other);
    }

    /** Returns a copy of all values, for {@link #restore}. */
    static Map<Parameter, Object> copy(Object object) {
        Map<Parameter, Object> values = new LinkedHashMap<>();
        for (Parameter parameter : ParameterTable.of(object.getClass()).getParameters()) {
            Object value = parameter.get(object);
            values.put(parameter, value instanceof List ? new ArrayList<>((List<?>) value) : value);
        }
        return values;
    }

    /** Restores the values of {@link #copy}. */
    static void restore(Object object, Map<Parameter, Object> values) {
        values.forEach((parameter, value) -> parameter.set(object, value));
    }

    /** Returns a value as a script passes it to {@code set}: groups are dictionaries. */
    static Object plain(Object value) {
        if (value instanceof List) {
            List<Object> entries = new ArrayList<>();
            ((List<?>) value).forEach(entry -> entries.add(plain(entry)));
            return entries;
        }
        if (value == null || value instanceof Number || value instanceof Boolean || value instanceof String) {
            return value;
        }
        Map<String, Object> group = new LinkedHashMap<>();
        for (Parameter parameter : ParameterTable.of(value.getClass()).getParameters()) {
            group.put(parameter.getName(), plain(parameter.get(value)));
        }
        return group;
    }
}
