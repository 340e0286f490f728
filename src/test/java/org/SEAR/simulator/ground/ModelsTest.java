// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ground;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Locale;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.robot.Robot;
import org.SEAR.sensors.DistanceReading;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Terrains, obstacles and movable objects made from triangles. */
public class ModelsTest {
    private static final double STRAIGHT = Double.POSITIVE_INFINITY;
    private static final int CELLS = 40;
    private static final double CELL = 0.5;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static double height(int row) {
        return 0.3 * Math.sin(row * CELL / 1.5);
    }

    /** Returns the elevation of the terrain at z, linear between its rows. */
    private static double height(double z) {
        double row = z / CELL + CELLS / 2.0;
        int below = (int) Math.floor(row);
        return height(below) + (row - below) * (height(below + 1) - height(below));
    }

    private void terrain() throws Exception {
        StringBuilder out = new StringBuilder();
        for (int row = 0; row <= CELLS; row++) {
            for (int side = -1; side <= 1; side++) {
                out.append(String.format(Locale.ROOT, "v %d %.6f %.2f%n", 5 * side, height(row),
                    (row - CELLS / 2.0) * CELL));
            }
        }
        for (int row = 0; row < CELLS; row++) {
            for (int side = 0; side < 2; side++) {
                int corner = 3 * row + side + 1;
                out.append(String.format("f %d %d %d%nf %d %d %d%n", corner, corner + 3, corner + 4, corner, corner + 4,
                    corner + 1));
            }
        }
        project.put("assets/hills.obj", out.toString());
        Model hills = new Model("hills", "hills.obj");
        hills.setTerrain(true);
    }

    @Test
    public void aRobotDrivesOverATerrain() throws Exception {
        terrain();
        SEARrobot robot = Worlds.cart("cart", 20, 0.1, 0.25, new double[] {0.2, -0.2}, 0, 0, -6, 0);
        robot.getComponents().stream().filter(part -> part instanceof Dynamics)
            .forEach(part -> part.move(0, 0.2 + height(-6), -6));
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 2);
        double above = simulation.getPose("cart").y - height(simulation.getPose("cart").z);
        simulation.getRobots().get(0).drive(0.5, STRAIGHT);
        for (int second = 0; second < 24; second++) {
            Worlds.run(simulation, 1);
            Pose pose = simulation.getPose("cart");
            assertEquals("height at " + pose, above, pose.y - height(pose.z), 0.05);
            assertEquals(0, pose.x, 0.1);
        }
        assertTrue(simulation.getPose("cart").toString(), simulation.getPose("cart").z > 5);
    }

    /** Makes a robot whose body sticks out in front of its wheels: its front is 0.3 m ahead of its middle. */
    private static void blunt(double z) {
        SEARrobot robot = new SEARrobot("blunt");
        robot.addComponent(new Dynamics("dynamics", 10, 0, 0.1, z, 0, 0, 0));
        Box body = new Box("body", 0.3, 0.6, 0.1, 1);
        body.move(0, 0.05, 0);
        robot.addComponent(body);
        for (int i = 0; i < 4; i++) {
            robot.addWheel(new Wheel("wheel" + i, 0.05, 0.02, 1, i % 2 == 0 ? 0.17 : -0.17, 0, i / 2 == 0
                ? 0.1 : -0.1));
        }
        robot.addComponent(new Distance("eye", "laser", 0, 0.05, 0.3, 0, 0, 0));
    }

    @Test
    public void aRobotHitsTheTrianglesThatItSees() throws Exception {
        project.put("assets/wall.obj", "v -5 0 0\nv 5 0 0\nv 0 4 0\nf 1 2 3\n");
        new Floor("floor", 20, 20);
        new Model("wall", "wall.obj").move(0, 0, 2);
        blunt(0);
        Simulation simulation = Worlds.start(project);
        Robot robot = simulation.getRobots().get(0);
        robot.drive(0.1, STRAIGHT);
        Worlds.run(simulation, 20);
        double top = robot.getPose().transform(0, 0.1, 0.3)[2];
        double bottom = robot.getPose().transform(0, 0, 0.3)[2];
        assertEquals(2, Math.max(top, bottom), 0.001);
        assertTrue(robot.getHardware().isBumpedLeft() && robot.getHardware().isBumpedRight());
    }

    @Test
    public void aMovableModelRestsIsPushedAndIsSeenWhereItIs() throws Exception {
        StringBuilder cube = new StringBuilder();
        for (int i = 0; i < 8; i++) {
            cube.append(String.format(Locale.ROOT, "v %.3f %.3f %.3f%n", 0.15 * (i % 2 * 2 - 1),
                0.15 * (i / 2 % 2 * 2 - 1), 0.15 * (i / 4 * 2 - 1)));
        }
        cube.append("f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
        project.put("assets/cube.obj", cube.toString());
        new Floor("floor", 20, 20);
        new Model("cube", "cube.obj", 1).move(0, 0.15, 1);
        blunt(0);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 3);
        assertEquals(0.15, simulation.getPose("cube").y, 0.002);
        assertEquals(1, simulation.getPose("cube").z, 0.002);
        assertEquals(0, Worlds.physics(simulation).getBusyBodies());
        simulation.getRobots().get(0).drive(0.2, STRAIGHT);
        Worlds.run(simulation, 6);
        double pushed = simulation.getPose("cube").z;
        assertTrue("at " + pushed, pushed > 1.4);
        assertEquals(simulation.getPose("blunt").z + 0.45, pushed, 0.01);
        assertEquals(0, ((DistanceReading) simulation.read("eye")).getDistance(), 0.01);
    }

    @Test
    public void aModelWithMassIsHeavyInItsMiddleWhereverItsOriginIs() throws Exception {
        StringBuilder cube = new StringBuilder();
        for (int i = 0; i < 8; i++) {
            cube.append(String.format(Locale.ROOT, "v %.1f %.1f %.1f%n", 0.4 * (i % 2), 0.4 * (i / 2 % 2),
                0.4 * (i / 4)));
        }
        cube.append("f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
        project.put("assets/corner.obj", cube.toString());
        new Floor("floor", 20, 20);
        new Box("table", 2, 2, 1, 0).move(1, 0.5, 0);
        new Model("stays", "corner.obj", 5).move(-0.12, 1, 0);
        new Model("falls", "corner.obj", 5).move(-0.28, 1, -0.7);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 4);
        assertEquals(1, simulation.getPose("stays").y, 0.002);
        assertEquals(-0.12, simulation.getPose("stays").x, 0.002);
        assertTrue(simulation.getPose("falls").toString(), simulation.getPose("falls").y < 0.7);
    }
}
