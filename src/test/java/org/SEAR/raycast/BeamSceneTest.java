// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Triangles;
import org.SEAR.raycast.solid.RayEllipsoid;
import org.SEAR.raycast.solid.RayRound;
import org.junit.Test;

/** Surfaces, edges, owners, visibility and movement in small scenes. */
public class BeamSceneTest {
    private static final double NOTHING = Double.POSITIVE_INFINITY;
    private static final double EXACT = 1e-12;
    private static final double START = Math.toRadians(-90);
    private static final double STEP = Math.toRadians(0.5);
    private static final int BEAMS = 361;
    private static final double RANGE = 8;

    private final BeamScene scene = new BeamScene();
    private final Hit hit = new Hit();

    private void at(int shape, double x, double y, double z) {
        scene.setPose(shape, x, y, z, 0, 0, 0, 1);
    }

    private double alongX(double x, double y, double z) {
        return scene.cast(x, y, z, 1, 0, 0, 10, BeamScene.WORLD, hit);
    }

    private double[] fan(Pose pose) {
        double[] ranges = new double[BEAMS];
        scene.castFan(pose, START, STEP, BEAMS, RANGE, BeamScene.WORLD, ranges, null);
        return ranges;
    }

    @Test
    public void beamsHitAnEllipsoidByItsEquation() {
        int shape = scene.addSolid(new RayEllipsoid(1, 2, 3), BeamScene.WORLD);
        scene.setPose(shape, 10, 0, 0, 0, 0, 0, 1);
        scene.commit();
        assertEquals(9, scene.cast(0, 0, 0, 1, 0, 0, 100, BeamScene.WORLD, hit), EXACT);
        assertEquals(-1, hit.nx, EXACT);
        assertEquals("at half of its height", 10 - Math.sqrt(0.75),
            scene.cast(0, 1, 0, 1, 0, 0, 100, BeamScene.WORLD, hit), EXACT);
        double length = Math.hypot(Math.sqrt(0.75), 0.25);
        assertEquals(-Math.sqrt(0.75) / length, hit.nx, EXACT);
        assertEquals(0.25 / length, hit.ny, EXACT);
        assertEquals("from inside", 3, scene.cast(10, 0, 0, 0, 0, 1, 100, BeamScene.WORLD, null), EXACT);
        assertEquals("from its surface", 0, scene.cast(9, 0, 0, 1, 0, 0, 100, BeamScene.WORLD, null), EXACT);
        assertEquals("beside it", NOTHING, scene.cast(0, 2.001, 0, 1, 0, 0, 100, BeamScene.WORLD, null), 0);
        double[] ranges = new double[3];
        scene.castFan(Pose.ofDegrees(0, 0, 0, 0, 90, 0), -0.1, 0.1, 3, 100, BeamScene.WORLD, ranges, null);
        assertEquals("ahead in a fan", 9, ranges[1], 1e-9);
        assertEquals("both sides are alike", ranges[0], ranges[2], 1e-9);
    }

    @Test
    public void everySolidIsMetOutsideAndLeftFromInside() {
        for (int kind = 0; kind < 3; kind++) {
            BeamScene one = new BeamScene();
            int shape = kind == 0 ? one.addBox(1, 1, 1, 7)
                : one.addSolid(kind == 1 ? RayRound.cylinder(1, 1) : RayRound.cone(2, 1), 7);
            one.setPose(shape, 5, 0, 0, 0, 0, 0, 1);
            one.commit();
            assertEquals(4, one.cast(0, 0, 0, 1, 0, 0, 10, BeamScene.WORLD, hit), EXACT);
            assertTrue("normal looks at the beam", hit.nx < -0.4);
            assertEquals(1, one.cast(5, 0, 0, 1, 0, 0, 10, BeamScene.WORLD, hit), EXACT);
            assertTrue("normal looks out", hit.nx > 0.4);
            assertEquals("starts on the surface", 0, one.cast(4, 0, 0, 1, 0, 0, 10, BeamScene.WORLD, hit), EXACT);
            assertEquals("behind", NOTHING, one.cast(8, 0, 0, 1, 0, 0, 10, BeamScene.WORLD, hit), 0);
            assertEquals("too far", NOTHING, one.cast(0, 0, 0, 1, 0, 0, 3.99, BeamScene.WORLD, hit), 0);
            assertEquals("own", NOTHING, one.cast(0, 0, 0, 1, 0, 0, 10, 7, hit), 0);
            assertEquals("someone else's", 4, one.cast(0, 0, 0, 1, 0, 0, 10, 8, hit), EXACT);
        }
    }

