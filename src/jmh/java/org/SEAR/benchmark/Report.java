// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.results.format.ResultFormatType;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.CommandLineOptionException;
import org.openjdk.jmh.runner.options.CommandLineOptions;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.VerboseMode;

/**
 * Runs the Java benchmarks and prints the results. The first argument is the JSON file; the others are JMH's options.
 */
public final class Report {
    private Report() {
    }

    /** @param args JSON file, JMH's options */
    public static void main(String[] args) throws RunnerException, CommandLineOptionException {
        Path json = Paths.get(args[0]);
        String[] own = Arrays.copyOfRange(args, 1, args.length);
        Map<String, Double> scores = new LinkedHashMap<>();
        collect(new Runner(new OptionsBuilder().parent(new CommandLineOptions(own)).addProfiler(CpuShare.class)
            .resultFormat(ResultFormatType.JSON).result(json.toString()).verbosity(VerboseMode.SILENT).build())
                .run(), scores);
        printBeams(scores);
        printPictures(scores);
        printSteps(scores);
    }

    private static void collect(Collection<RunResult> results, Map<String, Double> scores) {
        for (RunResult result : results) {
            String world = result.getParams().getParam("world");
            scores.put(result.getPrimaryResult().getLabel() + " " + world, result.getPrimaryResult().getScore());
        }
    }

    private static void printBeams(Map<String, Double> scores) {
        System.out.println();
        System.out.println("beams, millions a second, one thread, JDK " + System.getProperty("java.version"));
        System.out.printf("%-16s %9s %9s %9s %12s%n", "world", "fan", "single", "jbullet", "fan/jbullet");
        TreeSet<String> worlds = new TreeSet<>();
        for (String key : scores.keySet()) {
            if (key.matches("(fan|single|jbullet) .*")) {
                worlds.add(key.substring(key.indexOf(' ') + 1));
            }
        }
        for (String world : worlds) {
            double fan = score(scores, "fan " + world);
            double jbullet = score(scores, "jbullet " + world);
            System.out.printf(Locale.ROOT, "%-16s %9.2f %9.2f %9.4f %12.0f%n", world, fan,
                score(scores, "single " + world), jbullet, fan / jbullet);
        }
    }

    private static void printPictures(Map<String, Double> scores) {
        System.out.println();
        System.out.println("pictures of 320 x 240 a second, one thread");
        scores.forEach((key, score) -> {
            if (key.matches("(colors|depths) .*")) {
                System.out.printf(Locale.ROOT, "%-24s %9.1f%n", key, score);
            }
        });
    }

    private static double score(Map<String, Double> scores, String key) {
        return scores.getOrDefault(key, Double.NaN);
    }

    private static void printSteps(Map<String, Double> scores) {
        System.out.println();
        System.out.println("simulated seconds per second at 60 steps a simulated second");
        for (Map.Entry<String, Double> entry : scores.entrySet()) {
            if (entry.getKey().startsWith("step ")) {
                System.out.printf(Locale.ROOT, "%-16s %9.0f%n", entry.getKey().substring("step ".length()),
                    entry.getValue() / StepWorld.stepsASecond());
            }
        }
    }
}
