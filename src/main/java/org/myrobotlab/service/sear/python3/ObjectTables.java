// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.python3;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;

/** Objects of the grammar as tables for notebooks. Public because Python calls it. Any thread. */
public final class ObjectTables {
    /** Most listed values of a parameter. */
    private static final int MOST = 8;
    private static final List<String> PLACE = List.of("x", "y", "z");

    private ObjectTables() {
    }

    /** Returns a row for each parameter that differs from its default: name, value with unit, description. */
    public static List<List<String>> rows(Object of) {
        ParameterTable table = ParameterTable.of(of.getClass());
        List<List<String>> rows = new ArrayList<>();
        for (Parameter parameter : table.getParameters()) {
            List<Object> values = parameter.values(of);
            if (!values.isEmpty() && (PLACE.contains(parameter.getName()) || !isDefault(table, parameter, values))) {
                String value = values.stream().limit(MOST).map(one -> text(parameter, one))
                    .collect(Collectors.joining(", "));
                rows.add(List.of(parameter.getName(), values.size() > MOST ? value + ", ... (" + values.size() + ")"
                    : value, parameter.getDoc()));
            }
        }
        return rows;
    }

    private static boolean isDefault(ParameterTable table, Parameter parameter, List<Object> values) {
        return parameter.getKind() != Parameter.Kind.GROUP && values.size() == 1
            && Parameter.format(values.get(0)).equals(table.defaultOf(parameter));
    }

    /** Returns a value as text; a named group as its name. */
    private static String text(Parameter parameter, Object value) {
        if (parameter.getKind() != Parameter.Kind.GROUP) {
            return (Parameter.format(value) + " " + parameter.getUnit()).trim();
        }
        List<List<String>> rows = rows(value);
        return rows.stream().filter(row -> row.get(0).equals("name")).map(row -> row.get(1)).findFirst()
            .orElseGet(() -> rows.stream().map(row -> row.get(0) + " " + row.get(1)).collect(Collectors.joining(" ")));
    }
}
