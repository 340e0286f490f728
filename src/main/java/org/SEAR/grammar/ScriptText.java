package org.SEAR.grammar;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.Paths;

/** Texts as a Python 2 script hands them over. Any thread. */
public final class ScriptText {
    private static final int ASCII_END = 0x80;
    private static final int BYTE_END = 0x100;

    private ScriptText() {
    }

    /**
     * The text that the script's author wrote. In Python 2 a plain {@code "Tür"} is a string of UTF-8 bytes, and Jython makes one character
     * of each: such a string becomes the text that the bytes spell. All others, {@code u"Tür"} too, stay as they are.
     *
     * @param text may be null
     */
    public static String of(String text) {
        if (text == null || text.chars().allMatch(c -> c < ASCII_END) || text.chars().anyMatch(c -> c >= BYTE_END)) {
            return text;
        }
        try {
            return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(text.getBytes(StandardCharsets.ISO_8859_1))).toString();
        } catch (CharacterCodingException e) {
            return text;
        }
    }

    /**
     * A path that a script names.
     *
     * @param text of it, not null
     * @throws IllegalArgumentException if no file of this system can be called so
     */
    public static Path path(String text) {
        try {
            return Paths.get(of(text));
        } catch (InvalidPathException e) {
            throw new IllegalArgumentException("the path is \"" + of(text).replaceAll("\\p{Cntrl}", "?") + "\", legal: what a file can be called"
                + " here (" + e.getReason() + ")", e);
        }
    }
}
