// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.scip;

/** Two-character status of a sensor's reply. Source: SCIP 2.0 specification, chapters 8 to 12. */
public final class ScipStatus {
    /** Done. */
    public static final String OK = "00";
    /** A scan of MD or MS. */
    public static final String SCAN = "99";
    /** TM0, BM, HS: already in that state. */
    public static final String ALREADY = "02";
    /** TM, CR, HS: invalid parameter; SS: not a number. */
    public static final String BAD_PARAMETER = "01";
    /** SS: unsupported rate. */
    public static final String BAD_RATE = "02";
    /** SS, CR: value unchanged; TM2: already off. */
    public static final String UNCHANGED = "03";
    /** SS, CR: not supported by this model; TM1: not in the present mode. */
    public static final String NOT_HERE = "04";
    /** MD, MS, GD, GS: the first step is not a number. */
    public static final String BAD_START = "01";
    /** MD, MS, GD, GS: the last step is not a number. */
    public static final String BAD_END = "02";
    /** MD, MS, GD, GS: the cluster is not a number. */
    public static final String BAD_CLUSTER = "03";
    /** MD, MS, GD, GS: the last step is beyond the sensor's. */
    public static final String END_BEYOND = "04";
    /** MD, MS, GD, GS: the last step is before the first. */
    public static final String END_BEFORE_START = "05";
    /** MD, MS: the interval is not a number. */
    public static final String BAD_INTERVAL = "06";
    /** MD, MS: the number of scans is not a number. */
    public static final String BAD_COUNT = "07";
    /** GD, GS: the laser is off. */
    public static final String LASER_OFF = "10";
    /** The sensor is busy with other commands. */
    public static final String BUSY = "0B";
    /** A parameter is missing. */
    public static final String TOO_SHORT = "0C";
    /** Unknown command, or not permitted in the present mode. */
    public static final String UNKNOWN = "0E";
    /** The string after the parameters is too long. */
    public static final String LONG_STRING = "0G";
    /** The string after the parameters has an unprintable character. */
    public static final String BAD_STRING = "0H";

    private ScipStatus() {
    }
}
