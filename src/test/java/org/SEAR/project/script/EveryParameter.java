// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.script;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.SEAR.POJOs.Assembly;
import org.SEAR.POJOs.SearObject;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;

/**
 * Legal objects of a class of the grammar: without optional parameters, with each parameter alone, and with as many as
 * are legal together.
 */
final class EveryParameter {
    private static final List<Object> TEXTS = Arrays.asList("laser", "textures/brick.png", "#12ab34", "ttyX", "MT3329",
        "LMS291", "roomba400", "1");
    /** Two lines of a maze. */
    private static final List<Object> DRAWING = Arrays.asList(" _ _", "|_|r|");
    private static final List<Object> NUMBERS = Arrays.asList(0.5, 0.25, 2.5, 1.0, 45.0, 500.0, 9600.0);
    private static final List<Object> WHOLES = Arrays.asList(2, 1, 0, 12, 500, 19200);
    private static final int MOST_COMPANIONS = 3;
    private static final List<String> NUMBERS_THAT_OTHERS_NEED = List.of("mass", "fullWell");
    /** Larger ones fold a lens's picture, fill a maze's cells, or are no tensor. */
    private static final List<String> SMALL = List.of("p1", "p2", "thickness", "xy", "xz", "yz");

    private final Class<?> type;
    private final List<Parameter> parameters = new ArrayList<>();
    private final TreeSet<String> never = new TreeSet<>();
    private int made;

    EveryParameter(Class<? extends SearObject> type) {
        this.type = type;
        for (Parameter parameter : ParameterTable.of(type).getParameters()) {
            boolean structure = parameter.getTextRule() == TextRule.COMPONENT
                || SearObject.class.isAssignableFrom(parameter.getType());
            if (!structure && !parameter.isRequired()) {
                parameters.add(parameter);
            }
        }
    }

    /** Returns the objects; {@link #never} has the parameters that none of them sets. */
    List<SearObject> objects() {
        List<SearObject> all = new ArrayList<>();
        Map<Parameter, Object> most = new LinkedHashMap<>();
        List<Map<Parameter, Object>> single = new ArrayList<>();
        single.add(whole(new LinkedHashMap<>(), 0, MOST_COMPANIONS));
        for (Parameter parameter : parameters) {
            Map<Parameter, Object> alone = new LinkedHashMap<>();
            alone.put(parameter, another(parameter));
            Map<Parameter, Object> legal = whole(alone, 0, MOST_COMPANIONS);
            if (legal == null) {
                never.add(type.getSimpleName() + "." + parameter.getName());
                continue;
            }
            single.add(legal);
            Map<Parameter, Object> together = new LinkedHashMap<>(most);
            together.putAll(legal);
            if (isLegal(make(together))) {
                most = together;
            }
        }
        single.add(most);
        single.stream().filter(values -> values != null).forEach(values -> all.add(make(values)));
        return all;
    }

    /** Returns {@code Type.parameter} of parameters that can't be set at all. */
    TreeSet<String> never() {
        return never;
    }

    /** Returns the values with the fewest others that make them legal, or null. */
    private Map<Parameter, Object> whole(Map<Parameter, Object> values, int from, int more) {
        if (isLegal(make(values))) {
            return values;
        }
        for (int i = from; i < parameters.size() && more > 0; i++) {
            Parameter companion = parameters.get(i);
            boolean number = companion.getType().isPrimitive() && !companion.isList();
            if (!values.containsKey(companion) && (!number || NUMBERS_THAT_OTHERS_NEED.contains(companion.getName()))) {
                Map<Parameter, Object> larger = new LinkedHashMap<>(values);
                larger.put(companion, another(companion));
                Map<Parameter, Object> found = whole(larger, i + 1, more - 1);
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    private SearObject make(Map<Parameter, Object> values) {
        Object object = ParameterTable.of(type).newInstance();
        for (Parameter parameter : ParameterTable.of(type).getParameters()) {
            if (parameter.isRequired()) {
                parameter.set(object, parameter.getName().equals("name") ? "it " + made++ : another(parameter));
            }
        }
        values.forEach((parameter, value) -> parameter.set(object, value));
        return (SearObject) object;
    }

    private static boolean isLegal(SearObject object) {
        List<String> faults = new ArrayList<>();
        Assembly.crossCheck(object, (element, value, legal) -> faults.add(element));
        return faults.isEmpty();
    }

    /** Returns a legal value other than the default; for a list two values. */
    private Object another(Parameter parameter) {
        if (parameter.isList()) {
            List<Object> entries = new ArrayList<>();
            entries.add(single(parameter, 0));
            entries.add(single(parameter, 1));
            return entries;
        }
        return single(parameter, 0);
    }

    private Object single(Parameter parameter, int which) {
        if (parameter.getKind() == Parameter.Kind.GROUP) {
            ParameterTable table = ParameterTable.of(parameter.getType());
            Object group = table.newInstance();
            table.getParameters().forEach(inner -> inner.set(group, inner.isList() ? another(inner)
                : single(inner, which)));
            return group;
        }
        Object usual = parameter.get(ParameterTable.of(type == null || !owns(parameter) ? ownerOf(parameter) : type)
            .newInstance());
        List<Object> candidates = new ArrayList<>(parameter.getKind() == Parameter.Kind.TEXT ? TEXTS
            : parameter.getKind() == Parameter.Kind.NUMBER
            ? NUMBERS : parameter.getKind() == Parameter.Kind.WHOLE ? WHOLES : Arrays.asList((Object) false, true));
        if (parameter.getKind() == Parameter.Kind.TEXT) {
            candidates.addAll(Arrays.asList(parameter.legal().split(", ")));
        }
        if (parameter.getName().equals("sketch")) {
            candidates.add(0, "avoider.hex");
        }
        if (parameter.getTextRule() == TextRule.DRAWING) {
            candidates = new ArrayList<>(DRAWING);
        }
        if (parameter.getKind() == Parameter.Kind.NUMBER) {
            candidates.add(0, SMALL.contains(parameter.getName()) ? 0.01 : 45 + 0.25 * parameters.indexOf(parameter));
        }
        int skip = which;
        for (Object each : candidates) {
            if (parameter.isLegal(each) && !each.equals(usual) && skip-- == 0) {
                return each;
            }
        }
        throw new AssertionError(type + ": no example of " + parameter.getName() + ", legal: " + parameter.legal());
    }

    private boolean owns(Parameter parameter) {
        return ParameterTable.of(type).getParameters().contains(parameter);
    }

    private Class<?> ownerOf(Parameter inner) {
        return ParameterTable.of(type).getParameters().stream().map(Parameter::getType)
            .filter(group -> ParameterTable.of(group).getParameters().contains(inner)).findFirst()
            .orElseThrow(AssertionError::new);
    }
}
