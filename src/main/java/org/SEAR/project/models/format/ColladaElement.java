// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.StringTokenizer;
import java.util.stream.Collectors;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import org.SEAR.files.FileLimits;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;

/** Element of a COLLADA file, with its line. Elements that don't affect the surface are left out. */
final class ColladaElement {
    private static final String XML = "the XML of a COLLADA model";
    /** Elements without effect on the surface at rest. */
    private static final Set<String> LEFT_OUT = Set.of("library_animations", "library_animation_clips",
        "library_cameras", "library_lights", "library_force_fields", "library_physics_materials",
        "library_physics_models", "library_physics_scenes", "library_kinematics_models", "library_kinematics_scenes",
        "library_articulated_systems", "library_joints", "extra", "contributor");
    private static final int MAX_ELEMENTS = 1_000_000;

    final String name;
    final int line;
    final List<ColladaElement> children = new ArrayList<>();
    private final String file;
    private final Map<String, String> attributes = new HashMap<>(4);
    private final Map<String, ColladaElement> byId;
    private String text = "";

    private ColladaElement(String file, String name, int line, Map<String, ColladaElement> byId) {
        this.file = file;
        this.name = name;
        this.line = line;
        this.byId = byId;
    }

    /** Builds the tree. */
    private static final class Handler extends DefaultHandler {
        private final String file;
        private final Map<String, ColladaElement> byId = new HashMap<>();
        private final Deque<ColladaElement> open = new ArrayDeque<>();
        private final StringBuilder text = new StringBuilder();
        private Locator locator;
        private ColladaElement root;
        private int leftOut;
        private int count;

        Handler(String file) {
            this.file = file;
        }

        @Override
        public void setDocumentLocator(Locator given) {
            locator = given;
        }

        @Override
        public void startElement(String uri, String localName, String element, Attributes given) throws SAXException {
            if (leftOut > 0 || LEFT_OUT.contains(element)) {
                leftOut++;
                return;
            }
            try {
                FileLimits.range(file, "the number of elements", ++count, 0, MAX_ELEMENTS);
                FileLimits.range(file, "the nesting of elements", open.size(), 0, 2L * ModelLimits.MAX_DEPTH);
            } catch (IOException e) {
                throw new SAXException(e);
            }
            ColladaElement made = new ColladaElement(file, element, locator.getLineNumber(), byId);
            for (int i = 0; i < given.getLength(); i++) {
                made.attributes.put(given.getQName(i), given.getValue(i));
            }
            if (given.getValue("id") != null) {
                byId.putIfAbsent(given.getValue("id"), made);
            }
            if (open.isEmpty()) {
                root = made;
            } else {
                open.getLast().children.add(made);
            }
            open.addLast(made);
            text.setLength(0);
        }

        @Override
        public void characters(char[] characters, int start, int length) {
            if (leftOut == 0) {
                text.append(characters, start, length);
            }
        }

        @Override
        public void endElement(String uri, String localName, String element) {
            if (leftOut > 0) {
                leftOut--;
                return;
            }
            ColladaElement ended = open.removeLast();
            if (ended.children.isEmpty()) {
                ended.text = text.toString();
            }
            text.setLength(0);
        }
    }

    /**
     * Returns the root of a file.
     *
     * @param bytes XML without a document type
     * @throws IOException that names the line
     */
    static ColladaElement parse(String file, byte[] bytes) throws IOException {
        Handler handler = new Handler(file);
        try {
            SAXParserFactory factory = SAXParserFactory.newInstance();
            factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
            factory.newSAXParser().parse(new InputSource(new ByteArrayInputStream(bytes)), handler);
        } catch (SAXParseException e) {
            throw FileLimits.wrong(file, "the text before line " + e.getLineNumber() + ", column " + e.getColumnNumber()
                + ",", "no XML", XML, e);
        } catch (SAXException | ParserConfigurationException | IOException e) {
            if (e.getCause() instanceof org.SEAR.files.InvalidFile) {
                throw (IOException) e.getCause();
            }
            throw FileLimits.wrong(file, "the text", "no XML in UTF-8", XML, e);
        }
        if (!handler.root.name.equals("COLLADA")) {
            throw FileLimits.wrong(file, "the root element", "<" + handler.root.name + ">", "<COLLADA>");
        }
        return handler.root;
    }

