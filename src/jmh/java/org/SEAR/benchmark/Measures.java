// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.SEAR.geometry.Triangles;
import org.SEAR.raycast.BeamScene;

/**
 * One-time measurements in a fresh JVM, written to a JSON file. {@code mesh N}: time and bytes to build the hierarchy
 * of N triangles. {@code run WORLD FOLDER STEPS}: time from reading the project to the first reading, then the memory
 * of a run of STEPS steps. {@code project WORLD FOLDER} writes the project that another JVM runs as it would a user's.
 */
public final class Measures {
    private static final double NANOS = 1e9;
    private static final int BUILDS = 5;
    private static final long KIB = 1024;

    private Measures() {
    }

    /** @param args JSON file, measurement, size or world */
    public static void main(String[] args) throws IOException {
        Map<String, Double> out = new LinkedHashMap<>();
        out.put("jvmUp", ManagementFactory.getRuntimeMXBean().getUptime() / 1e3);
        switch (args[1]) {
            case "mesh":
                mesh("hills-" + args[2], out);
                break;
            case "project":
                new StepWorld(args[2], Paths.get(args[3])).close();
                break;
            case "run":
                run(args[2], Paths.get(args[3]), Integer.parseInt(args[4]), out);
                break;
            default:
                throw new IllegalArgumentException("measure is \"" + args[1] + "\", legal: mesh, project, run");
        }
        Path status = Paths.get("/proc/self/status");
        if (Files.isReadable(status)) {
            for (String line : Files.readAllLines(status)) {
                if (line.startsWith("VmHWM:")) {
                    out.put("peakResident", Double.parseDouble(line.replaceAll("[^0-9]", "")) * KIB);
                }
            }
        }
        StringBuilder json = new StringBuilder();
        out.forEach((name, value) -> json.append(json.length() == 0 ? "{" : ", ")
            .append(String.format(Locale.ROOT, "\"%s\": %.9g", name, value)));
        Files.write(Paths.get(args[0]), json.append("}\n").toString().getBytes(StandardCharsets.UTF_8));
    }

    private static double cpu() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() / NANOS;
    }

    /** Returns the used heap after garbage collection, bytes. */
    private static double heap() {
        for (int i = 0; i < 3; i++) {
            System.gc();
        }
        return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
    }

    private static void mesh(String world, Map<String, Double> out) {
        Triangles model = new BeamWorld(world, false).triangles;
        out.put("triangles", (double) model.size());
        out.put("modelBytes", 4.0 * (model.vertices.length + model.indices.length) / model.size());
        double before = heap();
        double[] first = new double[2];
        BeamScene kept = build(model, first);
        out.put("bytes", (heap() - before) / model.size());
        reach(kept);
        out.put("first", first[0]);
        out.put("firstCpu", first[1]);
        double[] wall = new double[BUILDS];
        double[] cpu = new double[BUILDS];
        for (int i = 0; i < BUILDS; i++) {
            double[] times = new double[2];
            build(new Triangles(model.vertices, model.indices), times);
            wall[i] = times[0];
            cpu[i] = times[1];
        }
        Arrays.sort(wall);
        Arrays.sort(cpu);
        out.put("median", wall[BUILDS / 2]);
        out.put("medianCpu", cpu[BUILDS / 2]);
        long from = System.nanoTime();
        double cpuBefore = cpu();
        JBulletWorld.mesh(model);
        out.put("jbullet", (System.nanoTime() - from) / NANOS);
        out.put("jbulletCpu", cpu() - cpuBefore);
    }

    /** @param times receives wall time and the thread's processor time, seconds */
    private static BeamScene build(Triangles triangles, double[] times) {
        double cpuBefore = cpu();
        long from = System.nanoTime();
        BeamScene scene = new BeamScene();
        scene.addMesh(triangles, 1, 1, 1, BeamScene.WORLD);
        scene.commit();
        reach(scene);
        times[0] = (System.nanoTime() - from) / NANOS;
        times[1] = cpu() - cpuBefore;
        return scene;
    }

    /** Casts one ray to trigger lazy construction and to keep the scene reachable. */
    private static void reach(BeamScene scene) {
        scene.cast(0, 100, 0, 0, -1, 0, 200, BeamScene.WORLD, null);
    }

    private static void run(String world, Path folder, int runSteps, Map<String, Double> out) {
        long from = System.nanoTime();
        double cpuBefore = cpu();
        try (StepWorld steps = new StepWorld(world, folder)) {
            steps.getSimulation().step();
            steps.getSimulation().read("lidar0");
            out.put("toReading", (System.nanoTime() - from) / NANOS);
            out.put("toReadingCpu", cpu() - cpuBefore);
            from = System.nanoTime();
            for (int i = 0; i < runSteps; i++) {
                steps.step();
            }
            out.put("run", (System.nanoTime() - from) / NANOS);
            out.put("heap", heap());
        }
    }
}
