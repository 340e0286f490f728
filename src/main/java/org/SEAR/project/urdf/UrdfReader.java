// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.urdf;

import java.io.IOException;
import java.io.StringReader;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.SEAR.files.FileLimits;

/** Reads the XML of untrusted URDFs: no document type, no entity, limited size and depth. Any thread. */
final class UrdfReader {
    /** Largest file, bytes. */
    static final int MAX_FILE = 16 << 20;
    private static final int MAX_DEPTH = 32;
    private static final int MAX_ELEMENTS = 200_000;
    /** Many files declare version 0.0, which XML parsers refuse; the declaration says nothing else that counts. */
    private static final Pattern DECLARATION = Pattern.compile("^\\s*<\\?xml[^>]*\\?>");
    /** A substitution of roslaunch: an environment variable with a default, which counts. */
    private static final Pattern OPTIONAL = Pattern.compile("\\$\\(optenv\\s+\\S+\\s*([^)]*)\\)");
    /** A substitution of roslaunch: the folder of a package. */
    private static final Pattern FIND = Pattern.compile("\\$\\(find\\s+(\\S+?)\\s*\\)");

    private UrdfReader() {
    }

    /**
     * Returns the root element.
     *
     * @param file its name in errors
     */
    static UrdfElement read(String file, byte[] bytes) throws IOException {
        FileLimits.range(file, "the size in bytes", bytes.length, 1, MAX_FILE);
        try {
            return parse(file, text(bytes));
        } catch (XMLStreamException e) {
            int line = e.getLocation() == null ? 0 : e.getLocation().getLineNumber();
            throw FileLimits.wrong(file, "the text", "no XML" + (line > 0 ? " at line " + line : "") + ": "
                + reason(e), "the XML of a URDF", e);
        }
    }

    private static String reason(XMLStreamException e) {
        String said = String.valueOf(e.getMessage()).replaceAll("\\s+", " ");
        return said.substring(said.indexOf("Message: ") < 0 ? 0 : said.indexOf("Message: ") + 9);
    }

    /** Returns the text, its declaration replaced by spaces. */
    private static String text(byte[] bytes) {
        String text;
        try {
            text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
        } catch (CharacterCodingException e) {
            text = new String(bytes, StandardCharsets.ISO_8859_1);
        }
        if (text.startsWith("\ufeff")) {
            text = text.substring(1);
        }
        Matcher declaration = DECLARATION.matcher(text);
        return declaration.find() ? declaration.group().replaceAll("[^\\n]", " ") + text.substring(declaration.end())
            : text;
    }

    private static UrdfElement parse(String file, String text) throws XMLStreamException, IOException {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, false);
        XMLStreamReader in = factory.createXMLStreamReader(new StringReader(text));
        UrdfElement root = null;
        UrdfElement[] open = new UrdfElement[MAX_DEPTH + 1];
        int depth = 0;
        int count = 0;
        while (in.hasNext()) {
            int event = in.next();
            int line = in.getLocation().getLineNumber();
            if (event == XMLStreamConstants.DTD || event == XMLStreamConstants.ENTITY_REFERENCE) {
                throw FileLimits.wrong(file, "line " + line, "a document type or an entity", "XML without them");
            }
            if (event == XMLStreamConstants.END_ELEMENT && --depth == 0) {
                return root;    // some files have text after it
            }
            if (event == XMLStreamConstants.START_ELEMENT) {
                FileLimits.range(file, "line " + line + ": the number of elements", ++count, 1, MAX_ELEMENTS);
                FileLimits.range(file, "line " + line + ": the depth of nesting", depth + 1, 1, MAX_DEPTH);
                UrdfElement element = new UrdfElement(file, depth == 0 ? null : open[depth - 1],
                    whole(in.getPrefix(), in.getLocalName()), line);
                for (int i = 0; i < in.getAttributeCount(); i++) {
                    String attribute = whole(in.getAttributePrefix(i), in.getAttributeLocalName(i));
                    if (!attribute.startsWith("xmlns")) {
                        element.put(attribute, expanded(in.getAttributeValue(i)));
                    }
                }
                root = root == null ? element : root;
                open[depth++] = element;
            }
        }
        return root;
    }

    private static String whole(String prefix, String name) {
        return prefix == null || prefix.isEmpty() ? name : prefix + ":" + name;
    }

    private static String expanded(String value) {
        return value.indexOf('$') < 0 ? value.trim()
            : FIND.matcher(OPTIONAL.matcher(value).replaceAll("$1")).replaceAll("package://$1").trim();
    }
}
