// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * All parameters of a class of the grammar: inherited ones first, then in the order of the fields. Validation, XML,
 * documentation, {@code sear sensors} and the tabs read this table. Immutable, any thread.
 */
public final class ParameterTable {
    private static final ClassValue<ParameterTable> TABLES = new ClassValue<ParameterTable>() {
        @Override
        protected ParameterTable computeValue(Class<?> type) {
            return new ParameterTable(type);
        }
    };

    private final Class<?> type;
    private final List<Parameter> parameters;

    private ParameterTable(Class<?> type) {
        this.type = type;
        List<Parameter> found = new ArrayList<>();
        collect(null, type, found);
        this.parameters = List.copyOf(found);
    }

    private static void collect(Field group, Class<?> type, List<Parameter> found) {
        if (type.getSuperclass() != null) {
            collect(group, type.getSuperclass(), found);
        }
        for (Field field : type.getDeclaredFields()) {
            if (field.isAnnotationPresent(Param.class)) {
                found.add(new Parameter(group, field));
            } else if (group == null && field.isAnnotationPresent(Included.class)) {
                collect(field, field.getType(), found);
            }
        }
    }

    public static ParameterTable of(Class<?> type) {
        return TABLES.get(type);
    }

    public List<Parameter> getParameters() {
        return parameters;
    }

    /** Returns the names of all elements, in order. */
    public List<String> names() {
        return parameters.stream().map(Parameter::getName).collect(Collectors.toList());
    }

    /** Returns the parameter of an element; null if there is none. */
    public Parameter find(String element) {
        for (Parameter parameter : parameters) {
            if (parameter.getName().equals(element)) {
                return parameter;
            }
        }
        return null;
    }

    /**
     * Returns the parameter of an element.
     *
     * @throws IllegalArgumentException if the class has no such element
     */
    public Parameter get(String element) {
        Parameter parameter = find(element);
        if (parameter == null) {
            throw new IllegalArgumentException(type.getSimpleName() + " has no parameter " + element
                + ", but " + names());
        }
        return parameter;
    }

    /**
     * Creates an object with all defaults and without a file, by the class's constructor without arguments (which may
     * be private).
     */
    public Object newInstance() {
        try {
            Constructor<?> constructor = type.getDeclaredConstructor();
            constructor.setAccessible(true);
            return constructor.newInstance();
        } catch (NoSuchMethodException e) {
            throw new IllegalStateException(type.getName() + " needs a constructor without arguments (it may be "
                + "private) to be read from a file", e);
        } catch (InvocationTargetException | InstantiationException | IllegalAccessException e) {
            throw new IllegalStateException("no " + type.getName() + " can be made with its constructor "
                + "without arguments", e);
        }
    }

    /** Returns the default of a parameter as text; empty for none. */
    public String defaultOf(Parameter parameter) {
        if (parameter.isRequired() || parameter.isList()) {
            return "";
        }
        if (Modifier.isAbstract(type.getModifiers())) {
            return parameter.getKind() == Parameter.Kind.NUMBER ? "0" : "";
        }
        Object value = parameter.get(newInstance());
        return value == null ? "" : Parameter.format(value);
    }

    /** Returns all problems of an object's values, in words; empty if it is valid. */
    public List<String> problems(Object object, String path) {
        List<String> problems = new ArrayList<>();
        for (Parameter parameter : parameters) {
            Object whole = parameter.get(object);
            String element = path + parameter.getName();
            if (parameter.isList()) {
                int entries = ((List<?>) whole).size();
                if (entries > parameter.getMaxEntries()) {
                    problems.add(element + " has " + entries + " entries, legal: at most " + parameter.getMaxEntries());
                }
            } else if (whole == null && !parameter.isLegal(null)) {
                problems.add(element + " is missing, legal: " + parameter.legal());
            }
            for (Object value : parameter.values(object)) {
                if (value == null || !parameter.isLegal(value)) {
                    problems.add(element + " is " + quote(value) + ", legal: " + parameter.legal());
                } else if (parameter.getKind() == Parameter.Kind.GROUP) {
                    problems.addAll(of(value.getClass()).problems(value, element + "."));
                }
            }
        }
        return problems;
    }

    public static String quote(Object value) {
        return value instanceof Number || value instanceof Boolean ? Parameter.format(value) : "\"" + value + "\"";
    }
}
