package org.SEAR.documents;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** A public method of a service as its javadoc describes it, in Markdown. */
final class ScriptCall {
    /** The title that stands above it in the source; empty if there is none. */
    String section = "";
    String name;
    /** In Python's words; empty if it answers nothing. */
    String answers;
    /** Names of the parameters and what is said of each; empty where nothing is. */
    final Map<String, String> parameters = new LinkedHashMap<>();
    /** What each parameter is, in Python's words. */
    final Map<String, String> types = new LinkedHashMap<>();
    String text = "";
    String returns = "";
    final Map<String, String> errors = new LinkedHashMap<>();
    /** A line of Python; empty if there is none. */
    String example = "";
    /** Whether MyRobotLab calls it. */
    boolean overrides;

    /** {@code drive(speed, radius)}. */
    String signature() {
        return name + parameters.keySet().stream().collect(Collectors.joining(", ", "(", ")"));
    }

    /** What is missing for a page that says all; empty if nothing is. */
    List<String> gaps() {
        List<String> gaps = parameters.entrySet().stream().filter(one -> one.getValue().isEmpty() && !isPlain(one.getKey()))
            .map(one -> signature() + " says nothing of " + one.getKey()).collect(Collectors.toList());
        if (text.isEmpty()) {
            gaps.add(signature() + " says nothing");
        }
        if (example.isEmpty()) {
            gaps.add(signature() + " has no example");
        }
        return gaps;
    }

    /** A switch, whose meaning the sentence gives, or the value that a publisher hands on. */
    private boolean isPlain(String parameter) {
        return parameter.equals("on") || name.startsWith("publish");
    }
}
