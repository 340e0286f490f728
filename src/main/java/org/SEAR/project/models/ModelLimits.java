package org.SEAR.project.models;

import java.io.IOException;

/** How large models and pictures may be; docs/projects.md has the same numbers. Generous for what people draw, and far below what stops a program. */
public final class ModelLimits {
    /** Bytes of a model's file. */
    static final long MAX_FILE = 256L << 20;
    /** Bytes of a .blend that is packed with gzip, when unpacked. */
    static final int MAX_BLEND = 64 << 20;
    /** Bytes of a picture's file. */
    static final int MAX_PICTURE_FILE = 64 << 20;
    /** Pixels of a picture, width times height. */
    static final long MAX_PIXELS = 32_000_000;
    /** Nodes of a model's scene. */
    static final int MAX_NODES = 10_000;
    /** How deep nodes may be nested. */
    static final int MAX_DEPTH = 100;
    /** Triangles and vertices of a model, each; a mesh that several nodes show counts each time. */
    static final int MAX_TRIANGLES = 4_000_000;
    /** Metres from the model's origin in each direction, before the object's scale. */
    static final float MAX_COORDINATE = 1e6f;

    private ModelLimits() {
    }

    /**
     * Says what is wrong with a model's file.
     *
     * @param what the field of the file
     * @param legal what would have been right
     */
    public static IOException wrong(String file, String what, Object value, String legal) {
        String text = String.valueOf(value);
        return new IOException(file + ": " + what + " is " + (text.length() > 80 ? text.substring(0, 80) + "..." : text) + ", legal: " + legal);
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
