// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.util.Random;
import org.SEAR.POJOs.Floor;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.Simulation;

/**
 * Moving bodies: {@code drop-N} is N rotated boxes of 0.25 to 0.5 m and 20 kg, 1.2 m apart, dropped together from 0.8
 * to 1.5 m above a floor. Within 1.25 simulated seconds they fall, bounce and tumble, and none sleeps. {@code asleep-N}
 * is the same world when all bodies sleep.
 */
public final class DropWorld implements AutoCloseable {
    /** Steps in which all bodies move. */
    static final int STEPS = 75;
    /** Steps until the bodies are at rest. */
    static final int REST_STEPS = 180;
    static final double MASS = 20;
    private static final int UNTIL_ASLEEP = 420;
    /** Distance between boxes, metres. */
    private static final double APART = 1.2;

    /** Length of the square floor's side, metres; its top is at height 0. */
    final double side;
    /** Nine numbers per box, as in {@link Room}. */
    final double[][] boxes;
    private final BenchmarkProject project;

    /** Creates the project. */
    public DropWorld(String name) {
        int number = Integer.parseInt(name.substring(name.indexOf('-') + 1));
        int row = (int) Math.ceil(Math.sqrt(number));
        side = APART * (row + 2);
        boxes = new double[number][];
        Random random = new Random(2026);
        for (int i = 0; i < number; i++) {
            double x = (i / row - (row - 1) / 2.0) * APART;
            double z = (i % row - (row - 1) / 2.0) * APART;
            boxes[i] = new double[] {size(random), size(random), size(random), x, 0.8 + 0.7 * random.nextDouble(), z,
                360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble()};
        }
        project = new BenchmarkProject(null, () -> {
            new Floor("floor", side, side);
            for (int i = 0; i < boxes.length; i++) {
                Room.add("box" + i, boxes[i], MASS);
            }
        });
        if (name.startsWith("asleep")) {
            for (int i = 0; i < UNTIL_ASLEEP; i++) {
                step();
            }
        }
    }

    private static double size(Random random) {
        return 0.25 + 0.25 * random.nextDouble();
    }

    /** Resets all boxes into the air. */
    public void reset() {
        project.getSimulation().reset();
    }

    public void step() {
        project.getSimulation().step();
    }

    public Simulation getSimulation() {
        return project.getSimulation();
    }

    /** Returns the present heights of the boxes' centres, metres. */
    double[] heights() {
        double[] heights = new double[boxes.length];
        for (int i = 0; i < heights.length; i++) {
            Pose pose = project.getSimulation().getPose("box" + i);
            heights[i] = pose.y;
        }
        return heights;
    }

    @Override
    public void close() {
        project.close();
    }
}
