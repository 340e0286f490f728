// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import java.io.IOException;
import org.SEAR.files.FileLimits;
import org.xml.sax.Attributes;

/** Attributes of an element of an OGRE mesh; each error names the line and the element. */
final class OgreAttributes {
    final String element;
    final int line;
    private final String file;
    private final Attributes given;

    OgreAttributes(String file, String element, int line, Attributes given) {
        this.file = file;
        this.element = element;
        this.line = line;
        this.given = given;
    }

    /** Throws if the element is at a wrong place. */
    void require(boolean right, String legal) throws IOException {
        if (!right) {
            throw FileLimits.wrong(file, "<" + element + "> in line " + line, "at a wrong place", legal);
        }
    }

    /** Returns the text of an attribute; null if it is missing. */
    String text(String name) {
        return given.getValue(name);
    }

    IOException wrong(String name, String legal) {
        String value = given.getValue(name);
        return FileLimits.wrong(file, name + " of <" + element + "> in line " + line, value == null ? "missing" : value,
            legal);
    }

    /** Returns a number, finite or not. */
    float number(String name) throws IOException {
        try {
            return Float.parseFloat(String.valueOf(given.getValue(name)));
        } catch (NumberFormatException e) {
            throw wrong(name, "a number with a decimal point");
        }
    }

    /** Returns a whole number that is not negative. */
    int whole(String name, int most) throws IOException {
        try {
            int value = Integer.parseInt(String.valueOf(given.getValue(name)).trim());
            if (value >= 0 && value <= most) {
                return value;
            }
        } catch (NumberFormatException e) {
            throw wrong(name, "a whole number from 0 to " + most);
        }
        throw wrong(name, "a whole number from 0 to " + most);
    }
}
