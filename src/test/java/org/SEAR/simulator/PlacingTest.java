package org.SEAR.simulator;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Sphere;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.sensors.DistanceReading;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** Things and robots that are put elsewhere while the world runs. */
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
        return world.place(name, Project.read(project.folder()));
    }

    private static double ahead(Simulation world) {
        return ((DistanceReading) world.read("ping")).getDistance();
    }

    @Test
    public void beamsSeeAFixedThingWhereItWasPut() throws Exception {
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
    public void robotsStopAtAFixedThingWhereItWasPutAndDriveWhereItWas() throws Exception {
        try (Simulation world = start()) {
            run(world, 60);
            wall.move(0, 0.5, 4.1);
            place(world, "wall");
            world.getRobots().get(0).getHardware().setWheelSpeeds(0.5, 0.5);
            run(world, 60 * 12);
            assertEquals("its front touches the wall", 4 - 0.17, world.getPose("rover").z, 0.02);
        }
    }

    @Test
    public void whatLayOnItFallsAndWhatSleptWakes() throws Exception {
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
    public void theSameMovesAtTheSameStepsGiveTheSameWorld() throws Exception {
        double[] first = moved();
        wall.move(0, 0.5, 2.1);
        ball.move(3, 1.15, 0);
        assertArrayEquals(first, moved(), 0);
    }

    private double[] moved() throws Exception {
        try (Simulation world = start()) {
            run(world, 100);
            ball.move(0.02, 1.5, 2.1);
            place(world, "ball");
            wall.move(0, 0.5, 2.15);
            place(world, "wall");
            run(world, 200);
            return new double[] {world.getPose("ball").x, world.getPose("ball").y, world.getPose("ball").z, ahead(world)};
        }
    }
}
