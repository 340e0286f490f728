// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.urdf;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.SEAR.files.FileLimits;
import org.SEAR.files.InvalidFile;

/** An element of a URDF. It remembers which of its attributes and children were read. One thread. */
final class UrdfElement {
    /** Says how to expand a xacro. */
    static final String EXPAND = "; expand a xacro by ros2 run xacro xacro";

    final String tag;
    final int line;
    private final String file;
    private final UrdfElement parent;
    private final Map<String, String> attributes = new LinkedHashMap<>();
    private final List<UrdfElement> children = new ArrayList<>();
    private final Set<String> read = new HashSet<>();
    private boolean known;

    /** @param parent null for the root */
    UrdfElement(String file, UrdfElement parent, String tag, int line) {
        this.file = file;
        this.parent = parent;
        this.tag = tag;
        this.line = line;
        if (parent != null) {
            parent.children.add(this);
        }
    }

    void put(String attribute, String value) {
        attributes.put(attribute, value);
    }

    /** Returns the children, for a reader that handles each of them. */
    List<UrdfElement> children() {
        return children;
    }

    /** Returns the children with a tag. */
    List<UrdfElement> children(String of) {
        List<UrdfElement> all = children.stream().filter(child -> child.tag.equals(of)).collect(Collectors.toList());
        all.forEach(child -> child.known = true);
        return all;
    }

    /** Returns the first child with a tag; null if there is none. A second one is left out. */
    UrdfElement child(String of) {
        for (UrdfElement child : children) {
            if (child.tag.equals(of)) {
                child.known = true;
                return child;
            }
        }
        return null;
    }

    /** Marks the element as understood. */
    UrdfElement take() {
        known = true;
        return this;
    }

    boolean has(String attribute) {
        return !attributes.getOrDefault(attribute, "").isEmpty();
    }

    /** Returns the text of an attribute without spaces at its ends; empty if it is missing. */
    String text(String attribute) {
        read.add(attribute);
        return attributes.getOrDefault(attribute, "");
    }

    /**
     * Returns a number.
     *
     * @param missing for a missing attribute
     * @throws IOException for other text, or a number outside of the range
     */
    double number(String attribute, double missing, double low, double high) throws IOException {
        String text = text(attribute);
        return text.isEmpty() ? missing : parsed(attribute, text, text, low, high);
    }

    /**
     * Returns numbers, from {@code -most} to {@code most}. More numbers than needed are noted.
     *
     * @param missing for a missing attribute
     */
    double[] numbers(String attribute, UrdfNotes notes, double most, double... missing) throws IOException {
        String text = text(attribute);
        if (text.isEmpty()) {
            return missing;
        }
        String[] words = text.split("[\\s,]+");
        if (words.length < missing.length) {
            throw wrong(attribute, text, missing.length + " numbers" + hint(text));
        }
        if (words.length > missing.length) {
            notes.add(attribute + " of <" + tag + "> of " + owner() + " has " + words.length + " numbers; the first "
                + missing.length + " count", line);
        }
        double[] all = new double[missing.length];
        for (int i = 0; i < all.length; i++) {
            all[i] = parsed(attribute, words[i], text, -most, most);
        }
        return all;
    }

    private double parsed(String attribute, String word, String text, double low, double high) throws IOException {
        double value;
        try {
            value = Double.parseDouble(word);
        } catch (NumberFormatException e) {
            value = Double.NaN;
        }
        if (!(value >= low && value <= high)) {
            throw wrong(attribute, text, (high == Double.MAX_VALUE ? "finite numbers" : String.format(Locale.ROOT,
                "numbers from %.9g to %.9g", low, high).replaceAll("\\.?0+(?= |$)", "")) + hint(text));
        }
        return value;
    }

    private static String hint(String text) {
        return text.contains("$") ? EXPAND : "";
    }

    /** Returns an error about an attribute. */
    InvalidFile wrong(String attribute, Object value, String legal) {
        return FileLimits.wrong(file, "line " + line + ": " + attribute + " of <" + tag + ">"
            + (parent == null || parent.parent == null ? "" : " of " + owner()), value, legal);
    }

    /** Returns the link or joint of the element, with its name. */
    String owner() {
        UrdfElement top = top();
        String name = top.attributes.getOrDefault("name", "");
        return top.parent == null ? "the robot" : top.tag + (name.isEmpty() ? "" : " " + name);
    }

    /** Returns the robot's child that contains the element, or is it; the root for itself. */
    private UrdfElement top() {
        UrdfElement top = this;
        while (top.parent != null && top.parent.parent != null) {
            top = top.parent;
        }
        return top;
    }

    private String kind() {
        UrdfElement top = top();
        return top == this || top.parent == null ? "the robot" : "a " + top.tag;
    }

    /** Notes the attributes and elements that nothing has read. */
    void noteRest(UrdfNotes notes) {
        for (Map.Entry<String, String> each : attributes.entrySet()) {
            if (!read.contains(each.getKey()) && !each.getKey().equals("name")) {
                notes.add("attribute " + each.getKey() + " of <" + tag + "> is left out", line);
            }
        }
        for (UrdfElement child : children) {
            if (child.known) {
                child.noteRest(notes);
            } else {
                notes.add("<" + child.tag + "> of " + child.within() + " is left out", child.line);
            }
        }
    }

    private String within() {
        return parent.parent == null ? "the robot" : parent.kind().equals("the robot") ? "a " + parent.tag
            : "<" + parent.tag + "> of " + parent.kind();
    }
}
