// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** A public method of a service with its javadoc in Markdown. */
final class ScriptCall {
    /** Section title above the method in the source; may be empty. */
    String section = "";
    String name;
    /** Return type in Python terms; empty for none. */
    String answers;
    /** Description by parameter name; empty if the javadoc has none. */
    final Map<String, String> parameters = new LinkedHashMap<>();
    /** Type by parameter name, in Python terms. */
    final Map<String, String> types = new LinkedHashMap<>();
    String text = "";
    String returns = "";
    final Map<String, String> errors = new LinkedHashMap<>();
    /** A line of Python; may be empty. */
    String example = "";
    /** Whether the method overrides one of MyRobotLab. */
    boolean overrides;

    /** Returns for example {@code drive(speed, radius)}. */
    String signature() {
        return name + parameters.keySet().stream().collect(Collectors.joining(", ", "(", ")"));
    }

    /** Returns the missing parts of the javadoc. */
    List<String> gaps() {
        List<String> gaps = parameters.entrySet().stream()
            .filter(one -> one.getValue().isEmpty() && !isPlain(one.getKey()))
            .map(one -> signature() + " says nothing of " + one.getKey()).collect(Collectors.toList());
        if (text.isEmpty()) {
            gaps.add(signature() + " says nothing");
        }
        if (example.isEmpty()) {
            gaps.add(signature() + " has no example");
        }
        return gaps;
    }

    /**
     * Returns whether a parameter needs no description: a switch that the sentence explains, or the value of a
     * publisher.
     */
    private boolean isPlain(String parameter) {
        return parameter.equals("on") || name.startsWith("publish");
    }
}
