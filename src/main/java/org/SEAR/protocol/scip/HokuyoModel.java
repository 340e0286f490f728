// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.scip;

import java.util.Locale;
import org.SEAR.protocol.lidar.LidarModel;

/**
 * Hokuyo scanners: their answers to PP and VV, and their codes instead of distances. Angle of a step: (step - front) *
 * 360 degrees / steps per turn, counter-clockwise seen from above. Sources: SCIP 2.0 specification; answers of real
 * devices.
 */
public enum HokuyoModel {
    /** 5.6 m, 240 degrees, 10 scans per second, RS-232 at 19200 baud. */
    URG_04LX(LidarModel.URG_04LX, "URG-04LX(Hokuyo Automatic Co.,Ltd.)", "SOKUIKI Sensor URG-04LX",
        "3.1.00(18/Jan./2007)", new int[] {20, 5600}, new int[] {1024, 44, 725, 384, 768}, 600, new int[] {0, 6, 19}),
    /** 60 m (30 m guaranteed), 270 degrees, 40 scans per second, USB. */
    UTM_30LX(LidarModel.UTM_30LX, "UTM-30LX(Hokuyo Automatic Co.,Ltd.)", "SOKUIKI Sensor TOP-URG UTM-30LX",
        "1.20.02(16/Jul./2013)",
        new int[] {23, 60000}, new int[] {1440, 0, 1080, 540, 1080}, 2400, new int[] {1, 2, 3});

    /** Bit rate that stands for USB, bits per second; the host's baud rate does not matter there. */
    public static final int USB = 12_000_000;
    private static final double CIRCLE = 360;
    private static final double SECONDS_A_MINUTE = 60;
    private static final int DIGITS = 6;

    private final LidarModel lidar;
    private final String modelText;
    private final String product;
    private final String firmware;
    private final int[] distances;
    private final int[] steps;
    private final int turns;
    private final int[] codes;

    /**
     * @param distances minimum and maximum, millimetres
     * @param steps of a turn; first and last measured step; front step; last step that a command can request
     * @param turns per minute
     * @param codes instead of a distance: no hit, too near, not measured
     */
    HokuyoModel(LidarModel lidar, String modelText, String product, String firmware, int[] distances, int[] steps,
        int turns, int[] codes) {
        this.lidar = lidar;
        this.modelText = modelText;
        this.product = product;
        this.firmware = firmware;
        this.distances = distances;
        this.steps = steps;
        this.turns = turns;
        this.codes = codes;
    }

    /** Finds the scanner of a LIDAR model; null for other makers. */
    public static HokuyoModel of(LidarModel lidar) {
        for (HokuyoModel model : values()) {
            if (model.lidar == lidar) {
                return model;
            }
        }
        return null;
    }

    /** Command that sets a baud rate: {@code SS019200}. */
    public static String baudCommand(int rate) {
        return String.format(Locale.ROOT, "SS%0" + DIGITS + "d", rate);
    }

    /** Catalogue name, for example {@code URG-04LX}. */
    public String getName() {
        return lidar.getName();
    }

    /** Its row in the table of LIDAR models. */
    public LidarModel getLidar() {
        return lidar;
    }

    /** Text of PP's line MODL. */
    public String getModelText() {
        return modelText;
    }

    /** Text of VV's line PROD. */
    public String getProduct() {
        return product;
    }

    /** Text of VV's line FIRM. */
    public String getFirmware() {
        return firmware;
    }

    /** Minimum distance, millimetres; smaller values are codes. */
    public int getLeast() {
        return distances[0];
    }

    /** Maximum distance, millimetres. */
    public int getGreatest() {
        return distances[1];
    }

    /** Steps per turn. */
    public int getSteps() {
        return steps[0];
    }

    /** First measured step. */
    public int getFirst() {
        return steps[1];
    }

    /** Last measured step. */
    public int getLast() {
        return steps[2];
    }

    /** Step that looks ahead. */
    public int getFront() {
        return steps[3];
    }

    /** Last step that a command can request; unmeasured steps return a code. */
    public int getLastAsked() {
        return steps[4];
    }

    /** Motor speed, turns per minute. */
    public int getTurns() {
        return turns;
    }

    /** Duration of a scan, seconds. */
    public double getScanTime() {
        return SECONDS_A_MINUTE / turns;
    }

    /** Angle between two steps, degrees. */
    public double getStepAngle() {
        return CIRCLE / getSteps();
    }

    /** Whether it lacks RS-232. */
    public boolean isUsbOnly() {
        return this == UTM_30LX;
    }

    /** Code for no hit within the range. */
    public int getNothing() {
        return codes[0];
    }

    /** Code for a hit nearer than {@link #getLeast}. */
    public int getTooNear() {
        return codes[1];
    }

    /** Code for a step that is not measured. */
    public int getNotMeasured() {
        return codes[2];
    }
}
