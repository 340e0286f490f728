package org.SEAR.files;

import java.io.IOException;

/** What is wrong with a file of somebody's, and how large pictures may be; docs/projects.md has the same numbers. Any thread. */
public final class FileLimits {
    /** Bytes of a picture's file. */
    public static final int MAX_PICTURE = 64 << 20;
    /** Pixels of a picture, width times height. */
    static final long MAX_PIXELS = 32_000_000;
    /** Characters of a value that are told. */
    private static final int REPORTED = 80;

    private FileLimits() {
    }

    /**
     * Says what is wrong with a file.
     *
     * @param what the field of the file
     * @param legal what would have been right
     */
    public static IOException wrong(String file, String what, Object value, String legal) {
        String text = String.valueOf(value);
        return new IOException(file + ": " + what + " is " + (text.length() > REPORTED ? text.substring(0, REPORTED)
            + "..." : text) + ", legal: " + legal);
    }

    /**
     * Refuses a value outside of a range.
     *
     * @throws IOException that names it
     */
    public static void range(String file, String what, long value, long low, long high) throws IOException {
        if (value < low || value > high) {
            throw wrong(file, what, value, low + " to " + high);
        }
    }
}
