// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.script;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.SEAR.POJOs.SearObject;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.ScriptText;

/**
 * Finds the constructor and calls that create one object, or one group of parameters, by trying them on drafts. It
 * combines each constructor with the methods that bring the draft nearer to the object, and takes the shortest result;
 * {@code set} covers parameters without a method. One use, within a {@link org.SEAR.POJOs.Draft}.
 */
final class ObjectScript {
    /** Length of a call compared to that of an argument, and of a call with names. */
    private static final int CALL = 2;
    private static final int BY_NAME = 6;

    private final Object wanted;
    private final Set<Class<?>> classes = new LinkedHashSet<>();
    private String expression;
    private List<String> calls = new ArrayList<>();
    private int length = Integer.MAX_VALUE;

    ObjectScript(Object wanted) {
        this.wanted = wanted;
        for (Call constructor : Call.constructors(wanted.getClass())) {
            tryWith(constructor);
        }
        if (expression == null && wanted instanceof SearObject) {
            makeByNames();
        }
        classes.add(wanted.getClass());
    }

    /** Uses {@code SearObject.make} for a class without a suitable constructor. */
    private void makeByNames() {
        Map<String, Object> named = new LinkedHashMap<>();
        ScriptValues.differences(wanted, ParameterTable.of(wanted.getClass()).newInstance())
            .forEach(parameter -> named.put(parameter.getName(), ScriptValues.plain(parameter.get(wanted))));
        try {
            Object draft = SearObject.make(((SearObject) wanted).getClass(), named);
            if (ScriptValues.differences(wanted, draft).isEmpty()) {
                expression = "SearObject.make(" + wanted.getClass().getSimpleName() + ", "
                    + PythonText.literal(named) + ")";
                classes.add(SearObject.class);
            }
        } catch (IllegalArgumentException e) {
            expression = null;
        }
    }

    /** Returns whether a script was found. */
    boolean isPossible() {
        return expression != null;
    }

    /** Returns the constructor call: {@code Box("crate", 1, 2, 3)}. */
    String expression() {
        return expression;
    }

    /** Returns the method calls in order: {@code setColor("red")}. */
    List<String> calls() {
        return calls;
    }

    /** Returns the classes that the script names. */
    Set<Class<?>> classes() {
        return classes;
    }

    private void tryWith(Call constructor) {
        Object[] values = values(constructor);
        Object draft = constructor.run(null, values);
        String made = draft == null ? null : words(wanted.getClass().getSimpleName(), constructor, values);
        if (made == null) {
            return;
        }
        List<String> found = new ArrayList<>();
        int size = values.length + change(draft, found);
        List<Parameter> rest = ScriptValues.differences(wanted, draft);
        if (!rest.isEmpty()) {
            if (!(draft instanceof SearObject) || !setByName((SearObject) draft, rest, found)) {
                return;
            }
            size += BY_NAME + rest.size();
        }
        if (size < length) {
            length = size;
            expression = made;
            calls = found;
        }
    }

    /** Calls methods as long as they reduce the differences; returns the length of the calls. */
    private int change(Object draft, List<String> found) {
        int size = 0;
        List<Parameter> rest = ScriptValues.differences(wanted, draft);
        boolean helped = draft instanceof SearObject;
        while (helped && !rest.isEmpty()) {
            helped = false;
            Call best = null;
            List<Parameter> after = rest;
            for (Call call : Call.methods(wanted.getClass())) {
                Map<Parameter, Object> before = ScriptValues.copy(draft);
                if (call.arguments.stream().anyMatch(rest::contains) && runAll(call, draft)) {
                    List<Parameter> left = ScriptValues.differences(wanted, draft);
                    if (left.size() < after.size()) {
                        best = call;
                        after = left;
                    }
                }
                ScriptValues.restore(draft, before);
            }
            if (best != null && words(best, found)) {
                runAll(best, draft);
                size += CALL + best.arguments.size();
                helped = true;
                rest = after;
            }
        }
        return size;
    }

    private boolean runAll(Call call, Object draft) {
        if (!call.isAdding()) {
            return call.run(draft, values(call)) != null;
        }
        return call.arguments.get(0).values(wanted).stream()
            .allMatch(entry -> call.run(draft, new Object[] {entry}) != null);
    }

    private boolean words(Call call, List<String> found) {
        String name = call.target.getName();
        List<String> words = new ArrayList<>();
        if (call.isAdding()) {
            call.arguments.get(0).values(wanted).forEach(entry -> words.add(words(name, call, new Object[] {entry})));
        } else {
            words.add(words(name, call, values(call)));
        }
        return !words.contains(null) && found.addAll(words);
    }

    private static boolean setByName(SearObject draft, List<Parameter> rest, List<String> found, Object wanted) {
        Map<String, Object> named = new LinkedHashMap<>();
        rest.forEach(parameter -> named.put(parameter.getName(), ScriptValues.plain(parameter.get(wanted))));
        try {
            draft.set(named);
        } catch (IllegalArgumentException e) {
            return false;
        }
        found.add("set(" + PythonText.literal(named) + ")");
        return ScriptValues.differences(wanted, draft).isEmpty();
    }

    private boolean setByName(SearObject draft, List<Parameter> rest, List<String> found) {
        return setByName(draft, rest, found, wanted);
    }

    private Object[] values(Call call) {
        return call.arguments.stream().map(parameter -> {
            Object value = parameter.get(wanted);
            return parameter.getName().equals("name") ? asWritten((String) value) : value instanceof List
                ? new ArrayList<>((List<?>) value) : value;
        }).toArray();
    }

    /** Returns the text by which a script writes a name: a name that looks like UTF-8 bytes is written as bytes. */
    private static String asWritten(String name) {
        return name.equals(ScriptText.of(name)) ? name
            : new String(name.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
    }

    /** Returns the call {@code name(1, 2)}; null if a value can't be written as an argument. */
    private String words(String name, Call call, Object[] values) {
        List<String> words = new ArrayList<>();
        for (int i = 0; i < values.length; i++) {
            words.add(word(call.arguments.get(i), values[i]));
        }
        return words.contains(null) ? null : name + "(" + String.join(", ", words) + ")";
    }

    private String word(Parameter parameter, Object value) {
        if (parameter.getKind() != Parameter.Kind.GROUP || value == null) {
            return PythonText.literal(value);
        }
        if (value instanceof List) {
            List<String> entries = ((List<?>) value).stream().map(entry -> word(parameter, entry))
                .collect(Collectors.toList());
            return entries.contains(null) ? null : "[" + String.join(", ", entries) + "]";
        }
        ObjectScript group = new ObjectScript(value);
        if (!group.isPossible()) {
            return null;
        }
        classes.addAll(group.classes);
        return group.expression;
    }
}
