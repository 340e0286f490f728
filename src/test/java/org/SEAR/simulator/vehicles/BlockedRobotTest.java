// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Locale;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Wheel;
import org.SEAR.Slow;
import org.SEAR.devices.RobotHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * A robot that drives against an object stops within a millimetre of its surface and does not enter fixed objects. The
 * distance of two bodies is the widest slab of space between them, found by a search over directions without the
 * contact code.
 */
@Category(Slow.class)
public class BlockedRobotTest {
    private static final double MILLIMETRE = 0.001;
    private static final double HEAVY = 2000;
    /** Steps of the search, radians. */
    private static final double FINE = 2e-4;
    private static final double FINEST = 1e-6;
    private static final double[] SPEEDS = {0.1, 0.5, 1};
    private static final String[] OBSTACLES = {"box", "cylinder", "cone", "ellipse", "model"};

    @Rule
    public final ProjectRule project = new ProjectRule();

    private void robot(String shape) throws Exception {
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("dynamics", 400, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 0));
        robot.addWheel(new Wheel("front", 0.0381, 0.03, 0, 0, 0, 0.1));
        robot.addWheel(new Wheel("right", 0.0381, 0.03, 1, -0.16, 0, 0));
        robot.addWheel(new Wheel("left", 0.0381, 0.03, 1, 0.16, 0, 0));
        robot.addWheel(new Wheel("back", 0.0381, 0.03, 0, 0, 0, -0.1));
        robot.addComponent("round".equals(shape) ? new Cylinder("body", 0.1666875, 0.0762, 0)
            : new Box("body", 0.3, 0.32, 0.0762, 0));
    }

    private void obstacle(String kind, double mass) throws Exception {
        Shape shape;
        switch (kind) {
            case "box":
                shape = new Box("obstacle", 2, 0.5, 0.4, mass);
                break;
            case "cylinder":
                shape = new Cylinder("obstacle", 0.25, 0.4, mass);
                break;
            case "ellipse":
                shape = new Cylinder("obstacle", 0.25, 0.4, mass);
                shape.scale(1.2, 1, 1);
                break;
            case "cone":
                shape = new Cone("obstacle", 0.25, 0.8, mass);
                break;
            default:
                StringBuilder cube = new StringBuilder();
                for (int i = 0; i < 8; i++) {
                    cube.append(String.format(Locale.ROOT, "v %d %.1f %.2f%n", i % 2 * 2 - 1, 0.2 * (i / 2 % 2 * 2 - 1),
                        0.25 * (i / 4 * 2 - 1)));
                }
                cube.append("f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
                project.put("assets/cube.obj", cube.toString());
                shape = new Model("obstacle", "cube.obj", mass);
        }
        shape.move(0, "cone".equals(kind) ? 0.4 : 0.2, 0.85);
    }

    @Test
    public void stopsAtFixedObjectsAndNeverEntersThem() throws Exception {
        for (String kind : OBSTACLES) {
            for (double speed : SPEEDS) {
                assertStops("box", kind, 0, speed);
            }
            assertStops("round", kind, 0, 0.5);
        }
    }

    @Test
    public void stopsAtObjectsTooHeavyToPush() throws Exception {
        for (String kind : OBSTACLES) {
            assertStops("box", kind, HEAVY, 0.1);
            assertStops("round", kind, HEAVY, 0.5);
        }
    }

    /** A wheel in front of the body meets the box first, and its grip keeps the robot straight. */
    @Test
    public void aProtrudingWheelKeepsItStraightAtAHeavyObject() throws Exception {
        for (double mass : new double[] {0, 30, 1000}) {
            new Floor("floor", 50, 50);
            SEARrobot object = new SEARrobot("robot");
            object.addComponent(new Dynamics("dynamics", 4, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 0));
            object.addComponent(new Cylinder("body", 0.1666875, 0.0762, 4));
            object.addWheel(new Wheel("front", 0.0381, 0.03, 0, 0, 0, 0.16));
            object.addWheel(new Wheel("right", 0.0381, 0.03, 1, -0.16, 0, 0));
            object.addWheel(new Wheel("left", 0.0381, 0.03, 1, 0.16, 0, 0));
            object.addWheel(new Wheel("back", 0.0381, 0.03, 0, 0, 0, -0.16));
            new Box("obstacle", 1, 1, 1, mass).move(0, 0.5, 2);
            Simulation simulation = Worlds.start(project);
            Worlds.run(simulation, 0.5);
            simulation.getRobots().get(0).drive(0.3, Double.POSITIVE_INFINITY);
            Worlds.run(simulation, 20);
            Pose pose = simulation.getRobots().get(0).getPose();
            double[] forward = pose.rotate(0, 0, 1);
            assertEquals(mass + " kg: degrees off straight on", 0,
                Math.toDegrees(Math.atan2(forward[0], forward[2])), 1);
            assertEquals(mass + " kg: front of the front wheel at the box", 1.5, pose.z + 0.16 + 0.0381, 0.01);
        }
    }

    private void assertStops(String shape, String kind, double mass, double speed) throws Exception {
        String what = shape + " robot at " + speed + " m/s against a " + kind + " of " + mass + " kg";
        new Floor("floor", 50, 50);
        robot(shape);
        obstacle(kind, mass);
        Simulation simulation = Worlds.start(project);
        Body robot = Worlds.body(simulation, simulation.getRobots().get(0).getObject().getName());
        Body obstacle = Worlds.body(simulation, "obstacle");
        Worlds.run(simulation, 0.5);
        simulation.getRobots().get(0).drive(speed, Double.POSITIVE_INFINITY);
        Worlds.run(simulation, 0.35 / speed);
        double deepest = 1;
        for (int step = 0; step < 240; step++) {
            simulation.step();
            if (mass == 0 && step < 120) {
                deepest = Math.min(deepest, between(robot, obstacle, FINE));
            }
        }
        assertTrue(what + " entered it by " + -deepest, deepest > -MILLIMETRE / 3);
        assertEquals(what, 0, between(robot, obstacle, FINEST), MILLIMETRE);
        RobotHardware hardware = simulation.getRobots().get(0).getHardware();
        assertTrue(what, hardware.isBumpedLeft() || hardware.isBumpedRight());
    }

    /**
     * Returns the distance between the robot's only part and the obstacle; negative if they overlap.
     * @param finest step of the search, radians
     */
    private static double between(Body robot, Body obstacle, double finest) {
        double best = Double.NEGATIVE_INFINITY;
        double yaw = 0;
        double pitch = 0;
        for (double step = 0.2; step > finest; step /= 2) {
            double fromYaw = yaw;
            double fromPitch = pitch;
            for (int i = -4; i <= 4; i++) {
                for (int k = -4; k <= 4; k++) {
                    double slab = slab(robot, obstacle, fromYaw + i * step, fromPitch + k * step);
                    if (slab > best) {
                        best = slab;
                        yaw = fromYaw + i * step;
                        pitch = fromPitch + k * step;
                    }
                }
            }
        }
        return best;
    }

    private static double slab(Body robot, Body obstacle, double yaw, double pitch) {
        double[] n = {Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)};
        return -reach(robot, n, 1) - reach(obstacle, n, -1);
    }

    private static double reach(Body body, double[] n, int sign) {
        Pose pose = body.getPose().times(body.places[0]);
        double[] inside = pose.rotateBack(sign * n[0], sign * n[1], sign * n[2]);
        double[] point = body.solids.get(0).farthest(inside[0], inside[1], inside[2]);
        double[] world = pose.transform(point[0], point[1], point[2]);
        return sign * (world[0] * n[0] + world[1] * n[1] + world[2] * n[2]);
    }
}
