// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.List;
import java.util.Locale;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Sphere;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Falling, sliding, rolling and bouncing agree with closed forms within 1 %; docs/physics.md shows the table. */
public class ClosedFormsTest {
    private static final double G = 9.81;
    private static final double SHARE = 0.01;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void freeFallIsAParabola() throws Exception {
        new Box("box", 0.3, 0.3, 0.3, 1).move(0, 100, 0);
        Simulation simulation = Worlds.start(project);
        for (double seconds : new double[] {0.5, 1, 2}) {
            Worlds.run(simulation, seconds - simulation.getTime());
            near("free fall, " + seconds + " s", G * seconds * seconds / 2, 100 - simulation.getPose("box").y);
        }
    }

    @Test
    public void aBoxSlidesDownASlope() throws Exception {
        new Floor("slope", 400, 10).rotate(0, 0, 20);
        Box box = new Box("thing", 0.3, 0.3, 0.2, 2);
        box.setFriction(0.25);
        put(box, 0.1, 20, 0, 0, 20);
        double slope = Math.toRadians(20);
        near("a box slides down 20 degrees, friction 0.2, 3 s", G * (Math.sin(slope) - 0.2 * Math.cos(slope))
            * 4.5, gone(3));
    }

    @Test
    public void aBoxThatFrictionHoldsStays() throws Exception {
        new Floor("slope", 400, 10).rotate(0, 0, 30);
        put(new Box("thing", 0.3, 0.3, 0.2, 2), 0.1, 30, 0, 0, 30);
        assertEquals(0, gone(10), 1e-3);
    }

    @Test
    public void aCylinderRollsDownASlope() throws Exception {
        new Floor("slope", 400, 10).rotate(0, 0, 10);
        put(new Cylinder("thing", 0.1, 0.3, 2), 0.1, 10, 90, 0, 0);
        double slope = Math.toRadians(10);
        near("a cylinder rolls down 10 degrees, 3 s", G * (Math.sin(slope) - 0.002 * Math.cos(slope)) * 2 / 3
            * 4.5, gone(3));
    }

    @Test
    public void aSphereRollsDownASlope() throws Exception {
        new Floor("slope", 400, 10).rotate(0, 0, 10);
        put(new Sphere("thing", 0.1, 2), 0.1, 10, 0, 0, 0);
        double slope = Math.toRadians(10);
        near("a sphere rolls down 10 degrees, 3 s", G * (Math.sin(slope) - 0.002 * Math.cos(slope)) * 5 / 7
            * 4.5, gone(3));
    }

    @Test
    public void rollingFrictionStopsAWheel() throws Exception {
        new Floor("slope", 400, 10).rotate(0, 0, 10);
        Cylinder thing = new Cylinder("thing", 0.1, 0.3, 2);
        thing.setRollingFriction(0.05);
        put(thing, 0.1, 10, 90, 0, 0);
        double slope = Math.toRadians(10);
        near("the same with rolling friction 0.051", G * (Math.sin(slope) - 0.051 * Math.cos(slope)) * 2 / 3
            * 4.5, gone(3));
    }

    @Test
    public void rollingFrictionHoldsAWheelOnALittleSlope() throws Exception {
        new Floor("slope", 400, 10).rotate(0, 0, 1);
        Cylinder thing = new Cylinder("thing", 0.1, 0.3, 2);
        thing.setRollingFriction(0.05);
        put(thing, 0.1, 1, 90, 0, 0);
        assertEquals(0, gone(20), 2e-3);
    }

    @Test
    public void aBounceReachesTheHeightOfItsRestitution() throws Exception {
        new Floor("floor", 10, 10);
        Box box = new Box("thing", 0.3, 0.3, 0.3, 1);
        box.setRestitution(0.8);
        box.move(0, 1.15, 0);
        Simulation simulation = Worlds.start(project);
        double e = 0.8;
        double at = Math.sqrt(2 / G);
        for (int bounce = 1; bounce <= 5; bounce++) {
            double height = Math.pow(e, 2 * bounce);
            double up = Math.sqrt(2 * height / G);
            double top = 0;
            while (simulation.getTime() < at + 2 * up - 0.01) {
                simulation.step();
                top = simulation.getTime() > at + 0.02 ? Math.max(top, simulation.getPose("thing").y - 0.15) : 0;
            }
            near("height of bounce " + bounce + " from 1 m, restitution 0.8", height, top);
            at += 2 * up;
        }
    }

