// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.scip;

import java.util.Locale;

/**
 * A command for distances. MD and MS request a stream of scans; GD and GS request one scan and need the laser on. MD
 * and GD have three characters per value, MS and GS two. {@code MD0044072501000}: steps 44 to 725, cluster 1, every
 * scan, endless. Immutable.
 */
public final class ScanCommand {
    /** Maximum number of scans of a command; 0 is endless. */
    public static final int MAX_COUNT = 99;
    /** Maximum number of steps merged to one value. */
    public static final int MAX_CLUSTER = 99;
    /** Length of MD and MS, characters. */
    public static final int STREAM_LENGTH = 15;
    /** Length of GD and GS, characters. */
    public static final int SINGLE_LENGTH = 12;
    private static final int START_AT = 2;
    private static final int END_AT = 6;
    private static final int CLUSTER_AT = 10;
    private static final int INTERVAL_AT = 12;
    private static final int COUNT_AT = 13;
    private static final int RADIX = 10;

    private final String letters;
    private final int start;
    private final int end;
    private final int cluster;
    private final int interval;
    private final int count;
    private final String string;

    /**
     * @param letters MD, MS, GD or GS
     * @param start first step
     * @param end last step
     * @param cluster steps merged to one value, 0 to 99; 0 means 1
     * @param interval skipped scans between two, 0 to 9
     * @param count scans, 0 to 99; 0 is endless
     * @param string user text after the parameters
     */
    public ScanCommand(String letters, int start, int end, int cluster, int interval, int count, String string) {
        this.letters = letters;
        this.start = start;
        this.end = end;
        this.cluster = cluster;
        this.interval = interval;
        this.count = count;
        this.string = string;
    }

    /** Whether a line requests a stream: it begins with MD or MS. */
    public static boolean isStream(String line) {
        return line.startsWith("MD") || line.startsWith("MS");
    }

    /**
     * Checks the parameters of a line that is long enough.
     *
     * @param lastStep last step that a command can request
     * @return the error status; null if all are legal
     */
    public static String fault(String line, int lastStep) {
        if (!isNumber(line, START_AT, END_AT)) {
            return ScipStatus.BAD_START;
        }
        if (!isNumber(line, END_AT, CLUSTER_AT)) {
            return ScipStatus.BAD_END;
        }
        if (!isNumber(line, CLUSTER_AT, INTERVAL_AT)) {
            return ScipStatus.BAD_CLUSTER;
        }
        if (isStream(line) && !isNumber(line, INTERVAL_AT, COUNT_AT)) {
            return ScipStatus.BAD_INTERVAL;
        }
        if (isStream(line) && !isNumber(line, COUNT_AT, STREAM_LENGTH)) {
            return ScipStatus.BAD_COUNT;
        }
        if (number(line, END_AT, CLUSTER_AT) > lastStep) {
            return ScipStatus.END_BEYOND;
        }
        return number(line, END_AT, CLUSTER_AT) < number(line, START_AT, END_AT) ? ScipStatus.END_BEFORE_START : null;
    }

    /** Parses a line without a {@link #fault}. */
    public static ScanCommand of(String line) {
        boolean stream = isStream(line);
        return new ScanCommand(line.substring(0, START_AT), number(line, START_AT, END_AT),
            number(line, END_AT, CLUSTER_AT),
            number(line, CLUSTER_AT, INTERVAL_AT), stream ? number(line, INTERVAL_AT, COUNT_AT) : 0,
            stream ? number(line, COUNT_AT, STREAM_LENGTH) : 1, line.substring(stream ? STREAM_LENGTH : SINGLE_LENGTH));
    }

    /**
     * Whether all characters of a line in a range are digits.
     *
     * @param to index after the last character
     */
    static boolean isNumber(String line, int from, int to) {
        for (int i = from; i < to; i++) {
            if (line.charAt(i) < '0' || line.charAt(i) > '9') {
                return false;
            }
        }
        return true;
    }

    private static int number(String line, int from, int to) {
        int value = 0;
        for (int i = from; i < to; i++) {
            value = value * RADIX + line.charAt(i) - '0';
        }
        return value;
    }

    /** Returns the same command with another number of scans. */
    public ScanCommand withCount(int scans) {
        return new ScanCommand(letters, start, end, cluster, interval, scans, string);
    }

    /** First step. */
    public int getStart() {
        return start;
    }

    /** Steps merged to one value, 1 to 99. */
    public int getCluster() {
        return Math.max(1, cluster);
    }

    /** Skipped scans between two. */
    public int getInterval() {
        return interval;
    }

    /** Number of scans; 0 is endless. */
    public int getCount() {
        return count;
    }

    /** Characters per value. */
    public int getCharacters() {
        return letters.endsWith("S") ? Encoding.SHORT : Encoding.LONG;
    }

    /** Number of values of a scan: whole clusters, at least one. */
    public int getValues() {
        return Math.max(1, (end - start + 1) / getCluster());
    }

    /** Returns the command as sent, without line feed. */
    @Override
    public String toString() {
        String common = String.format(Locale.ROOT, "%s%04d%04d%02d", letters, start, end, cluster);
        return (isStream(letters) ? common + String.format(Locale.ROOT, "%d%02d", interval, count) : common) + string;
    }
}
