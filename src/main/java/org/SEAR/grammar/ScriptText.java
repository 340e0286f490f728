// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.Paths;

/** Decoder of texts that a Python 2 script passes. Any thread. */
public final class ScriptText {
    private static final int ASCII_END = 0x80;
    private static final int BYTE_END = 0x100;

    private ScriptText() {
    }

    /**
     * Returns the text as its author wrote it. A plain Python 2 {@code "Tür"} is a string of UTF-8 bytes, and Jython
     * makes one character of each byte: such a string is decoded. Every other text, also {@code u"Tür"}, is returned
     * unchanged.
     *
     * @param text may be null
     */
    public static String of(String text) {
        if (text == null || text.chars().allMatch(c -> c < ASCII_END) || text.chars().anyMatch(c -> c >= BYTE_END)) {
            return text;
        }
        try {
            return StandardCharsets.UTF_8.newDecoder()
                .decode(ByteBuffer.wrap(text.getBytes(StandardCharsets.ISO_8859_1))).toString();
        } catch (CharacterCodingException e) {
            return text;
        }
    }

    /**
     * Parses a path. A relative path of a Python 3 program refers to its working folder, see {@link ScriptFolder}.
     *
     * @param text not null
     * @throws IllegalArgumentException if the text is no valid path on this system
     */
    public static Path path(String text) {
        try {
            return ScriptFolder.resolve(Paths.get(of(text)));
        } catch (InvalidPathException e) {
            throw new IllegalArgumentException("the path is \"" + of(text).replaceAll("\\p{Cntrl}", "?")
                + "\", legal: a valid file name on this system (" + e.getReason() + ")", e);
        }
    }
}