    @Test
    public void aPileStandsAsHighAsItsParts() throws Exception {
        new Floor("floor", 10, 10);
        for (int i = 0; i < 10; i++) {
            new Box("box" + i, 0.3, 0.3, 0.2, 2).move(0, 0.1 + 0.2 * i, 0);
        }
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 10);
        near("a pile of ten boxes of 0.2 m after 10 s", 2, simulation.getPose("box9").y + 0.1);
        assertEquals(0, simulation.getPose("box9").x, 1e-3);
    }

    @Test
    public void aPushedObjectSlidesUntilFrictionStopsIt() throws Exception {
        new Floor("floor", 50, 10);
        Box box = new Box("thing", 0.6, 0.3, 0.3, 2);
        box.setFriction(0.05);
        box.move(0, 0.15, 0.4);
        Worlds.roomba("roomba", 0, 0, 0);
        Simulation simulation = Worlds.start(project);
        simulation.getRobots().get(0).drive(0.5, Double.POSITIVE_INFINITY);
        Worlds.run(simulation, 4);
        simulation.getRobots().get(0).drive(0, Double.POSITIVE_INFINITY);
        double from = simulation.getPose("thing").z;
        Worlds.run(simulation, 4);
        near("a box pushed by a robot at 0.5 m/s slides on, friction 0.04", 0.25 / (2 * 0.04 * G),
            simulation.getPose("thing").z - from);
    }

    @Test
    public void aTowerOfFortyBoxesStands() throws Exception {
        new Floor("floor", 10, 10);
        for (int i = 0; i < 40; i++) {
            new Box("box" + i, 0.25, 0.25, 0.25, 1).move(0, 0.125 + 0.25 * i, 0);
        }
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 10);
        near("a tower of forty boxes of 0.25 m after 10 s", 10, simulation.getPose("box39").y + 0.125);
        assertEquals("something never sleeps", 0, Worlds.physics(simulation).getBusyBodies());
    }

    @Test
    public void gearsHoldARobotThatStallsOnASlope() throws Exception {
        for (double speed : new double[] {0.3, 0}) {
            new Floor("slope", 200, 50).rotate(-25, 0, 0);
            Worlds.roomba("roomba", 0, 0, 0);
            Simulation simulation = Worlds.start(project);
            simulation.getRobots().get(0).drive(speed, Double.POSITIVE_INFINITY);
            Worlds.run(simulation, 3);
            double z = simulation.getPose("roomba").z;
            Worlds.run(simulation, 20);
            assertEquals("at " + speed + " m/s up 25 degrees", z, simulation.getPose("roomba").z, 1e-3);
        }
    }

    /** Places an object on the slope, its middle this far above the surface, with rotated axes. */
    private static void put(SearObject thing, double above, double degrees, double rx, double ry, double rz) {
        double slope = Math.toRadians(degrees);
        thing.move(-above * Math.sin(slope), above * Math.cos(slope), 0);
        thing.rotate(rx, ry, rz);
    }

    /** Returns the distance travelled. */
    private double gone(double seconds) throws Exception {
        Simulation simulation = Worlds.start(project);
        Pose from = simulation.getPose("thing");
        Worlds.run(simulation, seconds);
        Pose to = simulation.getPose("thing");
        return Math.sqrt((from.x - to.x) * (from.x - to.x) + (from.y - to.y) * (from.y - to.y)
            + (from.z - to.z) * (from.z - to.z));
    }

    private static void near(String what, double expected, double actual) throws IOException {
        assertEquals(what, expected, actual, Math.abs(expected) * SHARE);
        String row = String.format(Locale.ROOT, "| %s | %.4f | %.4f |", what, expected, actual);
        List<String> page = Files.readAllLines(Paths.get(System.getProperty("sear.root", "."), "docs/physics.md"),
            StandardCharsets.UTF_8);
        assertTrue("docs/physics.md lacks the line " + row, page.contains(row));
    }
}
