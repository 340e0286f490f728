// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.SEAR.simulator.orders.BodyOrder;
import org.SEAR.simulator.orders.BodyOrder.Kind;
import org.junit.Rule;
import org.junit.Test;

/** Objects that start with a velocity, get one while the world runs, or are pushed. */
public class LaunchTest {
    private static final double G = 9.81;
    private static final double NEAR = 2e-3;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static void at(String what, double x, double y, double z, Pose pose) {
        assertArrayEquals(what, new double[] {x, y, z}, new double[] {pose.x, pose.y, pose.z}, NEAR);
    }

    private static double[] velocities(Simulation simulation, String name) {
        double[] v = new double[6];
        Worlds.body(simulation, name).velocities(v);
        return v;
    }

    private Simulation thrown() throws Exception {
        Box box = new Box("box", 0.3, 0.3, 0.3, 1);
        box.move(0, 100, 0);
        box.setVelocity(3, 5, -2);
        box.setSpin(0, 90, 0);
        return Worlds.start(project);
    }

    @Test
    public void anObjectStartsWithItsVelocityAndSpin() throws Exception {
        try (Simulation simulation = thrown()) {
            Worlds.run(simulation, 1);
            at("a parabola", 3, 100 + 5 - G / 2, -2, simulation.getPose("box"));
            assertArrayEquals("a quarter turn to the left", new double[] {0, 0, -1}, simulation.getPose("box")
                .rotate(1, 0, 0), NEAR);
        }
    }

    /** Speeds so low that a touching contact need not be detected in every step. */
    @Test
    public void aCreepingObjectStopsAtAnObstacle() throws Exception {
        new Floor("floor", 20, 20).setFriction(0);
        new Box("wall", 0.3, 0.3, 0.3).move(0, 0.15, 0);
        for (double speed : new double[] {0.003, 0.008, 0.011}) {
            Box box = new Box("box", 0.2, 0.2, 0.2, 1);
            box.setFriction(0);
            box.move(0, 0.1, 0.27);
            box.setVelocity(0, 0, -speed);
            try (Simulation simulation = Worlds.start(project)) {
                Worlds.run(simulation, 10);
                assertEquals(speed + " m/s", 0.25, simulation.getPose("box").z, NEAR);
            }
        }
    }

    @Test
    public void aResetFindsItsVelocityAgain() throws Exception {
        try (Simulation simulation = thrown()) {
            simulation.order(new BodyOrder(Kind.VELOCITY, "box", 0, 0, 0, 0));
            simulation.order(new BodyOrder(Kind.PUSH, "box", 10, 0, 0, 5));
            Worlds.run(simulation, 2);
            simulation.reset();
            Worlds.run(simulation, 1);
            at("as at the start, and nobody pushes", 3, 100 + 5 - G / 2, -2, simulation.getPose("box"));
        }
    }

    @Test
    public void aVelocityWhileTheWorldRunsLeavesTheSpinAndTheOtherWayRound() throws Exception {
        try (Simulation simulation = thrown()) {
            simulation.order(new BodyOrder(Kind.VELOCITY, "box", -1, 0, 0, 0));
            assertArrayEquals(new double[] {-1, 0, 0, 0, Math.PI / 2, 0}, velocities(simulation, "box"), NEAR);
            simulation.order(new BodyOrder(Kind.SPIN, "box", 180, 0, 0, 0));
            assertArrayEquals(new double[] {-1, 0, 0, Math.PI, 0, 0}, velocities(simulation, "box"), NEAR);
            Worlds.run(simulation, 1);
            at("thrown another way", -1, 100 - G / 2, 0, simulation.getPose("box"));
        }
    }

    @Test
    public void aPushMovesAsAConstantForce() throws Exception {
        new Box("box", 0.3, 0.3, 0.3, 2).move(0, 100, 0);
        try (Simulation simulation = Worlds.start(project)) {
            simulation.order(new BodyOrder(Kind.PUSH, "box", 6, 0, -2, 1));
            Worlds.run(simulation, 1);
            at("half of force by mass, times the square of the time", 1.5, 100 - G / 2, -0.5,
                simulation.getPose("box"));
            Worlds.run(simulation, 1);
            at("on with the speed that it got", 4.5, 100 - 2 * G, -1.5, simulation.getPose("box"));
            assertArrayEquals(new double[] {3, -2 * G, -1, 0, 0, 0}, velocities(simulation, "box"), 0.01);
        }
    }

    @Test
    public void aTapShorterThanAStepGivesItsWholeImpulse() throws Exception {
        new Box("box", 0.3, 0.3, 0.3, 2).move(0, 100, 0);
        try (Simulation simulation = Worlds.start(project)) {
            simulation.order(new BodyOrder(Kind.PUSH, "box", 400, 0, 0, 0.005));
            simulation.order(new BodyOrder(Kind.PUSH, "box", 40, 0, 0, 0.025));
            Worlds.run(simulation, 0.2);
            assertEquals("both add up", 1.5, velocities(simulation, "box")[0], 1e-5);
        }
    }