    @Test
    public void fansStartInsideAndOnSurfacesAsBeamsDo() {
        scene.addSolid(RayRound.cylinder(2, 1), BeamScene.WORLD);
        at(scene.addBox(0.5, 1, 0.5, BeamScene.WORLD), 0.5, 0, 5);
        scene.commit();
        double[] ranges = fan(Pose.IDENTITY);
        for (double range : ranges) {
            assertEquals(2, range, EXACT);
        }
        for (double range : fan(new Pose(0.5, 0, 4.5, 0, 0, 0, 1))) {
            assertEquals("on the box's face", 0, range, EXACT);
        }
    }

    @Test
    public void edgesRimsAndApexBelongToTheSolid() {
        scene.addBox(1, 1, 1, BeamScene.WORLD);
        at(scene.addSolid(RayRound.cylinder(1, 1), BeamScene.WORLD), 0, 10, 0);
        at(scene.addSolid(RayRound.cone(1, 1), BeamScene.WORLD), 0, 20, 0);
        scene.commit();
        assertEquals("along the box's top", 4, alongX(-5, 1, 0), EXACT);
        assertEquals("along its edge", 4, alongX(-5, 1, 1), EXACT);
        assertEquals("along the cylinder's top", 4, alongX(-5, 11, 0), EXACT);
        assertEquals("tangent to the cylinder", 5, alongX(-5, 10, 1), EXACT);
        assertEquals("base of the cone", 4, alongX(-5, 19, 0), EXACT);
        assertEquals("apex", 5, alongX(-5, 21, 0), EXACT);
        assertEquals("beside the apex", NOTHING, alongX(-5, 21 + 1e-9, 0), 0);
        assertEquals("down the axis", 5, scene.cast(0, 26, 0, 0, -1, 0, 10, BeamScene.WORLD, hit), EXACT);
    }

