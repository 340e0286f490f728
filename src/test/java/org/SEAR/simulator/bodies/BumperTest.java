// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** A bumper is pressed while its part touches anything but its robot. */
public class BumperTest {
    private static final double STRAIGHT = Double.POSITIVE_INFINITY;

    @Rule
    public final ProjectRule project = new ProjectRule();
    private Simulation simulation;

    private static Box box(String name, double length, double width, double height, double mass, double x,
        double y, double z) {
        Box box = new Box(name, length, width, height, mass);
        box.move(x, y, z);
        return box;
    }

    /** Makes a robot with two plates in front of body and wheels, which end at 0.2 m. */
    private static SEARrobot rover(double z) {
        new Floor("floor", 50, 50);
        SEARrobot rover = Worlds.roomba("rover", 0, z, 0);
        for (int side : new int[] {1, -1}) {
            Box plate = box(side > 0 ? "leftPlate" : "rightPlate", 0.1, 0.02, 0.05, 0, side * 0.08, 0.03, 0.25);
            rover.addComponent(plate);
            rover.addComponent(new Bumper(side > 0 ? "left" : "right", plate));
        }
        rover.addComponent(new Bumper("any"));
        return rover;
    }

    private boolean isPressed(String bumper) {
        return (Boolean) simulation.read(bumper).value();
    }

    private void start() throws Exception {
        simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
    }

    private void drive(double speed) {
        simulation.getRobots().get(0).drive(speed, STRAIGHT);
    }

    /** Drives until a bumper is pressed, at most ten seconds. */
    private void driveUntil(String bumper) {
        assertFalse(isPressed("any"));
        drive(0.1);
        for (int i = 0; i < 600 && !isPressed(bumper); i++) {
            simulation.step();
        }
        assertTrue(bumper + " of the robot at " + simulation.getPose("rover").z, isPressed(bumper));
    }

    @Test
    public void aPostPressesThePlateThatMeetsIt() throws Exception {
        rover(0);
        box("post", 0.05, 0.05, 0.5, 0, 0.1, 0.25, 0.6);
        start();
        driveUntil("left");
        assertEquals(0.6 - 0.025 - 0.26, simulation.getPose("rover").z, 0.005);
        assertFalse("the other plate", isPressed("right"));
        assertTrue("the whole robot", isPressed("any"));
        assertEquals("pressed", simulation.getUnit("left"));
        drive(-0.1);
        Worlds.run(simulation, 1);
        assertFalse("it drove back", isPressed("left") || isPressed("any"));
    }

    @Test
    public void contactsBesideThePlatesPressOnlyTheWholeRobot() throws Exception {
        rover(0);
        box("post", 0.05, 0.05, 0.5, 0, 0.16, 0.25, 0.5);
        start();
        driveUntil("any");
        assertFalse(isPressed("left") || isPressed("right"));
    }

    @Test
    public void aCrateThatItPushesPressesBoth() throws Exception {
        rover(0);
        box("crate", 0.4, 0.3, 0.3, 2, 0, 0.15, 0.6);
        start();
        driveUntil("left");
        Worlds.run(simulation, 2);
        assertTrue("pushed", simulation.getPose("crate").z > 0.7);
        int pressed = 0;
        for (int i = 0; i < 60; i++) {
            simulation.step();
            pressed += isPressed("left") && isPressed("right") ? 1 : 0;
        }
        assertEquals("steps", 60, pressed);
    }

    /** The wheels stick out in front of the body: an object that they touch presses the bumper and moves if it can. */
    @Test
    public void objectsHitByWheelsPressTheBumperAndMove() throws Exception {
        for (double mass : new double[] {0, 2}) {
            new Floor("floor", 50, 50);
            SEARrobot rover = new SEARrobot("rover");
            rover.addComponent(new Dynamics("dynamics", 4, 0, 0.06, 0, 0, 0, 0));
            rover.addComponent(box("body", 0.2, 0.2, 0.06, 4, 0, 0, 0));
            for (int side : new int[] {1, -1}) {
                rover.addWheel(new Wheel(side > 0 ? "frontLeft" : "frontRight", 0.05, 0.03, 1, side * 0.13, 0, 0.15));
                rover.addWheel(new Wheel(side > 0 ? "rearLeft" : "rearRight", 0.05, 0.03, 2, side * 0.13, 0, -0.15));
            }
            rover.addComponent(new Bumper("any"));
            box("crate", 0.5, 0.3, 0.3, mass, 0, 0.15, 0.6);
            start();
            driveUntil("any");
            assertEquals("front of the wheels", 0.45, simulation.getPose("rover").z + 0.2, 0.015);
            assertTrue(simulation.getRobots().get(0).getHardware().isBumpedLeft() && simulation.getRobots().get(0)
                .getHardware().isBumpedRight());
            Worlds.run(simulation, 3);
            double pushed = simulation.getPose("crate").z - 0.6;
            assertEquals("a crate of " + mass + " kg is pushed", mass == 0 ? 0 : 0.3, pushed, 0.05);
            drive(-0.1);
            Worlds.run(simulation, 1);
            assertFalse("it drove back", isPressed("any"));
        }
    }

