package org.SEAR.protocol.scip;

import java.util.ArrayList;
import java.util.List;

/** One answer of a sensor: the echo of the command, a status, lines; {@code GD0384038601|00P|00?Xg|0?X0?Y0?ZH||}. Immutable. */
public final class Reply {
    /** Most characters in a line of distances, without its checksum. */
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

    /** The command as it was sent; of a scan of MD or MS with the number of scans that remain. */
    public String getEcho() {
        return echo;
    }

    /** Two characters, see {@link ScipStatus}. */
    public String getStatus() {
        return status;
    }

    /** Whether it brings distances that were asked for by MD or MS. */
    public boolean isScan() {
        return ScipStatus.SCAN.equals(status) && ScanCommand.isStream(echo);
    }

    /** The value of a line such as {@code DMIN:20}; null if there is none of that name. */
    public String property(String name) {
        String start = name + ":";
        return lines.stream().filter(line -> line.startsWith(start)).map(line -> line.substring(start.length())).findFirst().orElse(null);
    }

    /**
     * The value of a line that is a number.
     *
     * @throws IllegalArgumentException if there is none
     */
    public int number(String name) {
        String value = property(name);
        if (value == null) {
            throw new IllegalArgumentException("there is no line " + name + " in " + lines);
        }
        return Integer.parseInt(value.trim());
    }

    /**
     * The time stamp of a scan, milliseconds.
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
     * The values of a scan.
     *
     * @param characters of each
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
