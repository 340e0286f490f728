// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.tiff;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Reverses the predictors of TIFF. Predictor 2 stores differences to the left value (TIFF 6.0, section 14). Predictor 3
 * groups the bytes of a row by significance and stores their differences (Adobe Photoshop TIFF Technical Note 3).
 */
final class TiffPredictor {
    private TiffPredictor() {
    }

    /**
     * Reverses a row in place; after predictor 3 the values are big-endian.
     * @param at index of the row's first byte
     * @param samples adjacent values per pixel
     * @param size bytes per value
     */
    static void undo(int predictor, byte[] bytes, int at, int columns, int samples, int size, ByteOrder order) {
        if (predictor == 2 && size == 1) {
            sumBytes(bytes, at, columns * samples, samples);
        } else if (predictor == 2) {
            sumValues(ByteBuffer.wrap(bytes).order(order), at, columns * samples, samples, size);
        } else if (predictor == 3) {
            sumBytes(bytes, at, columns * samples * size, samples);
            sort(bytes, at, columns * samples, size);
        }
    }

    private static void sumBytes(byte[] bytes, int at, int count, int step) {
        for (int i = at + step; i < at + count; i++) {
            bytes[i] += bytes[i - step];
        }
    }

    private static void sumValues(ByteBuffer row, int at, int count, int step, int size) {
        int end = at + count * size;
        int back = step * size;
        for (int i = at + back; i < end; i += size) {
            if (size == 2) {
                row.putShort(i, (short) (row.getShort(i) + row.getShort(i - back)));
            } else if (size == 4) {
                row.putInt(i, row.getInt(i) + row.getInt(i - back));
            } else {
                row.putLong(i, row.getLong(i) + row.getLong(i - back));
            }
        }
    }

    private static void sort(byte[] bytes, int at, int count, int size) {
        byte[] ranked = new byte[count * size];
        System.arraycopy(bytes, at, ranked, 0, ranked.length);
        for (int i = 0; i < count; i++) {
            for (int rank = 0; rank < size; rank++) {
                bytes[at + i * size + rank] = ranked[rank * count + i];
            }
        }
    }
}
