// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.lang.management.ManagementFactory;
import org.SEAR.Slow;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Triangles;
import org.SEAR.raycast.solid.Mesh;
import org.SEAR.raycast.solid.Patches;
import org.SEAR.raycast.tree.Bvh;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Guards against slowness with counts of operations instead of times. The limits are about a third above the measured
 * values.
 */
@Category(Slow.class)
public class WorkTest {
    private static final int BEAMS = 361;
    private static final int FANS = 100;
    private final double[] ranges = new double[BEAMS];

    private static BeamScene boxes(int count, RandomScenes world) {
        double half = Math.sqrt(5.0 * count) / 2;
        for (int i = 0; i < count; i++) {
            Pose pose = Pose.ofDegrees(world.between(-half, half), 0, world.between(-half, half),
                world.between(-180, 180), world.between(-180, 180), world.between(-180, 180));
            world.place(world.scene.addBox(world.between(0.1, 0.5), world.between(0.1, 0.5), world.between(0.1, 0.5),
                BeamScene.WORLD), pose);
        }
        world.scene.commit();
        return world.scene;
    }

    private void scan(BeamScene scene, RandomScenes world, double size) {
        for (int i = 0; i < FANS; i++) {
            Pose pose = Pose.ofDegrees(world.between(-size, size), 0, world.between(-size, size), 0,
                world.between(-180, 180), 0);
            scene.castFan(pose, -Math.PI / 2, Math.PI / 360, BEAMS, 8, BeamScene.WORLD, ranges, null);
        }
    }

    private void beams(BeamScene scene, RandomScenes world, double size) {
        for (int i = 0; i < FANS; i++) {
            double angle = world.between(-Math.PI, Math.PI);
            scene.cast(world.between(-size, size), 0, world.between(-size, size), Math.sin(angle), 0, Math.cos(angle),
                8, BeamScene.WORLD, null);
        }
    }

    @Test
    public void workGrowsWithTheLogarithmOfTheScene() {
        RayCaster work = BeamScene.casters().rays;
        double[] perFan = new double[3];
        double[] perBeam = new double[3];
        for (int i = 0; i < 3; i++) {
            int count = 100 * (int) Math.pow(10, i);
            RandomScenes world = new RandomScenes(3);
            BeamScene scene = boxes(count, world);
            double size = Math.sqrt(5.0 * count) / 2 - 4;
            long before = work.nodes() + work.tested;
            scan(scene, world, size);
            perFan[i] = (double) (work.nodes() + work.tested - before) / FANS;
            before = work.nodes() + work.tested;
            beams(scene, world, size);
            perBeam[i] = (double) (work.nodes() + work.tested - before) / FANS;
        }
        String measured = perFan[0] + " " + perFan[1] + " " + perFan[2] + "; " + perBeam[0] + " " + perBeam[1] + " "
            + perBeam[2];
        assertTrue("nodes and shapes a fan of 100, 1000, 10000 boxes: " + measured, perFan[0] < 120 && perFan[1] < 140
            && perFan[2] < 160);
        assertTrue("a beam: " + measured, perBeam[0] < 22 && perBeam[1] < 28 && perBeam[2] < 36);
    }

    @Test
    public void aFanOverHillsLooksAtFewTriangles() {
        RandomScenes world = new RandomScenes(4);
        Triangles hills = RandomScenes.terrain(230, 20, 1, 1);
        world.scene.addMesh(hills, 1, 1, 1, BeamScene.WORLD);
        world.scene.commit();
        RayCaster work = BeamScene.casters().rays;
        long nodes = work.nodes();
        long triangles = work.triangles;
        scan(world.scene, world, 5);
        assertTrue((work.triangles - triangles) / FANS + " triangles of " + hills.size(),
            (work.triangles - triangles) / FANS < 430);
        assertTrue((work.nodes() - nodes) / FANS + " nodes", (work.nodes() - nodes) / FANS < 260);
        long all = (work.nodes() - nodes + work.triangles - triangles) / FANS;
        assertTrue(all + " nodes and triangles", all < 690);
    }

