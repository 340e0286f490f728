// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.lms;

import java.util.function.IntToDoubleFunction;
import org.SEAR.protocol.lms.Configuration;
import org.SEAR.protocol.lms.CountWord;
import org.SEAR.protocol.lms.LmsCommand;
import org.SEAR.protocol.lms.LmsPayload;
import org.SEAR.protocol.lms.Variant;

/**
 * Telegrams with measured values: B0h, B6h, B7h, BFh, for example {@code B0 B5 00 | 181 words | 10}. Collects the scans
 * that the format needs, then writes their mean. Source: SICK telegram listing, chapters 7 and 10.
 */
final class ScanReply {
    private static final int QUARTERS = 4;

    private final ScanFormat format;
    private final Variant variant;
    private final Configuration configuration;
    private final double[] sums;
    private final int[] counts;
    private final int[] beyond;
    private int collected;

    ScanReply(ScanFormat format, Variant variant, Configuration configuration) {
        this.format = format;
        this.variant = variant;
        this.configuration = configuration;
        this.sums = new double[variant.getValues()];
        this.counts = new int[variant.getValues()];
        this.beyond = new int[variant.getValues()];
    }

    /**
     * Adds a scan with the variant's angles.
     *
     * @param ranges metres by the number of the beam, from the right
     * @return whether it was the last one
     */
    boolean add(IntToDoubleFunction ranges) {
        double limit = (configuration.getMode().getBeyondRange() - 1.0) / configuration.getUnitsPerMetre();
        for (int i = 0; i < sums.length; i++) {
            double range = ranges.applyAsDouble(i);
            if (range > limit + 0.5 / configuration.getUnitsPerMetre()) {
                beyond[i] += Double.isInfinite(range) ? 0 : 1;
            } else if (!Double.isNaN(range)) {
                sums[i] += range;
                counts[i]++;
            }
        }
        return ++collected >= format.scans;
    }

    /**
     * Returns command, values and status.
     *
     * @param partial number of the partial scan, from 0; used by the partial format only
     * @param scanIndex appended with the next one if the configuration includes indices
     * @param telegramIndex appended likewise
     */
    byte[] toBytes(int partial, int scanIndex, int telegramIndex, int status) {
        LmsPayload payload;
        switch (format.form) {
            case MEAN:
                payload = LmsCommand.MEAN.reply().add(format.scans);
                break;
            case RANGE:
                payload = LmsCommand.RANGE.reply().word(format.first).word(last());
                break;
            case MEAN_RANGE:
                payload = LmsCommand.MEAN_RANGE.reply().add(format.scans).word(format.first).word(last());
                break;
            default:
                payload = LmsCommand.SCAN.reply();
                break;
        }
        writeValues(payload, partial);
        if (configuration.isSendingIndices()) {
            payload.add(scanIndex).add(telegramIndex);
        }
        return payload.add(status).toBytes();
    }

    private void writeValues(LmsPayload payload, int partial) {
        int unit = configuration.getUnit();
        switch (format.form) {
            case MINIMUM:
                payload.word(CountWord.whole(1, unit).toWord()).word(minimum());
                break;
            case PARTIAL:
                int turns = variant.getTurns();
                int which = partial % turns;
                int count = count(which, turns, sums.length - 1);
                write(payload, CountWord.partial(count, unit, which * QUARTERS / turns), which, turns);
                break;
            case RANGE:
            case MEAN_RANGE:
                write(payload, CountWord.whole(count(format.first - 1, 1, last() - 1), unit), format.first - 1, 1);
                break;
            default:
                write(payload, CountWord.whole(count(0, format.stride, sums.length - 1), unit), 0, format.stride);
                break;
        }
    }

    private static int count(int from, int stride, int to) {
        return from > to ? 0 : (to - from) / stride + 1;
    }

    private void write(LmsPayload payload, CountWord count, int from, int stride) {
        payload.word(count.toWord());
        for (int i = 0; i < count.getCount(); i++) {
            payload.word(format.form == ScanFormat.Form.CONTOUR ? configuration.getMode().getNothingHit()
                : value(from + i * stride));
        }
    }

    private int last() {
        return Math.min(format.last, sums.length);
    }

    private int value(int i) {
        if (counts[i] > 0) {
            return configuration.getMode().encode(sums[i] / counts[i], configuration.getUnitsPerMetre());
        }
        return beyond[i] > 0 ? configuration.getMode().getBeyondRange() : configuration.getMode().getNothingHit();
    }

    /** Smallest distance, perpendicular to the line from 0 to 180 degrees, in the configured unit. */
    private int minimum() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < sums.length; i++) {
            if (counts[i] > 0) {
                double fromForward = Math.toRadians(i * variant.getResolution() / 100.0 - variant.getSpread() / 2.0);
                least = Math.min(least, sums[i] / counts[i] * Math.cos(fromForward));
            }
        }
        return configuration.getMode().encode(least, configuration.getUnitsPerMetre());
    }
}
