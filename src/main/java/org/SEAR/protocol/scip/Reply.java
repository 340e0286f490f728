// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.scip;

import java.util.ArrayList;
import java.util.List;

/**
 * One reply of a sensor: echo of the command, status, lines; {@code GD0384038601|00P|00?Xg|0?X0?Y0?ZH||}. Immutable.
 */
public final class Reply {
    /** Maximum number of characters in a line of distances, without its checksum. */
    public static final int LINE = 64;

    private final String echo;
    private final String status;
    private final List<String> lines;

    /** @param lines without checksums */
    Reply(String echo, String status, List<String> lines) {
        this.echo = echo;
        this.status = status;
        this.lines = new ArrayList<>(lines);
    }

    /** The command as sent; for a scan of MD or MS with the number of remaining scans. */
    public String getEcho() {
        return echo;
    }

    /** Two characters, see {@link ScipStatus}. */
    public String getStatus() {
        return status;
    }

    /** Whether it contains a scan of MD or MS. */
    public boolean isScan() {
        return ScipStatus.SCAN.equals(status) && ScanCommand.isStream(echo);
    }

    /** Value of a line such as {@code DMIN:20}; null if there is no such line. */
    public String property(String name) {
        String start = name + ":";
        return lines.stream().filter(line -> line.startsWith(start)).map(line -> line.substring(start.length()))
            .findFirst().orElse(null);
    }

    /**
     * Numeric value of a line.
     *
     * @throws IllegalArgumentException if there is no such line
     */
    public int number(String name) {
        String value = property(name);
        if (value == null) {
            throw new IllegalArgumentException("there is no line " + name + " in " + lines);
        }
        return Integer.parseInt(value.trim());
    }

    /**
     * Time stamp of a scan, milliseconds.
     *
     * @throws IllegalArgumentException if there is none
     */
    public int time() {
        if (lines.isEmpty() || lines.get(0).length() != Encoding.TIME) {
            throw new IllegalArgumentException("a scan without time stamp");
        }
        return Encoding.decode(lines.get(0), 0, Encoding.TIME);
    }

    /**
     * Decodes the values of a scan.
     *
     * @param characters per value
     * @throws IllegalArgumentException if the characters are no values
     */
    public int[] values(int characters) {
        String all = String.join("", lines.subList(Math.min(1, lines.size()), lines.size()));
        if (all.length() % characters != 0) {
            throw new IllegalArgumentException(all.length() + " characters of values of " + characters + " each");
        }
        int[] values = new int[all.length() / characters];
        for (int i = 0; i < values.length; i++) {
            values[i] = Encoding.decode(all, i * characters, characters);
        }
        return values;
    }
}
