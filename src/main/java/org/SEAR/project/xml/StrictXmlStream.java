// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.xml;

import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import javax.xml.stream.util.StreamReaderDelegate;

/** Rejects XML features that objects' files don't use: a document type, an entity, deep nesting. */
final class StrictXmlStream extends StreamReaderDelegate {
    private static final int MAX_DEPTH = 16;
    private int depth;
    private boolean behindElement;

    StrictXmlStream(XMLStreamReader reader) {
        super(reader);
    }

    @Override
    public int next() throws XMLStreamException {
        int event = super.next();
        if (event == XMLStreamConstants.START_ELEMENT) {
            depth++;
            behindElement = false;
        } else if (event == XMLStreamConstants.END_ELEMENT) {
            depth--;
            behindElement = true;
        }
        if (event == XMLStreamConstants.DTD || event == XMLStreamConstants.ENTITY_REFERENCE) {
            throw new XMLStreamException("a document type or entity is not allowed", getLocation());
        }
        if (behindElement && isText(event) && !getText().trim().isEmpty()) {
            throw new XMLStreamException("there is text between elements: " + getText().trim(), getLocation());
        }
        if (depth > MAX_DEPTH) {
            throw new XMLStreamException("elements are nested more than " + MAX_DEPTH + " deep", getLocation());
        }
        return event;
    }

    private static boolean isText(int event) {
        return event == XMLStreamConstants.CHARACTERS || event == XMLStreamConstants.CDATA;
    }

    /** Reads to the end, where a second root element is an error. */
    void finish() throws XMLStreamException {
        while (hasNext()) {
            next();
        }
    }
}
