// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.regex.Pattern;

/** Adapts source code to Python 2. */
final class PythonSource {
    private static final byte[] UTF_8_MARK = {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF};
    /** Encoding declaration as in PEP 263. */
    private static final Pattern ENCODING =
        Pattern.compile("\\A(?:[^\\n]*\\n)?[ \\t\\f]*#[^\\n]*?coding[:=][ \\t]*[-_.a-zA-Z0-9]+");

    private PythonSource() {
    }

    /**
     * Makes code without an encoding declaration UTF-8, where Python 2 expects ASCII. Ignores the byte order mark that
     * Windows editors write.
     */
    static byte[] withEncoding(byte[] code) {
        if (isMarked(code)) {
            return withEncoding(Arrays.copyOfRange(code, UTF_8_MARK.length, code.length));
        }
        if (isAscii(code) || ENCODING.matcher(new String(code, StandardCharsets.ISO_8859_1)).find()) {
            return code;
        }
        byte[] marked = new byte[UTF_8_MARK.length + code.length];
        System.arraycopy(UTF_8_MARK, 0, marked, 0, UTF_8_MARK.length);
        System.arraycopy(code, 0, marked, UTF_8_MARK.length, code.length);
        return marked;
    }

    private static boolean isMarked(byte[] code) {
        return code.length >= UTF_8_MARK.length && Arrays.equals(Arrays.copyOf(code, UTF_8_MARK.length), UTF_8_MARK);
    }

    private static boolean isAscii(byte[] code) {
        for (byte one : code) {
            if (one < 0) {
                return false;
            }
        }
        return true;
    }
}
