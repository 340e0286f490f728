// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Wheels roll over gaps, kerbs, planks and cobbles as rigid cylinders: their axles follow the closed form. */
public class RollingOverTest {
    private static final double RADIUS = 0.05;
    private static final double NEAR = 2e-4;
    private static final double SPEED = 0.1;
    private static final double START = -0.06;
    private static final int STEPS = 260;
    /** Coefficient of friction with which every wheel climbs the highest kerb. */
    private static final double RUBBER = 2.5;

    @Rule
    public final ProjectRule project = new ProjectRule();
    private final List<DoubleUnaryOperator> profiles = new ArrayList<>();

    /** Adds a four-wheeled robot in a lane of its own, whose front axle is at the start; returns the lane's x. */
    private double lane(DoubleUnaryOperator axle) {
        int number = profiles.size();
        profiles.add(axle);
        SEARrobot robot = new SEARrobot("robot" + number);
        robot.addComponent(new Dynamics("drive" + number, 4, 1000, 0.3, 0.4, 10000, 0.02, number, 0.068, START - 0.1,
            0, 0, 0));
        Box body = new Box("body" + number, 0.2, 0.32, 0.04, 4);
        body.move(0, 0.05, 0);
        robot.addComponent(body);
        for (int i = 0; i < 4; i++) {
            Wheel wheel = new Wheel("wheel" + number + i, RADIUS, 0.03, 1, i % 2 == 0 ? 0.12 : -0.12, 0,
                i < 2 ? 0.1 : -0.1);
            wheel.setFriction(RUBBER);
            robot.addWheel(wheel);
        }
        return number;
    }

    private static void slab(double x, double from, double to, double top) {
        new Box("slab" + x + from, 0.8, to - from, 0.1, 0).move(x, top - 0.05, (from + to) / 2);
    }

    /** Returns the height of an axle that rests on a cylinder, or on an edge, whose radius is 0. */
    private static double over(double centre, double height, double radius, double z) {
        double away = Math.abs(z - centre);
        double sum = RADIUS + radius;
        return away < sum ? height + Math.sqrt(sum * sum - away * away) : Double.NEGATIVE_INFINITY;
    }

    private static double onPlank(double from, double to, double top, double z) {
        return z >= from && z <= to ? top + RADIUS : Math.max(over(from, top, 0, z), over(to, top, 0, z));
    }

    private void gapsAndKerbs() {
        for (double gap : new double[] {0.001, 0.005, 0.01, 0.02, 0.03, 0.04}) {
            double x = lane(z -> z <= 0 || z >= gap ? RADIUS : Math.max(over(0, 0, 0, z), over(gap, 0, 0, z)));
            slab(x, -1, 0, 0);
            slab(x, gap, 1, 0);
        }
        for (double kerb : new double[] {0.001, 0.005, 0.01, 0.02, 0.03}) {
            double x = lane(z -> Math.max(RADIUS, onPlank(0, 1, kerb, z)));
            slab(x, -1, 0, 0);
            slab(x, 0, 1, kerb);
        }
    }

    private void planksAndCobbles() {
        double plank = lane(z -> Math.max(RADIUS, Math.max(onPlank(0, 0.02, 0.006, z), onPlank(0.09, 0.11, 0.012, z))));
        slab(plank, -1, 1, 0);
        slab(plank, 0, 0.02, 0.006);
        slab(plank, 0.09, 0.11, 0.012);
        double cobbles = lane(z -> Math.max(RADIUS, Math.max(over(0, -0.02, 0.03, z), over(0.07, -0.025, 0.04, z))));
        slab(cobbles, -1, 1, 0);
        log(cobbles, 0, -0.02, 0.03);
        log(cobbles, 0.07, -0.025, 0.04);
    }

    private static void log(double x, double z, double y, double radius) {
        Cylinder log = new Cylinder("log" + z, radius, 0.8, 0);
        log.rotate(0, 0, 90);
        log.move(x, y, z);
    }

    @Test
    public void axlesFollowTheClosedForm() throws Exception {
        gapsAndKerbs();
        planksAndCobbles();
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 0.5);
        simulation.getRobots().forEach(robot -> robot.drive(SPEED, Double.POSITIVE_INFINITY));
        for (int step = 0; step < STEPS; step++) {
            simulation.step();
            for (int i = 0; i < profiles.size(); i++) {
                for (int wheel = 0; wheel < 4; wheel += 2) {
                    Pose axle = axle(simulation, i, wheel);
                    assertEquals("lane " + i + ", wheel " + wheel + " at " + axle.z,
                        profiles.get(i).applyAsDouble(axle.z), axle.y, NEAR);
                }
            }
        }
        for (int i = 0; i < profiles.size(); i++) {
            assertTrue("lane " + i, axle(simulation, i, 2).z > 0.12);
        }
    }

    private static Pose axle(Simulation simulation, int robot, int wheel) {
        Pose pose = simulation.getRobots().get(robot).getPose();
        return pose.times(simulation.snapshot().robots.get(robot).wheels.get(wheel));
    }

    @Test
    public void readyRobotsCrossAGap() throws Exception {
        List<Function<String, SEARrobot>> ready = List.of(Robots::rover, Robots::car, Robots::fourWheeled,
            Robots::create);
        for (int i = 0; i < ready.size(); i++) {
            ready.get(i).apply("robot" + i).move(i, 0, -0.3);
            slab(i, -1, 0, 0);
            slab(i, 0.02, 2, 0);
        }
        Simulation simulation = Worlds.start(project);
        simulation.getRobots().forEach(robot -> robot.drive(0.2, Double.POSITIVE_INFINITY));
        Worlds.run(simulation, 5);
        for (int i = 0; i < ready.size(); i++) {
            assertEquals("robot" + i, 0.7, simulation.getRobots().get(i).getPose().z, 0.05);
        }
    }
}
