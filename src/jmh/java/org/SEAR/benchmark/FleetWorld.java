package org.SEAR.benchmark;

import java.util.List;
import java.util.Random;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.simulator.Simulation;

/**
 * Many robots in one hall. Each has 10 m x 10 m with 20 boxes of its own, without walls between them, and drives in circles there; its LIDAR of 361
 * beams, if it has some, sees 8 m far. All LIDARs are read in the same step, ten times a simulated second.
 */
public final class FleetWorld implements AutoCloseable {
    private static final double CELL = 10;
    private static final int BOXES = 20;
    private static final double CLEAR = 2.3;
    private static final double WALL = 0.1;
    private static final double WALL_HEIGHT = 2;

    private final BenchmarkProject project;
    private final Simulation simulation;
    private final List<String> sensors;

    /**
     * Fills a folder of its own with the objects.
     *
     * @param robots how many
     * @param lidars of each robot
     * @param noise whether their beams have errors
     */
    public FleetWorld(int robots, int lidars, boolean noise) {
        project = new BenchmarkProject(null, () -> build(robots, lidars, noise));
        simulation = project.getSimulation();
        sensors = simulation.getSensorNames();
        simulation.post(world -> world.getRobots().forEach(robot -> robot.drive(StepWorld.SPEED, StepWorld.CIRCLE)));
    }

    private static void build(int robots, int lidars, boolean noise) {
        int columns = (int) Math.ceil(Math.sqrt(robots));
        int rows = (robots + columns - 1) / columns;
        double width = columns * CELL;
        double depth = rows * CELL;
        new Floor("floor", width, depth);
        for (int side = -1; side <= 1; side += 2) {
            Room.add("wallx" + side, new double[] {WALL, WALL_HEIGHT, depth, side * width / 2, WALL_HEIGHT / 2, 0, 0, 0, 0}, 0);
            Room.add("wallz" + side, new double[] {width, WALL_HEIGHT, WALL, 0, WALL_HEIGHT / 2, side * depth / 2, 0, 0, 0}, 0);
        }
        Random random = new Random(2026);
        for (int i = 0; i < robots; i++) {
            double x = (i % columns + 0.5) * CELL - width / 2;
            double z = (i / columns + 0.5) * CELL - depth / 2;
            for (int k = 0; k < BOXES; k++) {
                box("box" + i + "-" + k, x, z, random);
            }
            robot("robot" + i, x, z, lidars, noise);
        }
    }

    private static void box(String name, double middleX, double middleZ, Random random) {
        double x;
        double z;
        do {
            x = (random.nextDouble() - 0.5) * (CELL - 1);
            z = (random.nextDouble() - 0.5) * (CELL - 1);
        } while (Math.hypot(x, z) < CLEAR);
        double[] sizes = random.doubles(3, 0.25, 1).toArray();
        double[] turned = random.doubles(3, 0, 360).toArray();
        Room.add(name, new double[] {sizes[0], sizes[1], sizes[2], middleX + x, 0.5, middleZ + z, turned[0], turned[1], turned[2]}, 0);
    }

    private static void robot(String name, double x, double z, int lidars, boolean noise) {
        SEARrobot robot = new SEARrobot(name);
        robot.addComponent(new Dynamics(name + "Dynamics", 40, 60, 0.3, 0.4, 10000, 0.1, x - StepWorld.CIRCLE, StepWorld.START_HEIGHT, z, 0, 0, 0));
        robot.addComponent(new Cylinder(name + "Body", 0.1666875, 0.0762, 40));
        robot.addWheel(new Wheel(name + "Front", 0.0381, 0.03, 0, 0, 0, 0.16));
        robot.addWheel(new Wheel(name + "Right", 0.0381, 0.03, 1, -0.16, 0, 0));
        robot.addWheel(new Wheel(name + "Left", 0.0381, 0.03, 1, 0.16, 0, 0));
        robot.addWheel(new Wheel(name + "Back", 0.0381, 0.03, 0, 0, 0, -0.16));
        for (int i = 0; i < lidars; i++) {
            LIDAR lidar = new LIDAR(name + "Lidar" + i, StepWorld.RANGE, 180, 0.5, 0, StepWorld.LIDAR_HEIGHT + i * StepWorld.LIDAR_PITCH, 0, 0,
                360.0 * i / lidars, 0);
            if (noise) {
                lidar.setNoise(new Noise().setWhite(0.01));
            }
            robot.addComponent(lidar);
        }
    }

    /** A step, and what a program reads after it. */
    public void step() {
        simulation.step();
        if (simulation.getStep() % StepWorld.SCAN_EVERY == 0) {
            simulation.read(sensors);
        }
    }

    /** A step, and the readings of all LIDARs: nanoseconds that these took. */
    long readAfterStep() {
        simulation.step();
        long from = System.nanoTime();
        simulation.read(sensors);
        return System.nanoTime() - from;
    }

    /** The running world. */
    public Simulation getSimulation() {
        return simulation;
    }

    @Override
    public void close() {
        project.close();
    }
}
