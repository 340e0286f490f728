// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/** Parameters that are set by name, as {@code SearObject.set} does. One use. */
public final class NamedValues {
    private final Object object;
    private final String label;
    private final Predicate<Parameter> fixed;
    private final ParameterTable table;
    private final Map<Parameter, Object> before = new LinkedHashMap<>();

    /**
     * @param label of the object, for error messages
     * @param fixed selects the parameters that can't be set
     */
    public NamedValues(Object object, String label, Predicate<Parameter> fixed) {
        this.object = object;
        this.label = label;
        this.fixed = fixed;
        this.table = ParameterTable.of(object.getClass());
    }

    /**
     * Sets the values; each is checked by itself, combinations are not.
     *
     * @throws IllegalArgumentException for the first invalid value
     */
    public void set(Map<?, ?> values) {
        for (Map.Entry<?, ?> entry : values.entrySet()) {
            Parameter parameter = table.get(ScriptText.of(String.valueOf(entry.getKey())));
            if (fixed.test(parameter)) {
                throw new IllegalArgumentException(label + ": " + parameter.getName()
                    + " can't be set: an object keeps its name, and addComponent and addWheel give a robot its parts");
            }
            Object value = whole(parameter, entry.getValue());
            before.putIfAbsent(parameter, parameter.get(object));
            parameter.set(object, value);
        }
    }

    /** Restores all values. */
    public void undo() {
        before.forEach((parameter, value) -> parameter.set(object, value));
    }

    private Object whole(Parameter parameter, Object value) {
        if (!parameter.isList()) {
            return single(parameter, value);
        }
        if (!(value instanceof List)) {
            throw illegal(parameter, value, "a list");
        }
        List<Object> entries = new ArrayList<>();
        ((List<?>) value).forEach(entry -> entries.add(single(parameter, entry)));
        return entries;
    }

    private Object single(Parameter parameter, Object value) {
        Object converted = value;
        if (value instanceof Number && parameter.getKind() == Parameter.Kind.NUMBER) {
            converted = ((Number) value).doubleValue() + 0.0;
        } else if (value instanceof Map && parameter.getKind() == Parameter.Kind.GROUP) {
            converted = group(parameter, (Map<?, ?>) value);
        }
        boolean right = converted == null ? !parameter.getType().isPrimitive() : boxed(parameter).isInstance(converted);
        if (!right || !parameter.isLegal(converted)) {
            throw illegal(parameter, value, parameter.legal());
        }
        return converted;
    }

    private Object group(Parameter parameter, Map<?, ?> values) {
        ParameterTable inner = ParameterTable.of(parameter.getType());
        Object made = inner.newInstance();
        values.forEach((key, value) -> {
            Parameter part = inner.get(String.valueOf(key));
            part.set(made, whole(part, value));
        });
        return made;
    }

    private static Class<?> boxed(Parameter parameter) {
        switch (parameter.getKind()) {
            case NUMBER:
                return Double.class;
            case WHOLE:
                return Integer.class;
            case SWITCH:
                return Boolean.class;
            default:
                return parameter.getType();
        }
    }

    private IllegalArgumentException illegal(Parameter parameter, Object value, String legal) {
        return new IllegalArgumentException(label + ": " + parameter.getName() + " is " + ParameterTable.quote(value)
            + ", legal: " + legal);
    }
}
