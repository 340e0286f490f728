// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import static org.junit.Assert.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.Slow;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Triangles;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * The hierarchies skip only what a beam misses: results equal, to the byte, those of testing every box and triangle.
 */
@Category(Slow.class)
public class CullingTest {
    private static final double[] AXIS = {0, -0.0, 1, -1, 1e-300, 1e-31, -1e-20, 1e-8};

    @Test
    public void hierarchyAndBruteForceHitTheSamePoints() {
        for (int seed = 1; seed <= 300; seed++) {
            RandomScenes world = new RandomScenes(seed);
            double away = Math.pow(10, world.random.nextInt(8)) - 1;
            double[] centre = {world.between(-away, away), world.between(-away, away), world.between(-away, away)};
            List<BeamScene> alone = new ArrayList<>();
            for (int shape = 0; shape < 16; shape++) {
                Pose pose = world.pose(4);
                double size = world.between(0.05, 1);
                if (shape % 2 == 0) {
                    place(world.scene, world.scene.addBox(size, 0.3, 0.4, BeamScene.WORLD), centre, pose);
                    alone.add(new BeamScene());
                    place(alone.get(alone.size() - 1), alone.get(alone.size() - 1)
                        .addBox(size, 0.3, 0.4, BeamScene.WORLD), centre, pose);
                } else {
                    Triangles soup = world.soup(1 + world.random.nextInt(40));
                    place(world.scene, world.scene.addMesh(soup, 1, size, 1, BeamScene.WORLD), centre, pose);
                    for (int i = 0; i < soup.size(); i++) {
                        Triangles one = new Triangles(Arrays.copyOfRange(soup.vertices, 9 * i, 9 * i + 9),
                            new int[] {0, 1, 2});
                        alone.add(new BeamScene());
                        place(alone.get(alone.size() - 1), alone.get(alone.size() - 1)
                            .addMesh(one, 1, size, 1, BeamScene.WORLD), centre, pose);
                    }
                }
            }
            for (int i = 0; i < 200; i++) {
                compare("seed " + seed + " beam " + i, world, alone, centre);
            }
        }
    }

    private static void place(BeamScene scene, int shape, double[] centre, Pose pose) {
        scene.setPose(shape, centre[0] + pose.x, centre[1] + pose.y, centre[2] + pose.z, pose.qx, pose.qy,
            pose.qz, pose.qw);
        scene.commit();
    }

    /** Compares random beams; half of them run along an axis or nearly so. */
    private static void compare(String what, RandomScenes world, List<BeamScene> alone, double[] centre) {
        boolean along = world.random.nextBoolean();
        double[] d = new double[3];
        for (int k = 0; k < 3; k++) {
            d[k] = along ? AXIS[world.random.nextInt(AXIS.length)] : world.between(-1, 1);
        }
        double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        if (length < 0.5) {
            d[world.random.nextInt(3)] = 1;
            length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        }
        double x = centre[0] + world.between(-4, 4);
        double y = centre[1] + world.between(-1, 1);
        double z = centre[2] + world.between(-4, 4);
        double range = world.random.nextInt(4) == 0 ? Double.MAX_VALUE : world.between(0, 10);
        double expected = Double.POSITIVE_INFINITY;
        for (BeamScene one : alone) {
            expected = Math.min(expected, one.cast(x, y, z, d[0] / length, d[1] / length, d[2] / length, range,
                BeamScene.WORLD, null));
        }
        double met = world.scene.cast(x, y, z, d[0] / length, d[1] / length, d[2] / length, range,
            BeamScene.WORLD, null);
        assertEquals(what + ", range " + range, expected, met, 0);
    }
}
