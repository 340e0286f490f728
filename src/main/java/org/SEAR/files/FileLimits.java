// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.io.IOException;

/** Error messages for files, and limits of pictures, documented in docs/projects.md. Any thread. */
public final class FileLimits {
    /** Most bytes of a picture's file. */
    public static final int MAX_PICTURE = 64 << 20;
    /** Most pixels of a picture, width times height. */
    static final long MAX_PIXELS = 32_000_000;
    /** Most characters of a value in a message. */
    private static final int REPORTED = 80;

    private FileLimits() {
    }

    /**
     * Returns an error about a file.
     *
     * @param what the field of the file
     * @param legal legal values
     */
    public static InvalidFile wrong(String file, String what, Object value, String legal) {
        return wrong(file, what, value, legal, null);
    }

    /**
     * Returns an error about a file.
     *
     * @param what the field of the file
     * @param legal legal values
     * @param cause what a reader threw; null for none
     */
    public static InvalidFile wrong(String file, String what, Object value, String legal, Exception cause) {
        String text = String.valueOf(value);
        return new InvalidFile(PrintableText.line(file) + ": " + PrintableText.line(what) + " is "
            + PrintableText.line(text.length() > REPORTED
            ? text.substring(0, REPORTED) + "..." : text) + ", legal: " + legal, cause);
    }

    /**
     * Throws if a value is out of range.
     *
     * @throws IOException with the value
     */
    public static void range(String file, String what, long value, long low, long high) throws IOException {
        if (value < low || value > high) {
            throw wrong(file, what, value, low + " to " + high);
        }
    }
}