    @Test
    public void robotsPressEachOthersBumpers() throws Exception {
        rover(0);
        Worlds.roomba("other", 0, 0.8, 180).addComponent(new Bumper("hit"));
        start();
        assertFalse(isPressed("hit"));
        driveUntil("any");
        assertTrue(isPressed("hit"));
    }

    /** Makes a body on its belly with a mast. */
    private static SEARrobot sledge() {
        SEARrobot sledge = new SEARrobot("sledge");
        sledge.addComponent(new Dynamics("dynamics", 4, 0, 0.05, 0, 0, 0, 0));
        Shape body = box("body", 0.8, 0.8, 0.1, 4, 0, 0, 0);
        Shape mast = box("mast", 0.05, 0.05, 0.5, 0, 0, 0.3, 0);
        sledge.addComponent(body);
        sledge.addComponent(mast);
        sledge.addComponent(new Bumper("belly", body));
        sledge.addComponent(new Bumper("top", mast));
        return sledge;
    }

    @Test
    public void aSleepingRobotTouchesTheFloor() throws Exception {
        new Floor("floor", 9, 9);
        sledge();
        start();
        assertTrue(isPressed("belly"));
        Worlds.run(simulation, 10);
        assertEquals("all sleep", 0, Worlds.physics(simulation).getBusyBodies());
        assertTrue(isPressed("belly"));
        assertFalse(isPressed("top"));
        simulation.reset();
        assertFalse("before the first step", isPressed("belly"));
        Worlds.run(simulation, 1);
        assertTrue(isPressed("belly"));
    }

    @Test
    public void aTerrainIsTouched() throws Exception {
        Terrain terrain = new Terrain("jacksboro", "terrain/jacksboro.tif");
        terrain.setArea(36.486, -84.2298333, 1000, 1000);
        sledge().place(36.485, -84.2308333, 0);
        start();
        Worlds.run(simulation, 3);
        assertTrue(isPressed("belly"));
        assertFalse(isPressed("top"));
    }

    private List<Object> readings() {
        List<Object> readings = new ArrayList<>();
        for (int i = 0; i < 900; i++) {
            if (i % 300 == 60) {
                drive(i < 600 ? 0.2 : -0.2);
            }
            simulation.step();
            readings.add(List.of(simulation.read("left").value(), simulation.read("right").value(),
                simulation.read("any").value()));
        }
        return readings;
    }

    @Test
    public void theSameRunGivesTheSameReadingsErrorsToo() throws Exception {
        SEARrobot rover = rover(0);
        box("crate", 0.2, 0.3, 0.3, 5, 0.1, 0.15, 0.6).rotate(0, 20, 0);
        Bumper loose = new Bumper("loose");
        loose.setNoise(new Noise().setDropout(0.5));
        rover.addComponent(loose);
        simulation = Worlds.start(project);
        List<Object> first = readings();
        assertTrue(first.toString(), first.contains(List.of(true, false, true))
            && first.contains(List.of(false, false, false)));
        simulation.reset();
        assertEquals("after reset", first, readings());
        simulation = Worlds.start(project);
        assertEquals("fresh start", first, readings());
    }

    @Test
    public void aLooseContactOpensNowAndThen() throws Exception {
        new Floor("floor", 9, 9);
        Bumper loose = new Bumper("loose");
        loose.setNoise(new Noise().setDropout(0.5));
        sledge().addComponent(loose);
        start();
        int pressed = 0;
        for (int i = 0; i < 600; i++) {
            simulation.step();
            pressed += isPressed("loose") ? 1 : 0;
        }
        assertEquals(300, pressed, 60);
    }

    private static void refused(String message, Runnable making) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, making::run).getMessage());
    }

    @Test
    public void wrongPartsAreRefused() throws Exception {
        String legal = ", legal: a shape that is a component of the same robot, and no wheel; Bumper(name) is pressed "
            + "by each of them";
        refused("Bumper \"b\": part is missing (None)" + legal, () -> new Bumper("b", null));
        Wheel wheel = new Wheel("wheel", 0.1, 0.05);
        refused("Bumper \"b\": Wheel \"wheel\" can't press it" + legal, () -> new Bumper("b", wheel));
        SEARrobot rover = rover(0);
        Bumper bumper = new Bumper("b");
        rover.addComponent(bumper);
        SEARrobot other = Worlds.roomba("other", 0, 3, 0);
        Shape body = (Shape) other.getComponents().get(1);
        refused("Bumper \"b\": Cylinder \"otherBody\" is a part of SEARrobot \"other\", legal: a part of "
            + "SEARrobot \"rover\"", () -> bumper.setPart(body));
        other.addComponent(new Bumper("far", (Shape) rover.getComponents().get(1)));
        ProjectException e = assertThrows(ProjectException.class, () -> Project.read(project.folder()));
        assertEquals(1, e.getProblems().size());
        assertTrue(e.getMessage(), e.getMessage()
            .contains("part is \"roverBody\", legal: the name of a shape of the sensor's robot other: otherBody"));
    }
}