    @Test
    public void aPushWakesASleepingObjectAndFrictionStopsIt() throws Exception {
        new Floor("floor", 40, 40);
        Box box = new Box("box", 0.6, 0.6, 0.2, 2);
        box.setFriction(0.25);
        box.move(0, 0.1, 0);
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 5);
            assertFalse("it sleeps", Worlds.body(simulation, "box").isActive());
            simulation.order(new BodyOrder(Kind.PUSH, "box", 2, 0, 0, 1));
            Worlds.run(simulation, 2);
            assertEquals("friction holds it", 0, simulation.getPose("box").x, 1e-3);
            double force = 10;
            double friction = 0.2 * 2 * G;
            double speed = (force - friction) / 2;
            simulation.order(new BodyOrder(Kind.PUSH, "box", force, 0, 0, 1));
            Worlds.run(simulation, 5);
            double way = speed / 2 + speed * speed / (2 * 0.2 * G);
            assertEquals("as far as the closed form says", way, simulation.getPose("box").x, 0.02 * way);
        }
    }

    @Test
    public void aRobotIsPushedToo() throws Exception {
        new Floor("floor", 40, 40);
        Worlds.cart("cart", 2, 0.05, 0.15, new double[] {0}, -0.15, 0, 0, 0);
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 1);
            double x = simulation.getPose("cart").x;
            simulation.order(new BodyOrder(Kind.PUSH, "cart", 200, 0, 0, 0.2));
            Worlds.run(simulation, 1);
            assertTrue("it was at " + x + " and is at " + simulation.getPose("cart").x,
                simulation.getPose("cart").x > x + 0.1);
        }
    }

    @Test
    public void teleportedObjectsAreAtRest() throws Exception {
        new Floor("floor", 40, 40);
        new Box("box", 0.3, 0.3, 0.3, 1).move(0, 0.15, 0);
        try (Simulation simulation = Worlds.start(project)) {
            simulation.order(new BodyOrder(Kind.PUSH, "box", 100, 0, 0, 60));
            Pose there = new Pose(5, 0.15, 0, 0, 0, 0, 1);
            simulation.move("box", there, there);
            Worlds.run(simulation, 2);
            at("nobody pushes it any more", 5, 0.15, 0, simulation.getPose("box"));
        }
    }

    private static void refused(String part, Runnable action) {
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, action::run);
        assertTrue(e.getMessage(), e.getMessage().contains(part));
    }

    @Test
    public void impossibleValuesAreRejectedByName() throws Exception {
        Box fixed = new Box("wall", 1, 1, 1);
        Box box = new Box("box", 0.3, 0.3, 0.3, 1, 0, 5, 0);
        refused("Box \"wall\" is fixed (mass 0) and can't have a velocity", () -> fixed.setVelocity(1, 0, 0));
        refused("velocityY is 1001", () -> box.setVelocity(0, 1001, 0));
        refused("spinX is NaN", () -> box.setSpin(Double.NaN, 0, 0));
        refused("\"lost\": velocityX can't be set: a wheel belongs to a robot", () -> new Wheel("lost", 0.1, 0.05)
            .setVelocity(1, 0, 0));
        box.setSpin(0, 0, 10);
        refused("mass is 0, legal: more than 0 kg for an object with a velocity or a spin", () -> box.setMass(0));
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("drive", 4));
        refused("has a velocity or a spin, which a component can't have", () -> robot.addComponent(box));
        robot.addWheel(new Wheel("wheel", 0.1, 0.05));
        refused("velocityX is 2, legal: 0 for a fixed object", () -> SearObject.make(Box.class,
            Map.of("name", "other", "length", 1, "width", 1, "height", 1, "velocityX", 2)));
        try (Simulation simulation = Worlds.start(project)) {
            refused("wall is fixed", () -> simulation.order(new BodyOrder(Kind.PUSH, "wall", 1, 0, 0, 1)));
            refused("nothing that can be moved is named \"ghost\"",
                () -> simulation.order(new BodyOrder(Kind.SPIN, "ghost", 1, 0, 0, 0)));
            refused("legal for its 1.0 kg: at most 60000",
                () -> simulation.order(new BodyOrder(Kind.PUSH, "box", 70000, 0, 0, 1)));
            refused("push for 0.0 s", () -> new BodyOrder(Kind.PUSH, "box", 1, 0, 0, 0));
            refused("velocity is Infinity along an axis",
                () -> new BodyOrder(Kind.VELOCITY, "box", 0, Double.POSITIVE_INFINITY, 0, 0));
        }
    }

    private String problem() {
        return assertThrows(ProjectException.class, () -> Worlds.start(project)).getMessage();
    }

    @Test
    public void filesWithImpossibleValuesAreRejected() throws Exception {
        project.put("environment/box.xml",
            "<Box><name>box</name><length>1</length><width>1</width><height>1</height><spinY>30</spinY></Box>");
        String message = problem();
        assertTrue(message, message.contains("environment/box.xml") && message.contains("spinY")
            && message.contains("0 for a fixed object"));
        project.put("environment/box.xml",
            "<Box><name>box</name><length>1</length><width>1</width><height>1</height><mass>1</mass></Box>");
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("drive", 4, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.2, 0.2, 0.1, 4));
        robot.addWheel(new Wheel("wheel", 0.05, 0.02));
        project.put("robot/body.xml", project.text("robot/body.xml")
            .replace("</Box>", "<velocityZ>1</velocityZ></Box>"));
        message = problem();
        assertTrue(message, message.contains("robot/body.xml") && message.contains("velocityZ")
            && message.contains("a part of a robot"));
    }

    @Test
    public void theFileHasTheStartingVelocity() throws Exception {
        Box box = new Box("box", 0.3, 0.3, 0.3, 1);
        box.setVelocity(1, -2, 0.5);
        box.setSpin(0, 720, 0);
        String text = project.text("environment/box.xml");
        for (String line : List.of("<velocityX>1</velocityX>", "<velocityY>-2</velocityY>",
            "<velocityZ>0.5</velocityZ>", "<spinY>720</spinY>")) {
            assertTrue(text, text.contains(line));
        }
        assertFalse(text, text.contains("spinX"));
    }
}
