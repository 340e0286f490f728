package org.myrobotlab.service.sear.panel;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Base64;

/**
 * A scan as panels get it: a text of 16 bits for each beam, which is less than half of what its numbers would be. Base64 of unsigned numbers, the
 * lower byte first: the unit in tenths of millimetres, as fine as the farthest beam allows, then for each beam how many of them, 65535 where nothing
 * was hit. {@code world/ranges.js} reads it. Immutable.
 */
final class ScanRanges {
    private static final double TENTHS = 1e4;
    private static final int NOTHING = 0xffff;

    private final double[] metres;

    /** @param metres infinite or no number where nothing was hit */
    ScanRanges(double[] metres) {
        this.metres = metres.clone();
    }

    int size() {
        return metres.length;
    }

    /** Infinite or no number where nothing was hit. */
    double get(int beam) {
        return metres[beam];
    }

    /** Whether a beam has hit something at so many metres. */
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
