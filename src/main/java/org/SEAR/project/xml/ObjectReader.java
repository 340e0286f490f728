// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.xml;

import com.thoughtworks.xstream.io.HierarchicalStreamReader;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.project.problems.ProblemList;

/**
 * Creates an object from the elements of one file by its {@link ParameterTable}. Continues after a problem, so that all
 * problems are reported.
 */
final class ObjectReader {
    private final String file;
    private final ProblemList problems;
    private final Map<String, Integer> lines = new HashMap<>();

    ObjectReader(String file, ProblemList problems) {
        this.file = file;
        this.problems = problems;
    }

    /** Returns the line of each element, by its path. */
    Map<String, Integer> lines() {
        return lines;
    }

    Object read(HierarchicalStreamReader reader, Class<?> type) {
        return readGroup(reader, type, "", LineNumber.line(reader));
    }

    private Object readGroup(HierarchicalStreamReader reader, Class<?> type, String path, int startLine) {
        ParameterTable table = ParameterTable.of(type);
        Object object = table.newInstance();
        Map<String, List<Object>> found = new HashMap<>();
        String stray = reader.getValue();
        if (stray != null && !stray.trim().isEmpty()) {
            problems.add(file, startLine, path.isEmpty() ? "text" : path.substring(0, path.length() - 1), stray.trim(),
                "elements only: " + String.join(", ", table.names()));
        }
        while (!problems.isFull() && reader.hasMoreChildren()) {
            reader.moveDown();
            readElement(reader, table, path, found);
            reader.moveUp();
        }
        for (Parameter parameter : table.getParameters()) {
            assign(object, parameter, found.get(parameter.getName()), path, startLine);
        }
        return object;
    }

    private void readElement(HierarchicalStreamReader reader, ParameterTable table, String path,
        Map<String, List<Object>> found) {
        int line = LineNumber.line(reader);
        String element = reader.getNodeName();
        Parameter parameter = table.find(element);
        if (parameter == null) {
            problems.add(file, line, "", "<" + path + element + "> is unknown", String.join(", ", table.names()));
            return;
        }
        reportAttributes(reader, file, line, problems);
        List<Object> values = found.computeIfAbsent(element, e -> new ArrayList<>());
        lines.putIfAbsent(path + element, line);
        lines.put(path + element + "#" + values.size(), line);
        if (values.size() == parameter.getMaxEntries()) {
            problems.add(file, line, "", "<" + path + element + "> occurs once too often", "at most "
                + parameter.getMaxEntries());
        }
        if (values.size() < parameter.getMaxEntries()) {
            values.add(parameter.getKind() == Parameter.Kind.GROUP
                ? readGroup(reader, parameter.getType(), path + element + ".", line)
                : readValue(reader, parameter, path + element, line));
        }
    }

    private Object readValue(HierarchicalStreamReader reader, Parameter parameter, String path, int line) {
        String text = reader.getValue();
        if (reader.hasMoreChildren()) {
            problems.add(file, line, path, "elements inside", parameter.legal());
            return null;
        }
        try {
            return parameter.parse(text);
        } catch (IllegalArgumentException e) {
            problems.add(file, line, path, text.trim(), parameter.legal());
            return null;
        }
    }

    private void assign(Object object, Parameter parameter, List<Object> values, String path, int startLine) {
        if (values == null) {
            if (parameter.isRequired()) {
                problems.add(file, startLine, "", "<" + path + parameter.getName() + "> is missing", parameter.legal());
            }
        } else if (parameter.isList()) {
            parameter.set(object, values);
        } else if (values.get(0) != null) {
            parameter.set(object, values.get(0));
        }
    }

    /** Reports attributes, which no element of the grammar has. */
    static void reportAttributes(HierarchicalStreamReader reader, String file, int line, ProblemList problems) {
        Set<String> seen = new HashSet<>();
        for (int i = 0; i < reader.getAttributeCount(); i++) {
            if (seen.add(reader.getAttributeName(i))) {
                problems.add(file, line, reader.getNodeName() + " " + reader.getAttributeName(i),
                    reader.getAttribute(i), "no attributes at all");
            }
        }
    }
}