    /** Returns the error of a value of this element. */
    IOException wrong(String what, Object value, String legal) {
        return FileLimits.wrong(file, what + " of <" + name + "> in line " + line, value == null ? "missing" : value,
            legal);
    }

    /** Returns an attribute; null if it is missing. */
    String attribute(String attribute) {
        return attributes.get(attribute);
    }

    /** Returns a whole number that is not negative; the default if it is missing and the default is not negative. */
    int whole(String attribute, int missing, int most) throws IOException {
        String given = attributes.get(attribute);
        if (given == null && missing >= 0) {
            return missing;
        }
        try {
            int value = Integer.parseInt(String.valueOf(given).trim());
            if (value >= 0 && value <= most) {
                return value;
            }
        } catch (NumberFormatException e) {
            throw wrong(attribute, given, "a whole number from 0 to " + most);
        }
        throw wrong(attribute, given, "a whole number from 0 to " + most);
    }

    String text() {
        return text.trim();
    }

    /** Returns the first child of a name; null if there is none. */
    ColladaElement child(String... path) {
        ColladaElement at = this;
        for (String each : path) {
            ColladaElement from = at;
            at = from == null ? null : from.children.stream().filter(child -> child.name.equals(each)).findFirst()
                .orElse(null);
        }
        return at;
    }

    /** Returns the children of a name. */
    List<ColladaElement> all(String child) {
        return children.stream().filter(each -> each.name.equals(child)).collect(Collectors.toList());
    }

    /**
     * Returns the element that an attribute refers to.
     *
     * @param kind name of the element
     */
    ColladaElement reference(String attribute, String kind) throws IOException {
        String given = attributes.get(attribute);
        ColladaElement found = given == null || !given.startsWith("#") ? null : byId.get(given.substring(1));
        if (found == null || !found.name.equals(kind)) {
            throw wrong(attribute, given, "# and the id of a <" + kind + "> of this file");
        }
        return found;
    }

    /** Returns the element of an id; null if there is none. */
    ColladaElement byId(String id) {
        return byId.get(id);
    }

    /** Returns the numbers of the text, which must have so many. */
    double[] numbers(int count) throws IOException {
        StringTokenizer words = new StringTokenizer(text);
        double[] all = new double[count];
        if (words.countTokens() != count) {
            throw wrong("the number of numbers", words.countTokens(), String.valueOf(count));
        }
        for (int i = 0; i < count; i++) {
            String word = words.nextToken();
            try {
                all[i] = Double.parseDouble(word);
            } catch (NumberFormatException e) {
                throw wrong("a number", word, "a number with a decimal point");
            }
            if (Double.isNaN(all[i]) || Double.isInfinite(all[i])) {
                throw wrong("a number", word, "a finite number");
            }
        }
        return all;
    }

    /** Returns all numbers of the text, finite or not. */
    float[] floats() throws IOException {
        StringTokenizer words = new StringTokenizer(text);
        float[] all = new float[words.countTokens()];
        for (int i = 0; i < all.length; i++) {
            String word = words.nextToken();
            try {
                all[i] = Float.parseFloat(word);
            } catch (NumberFormatException e) {
                throw wrong("number " + (i + 1), word, "a number with a decimal point");
            }
        }
        return all;
    }

    /** Returns all whole numbers of the text, none of them negative. */
    int[] indices() throws IOException {
        StringTokenizer words = new StringTokenizer(text);
        int[] all = new int[words.countTokens()];
        for (int i = 0; i < all.length; i++) {
            String word = words.nextToken();
            try {
                all[i] = Integer.parseInt(word);
            } catch (NumberFormatException e) {
                throw wrong("number " + (i + 1), word, "a whole number that is not negative");
            }
            if (all[i] < 0) {
                throw wrong("number " + (i + 1), word, "a whole number that is not negative");
            }
        }
        return all;
    }
}
