// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.tiff;

import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.SEAR.files.FileLimits;

/** Unpacks a strip or tile into an array of fixed size, which packed data cannot exceed. Any thread. */
final class TiffDecoder {
    static final int NONE = 1;
    private static final int LZW = 5;
    private static final int DEFLATE = 8;
    private static final int OLD_DEFLATE = 32946;
    private static final int PACK_BITS = 32773;
    private static final Map<Integer, String> OTHERS = Map.of(2, "CCITT", 3, "CCITT fax 3", 4, "CCITT fax 4", 6,
        "old JPEG", 7, "JPEG", 34712, "JPEG 2000", 34887, "LERC", 34925, "LZMA", 50000, "ZSTD", 50001, "WebP");

    private TiffDecoder() {
    }

    /** Throws for an unsupported compression. */
    static void require(String file, int compression) throws IOException {
        if (compression != NONE && compression != LZW && compression != DEFLATE && compression != OLD_DEFLATE
            && compression != PACK_BITS) {
            throw FileLimits.wrong(file, "Compression", compression + OTHERS.entrySet().stream()
                .filter(other -> other.getKey() == compression)
                .map(other -> " (" + other.getValue() + ")").findAny().orElse(""),
                "1 (none), 5 (LZW), 8 (deflate) or 32773 (PackBits), "
                + "for example by gdal_translate -co COMPRESS=DEFLATE");
        }
    }

    /**
     * Unpacks until the array is full.
     * @param what name of the strip or tile in messages
     * @throws IOException if the data is broken or too short
     */
    static void unpack(String file, String what, int compression, byte[] packed, byte[] into) throws IOException {
        int count;
        if (compression == LZW) {
            count = TiffLzw.unpack(file, what, packed, into);
        } else if (compression == PACK_BITS) {
            count = packBits(packed, into);
        } else {
            count = inflate(file, what, packed, into);
        }
        if (count < into.length) {
            throw FileLimits.wrong(file, what, "cut off after " + count + " bytes", "at least " + into.length);
        }
    }

    private static int inflate(String file, String what, byte[] packed, byte[] into) throws IOException {
        Inflater inflater = new Inflater();
        try {
            inflater.setInput(packed);
            int count = 0;
            int more = 1;
            while (more > 0 && count < into.length) {
                more = inflater.inflate(into, count, into.length - count);
                count += more;
            }
            return count;
        } catch (DataFormatException e) {
            throw new IOException(file + ": " + what + " is broken (" + e.getMessage() + "), legal: deflate", e);
        } finally {
            inflater.end();
        }
    }

    /**
     * PackBits, TIFF 6.0, section 9: a count of 0 to 127 precedes count + 1 literal bytes; -1 to -127 repeats the next
     * byte 1 - count times.
     */
    private static int packBits(byte[] packed, byte[] into) {
        int in = 0;
        int out = 0;
        while (in < packed.length - 1 && out < into.length) {
            int count = packed[in++];
            if (count >= 0) {
                int length = Math.min(Math.min(count + 1, packed.length - in), into.length - out);
                System.arraycopy(packed, in, into, out, length);
                in += count + 1;
                out += length;
            } else if (count > -128) {
                int end = Math.min(out + 1 - count, into.length);
                Arrays.fill(into, out, end, packed[in++]);
                out = end;
            }
        }
        return out;
    }
}