    @Test
    public void closedMeshesHaveNoGapsAndNoSurfaceEdgeOn() {
        float[] corners = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};
        int[] faces = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3,
            5, 3, 7, 5};
        scene.addMesh(new Triangles(corners, faces), 1, 1, 1, BeamScene.WORLD);
        scene.commit();
        for (int i = -100; i <= 100; i++) {
            assertEquals("through diagonals and edges, " + i, 4, alongX(-5, i / 100.0, -i / 100.0), EXACT);
            assertEquals("across, " + i, 4, alongX(-5, i / 100.0, 0), EXACT);
        }
        assertEquals(-1, hit.nx, EXACT);
        assertEquals("past it", NOTHING, alongX(-5, 1.0001, 0), 0);
    }

    @Test
    public void changesCountFromTheNextCommit() {
        int box = scene.addBox(1, 1, 1, BeamScene.WORLD);
        assertEquals("not yet there", NOTHING, alongX(-5, 0, 0), 0);
        scene.commit();
        assertEquals(4, alongX(-5, 0, 0), EXACT);
        at(box, 2, 0, 0);
        scene.setVisible(box, false);
        assertEquals("not yet moved", 4, alongX(-5, 0, 0), EXACT);
        scene.commit();
        assertEquals("invisible", NOTHING, alongX(-5, 0, 0), 0);
        scene.setVisible(box, true);
        scene.commit();
        assertEquals("moved", 6, alongX(-5, 0, 0), EXACT);
        IllegalArgumentException refused =
            assertThrows(IllegalArgumentException.class, () -> scene.setVisible(9, true));
        assertEquals("beam scene: shape 9, legal: 0 to 0, as add... returned it", refused.getMessage());
    }

    @Test
    public void aSceneThatMovedAnswersTheSameBytesAsOneBuiltThere() {
        RandomScenes moving = new RandomScenes(5);
        moving.shapes(60, 3);
        List<Pose> poses = new ArrayList<>();
        for (int round = 0; round < 30; round++) {
            poses.clear();
            for (int shape = 0; shape < 60; shape++) {
                poses.add(moving.pose(3 + round));
                moving.place(shape, poses.get(shape));
            }
            moving.scene.commit();
        }
        RandomScenes fresh = new RandomScenes(5);
        fresh.shapes(60, 3);
        for (int shape = 0; shape < 60; shape++) {
            fresh.place(shape, poses.get(shape));
        }
        fresh.scene.commit();
        for (int i = 0; i < 100; i++) {
            Pose pose = moving.pose(30);
            double[] there = new double[BEAMS];
            double[] here = new double[BEAMS];
            moving.scene.castFan(pose, START, STEP, BEAMS, 50, BeamScene.WORLD, there, null);
            fresh.scene.castFan(pose, START, STEP, BEAMS, 50, BeamScene.WORLD, here, null);
            assertArrayEquals("fan " + i, here, there, 0);
        }
    }

    @Test
    public void threadsGetTheSameBytes() throws Exception {
        RandomScenes world = new RandomScenes(77);
        world.shapes(200, 5);
        List<Pose> poses = new ArrayList<>();
        for (int i = 0; i < 200; i++) {
            poses.add(world.pose(5));
        }
        ExecutorService pool = Executors.newFixedThreadPool(4);
        try {
            List<Future<Integer>> hashes = new ArrayList<>();
            for (int thread = 0; thread < 4; thread++) {
                hashes.add(pool.submit(() -> {
                    int hash = 0;
                    double[] ranges = new double[BEAMS];
                    for (Pose pose : poses) {
                        world.scene.castFan(pose, START, STEP, BEAMS, RANGE, BeamScene.WORLD, ranges, null);
                        hash = 31 * hash + Arrays.hashCode(ranges);
                    }
                    return hash;
                }));
            }
            for (Future<Integer> hash : hashes) {
                assertEquals(hashes.get(0).get(), hash.get());
            }
        } finally {
            pool.shutdown();
        }
    }

    @Test
    public void equallyNearShapesAnswerTheFirst() {
        for (int i = 0; i < 20; i++) {
            scene.addBox(1, 1, 1, BeamScene.WORLD);
        }
        scene.commit();
        assertEquals(4, alongX(-5, 0.1, 0.2), EXACT);
        assertEquals(0, hit.shape);
        int[] shapes = new int[5];
        scene.castFan(new Pose(0, 0, -5, 0, 0, 0, 1), -0.1, 0.05, 5, RANGE, BeamScene.WORLD, new double[5], shapes);
        assertArrayEquals(new int[5], shapes);
    }

    @Test
    public void aFanOfAFullTurnSeesAllAround() {
        for (int side = 0; side < 4; side++) {
            at(scene.addBox(side % 2 == 0 ? 0.5 : 5, 1, side % 2 == 0 ? 5 : 0.5, BeamScene.WORLD), side == 0 ? 3
                : side == 2 ? -3 : 0, 0, side == 1 ? 3 : side == 3 ? -3 : 0);
        }
        scene.commit();
        for (double start : new double[] {-Math.PI, 0, 1, 100}) {
            double[] ranges = new double[721];
            scene.castFan(Pose.IDENTITY, start, Math.PI / 360, 721, RANGE, BeamScene.WORLD, ranges, null);
            for (int i = 0; i < ranges.length; i++) {
                double angle = start + i * Math.PI / 360;
                assertEquals("start " + start + " beam " + i,
                    2.5 / Math.max(Math.abs(Math.sin(angle)), Math.abs(Math.cos(angle))), ranges[i], 1e-9);
            }
        }
    }
}
