// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.zip.CRC32;

/**
 * Checks that a PNG, JPEG or GIF is complete, and that a PNG's checksums are right. Decoders may fill an incomplete
 * picture with grey. Any thread.
 */
final class WholePicture {
    private static final int PNG = 0x89504e47;
    private static final int PNG_HEAD = 8;
    private static final int PNG_END = 0x49454e44;
    /** Bit in the type of a part that no pixel needs. */
    private static final int PNG_EXTRA = 0x20000000;
    private static final int GIF = 0x47494638;
    private static final int JPEG = 0xffd8ff;
    private static final int SCAN = 0xda;
    private static final int JPEG_END = 0xd9;

    private WholePicture() {
    }

    /**
     * Checks a picture's parts; accepts other formats unchecked.
     *
     * @throws UnreadablePicture with the file and the damage
     */
    static void require(byte[] bytes, String name) throws IOException {
        int magic = bytes.length < 4 ? 0 : ByteBuffer.wrap(bytes).getInt();
        if (magic == PNG) {
            requirePng(bytes, name);
        } else if (magic >>> 8 == JPEG && !hasJpegEnd(bytes) || magic == GIF && bytes[bytes.length - 1] != ';'
            && !hasEndBefore(bytes)) {
            throw broken(name, "its end is missing: is it cut off?");
        }
    }

    private static UnreadablePicture broken(String name, String what) {
        return new UnreadablePicture(name + ": the picture is broken (" + what + "), legal: a whole picture", null);
    }

    private static void requirePng(byte[] bytes, String name) throws IOException {
        ByteBuffer in = ByteBuffer.wrap(bytes);
        CRC32 sum = new CRC32();
        long at = PNG_HEAD;
        while (at + 12 <= bytes.length) {
            long length = Integer.toUnsignedLong(in.getInt((int) at));
            if (at + 12 + length > bytes.length) {
                break;
            }
            int type = in.getInt((int) at + 4);
            sum.reset();
            sum.update(bytes, (int) at + 4, (int) length + 4);
            if ((type & PNG_EXTRA) == 0 && (int) sum.getValue() != in.getInt((int) (at + 8 + length))) {
                throw broken(name, "the checksum of its part at byte " + at + " is wrong");
            }
            if (type == PNG_END) {
                return;
            }
            at += 12 + length;
        }
        throw broken(name, "its end is missing after byte " + at + ": is it cut off?");
    }

    /** Returns whether the end precedes a padding of zeros, which some programs write. */
    private static boolean hasEndBefore(byte[] bytes) {
        int last = bytes.length - 1;
        while (last > 0 && bytes[last] == 0) {
            last--;
        }
        return bytes[last] == ';';
    }

    /**
     * Returns whether FF D9 follows the first scan's header, where it can only be the end. A thumbnail in the metadata
     * before it has its own end.
     */
    private static boolean hasJpegEnd(byte[] bytes) {
        int at = 2;
        while (at + 4 <= bytes.length && (bytes[at] & 0xff) == 0xff && (bytes[at + 1] & 0xff) != SCAN) {
            boolean filled = (bytes[at + 1] & 0xff) == 0xff;
            at += filled ? 1 : 2 + ((bytes[at + 2] & 0xff) << 8 | bytes[at + 3] & 0xff);
        }
        for (int i = at; i + 1 < bytes.length; i++) {
            if ((bytes[i] & 0xff) == 0xff && (bytes[i + 1] & 0xff) == JPEG_END) {
                return true;
            }
        }
        return false;
    }
}
