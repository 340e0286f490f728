// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Sphere;
import org.SEAR.Slow;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Standing and lying objects stay in place; pushed objects move straight. */
@Category(Slow.class)
public class RestingTest {
    private static final double STRAIGHT = Double.POSITIVE_INFINITY;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Before
    public void floor() {
        new Floor("floor", 50, 50);
    }

    @Test
    public void aStackStandsAndSleeps() throws Exception {
        for (int i = 0; i < 4; i++) {
            place(new Box("box" + i, 0.25, 0.25, 0.25, 1), 0, 0.125 + 0.25 * i, 0, 0, 15 * i, 0);
        }
        staysPut(3, "box0", "box1", "box3");
    }

    @Test
    public void differentObjectsOnTopOfEachOtherStay() throws Exception {
        place(new Box("box", 0.5, 0.5, 0.3, 2), 0, 0.15, 0, 0, 30, 0);
        place(new Cylinder("can", 0.15, 0.4, 2), 0.1, 0.5, 0, 0, 0, 0);
        place(new Cone("cone", 0.15, 0.4, 1), 0.1, 0.9, 0, 0, 0, 0);
        staysPut(3, "box", "can", "cone");
    }

    @Test
    public void roundObjectsStandAndLie() throws Exception {
        double slope = Math.atan2(0.2, 0.6);
        place(new Cylinder("standing", 0.2, 0.6, 3), 0, 0.3, 0, 0, 0, 0);
        place(new Cylinder("lying", 0.2, 0.6, 3), 2, 0.2, 0, 0, 0, 90);
        place(new Cone("cone", 0.2, 0.6, 3), 4, 0.3, 0, 0, 0, 0);
        place(new Cone("lyingCone", 0.2, 0.6, 3), 6, 0.3 * Math.sin(slope), 0, 0, 0, 90 + Math.toDegrees(slope));
        staysPut(3, "standing", "lying", "cone", "lyingCone");
    }

    @Test
    public void spheresRestOnTheirLowestPoint() throws Exception {
        place(new Sphere("ball", 0.2, 3), 0, 0.2, 0, 0, 0, 0);
        place(new Sphere("small", 0.02, 0.05), 1, 0.02, 0, 30, 40, 50);
        Sphere flat = new Sphere("flat", 0.2, 3);
        flat.scale(1, 0.5, 1.5);
        place(flat, 2, 0.1, 0, 0, 20, 0);
        staysPut(3, "ball", "small", "flat");
    }

    @Test
    public void aSphereThatFallsStopsAtItsRadius() throws Exception {
        place(new Sphere("ball", 0.2, 3), 0, 1.2, 0, 10, 20, 30);
        Sphere egg = new Sphere("egg", 0.2, 1);
        egg.scale(0.7, 1, 0.7);
        egg.setRollingFriction(0.05);    // otherwise it rocks for minutes
        place(egg, 3, 0.5, 0, 0, 0, 20);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 40);
        assertEquals(0.2, simulation.getPose("ball").y, 1e-3);
        assertEquals("an egg lies on its side", 0.14, simulation.getPose("egg").y, 2e-3);
        assertEquals(0, Worlds.physics(simulation).getBusyBodies());
    }

    @Test
    public void fallingObjectsComeToRestOnAFace() throws Exception {
        place(new Box("box", 0.3, 0.4, 0.2, 2), 0, 0.5, 0, 10, 20, 30);
        place(new Cone("cone", 0.2, 0.6, 3), 2, 0.3, 0, 0, 0, 80);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 6);
        assertEquals(0, Worlds.physics(simulation).getBusyBodies());
        double[] up = simulation.getPose("box").rotate(0, 1, 0);
        assertEquals(0.1, simulation.getPose("box").y, 1e-3);
        assertEquals(1, up[1], 1e-3);
        assertEquals("on its side", -0.3162, simulation.getPose("cone").rotate(0, 1, 0)[1], 1e-3);
    }

    @Test
    public void aLightBoxIsPushedStraightWithoutJumping() throws Exception {
        place(new Box("box", 0.25, 0.25, 0.25, 0.5), 0, 0.125, 0.5, 0, 0, 0);
        Worlds.roomba("roomba", 0, 0, 0);
        Simulation simulation = Worlds.start(project);
        simulation.getRobots().get(0).drive(0.3, STRAIGHT);
        double last = 0;
        for (int step = 0; step < 420; step++) {
            simulation.step();
            Pose box = simulation.getPose("box");
            assertEquals("height at step " + step, 0.125, box.y, 0.002);
            assertTrue("back at step " + step, box.z >= last - 0.001);
            last = box.z;
        }
        assertEquals("aside", 0, simulation.getPose("box").x, 0.02);
        assertEquals(simulation.getPose("roomba").z + 0.1666875 + 0.125, last, 0.03);
    }

    private static void place(SearObject object, double x, double y, double z, double rx, double ry, double rz) {
        object.move(x, y, z);
        object.rotate(rx, ry, rz);
    }

    private void staysPut(double seconds, String... names) throws Exception {
        Simulation simulation = Worlds.start(project);
        assertTrue(simulation.snapshot().warnings.toString(), simulation.snapshot().warnings.isEmpty());
        Pose[] starts = new Pose[names.length];
        for (int i = 0; i < names.length; i++) {
            starts[i] = simulation.getPose(names[i]);
        }
        Worlds.run(simulation, 0.5);
        Pose[] settled = new Pose[names.length];
        for (int i = 0; i < names.length; i++) {
            settled[i] = simulation.getPose(names[i]);
            assertEquals(names[i] + " from its start", 0, distance(starts[i], settled[i]), 0.015);
        }
        Worlds.run(simulation, seconds);
        for (int i = 0; i < names.length; i++) {
            assertEquals(names[i] + " creeps", 0, distance(settled[i], simulation.getPose(names[i])), 1e-3);
        }
        assertEquals("something never sleeps", 0, Worlds.physics(simulation).getBusyBodies());
    }

    private static double distance(Pose a, Pose b) {
        return Math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
    }
}
