// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.cola;

import java.util.List;
import org.SEAR.protocol.lidar.LidarModel;

/**
 * Differences between CoLa scanners, as data. A further scanner is a further row here and in {@link LidarModel}.
 * Sources: SICK's telegram listing, recorded telegrams, {@code sick_scan_xd}.
 */
enum ColaModel {
    LMS111(LidarModel.LMS111, "LMS10x_FieldEval", "V1.36-21.10.2010", 7, 15, true, new ScanRate(5000, 5000, 360),
        new ScanRate(2500, 2500, 360), new ScanRate(2500, 5000, 360)),
    TIM561(LidarModel.TIM561, "TiM561", "V2.60-20.02.15", 1, 8, false, new ScanRate(1500, 3333, 162)),
    /** Has exactly the rate of its object. */
    COLA(LidarModel.COLA, "SEAR", "V1.00-22.11.2026", 0, 1, false);

    /** A valid combination of scan rate, angular resolution and measurement rate. Immutable. */
    static final class ScanRate {
        /** Scan rate, 1/100 Hz. */
        final int frequency;
        /** Angle between measurements, 1/10000 degree, truncated: 3333 is a third. */
        final int resolution;
        /** Measurement rate, 100 measurements per second. */
        final int beams;

        ScanRate(int frequency, int resolution, int beams) {
            this.frequency = frequency;
            this.resolution = resolution;
            this.beams = beams;
        }

        /** Scan rate, Hz. */
        double hertz() {
            return frequency / 100.0;
        }

        /** Angle between measurements, degrees. */
        double degrees() {
            return resolution == THIRD ? 1 / 3.0 : resolution / TEN_THOUSANDTHS;
        }
    }

    /** Units of the protocol's angles per degree. */
    static final double TEN_THOUSANDTHS = 10000;
    /** Straight ahead, 1/10000 degree. */
    static final int FORWARD = 900000;
    private static final int THIRD = 3333;
    /** Scan rate, Hz, of a model without rates of its own. */
    private static final int HERTZ = 10;
    private static final int CENTI = 100;
    private static final double CIRCLE = 360;

    final LidarModel lidar;
    final String type;
    final String version;
    /** Second word of the digital outputs in a scan: a bit per output. */
    final int outputs;
    /** Time from power-on to the first measurement, seconds. */
    final double boot;
    /** Whether mLMPsetscancfg can set frequency and resolution. */
    final boolean scanConfigurable;
    /** First and last angle of the whole range, 1/10000 degree. */
    final int firstAngle;
    final int lastAngle;
    final List<ScanRate> rates;

    ColaModel(LidarModel lidar, String type, String version, int outputs, double boot, boolean scanConfigurable,
        ScanRate... rates) {
        this.lidar = lidar;
        this.type = type;
        this.version = version;
        this.outputs = outputs;
        this.boot = boot;
        this.scanConfigurable = scanConfigurable;
        int half = (int) Math.round(lidar.getWidestSpread() / 2 * TEN_THOUSANDTHS);
        this.firstAngle = FORWARD - half;
        this.lastAngle = FORWARD + half;
        this.rates = List.of(rates);
    }

    /**
     * Finds the row of a LIDAR model.
     *
     * @throws IllegalArgumentException if there is none
     */
    static ColaModel of(LidarModel lidar) {
        for (ColaModel model : values()) {
            if (model.lidar == lidar) {
                return model;
            }
        }
        throw new IllegalArgumentException("SEAR has no CoLa firmware for " + lidar.withArticle());
    }

    /** Returns the rate whose resolution is nearest to an angle in degrees; the fastest if several are equally near. */
    ScanRate rateWith(double degrees) {
        if (rates.isEmpty()) {
            return new ScanRate(HERTZ * CENTI, (int) Math.round(degrees * TEN_THOUSANDTHS),
                (int) Math.round(CIRCLE / degrees * HERTZ / CENTI));
        }
        ScanRate nearest = rates.get(0);
        for (ScanRate rate : rates) {
            if (Math.abs(rate.degrees() - degrees) < Math.abs(nearest.degrees() - degrees)) {
                nearest = rate;
            }
        }
        return nearest;
    }
}
