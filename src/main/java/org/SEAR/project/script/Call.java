// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.script;

import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;

/**
 * A public constructor or method of a class of the grammar, with the parameters that its argument names match:
 * {@code newX} stands for {@code x}, {@code user} for {@code userPort}; for a setter {@code setMass} the method's name
 * counts. Calling it shows whether it sets these parameters. Immutable, any thread.
 */
final class Call {
    private static final ClassValue<List<Call>> CONSTRUCTORS = new ClassValue<List<Call>>() {
        @Override
        protected List<Call> computeValue(Class<?> type) {
            return calls(type, Arrays.asList(type.getConstructors()));
        }
    };
    private static final ClassValue<List<Call>> METHODS = new ClassValue<List<Call>>() {
        @Override
        protected List<Call> computeValue(Class<?> type) {
            return calls(type, Arrays.stream(type.getMethods()).filter(m -> !Modifier.isStatic(m.getModifiers())
                && !m.isBridge() && m.getDeclaringClass() != Object.class && m.getParameterCount() > 0 && !m.getName()
                    .matches("(get|has|is)[A-Z].*"))
                .collect(Collectors.toList()));
        }
    };

    final Executable target;
    final List<Parameter> arguments;

    private Call(Executable target, List<Parameter> arguments) {
        this.target = target;
        this.arguments = arguments;
    }

    /** Returns the constructors whose arguments are all parameters; the shortest first. */
    static List<Call> constructors(Class<?> type) {
        return CONSTRUCTORS.get(type);
    }

    /** Returns the methods whose arguments are all parameters; the shortest first. */
    static List<Call> methods(Class<?> type) {
        return METHODS.get(type);
    }

    private static List<Call> calls(Class<?> type, List<? extends Executable> all) {
        ParameterTable table = ParameterTable.of(type);
        List<Call> calls = new ArrayList<>();
        for (Executable each : all) {
            List<Parameter> arguments = new ArrayList<>();
            for (java.lang.reflect.Parameter argument : each.getParameters()) {
                arguments.add(find(table, each, argument));
            }
            if (!arguments.contains(null)) {
                calls.add(new Call(each, List.copyOf(arguments)));
            }
        }
        calls.sort(Comparator.<Call>comparingInt(call -> call.arguments.size())
            .thenComparing(call -> call.target.toString()));
        return List.copyOf(calls);
    }

    private static Parameter find(ParameterTable table, Executable call, java.lang.reflect.Parameter argument) {
        String word = argument.getName().replaceFirst("^new(?=[A-Z])", "");
        List<String> words = new ArrayList<>();
        if (call instanceof Method && call.getParameterCount() == 1) {
            words.add(call.getName().replaceFirst("^(set|add)(?=[A-Z])", ""));
        }
        words.add(word);
        words.add(word.replaceFirst("s$", ""));
        for (String each : words) {
            Parameter found = named(table, each);
            if (found != null && fits(found, call, argument.getType())) {
                return found;
            }
        }
        return null;
    }

    private static Parameter named(ParameterTable table, String word) {
        String wanted = word.toLowerCase(Locale.ROOT);
        List<Parameter> near = new ArrayList<>();
        for (Parameter parameter : table.getParameters()) {
            String name = parameter.getName().toLowerCase(Locale.ROOT);
            if (name.equals(wanted)) {
                return parameter;
            }
            if (wanted.length() > 2 && (name.startsWith(wanted) || name.endsWith(wanted))) {
                near.add(parameter);
            }
        }
        return near.size() == 1 ? near.get(0) : null;
    }

    private static boolean fits(Parameter parameter, Executable call, Class<?> type) {
        if (parameter.isList() && !call.getName().startsWith("add")) {
            return type == List.class;
        }
        switch (parameter.getKind()) {
            case NUMBER:
                return type == double.class || type == Double.class;
            case WHOLE:
                return type == int.class || type == Integer.class;
            case SWITCH:
                return type == boolean.class || type == Boolean.class;
            default:
                return type == parameter.getType();
        }
    }

    /** Returns whether the call adds a single entry to a list. */
    boolean isAdding() {
        return arguments.size() == 1 && arguments.get(0).isList() && target.getParameterTypes()[0] != List.class;
    }

    /**
     * Calls the constructor or method.
     *
     * @param object null for a constructor
     * @return the new object; the object itself for a method; null if the values are rejected
     */
    Object run(Object object, Object[] values) {
        Class<?>[] types = target.getParameterTypes();
        for (int i = 0; i < values.length; i++) {
            if (values[i] == null && types[i].isPrimitive()) {
                return null;
            }
        }
        try {
            if (target instanceof Constructor) {
                return ((Constructor<?>) target).newInstance(values);
            }
            ((Method) target).invoke(object, values);
            return object;
        } catch (ReflectiveOperationException e) {
            return null;
        }
    }
}
