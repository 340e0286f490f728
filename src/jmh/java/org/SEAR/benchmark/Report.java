package org.SEAR.benchmark;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.results.format.ResultFormatType;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.CommandLineOptionException;
import org.openjdk.jmh.runner.options.CommandLineOptions;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.VerboseMode;

/**
 * Runs the benchmark and prints what was measured beside the goals. First argument: where the JSON goes; second: a folder that takes the worlds, for
 * other engines to run the same ones; the others are JMH's own and choose.
 */
public final class Report {
    private static final String[] WORLDS = {"room-20", "room-100", "room-1000", "hall-100", "hall-1000", "hills-110000"};
    private static final double FAN_GOAL = 12;
    private static final double[] SINGLE_GOALS = {4, 3.5, 3, 3.5, 3, 2.5};
    private static final String[] GROWTH = {"hall-10", "hall-100", "hall-1000", "hall-10000", "hills-1000", "hills-10000", "hills-100000",
        "hills-1000000"};

    private static final String[] STEPS = {"drive 20", "drive 1000", "lidar 20", "lidar 1000", "all 20", "all 1000"};
    /** Simulated seconds per second; 0 = no goal. */
    private static final double[] STEP_GOALS = {0, 0, 1000, 500, 300, 200};

    private Report() {
    }

    /** @param args JSON file, folder of worlds, JMH's own arguments */
    public static void main(String[] args) throws RunnerException, CommandLineOptionException, IOException {
        Path json = Paths.get(args[0]);
        Path folder = Paths.get(args[1]);
        String[] own = Arrays.copyOfRange(args, 2, args.length);
        Files.createDirectories(folder);
        for (String world : WORLDS) {
            export(new BeamWorld(world), folder.resolve(world + ".json"));
        }
        Map<String, Double> scores = new LinkedHashMap<>();
        ChainedOptionsBuilder options = new OptionsBuilder().parent(new CommandLineOptions(own)).resultFormat(ResultFormatType.JSON)
            .result(json.toString()).verbosity(VerboseMode.SILENT);
        System.out.println("measuring beams and steps ...");
        collect(new Runner(options.build()).run(), scores);
        if (own.length == 0) {
            System.out.println("measuring growth ...");
            Path growth = json.resolveSibling("jmh-growth.json");
            collect(new Runner(new OptionsBuilder().include("Beams.(fan|single)").param("world", GROWTH).resultFormat(ResultFormatType.JSON)
                .result(growth.toString()).verbosity(VerboseMode.SILENT).build()).run(), scores);
        }
        print(scores);
        printSteps(scores);
    }

    private static void collect(Collection<RunResult> results, Map<String, Double> scores) {
        for (RunResult result : results) {
            String method = result.getPrimaryResult().getLabel();
            String world = result.getParams().getParam("world");
            String key = world == null ? result.getParams().getParam("equipment") + " " + result.getParams().getParam("boxes") : method + " " + world;
            scores.put(key, result.getPrimaryResult().getScore());
        }
    }

    private static void print(Map<String, Double> scores) {
        System.out.println();
        System.out.println("beams, millions a second, one thread, JDK " + System.getProperty("java.version"));
        System.out.printf("%-14s %9s %6s %6s   %9s %6s %6s   %9s %9s%n", "world", "fan", "goal", "ratio", "single", "goal", "ratio", "jbullet",
            "fan/jb.");
        for (int i = 0; i < WORLDS.length; i++) {
            double fan = score(scores, "fan " + WORLDS[i]);
            double single = score(scores, "single " + WORLDS[i]);
            double jbullet = score(scores, "jbullet " + WORLDS[i]);
            System.out.printf(Locale.ROOT, "%-14s %9.2f %6.1f %6.2f   %9.2f %6.1f %6.2f   %9.4f %9.0f%n", WORLDS[i], fan, FAN_GOAL,
                fan / FAN_GOAL, single, SINGLE_GOALS[i], single / SINGLE_GOALS[i], jbullet, fan / jbullet);
        }
        System.out.println();
        System.out.printf("%-14s %9s %9s   (growth)%n", "world", "fan", "single");
        for (String world : GROWTH) {
            System.out.printf(Locale.ROOT, "%-14s %9.2f %9.2f%n", world, score(scores, "fan " + world), score(scores, "single " + world));
        }
    }

    private static void printSteps(Map<String, Double> scores) {
        System.out.println();
        System.out.println("one robot with four wheels, LIDAR at 10 Hz, 60 steps a second: simulated seconds per second");
        System.out.printf("%-14s %9s %6s %6s%n", "what, boxes", "speed", "goal", "ratio");
        for (int i = 0; i < STEPS.length; i++) {
            double speed = score(scores, STEPS[i]) / StepWorld.stepsASecond();
            if (STEP_GOALS[i] > 0) {
                System.out.printf(Locale.ROOT, "%-14s %9.0f %6.0f %6.2f%n", STEPS[i], speed, STEP_GOALS[i], speed / STEP_GOALS[i]);
            } else {
                System.out.printf(Locale.ROOT, "%-14s %9.0f%n", STEPS[i], speed);
            }
        }
    }

    private static double score(Map<String, Double> scores, String key) {
        return scores.getOrDefault(key, Double.NaN);
    }

    private static void export(BeamWorld world, Path file) throws IOException {
        try (PrintWriter out = new PrintWriter(Files.newBufferedWriter(file, StandardCharsets.UTF_8))) {
            out.println("{\"name\": \"" + world.name + "\", \"range\": " + BeamWorld.RANGE + ", \"beams\": " + BeamWorld.BEAMS + ",");
            out.print("\"boxes\": [");
            for (int i = 0; i < world.boxes.length; i++) {
                out.print((i == 0 ? "" : ",\n") + Arrays.toString(world.boxes[i]));
            }
            out.println("],");
            boolean hills = world.triangles != null;
            out.println("\"vertices\": " + (hills ? Arrays.toString(world.triangles.vertices) : "[]") + ",");
            out.println("\"indices\": " + (hills ? Arrays.toString(world.triangles.indices) : "[]") + ",");
            out.print("\"origins\": [");
            for (int i = 0; i < world.poses.length; i++) {
                out.print((i == 0 ? "" : ", ") + "[" + world.poses[i].x + ", " + world.poses[i].y + ", " + world.poses[i].z + "]");
            }
            out.println("],");
            out.println("\"directions\": " + Arrays.toString(world.directions()) + ",");
            out.println("\"ranges\": " + Arrays.toString(world.ranges()).replace("Infinity", "-1") + "}");
        }
    }
}
