// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ground;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.function.Function;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Sphere;
import org.SEAR.Slow;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.solid.Grounds;
import org.SEAR.physics.solid.Solid;
import org.SEAR.physics.solid.TerrainSolid;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.GroundWorld;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Objects stand, fall and drive on a height field as on a mesh of the same triangles. */
@Category(Slow.class)
public class HeightsUnderfootTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private GroundWorld world(Solid ground, org.SEAR.POJOs.Shape... things) throws Exception {
        return new GroundWorld(ground, Project.read(project.folder()), things);
    }

    private static double apart(Pose a, Pose b) {
        return Math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
    }

    @Test
    public void aBoxDroppedOnASlopeComesToRestAsOnTheMesh() throws Exception {
        Box box = new Box("box", 0.5, 0.3, 0.4, 2);
        box.move(0.13, 0.31, 0.21);
        HeightField slope = Grounds.slope(0.25);
        GroundWorld heights = world(new TerrainSolid(slope), box);
        GroundWorld mesh = world(Grounds.mesh(slope), box);
        heights.run(6);
        mesh.run(6);
        Pose rest = heights.bodies.get(0).getPose();
        assertFalse("it sleeps", heights.physics.isAwake(heights.bodies.get(0)));
        assertEquals(rest + " and " + mesh.bodies.get(0).getPose(), 0, apart(rest, mesh.bodies.get(0).getPose()), 8e-3);
        double thickness = (rest.y - slope.height(rest.x, rest.z)) * Math.cos(Math.atan(0.25));
        assertTrue("it lies on a side: " + thickness,
            Math.min(Math.abs(thickness - 0.15), Math.min(Math.abs(thickness - 0.2),
            Math.abs(thickness - 0.25))) < 2e-3);
    }

    @Test
    public void aRobotsTrackOfAMinuteIsThatOverTheMesh() throws Exception {
        Worlds.roomba("roomba", -3.3, -4.1, 20);
        HeightField field = Grounds.rough(400, 0.01, 3);
        Function<Solid, GroundWorld> start = ground -> {
            try {
                return world(ground);
            } catch (Exception e) {
                throw new IllegalStateException(e);
            }
        };
        GroundWorld heights = start.apply(new TerrainSolid(field));
        GroundWorld mesh = start.apply(Grounds.mesh(field));
        Pose from = heights.robot.getPose();
        double worst = 0;
        double farthest = 0;
        double lowest = Double.POSITIVE_INFINITY;
        double highest = Double.NEGATIVE_INFINITY;
        for (int second = 0; second < 60; second++) {
            double radius = second < 20 ? Double.POSITIVE_INFINITY : second < 40 ? 2 : -1.5;
            heights.robot.drive(0.3, radius);
            mesh.robot.drive(0.3, radius);
            heights.run(1);
            mesh.run(1);
            Pose now = heights.robot.getPose();
            worst = Math.max(worst, apart(now, mesh.robot.getPose()));
            farthest = Math.max(farthest, apart(now, from));
            lowest = Math.min(lowest, now.y);
            highest = Math.max(highest, now.y);
        }
        assertTrue("it drove " + farthest + " m over " + (highest - lowest) + " m of height", farthest > 3
            && highest - lowest > 0.1);
        assertEquals("apart from the track over the mesh, metres", 0, worst, 1e-3);
    }

    @Test
    public void twoRunsGiveTheSameBytes() throws Exception {
        Worlds.roomba("roomba", 1.3, -2.1, 70);
        Box box = new Box("box", 0.3, 0.2, 0.4, 2);
        box.move(-1.5, 1.5, 0.7);
        HeightField field = Grounds.rough(400, 0.03, 4);
        GroundWorld first = world(new TerrainSolid(field), box);
        GroundWorld second = world(new TerrainSolid(field), box);
        for (GroundWorld one : new GroundWorld[] {first, second}) {
            one.robot.drive(0.3, 2);
            one.run(8);
        }
        assertSame(first.robot.getPose(), second.robot.getPose());
        assertSame(first.bodies.get(0).getPose(), second.bodies.get(0).getPose());
    }

    private static void assertSame(Pose a, Pose b) {
        double[] one = {a.x, a.y, a.z, a.qx, a.qy, a.qz, a.qw};
        double[] other = {b.x, b.y, b.z, b.qx, b.qy, b.qz, b.qw};
        for (int i = 0; i < one.length; i++) {
            assertEquals(Double.doubleToRawLongBits(one[i]), Double.doubleToRawLongBits(other[i]));
        }
    }

    @Test
    public void fastObjectsDoNotTunnel() throws Exception {
        HeightField field = Grounds.rough(400, 0.05, 5);
        for (double speed : new double[] {20, 80, 300}) {
            Sphere ball = new Sphere("ball" + (int) speed, 0.02, 0.1);
            ball.move(0.7, 5, 1.1);
            Box plate = new Box("plate" + (int) speed, 0.3, 0.3, 0.01, 1);
            plate.move(-2.2, 5, 0.4);
            plate.rotate(20, 30, 10);
            GroundWorld world = world(new TerrainSolid(field), ball, plate);
            world.bodies.get(0).setVelocities(0.3 * speed, -speed, 0, 0, 0, 0);
            world.bodies.get(1).setVelocities(0, -speed, 0.2 * speed, 0, 0, 0);
            for (int i = 0; i < 60; i++) {
                world.run(1.0 / 60);
                world.bodies.forEach(body -> {
                    Pose pose = body.getPose();
                    double ground = field.height(pose.x, pose.z);
                    assertTrue(body.name + " at " + speed + " m/s is at " + pose + ", ground " + ground,
                        !(pose.y < ground - 0.02));
                });
            }
        }
    }

    @Test
    public void objectsFallOffTheRim() throws Exception {
        Worlds.roomba("roomba", 0.2, 9.3, 0);
        Box box = new Box("box", 0.5, 0.3, 0.4, 2);
        box.move(10.1, 0.3, 0);
        GroundWorld world = world(new TerrainSolid(Grounds.slope(0)), box);
        world.robot.drive(0.4, Double.POSITIVE_INFINITY);
        world.run(5);
        assertTrue("box at " + world.bodies.get(0).getPose(), world.bodies.get(0).getPose().y < -5);
        assertTrue("robot at " + world.robot.getPose(), world.robot.getPose().y < -5);
    }

    @Test
    public void objectsThatStartInTheGroundAreLiftedOntoIt() throws Exception {
        Box box = new Box("box", 0.5, 0.3, 0.4, 2);
        box.move(3.1, 0.05, -2.2);
        HeightField flat = Grounds.slope(0);
        GroundWorld world = world(new TerrainSolid(flat), box);
        assertEquals("[box started inside a fixed object (ground); SEAR lifted it by 0.150 m. Raise y in its move(x, "
            + "y, z) by that, or change x or z]", world.warnings.toString());
    }
}