    @Test
    public void aBeamLooksAtFewNodesAndItems() {
        RandomScenes world = new RandomScenes(4);
        world.scene.addMesh(RandomScenes.terrain(230, 20, 1, 1), 1, 1, 1, BeamScene.WORLD);
        world.scene.commit();
        check("over 105800 triangles", world.scene, world, 8, 36, 5);
        RandomScenes crowd = new RandomScenes(3);
        for (int i = 0; i < 1000; i++) {
            Pose pose = Pose.ofDegrees(crowd.between(-4.5, 4.5), 0.5, crowd.between(-4.5, 4.5),
                crowd.between(-180, 180), crowd.between(-180, 180), crowd.between(-180, 180));
            crowd.place(crowd.scene.addBox(crowd.between(0.125, 0.5), crowd.between(0.125, 0.5),
                crowd.between(0.125, 0.5), BeamScene.WORLD), pose);
        }
        crowd.scene.commit();
        check("between 1000 boxes on 81 m^2", crowd.scene, crowd, 4, 57, 16);
    }

    private void check(String where, BeamScene scene, RandomScenes world, double size, int mostNodes, int mostItems) {
        RayCaster work = BeamScene.casters().rays;
        long nodes = work.nodes();
        long items = work.tested + work.triangles;
        for (int i = 0; i < 1000; i++) {
            double angle = world.between(-Math.PI, Math.PI);
            scene.cast(world.between(-size, size), world.between(0.2, 0.8), world.between(-size, size), Math.sin(angle),
                0, Math.cos(angle), 8, BeamScene.WORLD, null);
        }
        String measured = (work.nodes() - nodes) / 1000.0 + " nodes, " + (work.tested + work.triangles - items) / 1000.0
            + " items a beam " + where;
        assertTrue(measured, work.nodes() - nodes < 1000L * mostNodes && work.tested + work.triangles
            - items < 1000L * mostItems);
    }

    @Test
    public void castingMovingAndCommittingAllocateNothing() {
        RandomScenes world = new RandomScenes(6);
        world.shapes(100, 5);
        Hit hit = new Hit();
        Pose[] poses = {world.pose(5), world.pose(5), world.pose(5)};
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long least = Long.MAX_VALUE;
        for (int round = 0; round < 5; round++) {
            long before = threads.getThreadAllocatedBytes(id);
            for (int i = 0; i < 200; i++) {
                Pose pose = poses[i % 3];
                world.scene.setPose(i % 100, pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw);
                world.scene.setPose(i % 100, 0.001 * i, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw);
                world.scene.setPose(i % 100, pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw);
                world.scene.castFan(pose, -1, 0.01, 200, 8, BeamScene.WORLD, ranges, null);
                world.scene.cast(pose.x, pose.y, pose.z, 0, 0.6, 0.8, 8, BeamScene.WORLD, hit);
            }
            least = Math.min(least, threads.getThreadAllocatedBytes(id) - before);
        }
        assertTrue(least + " bytes for 200 fans and 200 beams", least < 1000);
    }

    @Test
    public void aMillionTrianglesTakeLessThan120BytesEachAndAreSortedALogarithmOfTimes() {
        Triangles hills = RandomScenes.terrain(708, 100, 3, 9);
        long own = 4L * hills.vertices.length + 4L * hills.indices.length;
        Mesh mesh = Mesh.of(hills);
        Patches patches = mesh.patches;
        long forFans = 4L * (patches.corners.length + patches.links.length + patches.tree.data.length);
        long bytes = 4L * (mesh.corners.length + mesh.order.length + mesh.tree.data.length) + forFans + own;
        assertEquals(1002528, hills.size());
        assertTrue(bytes / hills.size() + " bytes a triangle", bytes / hills.size() < 120);
        assertTrue(forFans / hills.size() + " bytes a triangle for fans", forFans / hills.size() < 20);
        double depth = (double) depths(mesh.tree, 0, 0) / hills.size();
        assertTrue("sorted " + depth + " times each while building", depth < 25);
    }

    /** Returns the sum of the depths of all items, which counts how often the builder moved an item. */
    private static long depths(Bvh tree, int node, int depth) {
        if (tree.count(node) > 0) {
            return (long) depth * tree.count(node);
        }
        return depths(tree, tree.link(node), depth + 1) + depths(tree, tree.link(node) + 1, depth + 1);
    }
}
