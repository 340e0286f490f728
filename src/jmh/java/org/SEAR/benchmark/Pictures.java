package org.SEAR.benchmark;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.SEAR.POJOs.BrownLens;
import org.SEAR.POJOs.Robots;
import org.SEAR.camera.Eye;
import org.SEAR.camera.Sight;
import org.SEAR.geometry.Pose;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.raycast.BeamScene;
import org.SEAR.sensors.Truth;
import org.SEAR.simulator.Simulation;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** A camera's pictures a second, 320 x 240 pixels of 60 degrees, by one thread, while it turns: in a room with 20 boxes and in an example's world. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 4, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class Pictures {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 240;
    private static final int TURNS = 36;
    private static final double ABOVE = 0.3;

    @Param({"room-20", "sensors"})
    public String world;

    private Simulation simulation;
    private Truth truth;
    private Eye eye;
    private int turn;

    /** Makes the world; something stands in it after a second. */
    @Setup(Level.Trial)
    public void build() throws Exception {
        Path folder = Files.createTempDirectory("pictures").resolve("SEARproject");
        System.setProperty("sear.project", folder.toString());
        if (world.startsWith("room")) {
            new Room(world).build();
            Robots.rover("rover");
        } else {
            Bundle.load(Path.of("examples", world + ".sear"), folder);
        }
        simulation = Simulation.load(folder, 1);
        for (int step = 0; step < 60; step++) {
            simulation.step();
        }
        truth = simulation.getRobots().get(0).getTruth();
        double focal = WIDTH / (2 * Math.tan(Math.toRadians(30)));
        eye = new Eye(WIDTH, HEIGHT, new BrownLens(focal, (WIDTH - 1) / 2.0, (HEIGHT - 1) / 2.0, new double[4]), 0.02, 10_000);
        eye.setShared(false);
    }

    private Sight sight(BeamScene scene) {
        turn = (turn + 1) % TURNS;
        Pose body = truth.body();
        Pose place = new Pose(body.x, body.y + ABOVE, body.z, 0, 0, 0, 1);
        Pose looking = Pose.ofDegrees(0, 0, 0, 0, 360.0 * turn / TURNS, 0).times(Pose.ofDegrees(0, 0, 0, 10, 0, 0));
        return new Sight(scene, truth.looks(), place.times(looking), truth.owner());
    }

    /** Colours with shadows. */
    @Benchmark
    public int[] colors() {
        return eye.colors(sight(truth.sight()));
    }

    /** Depths. */
    @Benchmark
    public float[] depths() {
        return eye.depths(sight(truth.scene()));
    }
}
