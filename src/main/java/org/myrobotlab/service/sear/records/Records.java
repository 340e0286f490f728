// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.records;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.SEAR.files.AtomicFile;
import org.SEAR.geometry.Pose;
import org.SEAR.grammar.ScriptText;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.record.Frames;
import org.SEAR.record.RecordHeader;
import org.SEAR.record.Rerun;
import org.SEAR.record.RunRecord;
import org.SEAR.record.Series;
import org.SEAR.sensors.Reading;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.readings.EulerAngles;

/** Contents of records for scripts and panels. Any thread. */
public final class Records {
    /** Most frames for scripts and tables; of a longer record every second, fourth ... frame. */
    private static final int MAX_ROWS = 200000;
    /** Most frames for panels. */
    private static final int MAX_FRAMES = 2000;
    private static final int MAX_POINTS = 4000;
    private static final int MAX_LISTED = 200;
    private static final double FINE = 1e4;

    private final Host host;
    /** The last reported message. */
    private String reported = "";

    /** @param host takes messages about incomplete records */
    public Records(Host host) {
        this.host = host;
    }

    /** Reports that a record is incomplete, once for repeated reads. */
    private synchronized void report(RunRecord record, boolean whole) {
        String words = whole ? "" : record.getPath()
            + (record.isBeingWritten() ? " is still being written: SEAR reads it up to its latest event"
            : " was cut off, by a crash or a full disk: SEAR reads it up to that point");
        if (!words.equals(reported) && !words.isEmpty()) {
            host.progress(words);
        }
        reported = words;
    }

    /**
     * Opens a record.
     *
     * @param path as passed to {@link Recording#begin}; the ending is optional
     * @throws IOException with the path, if it is not a record
     */
    public static RunRecord open(String path) throws IOException {
        if (path == null) {
            throw new IllegalArgumentException("the path is missing (None), legal: the path of a record, such as "
                + "\"run.searlog\"");
        }
        Path file = ScriptText.path(path);
        Path whole = Paths.get(file + Recording.ENDING);
        return RunRecord.open(!Files.exists(file) && Files.exists(whole) ? whole : file);
    }

