// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.scip;

import java.nio.charset.StandardCharsets;

/**
 * Writes a sensor's reply line by line: echo, status, then text, properties or distances, each line with its checksum,
 * and an empty line.
 */
public final class ReplyWriter {
    private final StringBuilder out = new StringBuilder();

    /**
     * @param echo the command as received
     * @param status two characters, see {@link ScipStatus}
     */
    public ReplyWriter(String echo, String status) {
        out.append(echo).append('\n');
        line(status);
    }

    /** Appends a line and its checksum. */
    public ReplyWriter line(CharSequence text) {
        out.append(text).append(Checksum.of(text)).append('\n');
        return this;
    }

    /** Appends a line such as {@code DMIN:20;4}. */
    public ReplyWriter property(String name, Object value) {
        String text = name + ":" + value;
        return counted(text, text);
    }

    /**
     * Appends a property line with a checksum of only a part of it.
     *
     * @param counted the part of the text in the checksum
     */
    public ReplyWriter counted(String text, String counted) {
        out.append(text).append(';').append(Checksum.of(counted)).append('\n');
        return this;
    }

    /** @param milliseconds its low 24 bits are sent */
    public ReplyWriter time(long milliseconds) {
        StringBuilder text = new StringBuilder();
        Encoding.append(text, (int) Math.floorMod(milliseconds, (long) Encoding.TIME_WRAP), Encoding.TIME);
        return line(text);
    }

    /**
     * Appends distances or codes, in lines of 64 characters.
     *
     * @param characters per value; larger values are clamped
     */
    public ReplyWriter values(int[] values, int characters) {
        StringBuilder text = new StringBuilder(values.length * characters);
        for (int value : values) {
            Encoding.append(text, Math.min(value, Encoding.max(characters)), characters);
        }
        for (int from = 0; from < text.length(); from += Reply.LINE) {
            line(text.subSequence(from, Math.min(text.length(), from + Reply.LINE)));
        }
        return this;
    }

    /** Returns the whole reply. */
    public byte[] toBytes() {
        return (out + "\n").getBytes(StandardCharsets.ISO_8859_1);
    }
}
