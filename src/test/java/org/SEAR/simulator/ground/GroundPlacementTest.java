// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ground;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.Locale;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Sphere;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Objects placed on any ground stand there before the first step. */
public class GroundPlacementTest {
    private static final double FINE = 1e-3;

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** Makes a slope of triangles that rises by 1 m in 4 m to the north, 40 m long and wide. */
    private void slope() throws Exception {
        project.put("assets/slope.obj",
            String.format(Locale.ROOT, "v -20 -5 -20%nv 20 5 -20%nv -20 -5 20%nv 20 5 20%nf 1 3 4%nf 1 4 2%n"));
        new Model("slope", "slope.obj").setTerrain(true);
    }

    private Pose start(String name) throws Exception {
        try (Simulation simulation = Worlds.start(project)) {
            assertEquals(simulation.snapshot().warnings.toString(), 0, simulation.snapshot().warnings.size());
            return simulation.getPose(name);
        }
    }

    @Test
    public void itStandsOnTheHighestFloor() throws Exception {
        new Floor("low", 20, 20);
        new Floor("high", 4, 4).move(0, 1.5, 0);
        new Box("roof", 10, 0.1, 10).move(0, 5, 0);
        Box box = new Box("box", 1, 0.6, 0.5, 2);
        box.move(3, 7, 3);
        box.placeAt(0.5, 0.5);
        new Sphere("beside", 0.25, 1).placeAt(6, 6);
        assertEquals(1.5 + 0.25, start("box").y, FINE);
        assertEquals(0.25, start("beside").y, FINE);
        assertEquals(6, start("beside").x, 0);
    }

    @Test
    public void theGroundIsFoundBelowAnObject() throws Exception {
        new Floor("floor", 20, 20);
        new Box("box", 1, 0.5, 0.5, 2).placeAt(1, 1);
        new Box("pillar", 1, 0.5, 0.5).placeAt(3, 3);
        new Sphere("ball", 0.25, 1).placeAt(5, 5);
        Worlds.roomba("roomba", -2, -2, 0);
        try (Simulation simulation = Worlds.start(project)) {
            for (int step = 0; step < 60; step++) {
                for (double at : new double[] {1, 3, 5, -2, 7}) {
                    assertEquals("at " + at + " in step " + step, 0, simulation.getGroundHeight(at, at), 1e-9);
                }
                simulation.step();
            }
        }
    }

    @Test
    public void onASlopeNoPartIsBelowTheGround() throws Exception {
        slope();
        new Box("box", 2, 1, 0.5).placeAt(4, 3);
        new Cone("cone", 0.5, 1).placeAt(-4, 3);
        new Sphere("ball", 0.5, 3).placeAt(8, 3);
        assertEquals("its upper edge, 1 m north of its middle, touches", (4 + 1) / 4.0 + 0.25, start("box").y, FINE);
        assertEquals((-4 + 0.5) / 4 + 0.5, start("cone").y, FINE);
        assertEquals(8 / 4.0 + 0.5 * Math.hypot(1, 0.25), start("ball").y, FINE);
    }

    @Test
    public void aRobotStandsOnItsWheelsAlongTheSlopeAndAtRest() throws Exception {
        slope();
        SEARrobot robot = Worlds.cart("cart", 20, 0.1, 0.25, new double[] {0.2, -0.2}, 0, 0, 0, 0);
        robot.getComponents().stream().filter(part -> part instanceof Dynamics).forEach(part -> {
            part.move(7, 8, 9);
            part.rotate(0, 70, 0);
        });
        robot.rotate(0, 20, 0);
        robot.placeAt(4, 3, 90);
        try (Simulation simulation = Worlds.start(project)) {
            assertEquals(simulation.snapshot().warnings.toString(), 0, simulation.snapshot().warnings.size());
            Pose before = simulation.getPose("cart");
            assertEquals(4, before.x, 0.05);
            assertEquals(3, before.z, 0.05);
            assertEquals("it looks east, across the slope", 1, before.rotate(0, 0, 1)[2], FINE);
            assertEquals("and leans as the slope does", Math.cos(Math.atan(0.25)), before.rotate(0, 1, 0)[1], FINE);
            Worlds.run(simulation, 3);
            Pose after = simulation.getPose("cart");
            assertEquals("it neither falls nor jumps", before.y, after.y, 0.02);
        }
    }