    /** Returns the records in the working folder, sorted by name. */
    public static List<String> list() throws IOException {
        TreeSet<String> names = new TreeSet<>();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(ScriptText.path(""), "*.searlog")) {
            for (Path file : files) {
                names.add(file.getFileName().toString());
                if (names.size() > MAX_LISTED) {
                    names.pollLast();
                }
            }
        }
        return new ArrayList<>(names);
    }

    /** Returns the names of a record's values. */
    public static List<String> names(String path) throws IOException {
        return new ArrayList<>(Series.names(open(path).getHeader()));
    }

    /** Runs a record's commands again in a separate world. */
    public Map<String, Object> rerun(String path, Path project) throws IOException, ProjectException {
        RunRecord record = open(path);
        Rerun.Result result = Rerun.of(record, Project.read(project));
        report(record, result.whole);
        Map<String, Object> answer = new LinkedHashMap<>();
        answer.put("same", result.same);
        answer.put("seconds", result.seconds);
        answer.put("ports", result.ports);
        answer.put("apart", result.apart);
        return answer;
    }

    /**
     * Writes values of a record as a table.
     *
     * @return the absolute path of the table
     */
    public Path saveCsv(String path, List<String> names, String csv) throws IOException {
        if (csv == null) {
            throw new IllegalArgumentException("the path of the table is missing (None), legal: such as \"run.csv\"");
        }
        Path file = ScriptText.path(csv);
        if (Files.exists(file) && !csv.endsWith(".csv")) {
            throw new IOException(file + " already exists and is not a .csv file: choose another name");
        }
        RunRecord record = open(path);
        Series series = Series.of(record, names, MAX_ROWS);
        report(record, series.whole);
        AtomicFile.write(file, series.csv().getBytes(StandardCharsets.UTF_8));
        return file.toAbsolutePath().normalize();
    }

    /** Returns {@code {"path": .., "names": [..], "times": [..], "values": [[.., null, ..], ..]}}. */
    public Map<String, Object> values(String path, List<String> names) throws IOException {
        RunRecord record = open(path);
        Series series = Series.of(record, names, MAX_POINTS);
        report(record, series.whole);
        List<List<Object>> values = new ArrayList<>();
        for (double[] column : series.values) {
            List<Object> numbers = new ArrayList<>();
            for (double number : column) {
                numbers.add(Double.isNaN(number) || Double.isInfinite(number) ? null : Double.valueOf(number));
            }
            values.add(numbers);
        }
        Map<String, Object> answer = new LinkedHashMap<>();
        answer.put("path", path);
        answer.put("names", series.names);
        answer.put("times", series.times);
        answer.put("values", values);
        return answer;
    }

    /**
     * Returns the frames of a replay in panels.
     *
     * <pre>
     * {"path", "whole", "written" (at present), "names": [..], "robots": [name, ..], "objects": [name of a moving one,
     * ..],
     *  "sensors": [name, ..], "lights": [[number of a robot, of its light], ..], "times": [..], and by time:
     *  "robotPoses": [[[x, y, z, rx, ry, rz], ..], ..], "objectPoses": likewise, "speeds": [[[m/s, rad/s] of each
     * robot, ..], ..],
     *  "pictures": [name of a camera with recorded pictures, ..],
     *  "words": [[reading of each sensor as text, null for an unknown sensor, ..], ..],
     *  "brightness": [[of each light, 0 to 1, ..], ..]}
     * </pre>
     *
     * @param known see {@link #wording}
     */
    public Map<String, Object> frames(String path, Map<String, Function<double[], String>> known) throws IOException {
        RunRecord record = open(path);
        Frames frames = Frames.of(record, MAX_FRAMES);
        report(record, frames.whole);
        List<String> moved = new ArrayList<>();
        frames.moved.forEach(number -> moved.add(record.getHeader().objects.get(number)));
        Map<String, Object> answer = new LinkedHashMap<>();
        answer.put("path", path);
        answer.put("whole", frames.whole);
        answer.put("written", record.isBeingWritten());
        answer.put("names", new ArrayList<>(Series.names(record.getHeader())));
        answer.put("robots", record.getHeader().robots);
        answer.put("objects", moved);
        answer.put("sensors", record.getHeader().sensors);
        answer.put("lights", frames.lights);
        answer.put("pictures", frames.pictured.stream().map(record.getHeader().sensors::get)
            .collect(Collectors.toList()));
        answer.put("times", frames.times);
        answer.put("speeds", frames.speeds.stream().map(robots -> numbers(robots, FINE)).collect(Collectors.toList()));
        answer.put("words", frames.readings.stream().map(read -> words(record.getHeader(), read, known))
            .collect(Collectors.toList()));
        answer.put("brightness", frames.brightness);
        answer.put("robotPoses", poses(frames.robots));
        answer.put("objectPoses", poses(frames.objects));
        return answer;
    }

    /**
     * Returns functions that format the numbers of each sensor as text. Simulation thread; the functions run on any.
     */
    public static Map<String, Function<double[], String>> wording(Simulation world) {
        Map<String, Function<double[], String>> words = new HashMap<>();
        for (String name : world.getJoints().after(world.getSensorNames())) {
            Reading reading = world.read(name);
            String unit = world.getUnit(name);
            int size = reading.numbers().length;
            words.put(name, kept -> kept.length == size ? reading.words(kept, unit) : null);
        }
        return words;
    }

    private static List<String> words(RecordHeader header, double[] read,
        Map<String, Function<double[], String>> known) {
        List<String> words = new ArrayList<>();
        int at = 0;
        for (int i = 0; i < header.sensors.size(); i++) {
            int size = header.sizes.get(i);
            double[] kept = Arrays.copyOfRange(read, at, at + size);
            words.add(size == 0 ? null : known.getOrDefault(header.sensors.get(i), none -> null).apply(kept));
            at += size;
        }
        return words;
    }

    private static List<List<double[]>> poses(List<List<double[]>> frames) {
        List<List<double[]>> all = new ArrayList<>();
        for (List<double[]> frame : frames) {
            List<double[]> poses = new ArrayList<>();
            for (double[] n : frame) {
                double[] angles = EulerAngles.degrees(new Pose(n[0], n[1], n[2], n[3], n[4], n[5], n[6]));
                poses.add(new double[] {rounded(n[0]), rounded(n[1]), rounded(n[2]), rounded(angles[0]),
                    rounded(angles[1]), rounded(angles[2])});
            }
            all.add(poses);
        }
        return all;
    }

    private static List<List<Double>> numbers(List<double[]> exact, double per) {
        List<List<Double>> all = new ArrayList<>();
        for (double[] each : exact) {
            all.add(Arrays.stream(each).mapToObj(n -> Double.isNaN(n) || Double.isInfinite(n) ? null
                : Double.valueOf(Math.rint(n * per) / per)).collect(Collectors.toList()));
        }
        return all;
    }

    private static double rounded(double value) {
        return Double.isNaN(value) || Double.isInfinite(value) ? 0 : Math.round(value * FINE) / FINE;
    }
}
