// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lidar;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Arrays;
import java.util.stream.Collectors;

/** Angle ranges and resolutions of one model, and whether commands can reduce them. Immutable, any thread. */
final class Fans {
    /** Tolerance of an angle, degrees: 0.333 is a third. */
    private static final double TOLERANCE = 5e-4;
    private static final int DECIMALS = 7;

    /** Widest angle, degrees. */
    final double spread;
    /** Smallest angle between measurements, degrees. */
    final double finest;
    private final boolean cut;
    private final double[] resolutions;
    /** Maximum number of measurements merged or skipped to one; 0: any angle from the finest to the coarsest. */
    private final int clusters;

    private Fans(double spread, boolean cut, int clusters, double... resolutions) {
        this.spread = spread;
        this.cut = cut;
        this.clusters = clusters;
        this.resolutions = resolutions;
        this.finest = Arrays.stream(resolutions).min().getAsDouble();
    }

    /** Exactly this angle, with one of these resolutions. */
    static Fans of(double spread, double... resolutions) {
        return new Fans(spread, false, 1, resolutions);
    }

    /** Any angle up to this one, with one of these resolutions. */
    static Fans upTo(double spread, double... resolutions) {
        return new Fans(spread, true, 1, resolutions);
    }

    /** Any angle up to this one, with a resolution of 1 to {@code most} steps. */
    static Fans ofSteps(double spread, double step, int most) {
        return new Fans(spread, true, most, step);
    }

    /** Any angle up to this one, with any resolution between the two. */
    static Fans between(double spread, double finest, double coarsest) {
        return new Fans(spread, true, 0, finest, coarsest);
    }

    /** Whether the model supports an angle and a resolution, degrees. */
    boolean has(double wantedSpread, double wantedResolution) {
        boolean fits = Math.abs(wantedSpread - spread) < TOLERANCE || cut && wantedSpread < spread;
        return fits && hasResolution(wantedResolution);
    }

    private boolean hasResolution(double wanted) {
        if (clusters == 0) {
            return wanted > resolutions[0] - TOLERANCE && wanted < resolutions[1] + TOLERANCE;
        }
        for (double resolution : resolutions) {
            long times = Math.round(wanted / resolution);
            if (times >= 1 && times <= clusters && Math.abs(wanted - times * resolution) < TOLERANCE) {
                return true;
            }
        }
        return false;
    }

    /** Returns the text for users: {@code 100 with 1, 0.5 or 0.25}. */
    @Override
    public String toString() {
        return (cut ? "up to " : "") + format(spread) + " with " + angles();
    }

    private String angles() {
        if (clusters == 0) {
            return format(resolutions[0]) + " to " + format(resolutions[1]);
        }
        if (clusters > 1) {
            return "1 to " + clusters + " times " + format(resolutions[0]);
        }
        String list = Arrays.stream(resolutions).mapToObj(Fans::format).collect(Collectors.joining(", "));
        int last = list.lastIndexOf(", ");
        return last < 0 ? list : list.substring(0, last) + " or " + list.substring(last + 2);
    }

    /** Formats a number without trailing zeros. */
    static String format(double number) {
        BigDecimal decimal = BigDecimal.valueOf(number).setScale(DECIMALS, RoundingMode.HALF_UP).stripTrailingZeros();
        return decimal.signum() == 0 ? "0" : decimal.toPlainString();
    }
}