    @Test
    public void aRobotKeepsItsHeadingUnlessAnotherIsGiven() throws Exception {
        new Floor("floor", 20, 20);
        SEARrobot robot = Worlds.cart("cart", 20, 0.1, 0.25, new double[] {0.2, -0.2}, 0, 0, 0, 30);
        robot.placeAt(4, 3, -45);
        assertEquals(Math.sin(Math.toRadians(-45)), start("cart").rotate(0, 0, 1)[2], FINE);
        robot.placeAt(5, 6);
        assertEquals(Math.sin(Math.toRadians(-45)), start("cart").rotate(0, 0, 1)[2], FINE);
        robot.rotate(0, 0, 0);
        assertEquals("as its Dynamics has it", Math.cos(Math.toRadians(30)), start("cart").rotate(0, 0, 1)[2], FINE);
        assertEquals(5, start("cart").x, 0);
        robot.move(1, 0, 1);
        assertEquals(1, start("cart").x, FINE);
    }

    @Test
    public void anObliqueHeadingOnASlopeEqualsTheCompassReading() throws Exception {
        slope();
        SEARrobot robot = Worlds.cart("cart", 20, 0.1, 0.25, new double[] {0.2, -0.2}, 0, 0, 0, 0);
        robot.placeAt(0, 0);
        for (double heading : new double[] {0, 45, 90, 100, -30, -150}) {
            robot.rotate(0, 90 - heading, 0);
            Pose pose = start("cart");
            assertEquals(heading, pose.heading(), 1e-6);
            assertEquals("and it leans as the slope does", Math.cos(Math.atan(0.25)), pose.rotate(0, 1, 0)[1], FINE);
        }
    }

    @Test
    public void movingItTakesItOffTheGround() throws Exception {
        new Floor("floor", 20, 20);
        Box box = new Box("box", 1, 1, 1);
        box.place(36.5, -84.2);
        box.placeAt(3, 3);
        box.move(1, 4, 1);
        assertEquals(4, start("box").y, 0);
    }

    @Test
    public void missingGroundOrOriginIsReported() throws Exception {
        new Floor("floor", 20, 20);
        new Box("beside", 1, 1, 1).placeAt(30, 3);
        new Box("nowhere", 1, 1, 1).place(36.5, -84.2);
        SEARrobot robot = Worlds.cart("cart", 20, 0.1, 0.25, new double[] {0.2, -0.2}, 0, 0, 0, 0);
        robot.placeAt(-40, 0);
        String told = assertThrows(ProjectException.class, () -> Worlds.start(project)).getMessage();
        assertTrue(told, told.contains("environment/beside.xml: x, z is \"30, 3\", legal: a place with ground"));
        assertTrue(told, told.contains("environment/nowhere.xml: placeLatitude is \"36.5\", legal: only with a "
            + "Terrain whose map"));
        assertTrue(told, told.contains("robot/cart.xml: x, z is \"-40, 0\", legal: a place with ground"));
    }

    @Test
    public void partsOfRobotsAreNotPlaced() throws Exception {
        SEARrobot robot = new SEARrobot("cart");
        Box part = new Box("part", 1, 1, 1);
        robot.addComponent(part);
        assertRefused("Box \"part\" is a part of SEARrobot \"cart\" and can't be placed on the ground",
            () -> part.placeAt(1, 2));
        Box placed = new Box("placed", 1, 1, 1);
        placed.placeAt(1, 2);
        assertRefused("Box \"placed\" was placed on the ground, which a component can't be",
            () -> robot.addComponent(placed));
        assertRefused("Box \"placed\": placeLatitude is 91, legal: a number from -90 to 90 deg",
            () -> placed.place(91, 0));
        assertTrue("nothing is lost", placed.isOnGround());
        project.put("robot/part.xml", project.files().get("robot/part.xml")
            .replace("<mass>", "<onGround>true</onGround><mass>"));
        String told = assertThrows(ProjectException.class, () -> Worlds.start(project)).getMessage();
        assertTrue(told, told.contains("robot/part.xml:10: onGround is \"true\", legal: none for Box \"part\", a "
            + "part of a robot"));
    }

    private static void assertRefused(String message, org.junit.function.ThrowingRunnable call) {
        String told = assertThrows(IllegalArgumentException.class, call).getMessage();
        assertTrue(told, told.contains(message));
    }
}
