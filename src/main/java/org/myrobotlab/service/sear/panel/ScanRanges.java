// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Base64;

/**
 * A scan encoded for panels with 16 bits per beam, less than half of the numbers' text. Base64 of unsigned numbers, low
 * byte first: the unit in tenths of a millimetre, as fine as the longest range allows, then the range of each beam in
 * this unit, 65535 without a hit. {@code world/ranges.js} decodes it. Immutable.
 */
final class ScanRanges {
    private static final double TENTHS = 1e4;
    private static final int NOTHING = 0xffff;

    private final double[] metres;

    /** @param metres range of each beam; infinite or NaN without a hit */
    ScanRanges(double[] metres) {
        this.metres = metres.clone();
    }

    int size() {
        return metres.length;
    }

    /** Returns metres; infinite or NaN without a hit. */
    double get(int beam) {
        return metres[beam];
    }

    /** Returns whether the range in metres is a hit. */
    static boolean isHit(double range) {
        return !Double.isNaN(range) && !Double.isInfinite(range);
    }

    String text() {
        double farthest = 0;
        for (double range : metres) {
            farthest = isHit(range) ? Math.max(farthest, range) : farthest;
        }
        int unit = (int) Math.max(1, Math.min(NOTHING, Math.ceil(farthest * TENTHS / (NOTHING - 1))));
        ByteBuffer numbers = ByteBuffer.allocate(Short.BYTES * (metres.length + 1)).order(ByteOrder.LITTLE_ENDIAN);
        numbers.putShort((short) unit);
        for (double range : metres) {
            numbers.putShort((short) (isHit(range) ? Math.round(Math.max(0, range) * TENTHS / unit) : NOTHING));
        }
        return Base64.getEncoder().encodeToString(numbers.array());
    }
}
