// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** A car on a bridge of hinged planks. */
public class RopeBridgeTest {
    private static final int PLANKS = 20;
    private static final double LENGTH = 0.15;
    private static final double RADIUS = 10;
    /** Height of the arc's centre, metres. */
    private static final double CENTRE = 10.87;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static void bridge() {
        for (int side = -1; side <= 1; side += 2) {
            new Box(side < 0 ? "south" : "north", 1.6, 1, 1, 0, 2.3 * side, 0.5, 0, 0, 0, 0);
        }
        Box last = null;
        double step = LENGTH / RADIUS;
        for (int i = 0; i <= PLANKS; i++) {
            double angle = (i - PLANKS / 2) * step;
            double middle = angle + step / 2;
            Box plank = i == PLANKS ? null : new Box("plank" + i, LENGTH, 0.8, 0.04, 1, RADIUS * Math.sin(middle),
                CENTRE - RADIUS * Math.cos(middle), 0, 0, 0, Math.toDegrees(middle));
            new Hinge("hinge" + i, plank == null ? null : last, plank == null ? last : plank, RADIUS * Math.sin(angle),
                CENTRE - RADIUS * Math.cos(angle), 0, 90, 0, 0);
            last = plank;
        }
    }

    /** Returns the widest gap of a hinge, metres. */
    private static double opening(Simulation world) {
        double widest = 0;
        for (int i = 0; i <= PLANKS; i++) {
            Pose[] frames = world.getJoints().frames("hinge" + i);
            widest = Math.max(widest, Math.sqrt(Math.pow(frames[0].x - frames[1].x, 2)
                + Math.pow(frames[0].y - frames[1].y, 2) + Math.pow(frames[0].z - frames[1].z, 2)));
        }
        return widest;
    }

    @Test
    public void twentyPlanksCarryACar() throws Exception {
        bridge();
        SEARrobot car = Robots.car("car");
        car.move(-2, 1.1, 0);
        car.rotate(0, 90, 0);
        try (Simulation world = Worlds.start(project)) {
            world.getRobots().get(0).getHardware().setWheelSpeeds(0.4, 0.4);
            double lowest = 1;
            double widest = 0;
            for (int i = 0; i < 600; i++) {
                world.step();
                lowest = Math.min(lowest, world.getPose("plank10").y);
                widest = Math.max(widest, opening(world));
            }
            Pose end = world.getPose("car");
            assertTrue("on the northern bank, not at " + end.x, end.x > 1.7);
            assertTrue(end.y > 1);
            assertEquals("it drives along the middle", 0, end.z, 0.1);
            assertEquals("closed hinges", 0, widest, 1e-4);
            assertTrue("the bridge sags under the car, to " + lowest, lowest < 0.87);
        }
    }
}
