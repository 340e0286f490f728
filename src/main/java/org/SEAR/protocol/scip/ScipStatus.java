package org.SEAR.protocol.scip;

/** The two characters that a sensor answers a command with. Source: SCIP 2.0 specification, chapters 8 to 12. */
public final class ScipStatus {
    /** Done. */
    public static final String OK = "00";
    /** A scan of MD or MS. */
    public static final String SCAN = "99";
    /** TM0, BM, HS: it is so already. */
    public static final String ALREADY = "02";
    /** TM, CR, HS: the parameter is none; SS: it is no number. */
    public static final String BAD_PARAMETER = "01";
    /** SS: no such rate. */
    public static final String BAD_RATE = "02";
    /** SS, CR: it is so already; TM2: it is off already. */
    public static final String UNCHANGED = "03";
    /** SS, CR: not with this model; TM1: not in that mode. */
    public static final String NOT_HERE = "04";
    /** MD, MS, GD, GS: the first step is no number. */
    public static final String BAD_START = "01";
    /** MD, MS, GD, GS: the last step is no number. */
    public static final String BAD_END = "02";
    /** MD, MS, GD, GS: the cluster is no number. */
    public static final String BAD_CLUSTER = "03";
    /** MD, MS, GD, GS: the last step is beyond the sensor's. */
    public static final String END_BEYOND = "04";
    /** MD, MS, GD, GS: the last step is before the first. */
    public static final String END_BEFORE_START = "05";
    /** MD, MS: the interval is no number. */
    public static final String BAD_INTERVAL = "06";
    /** MD, MS: the number of scans is no number. */
    public static final String BAD_COUNT = "07";
    /** GD, GS: the laser is off. */
    public static final String LASER_OFF = "10";
    /** The sensor is busy with other commands. */
    public static final String BUSY = "0B";
    /** A parameter is missing. */
    public static final String TOO_SHORT = "0C";
    /** There is no such command, or not in the present mode. */
    public static final String UNKNOWN = "0E";
    /** The string after the parameters is too long. */
    public static final String LONG_STRING = "0G";
    /** The string after the parameters has a character that is not printable. */
    public static final String BAD_STRING = "0H";

    private ScipStatus() {
    }
}
