package org.SEAR.devices.lms;

import org.SEAR.sensors.LidarScan;

/**
 * The telegrams with measured values: B0h, B6h, B7h, BFh, for example {@code B0 B5 00 | 181 words | 10}. Collects as many scans as the kind asks for
 * and then writes their mean. Source: SICK telegram listing, chapters 7 and 10.
 */
final class ScanReply {
    private static final int PARTIAL_FLAG = 1 << 13;
    private static final int PARTIAL_SHIFT = 11;
    private static final int UNIT_SHIFT = 14;
    private static final int QUARTERS = 4;

    private final ScanKind kind;
    private final Variant variant;
    private final Configuration configuration;
    private final double[] sums;
    private final int[] counts;
    private final int[] beyond;
    private int collected;

    ScanReply(ScanKind kind, Variant variant, Configuration configuration) {
        this.kind = kind;
        this.variant = variant;
        this.configuration = configuration;
        this.sums = new double[variant.getValues()];
        this.counts = new int[variant.getValues()];
        this.beyond = new int[variant.getValues()];
    }

    /** Takes a scan of the variant's fan. @return whether that was the last one */
    boolean add(LidarScan scan) {
        double limit = (configuration.getMode().getBeyondRange() - 1.0) / configuration.getUnitsPerMetre();
        for (int i = 0; i < sums.length; i++) {
            double range = scan.range(i);
            if (range > limit + 0.5 / configuration.getUnitsPerMetre()) {
                beyond[i] += Double.isInfinite(range) ? 0 : 1;
            } else if (!Double.isNaN(range)) {
                sums[i] += range;
                counts[i]++;
            }
        }
        return ++collected >= kind.scans;
    }

    /**
     * Command, values and status.
     *
     * @param partial which partial scan, from 0; looked at only by that kind
     * @param scanIndex and @param telegramIndex appended if the configuration asks for them
     */
    byte[] toBytes(int partial, int scanIndex, int telegramIndex, int status) {
        Payload payload;
        switch (kind.form) {
            case MEAN:
                payload = new Payload(0xB6).add(kind.scans);
                break;
            case RANGE:
                payload = new Payload(0xB7).word(kind.first).word(last());
                break;
            case MEAN_RANGE:
                payload = new Payload(0xBF).add(kind.scans).word(kind.first).word(last());
                break;
            default:
                payload = new Payload(0xB0);
                break;
        }
        writeValues(payload, partial);
        if (configuration.isSendingIndices()) {
            payload.add(scanIndex).add(telegramIndex);
        }
        return payload.add(status).toBytes();
    }

    private void writeValues(Payload payload, int partial) {
        int unit = configuration.getUnit() << UNIT_SHIFT;
        switch (kind.form) {
            case MINIMUM:
                payload.word(1 | unit).word(minimum());
                break;
            case PARTIAL:
                int turns = variant.getTurns();
                int which = partial % turns;
                write(payload, unit | PARTIAL_FLAG | which * QUARTERS / turns << PARTIAL_SHIFT, which, turns, sums.length - 1);
                break;
            case RANGE:
            case MEAN_RANGE:
                write(payload, unit, kind.first - 1, 1, last() - 1);
                break;
            default:
                write(payload, unit, 0, kind.stride, sums.length - 1);
                break;
        }
    }

    private void write(Payload payload, int flags, int from, int stride, int to) {
        int count = from > to ? 0 : (to - from) / stride + 1;
        payload.word(count | flags);
        for (int i = from; i <= to; i += stride) {
            payload.word(kind.form == ScanKind.Form.CONTOUR ? configuration.getMode().getNothingHit() : value(i));
        }
    }

    private int last() {
        return Math.min(kind.last, sums.length);
    }

    private int value(int i) {
        if (counts[i] > 0) {
            return configuration.getMode().encode(sums[i] / counts[i], configuration.getUnitsPerMetre());
        }
        return beyond[i] > 0 ? configuration.getMode().getBeyondRange() : configuration.getMode().getNothingHit();
    }

    /** The smallest distance measured at right angles to the line from 0 to 180 degrees. */
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
