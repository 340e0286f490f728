package org.SEAR.protocol.scip;

import java.util.Locale;
import org.SEAR.protocol.lidar.LidarModel;

/**
 * The scanners: what they answer to PP and VV, and the codes that they send in place of distances. Angle of a step: (step - front) * 360 degrees /
 * steps of a turn, counter-clockwise seen from above. Sources: SCIP 2.0 specification; answers of real devices.
 */
public enum HokuyoModel {
    /** 5.6 m, 240 degrees, 10 scans a second, RS-232 at 19200 baud. */
    URG_04LX(LidarModel.URG_04LX, "URG-04LX(Hokuyo Automatic Co.,Ltd.)", "SOKUIKI Sensor URG-04LX", "3.1.00(18/Jan./2007)", new int[] {20, 5600},
        new int[] {1024, 44, 725, 384, 768}, 600, new int[] {0, 6, 19}),
    /** 60 m (30 m promised), 270 degrees, 40 scans a second, USB. */
    UTM_30LX(LidarModel.UTM_30LX, "UTM-30LX(Hokuyo Automatic Co.,Ltd.)", "SOKUIKI Sensor TOP-URG UTM-30LX", "1.20.02(16/Jul./2013)",
        new int[] {23, 60000}, new int[] {1440, 0, 1080, 540, 1080}, 2400, new int[] {1, 2, 3});

    /** The rate that stands for USB, bits a second: there the rate of the host has no meaning. */
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
     * @param distances least and greatest, millimetres
     * @param steps of a turn, first and last that are measured, the front one, last one that can be asked for
     * @param turns a minute
     * @param codes in place of a distance: nothing hit, too near, not measured
     */
    HokuyoModel(LidarModel lidar, String modelText, String product, String firmware, int[] distances, int[] steps, int turns, int[] codes) {
        this.lidar = lidar;
        this.modelText = modelText;
        this.product = product;
        this.firmware = firmware;
        this.distances = distances;
        this.steps = steps;
        this.turns = turns;
        this.codes = codes;
    }

    /** The one of that row in the table of LIDARs; null if that is no Hokuyo. */
    public static HokuyoModel of(LidarModel lidar) {
        for (HokuyoModel model : values()) {
            if (model.lidar == lidar) {
                return model;
            }
        }
        return null;
    }

    /** The command that sets a rate: {@code SS019200}. */
    public static String baudCommand(int rate) {
        return String.format(Locale.ROOT, "SS%0" + DIGITS + "d", rate);
    }

    /** Name in catalogues, for example {@code URG-04LX}. */
    public String getName() {
        return lidar.getName();
    }

    /** Its row in the table of LIDARs. */
    public LidarModel getLidar() {
        return lidar;
    }

    /** Of PP's line MODL. */
    public String getModelText() {
        return modelText;
    }

    /** Of VV's line PROD. */
    public String getProduct() {
        return product;
    }

    /** Of VV's line FIRM. */
    public String getFirmware() {
        return firmware;
    }

    /** Least distance, millimetres: smaller values are codes. */
    public int getLeast() {
        return distances[0];
    }

    /** Greatest distance, millimetres. */
    public int getGreatest() {
        return distances[1];
    }

    /** Steps of a whole turn. */
    public int getSteps() {
        return steps[0];
    }

    /** First step that is measured. */
    public int getFirst() {
        return steps[1];
    }

    /** Last step that is measured. */
    public int getLast() {
        return steps[2];
    }

    /** The step that looks ahead. */
    public int getFront() {
        return steps[3];
    }

    /** Last step that can be asked for; what is not measured is a code. */
    public int getLastAsked() {
        return steps[4];
    }

    /** Turns a minute. */
    public int getTurns() {
        return turns;
    }

    /** Seconds of a scan. */
    public double getScanTime() {
        return SECONDS_A_MINUTE / turns;
    }

    /** Degrees between two steps. */
    public double getStepAngle() {
        return CIRCLE / getSteps();
    }

    /** Whether it has no RS-232. */
    public boolean isUsbOnly() {
        return this == UTM_30LX;
    }

    /** What it sends where nothing is within its range. */
    public int getNothing() {
        return codes[0];
    }

    /** What it sends for what is nearer than {@link #getLeast}. */
    public int getTooNear() {
        return codes[1];
    }

    /** What it sends for steps that it doesn't measure. */
    public int getNotMeasured() {
        return codes[2];
    }
}
