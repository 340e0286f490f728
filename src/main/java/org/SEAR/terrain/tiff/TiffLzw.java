// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.tiff;

import java.io.IOException;
import org.SEAR.files.FileLimits;

/** LZW of TIFF 6.0, section 13: codes of 9 to 12 bits, most significant bit first, widened one code early. */
final class TiffLzw {
    private static final int CLEAR = 256;
    private static final int END = 257;
    private static final int CODES = 4096;
    private static final int FIRST_BITS = 9;
    private static final int MAX_BITS = 12;

    private final byte[] packed;
    private final byte[] into;
    /** Start and length of each code's bytes in the output. */
    private final int[] start = new int[CODES];
    private final int[] length = new int[CODES];
    private int bitsRead;

    private TiffLzw(byte[] packed, byte[] into) {
        this.packed = packed;
        this.into = into;
    }

    /** Unpacks at most into.length bytes and returns their number. */
    static int unpack(String file, String what, byte[] packed, byte[] into) throws IOException {
        if (packed.length > 1 && packed[0] == 0 && (packed[1] & 1) == 1) {
            throw FileLimits.wrong(file, what, "packed with LZW from before TIFF 6.0",
                "LZW of TIFF 6.0, as GDAL writes it");
        }
        int count = new TiffLzw(packed, into).unpack();
        if (count < 0) {
            throw FileLimits.wrong(file, what, "broken (an undefined LZW code)", "LZW");
        }
        return count;
    }

    private int unpack() {
        int out = 0;
        int next = END + 1;
        int bits = FIRST_BITS;
        int lastStart = 0;
        int lastLength = 0;
        for (int code = code(bits); code >= 0 && code != END && out < into.length; code = code(bits)) {
            if (code == CLEAR) {
                next = END + 1;
                bits = FIRST_BITS;
                lastLength = 0;
                continue;
            }
            if (lastLength > 0 && next < CODES) {
                // the bytes of the previous code and the first byte of this code, which follows them
                start[next] = lastStart;
                length[next] = lastLength + 1;
                next++;
            }
            if (code >= next) {
                return -1;
            }
            lastStart = out;
            if (code < CLEAR) {
                into[out++] = (byte) code;
                lastLength = 1;
            } else {
                lastLength = length[code];
                int end = (int) Math.min((long) out + lastLength, into.length);
                for (int from = start[code]; out < end; from++) {
                    into[out++] = into[from];
                }
            }
            if (next + 1 >= 1 << bits && bits < MAX_BITS) {
                bits++;
            }
        }
        return out;
    }

    private int code(int bits) {
        int at = bitsRead >> 3;
        if ((long) bitsRead + bits > 8L * packed.length) {
            return -1;
        }
        int window = (packed[at] & 0xff) << 16 | (at + 1 < packed.length ? packed[at + 1] & 0xff : 0) << 8
            | (at + 2 < packed.length ? packed[at + 2] & 0xff : 0);
        int code = window >> 24 - (bitsRead & 7) - bits & (1 << bits) - 1;
        bitsRead += bits;
        return code;
    }
}
