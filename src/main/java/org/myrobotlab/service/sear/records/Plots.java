// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.records;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.ScriptText;
import org.SEAR.plot.Plot;
import org.SEAR.record.RecordHeader;
import org.SEAR.record.RunRecord;
import org.SEAR.record.Series;
import org.SEAR.simulator.Simulation;

/** Plots of numbers over time for scripts. Any thread. */
public final class Plots {
    /** Most points; more than a picture is wide. */
    private static final int MAX_POINTS = 4000;
    private static final Pattern WITH_UNIT = Pattern.compile("(.*\\S)\\s*[(\\[]([^()\\[\\]]+)[)\\]]");
    private static final Map<String, String> UNITS = Map.of(".x", "m", ".y", "m", ".z", "m", ".heading", "deg",
        ".speed", "m/s", ".turnRate", "rad/s",
        " radius wanted", "m", " received", "bytes", " sent", "bytes", " wanted", "m/s");

    private Plots() {
    }

    /**
     * Draws lists of numbers to a file.
     *
     * @param lines values by name; the name may end with a unit in brackets
     */
    public static Path save(String picture, String xTitle, List<?> xs, Map<String, ?> lines) throws IOException {
        String title = given(xTitle, "the title of the axis");
        Plot plot = new Plot(title, numbers(title, xs));
        for (Map.Entry<String, ?> line : new TreeMap<>(lines).entrySet()) {
            String name = ScriptText.of(line.getKey());
            if (!(line.getValue() instanceof List)) {
                throw new IllegalArgumentException("\"" + name + "\" is " + line.getValue()
                    + ", legal: a list of numbers");
            }
            Matcher unit = WITH_UNIT.matcher(name);
            boolean has = unit.matches();
            plot.add(has ? unit.group(1) : name, has ? unit.group(2) : "", numbers(name, (List<?>) line.getValue()));
        }
        return saved(plot, picture);
    }

    private static String given(String text, String what) {
        if (text == null) {
            throw new IllegalArgumentException(what + " is missing (None), legal: a text such as \"time (s)\"");
        }
        return ScriptText.of(text);
    }

    private static Path saved(Plot plot, String picture) throws IOException {
        Path file = ScriptText.path(given(picture, "the path of the picture"));
        plot.save(file);
        return file.toAbsolutePath().normalize();
    }

    private static double[] numbers(String name, List<?> list) {
        if (list == null) {
            throw new IllegalArgumentException("\"" + name + "\" is missing (None), legal: a list of numbers");
        }
        double[] numbers = new double[list.size()];
        for (int i = 0; i < numbers.length; i++) {
            Object value = list.get(i);
            if (value != null && !(value instanceof Number)) {
                throw new IllegalArgumentException("\"" + name + "\" has " + ParameterTable.quote(value)
                    + " at index " + i + ", legal: numbers, or None for a missing value");
            }
            numbers[i] = value == null ? Double.NaN : ((Number) value).doubleValue();
        }
        return numbers;
    }

    /**
     * Draws values of a record over time to a file.
     *
     * @param sensors their units, see {@link #units}
     * @return the absolute path of the picture
     */
    public static Path saveRecord(String path, List<String> names, String picture, Map<String, String> sensors)
        throws IOException {
        RunRecord record = Records.open(given(path, "the path of the record"));
        Series series = Series.of(record, names, MAX_POINTS);
        Plot plot = new Plot("time (s)", series.times);
        for (int i = 0; i < series.names.size(); i++) {
            String name = series.names.get(i);
            plot.add(name, unit(name, record.getHeader(), sensors), series.values[i]);
        }
        return saved(plot, picture);
    }

    private static String unit(String name, RecordHeader header, Map<String, String> sensors) {
        for (int i = 0; i < header.sensors.size(); i++) {
            String sensor = header.sensors.get(i);
            for (int k = 0; k < header.numbers.get(i).size(); k++) {
                if (name.equals(sensor + header.numbers.get(i).get(k))) {
                    String[] units = sensors.getOrDefault(sensor, "").split(", ");
                    return units[Math.min(k, units.length - 1)];
                }
            }
        }
        return UNITS.entrySet().stream().filter(unit -> name.endsWith(unit.getKey()))
            .max((a, b) -> a.getKey().length() - b.getKey().length()).map(Map.Entry::getValue).orElse("");
    }

    /** Returns the units of a world's sensors. Simulation thread. */
    public static Map<String, String> units(Simulation world) {
        Map<String, String> units = new HashMap<>();
        world.getJoints().after(world.getSensorNames()).forEach(name -> units.put(name, world.getUnit(name)));
        return units;
    }
}
