// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import static org.junit.Assert.assertEquals;

import org.SEAR.geometry.Pose;
import org.junit.Test;

/** The shortest beam of a bundle equals the shortest of the same beams cast one by one. */
public class BundleTest {
    @Test
    public void bundlesAgreeWithSingleBeams() {
        for (long seed = 1; seed <= 2000; seed++) {
            RandomScenes world = new RandomScenes(seed);
            world.shapes(1 + world.random.nextInt(30), 4);
            compare("seed " + seed, world, world.pose(4), 1 + world.random.nextInt(40), world.random.nextInt(3));
        }
    }

    private static void compare(String what, RandomScenes world, Pose pose, int beams, int kind) {
        double width = kind == 0 ? 0 : kind == 1 ? 0.3 : 4;
        double[] directions = new double[3 * beams];
        double[] ranges = new double[beams];
        double shortest = Double.POSITIVE_INFINITY;
        int line = -1;
        for (int i = 0; i < beams; i++) {
            double a = world.between(-width, width);
            double b = world.between(-width, width);
            double[] d = pose.rotate(Math.sin(a) * Math.cos(b), Math.sin(b), Math.cos(a) * Math.cos(b));
            System.arraycopy(d, 0, directions, 3 * i, 3);
            ranges[i] = world.between(0.5, 6);
            double single = world.scene.cast(pose.x, pose.y, pose.z, d[0], d[1], d[2], ranges[i],
                BeamScene.WORLD, null);
            if (single < shortest) {
                shortest = single;
                line = i;
            }
        }
        double[] answer = new double[1];
        assertEquals(what, line, world.scene.castBundle(pose.x, pose.y, pose.z, directions, ranges,
            BeamScene.WORLD, answer));
        assertEquals(what, shortest, answer[0], 0);
    }

    @Test
    public void anEmptySceneAndAnIgnoredOwnerAreNotMet() {
        double[] answer = new double[1];
        BeamScene scene = new BeamScene();
        assertEquals(-1, scene.castBundle(0, 0, 0, new double[] {0, 0, 1}, new double[] {5}, BeamScene.WORLD, answer));
        assertEquals(Double.POSITIVE_INFINITY, answer[0], 0);
        scene.setPose(scene.addBox(1, 1, 1, 3), 0, 0, 3, 0, 0, 0, 1);
        scene.commit();
        assertEquals(-1, scene.castBundle(0, 0, 0, new double[] {0, 0, 1}, new double[] {5}, 3, answer));
        assertEquals(0, scene.castBundle(0, 0, 0, new double[] {0, 0, 1}, new double[] {5}, BeamScene.WORLD, answer));
        assertEquals(2, answer[0], 1e-12);
    }
}
