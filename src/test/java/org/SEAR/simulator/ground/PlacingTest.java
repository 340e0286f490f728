// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ground;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Sphere;
import org.SEAR.devices.RobotHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.sensors.DistanceReading;
import org.SEAR.simulator.Simulation;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** Objects and robots teleported while the world runs. */
public class PlacingTest {
    @Rule
    public final ProjectRule project = new ProjectRule();
    private Box wall;
    private Box shelf;
    private Sphere ball;
    private SEARrobot robot;

    @Before
    public void makeTheWorld() {
        new Floor("floor", 20, 20);
        wall = new Box("wall", 4, 0.2, 1);
        wall.move(0, 0.5, 2.1);
        shelf = new Box("shelf", 0.5, 0.5, 0.1);
        shelf.move(3, 1, 0);
        ball = new Sphere("ball", 0.1, 1);
        ball.move(3, 1.15, 0);
        robot = Robots.create("rover");
        Distance ping = new Distance("ping", "laser");
        ping.move(0, 0.1, 0);
        robot.addComponent(ping);
    }

    private Simulation start() throws Exception {
        return Simulation.load(project.folder(), 1);
    }

    private static void run(Simulation world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.step();
        }
    }

    private boolean place(Simulation world, String name) throws Exception {
        return world.place(name, Project.read(project.folder()), false);
    }

    private static double ahead(Simulation world) {
        return ((DistanceReading) world.read("ping")).getDistance();
    }

    @Test
    public void beamsSeeATeleportedFixedObject() throws Exception {
        try (Simulation world = start()) {
            run(world, 120);
            assertEquals(2, ahead(world), 0.01);
            wall.move(0, 0.5, 1.1);
            assertTrue(place(world, "wall"));
            run(world, 1);
            assertEquals(1, ahead(world), 0.01);
            world.reset();
            run(world, 1);
            assertEquals("a reset finds it there, too", 1, ahead(world), 0.01);
            assertFalse(place(world, "nothing of that name"));
        }
    }

    @Test
    public void robotsStopAtATeleportedFixedObjectAndDriveOverItsFormerPlace() throws Exception {
        try (Simulation world = start()) {
            run(world, 60);
            wall.move(0, 0.5, 4.1);
            place(world, "wall");
            world.getRobots().get(0).getHardware().setWheelSpeeds(0.5, 0.5);
            run(world, 60 * 12);
            assertEquals("its front touches the wall", 4 - 0.17, world.getPose("rover").z, 0.02);
        }
    }

    /** A closed mesh of 4 x 1 x 0.3 m comes down on a ball inside it and on a robot across its surface. */
    @Test
    public void bodiesInAClosedMeshLeaveItTheShortestWay() throws Exception {
        Path assets = project.folder().resolve("assets");
        Files.createDirectories(assets);
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < 8; i++) {
            text.append(String.format(Locale.ROOT, "v %d %.1f %.2f%n", i < 4 ? -2 : 2, i % 4 < 2 ? -0.5 : 0.5,
                i % 2 == 0 ? -0.15 : 0.15));
        }
        Files.writeString(assets.resolve("thick.obj"),
            text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n");
        Model thick = new Model("thick", "thick.obj", 0);
        thick.move(0, 0.5, -6);
        ball.move(1, 0.1, 0.02);
        try (Simulation world = start()) {
            run(world, 60);
            thick.move(0, 0.5, 0);
            place(world, "thick");
            run(world, 60);
            assertEquals(0.25, world.getPose("ball").z, 0.02);
            assertTrue("" + world.getPose("rover").z, Math.abs(world.getPose("rover").z) > 0.25);
            world.move("ball", world.getPose("ball"), Pose.ofDegrees(1, 0.1, -0.12, 0, 0, 0));
            assertEquals("after its own teleport", -0.25, world.getPose("ball").z, 0.01);
            String warnings = String.join("\n", world.snapshot().warnings);
            assertTrue(warnings, warnings.contains("ball was inside a fixed object: SEAR moved it by (0.000, "));
        }
    }

    @Test
    public void objectsOnAMovedSupportWakeAndFall() throws Exception {
        try (Simulation world = start()) {
            run(world, 600);
            assertEquals(1.15, world.getPose("ball").y, 0.01);
            shelf.move(-3, 1, 0);
            place(world, "shelf");
            run(world, 180);
            assertEquals(0.1, world.getPose("ball").y, 0.01);
            ball.move(-3, 2, 0);
            place(world, "ball");
            run(world, 180);
            assertEquals("it lies on the shelf again", 1.15, world.getPose("ball").y, 0.01);
        }
    }

    @Test
    public void aRobotGoesToItsStartAndItsOdometerDoesNotCountTheWay() throws Exception {
        try (Simulation world = start()) {
            world.getRobots().get(0).getHardware().setWheelSpeeds(0.2, 0.2);
            run(world, 120);
            world.getRobots().get(0).getHardware().setWheelSpeeds(0, 0);
            run(world, 60);
            double path = world.getRobots().get(0).getHardware().getPath();
            robot.placeAt(-5, 3, 0);
            assertTrue(place(world, "rover"));
            run(world, 60);
            assertEquals(-5, world.getPose("rover").x, 0.01);
            assertEquals(3, world.getPose("rover").z, 0.01);
            assertEquals("it looks north", 1, world.getPose("rover").rotate(0, 0, 1)[0], 0.01);
            assertEquals(path, world.getRobots().get(0).getHardware().getPath(), 0.002);
            robot.placeAt(50, 50);
            String message = assertThrows(IllegalArgumentException.class, () -> place(world, "rover")).getMessage();
            assertTrue(message, message.contains("a place with ground"));
            assertEquals("it stays where it is", -5, world.getPose("rover").x, 0.01);
        }
    }

    @Test
    public void aDrivingRobotIsPutDownAtRestAndDrivesOnFromThere() throws Exception {
        try (Simulation world = start()) {
            RobotHardware hardware = world.getRobots().get(0).getHardware();
            hardware.setWheelSpeeds(0.3, 0.3);
            run(world, 120);
            Pose left = world.getPose("rover/" + robot.getWheels().get(0).getName());
            Pose before = world.getPose("rover");
            robot.move(-5, 0, 3);
            robot.rotate(0, 180, 0);
            wall.move(-5, 0.5, 1.1);
            place(world, "wall");
            assertTrue(place(world, "rover"));
            assertEquals("at once", -5, world.snapshot().robots.get(0).pose.x, 1e-9);
            Pose wheel = world.getPose("rover/" + robot.getWheels().get(0).getName());
            assertEquals("its wheels with it, the other way round", left.x - before.x, -5 - wheel.x, 1e-3);
            run(world, 1);
            assertEquals("it measures from there in the next step", 3 - 1.2, ahead(world), 0.01);
            assertTrue("at rest: " + world.snapshot().robots.get(0).speed, world.snapshot().robots.get(0).speed < 0.15);
            run(world, 120);
            assertTrue("its motors go on: " + world.getPose("rover"), world.getPose("rover").z < 2.7);
            world.reset();
            assertEquals("a reset finds it there", 3, world.getPose("rover").z, 1e-9);
        }
    }

    @Test
    public void undoneMovesRestoreTheFormerPlace() throws Exception {
        try (Simulation world = start()) {
            drive(world, 120);
            Pose driven = world.getPose("rover");
            robot.move(-5, 0, 3);
            place(world, "rover");
            drive(world, 60);
            Pose again = world.getPose("rover");
            robot.move(-5, 0, -3);
            place(world, "rover");
            robot.move(-5, 0, 3);
            assertTrue(world.place("rover", Project.read(project.folder()), true));
            assertEquals(again.z, world.getPose("rover").z, 1e-9);
            robot.move(0, 0, 0);
            world.place("rover", Project.read(project.folder()), true);
            assertEquals(driven.z, world.getPose("rover").z, 1e-9);
            run(world, 60);
            assertEquals("it stands", driven.z, world.getPose("rover").z, 0.01);
            world.reset();
            assertEquals("a reset finds it at its start", 0, world.getPose("rover").z, 1e-9);
        }
    }

    private static void drive(Simulation world, int steps) {
        world.getRobots().get(0).getHardware().setWheelSpeeds(0.3, 0.3);
        run(world, steps);
        world.getRobots().get(0).getHardware().setWheelSpeeds(0, 0);
        run(world, 60);
    }

    /** The shelf is fixed at a height of 0.95 to 1.05 m; the ball lies on it. */
    @Test
    public void aTeleportedRobotStandsOnItsSupportWithoutOverlap() throws Exception {
        Box step = new Box("step", 1, 1, 0.2);
        step.move(-3, 0.1, 0);
        try (Simulation world = start()) {
            run(world, 60);
            double floor = world.getPose("rover").y;
            assertEquals("on the floor as before", 0, world.rise("rover", shift(-1.5)), 0.005);
            assertEquals("on the step", 0.2, world.rise("rover", shift(-3)), 0.005);
            assertEquals("below the shelf", 0, world.rise("rover", shift(3)), 0.005);
            assertEquals("beside the world it keeps its height", 0, world.rise("rover", shift(30)), 0.005);
            assertEquals("only robots", 0, world.rise("ball", shift(1)), 0);
            robot.move(-3, 0, 0);
            place(world, "rover");
            assertTrue("lifted out of the step", world.getPose("rover").y >= 0.2);
            run(world, 120);
            assertEquals(0.2 + floor, world.getPose("rover").y, 0.005);
            assertEquals("down from it", 0, world.rise("rover", shift(3)) + world.getRobots().get(0).getStart().y,
                floor + 0.005);
        }
    }

    private static Pose shift(double x) {
        return new Pose(x, 0, 0, 0, 0, 0, 1);
    }

    @Test
    public void theSameMovesAtTheSameStepsGiveTheSameWorld() throws Exception {
        double[] first = moved();
        wall.move(0, 0.5, 2.1);
        ball.move(3, 1.15, 0);
        robot.move(0, 0, 0);
        assertArrayEquals(first, moved(), 0);
    }

    private double[] moved() throws Exception {
        try (Simulation world = start()) {
            run(world, 100);
            ball.move(0.02, 1.5, 2.1);
            place(world, "ball");
            wall.move(0, 0.5, 2.15);
            place(world, "wall");
            world.getRobots().get(0).getHardware().setWheelSpeeds(0.2, 0.3);
            run(world, 100);
            robot.move(-1, 0, 1);
            place(world, "rover");
            run(world, 100);
            Pose rover = world.getPose("rover");
            return new double[] {rover.x, rover.y, rover.z, rover.qy,
                world.getPose("ball").x, world.getPose("ball").y, world.getPose("ball").z, ahead(world)};
        }
    }
}
