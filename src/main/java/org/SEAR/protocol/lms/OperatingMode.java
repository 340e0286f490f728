package org.SEAR.protocol.lms;

/**
 * The operating modes of telegram {@code 20 mode}: what a device permits, and whether it sends by itself. The codes of {@link Baud} stand in the same
 * byte. Source: SICK telegram listing, table 6-2.
 */
public final class OperatingMode {
    /** Configurations may be written; needs the {@link #PASSWORD}. */
    public static final int INSTALLATION = 0x00;
    /** Tests; no scans. */
    public static final int DIAGNOSTIC = 0x10;
    /** Sends every scan whole. */
    public static final int STREAM_ALL = 0x24;
    /** Sends scans when asked. */
    public static final int ON_REQUEST = 0x25;
    /** Sends the mean of so many scans. */
    public static final int STREAM_MEAN = 0x26;
    /** Sends part of every scan. */
    public static final int STREAM_RANGE = 0x27;
    /** Sends part of the mean of so many scans. */
    public static final int STREAM_MEAN_RANGE = 0x28;
    /** Sends every turn of the mirror. */
    public static final int STREAM_PARTIAL = 0x2A;
    /** Of installation mode. */
    public static final String PASSWORD = "SICK_LMS";

    private static final int FIRST_MEASURING = 0x20;
    private static final int LAST_MEASURING = 0x2F;

    private OperatingMode() {
    }

    /** Whether a device in that mode sends by itself. */
    public static boolean isStream(int mode) {
        return mode >= FIRST_MEASURING && mode <= LAST_MEASURING && mode != ON_REQUEST;
    }
}
