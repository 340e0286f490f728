// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.xml;

import com.thoughtworks.xstream.converters.ErrorWriter;
import com.thoughtworks.xstream.io.HierarchicalStreamReader;
import java.util.Collections;
import java.util.Iterator;

/** Reads the line number of an XStream reader, which only reports it to an {@link ErrorWriter}. */
final class LineNumber implements ErrorWriter {
    private static final String LINE = "line number";
    private String line;

    private LineNumber() {
    }

    /** Returns the line where the current element's tag ends; 0 if unknown. */
    static int line(HierarchicalStreamReader reader) {
        LineNumber position = new LineNumber();
        reader.appendErrors(position);
        return position.line == null ? 0 : Integer.parseInt(position.line);
    }

    @Override
    public void add(String name, String information) {
        set(name, information);
    }

    @Override
    public void set(String name, String information) {
        if (name.equals(LINE)) {
            line = information;
        }
    }

    @Override
    public String get(String errorKey) {
        return errorKey.equals(LINE) ? line : null;
    }

    @Override
    public Iterator<String> keys() {
        return Collections.singleton(LINE).iterator();
    }
}
