// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

/**
 * Operating modes of telegram {@code 20 mode}: permitted requests, and unsolicited scans. The codes of {@link Baud}
 * share the same byte. Source: SICK telegram listing, table 6-2.
 */
public final class OperatingMode {
    /** Permits writing the configuration; needs the {@link #PASSWORD}. */
    public static final int INSTALLATION = 0x00;
    /** Tests; no scans. */
    public static final int DIAGNOSTIC = 0x10;
    /** Sends every scan with all values. */
    public static final int STREAM_ALL = 0x24;
    /** Sends scans on request. */
    public static final int ON_REQUEST = 0x25;
    /** Sends the mean of several scans. */
    public static final int STREAM_MEAN = 0x26;
    /** Sends part of every scan. */
    public static final int STREAM_RANGE = 0x27;
    /** Sends part of the mean of several scans. */
    public static final int STREAM_MEAN_RANGE = 0x28;
    /** Sends every turn of the mirror. */
    public static final int STREAM_PARTIAL = 0x2A;
    /** Password of installation mode. */
    public static final String PASSWORD = "SICK_LMS";

    private static final int FIRST_MEASURING = 0x20;
    private static final int LAST_MEASURING = 0x2F;

    private OperatingMode() {
    }

    /** Whether a device in a mode sends scans without requests. */
    public static boolean isStream(int mode) {
        return mode >= FIRST_MEASURING && mode <= LAST_MEASURING && mode != ON_REQUEST;
    }
}
