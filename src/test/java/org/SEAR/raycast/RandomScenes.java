// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import java.util.Random;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Triangles;
import org.SEAR.raycast.solid.RayEllipsoid;
import org.SEAR.raycast.solid.RayRound;

/** A scene of random shapes together with its {@link Oracle}. */
final class RandomScenes {
    final BeamScene scene = new BeamScene();
    final Oracle oracle = new Oracle();
    final Random random;

    RandomScenes(long seed) {
        random = new Random(seed);
    }

    double between(double low, double high) {
        return low + random.nextDouble() * (high - low);
    }

    /** Returns a pose within the cube of this half size: with any rotation, upright or unrotated. */
    Pose pose(double size) {
        double x = between(-size, size);
        double y = between(-size, size) / 3;
        double z = between(-size, size);
        switch (random.nextInt(3)) {
            case 0:
                return Pose.ofDegrees(x, y, z, between(-180, 180), between(-180, 180), between(-180, 180));
            case 1:
                return Pose.ofDegrees(x, y, z, 0, between(-180, 180), 0);
            default:
                return Pose.ofDegrees(x, y, z, 0, 0, 0);
        }
    }

    void place(int shape, Pose pose) {
        scene.setPose(shape, pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw);
    }

    void shapes(int count, double size) {
        for (int i = 0; i < count; i++) {
            Pose pose = pose(size);
            double a = between(0.05, 0.8);
            double b = between(0.05, 0.8);
            double c = between(0.05, 0.8);
            switch (random.nextInt(5)) {
                case 0:
                    place(scene.addBox(a, b, c, BeamScene.WORLD), pose);
                    oracle.surfaces.add(Oracle.box(pose, a, b, c));
                    break;
                case 1:
                    place(scene.addSolid(RayRound.cylinder(a, b), BeamScene.WORLD), pose);
                    oracle.surfaces.add(Oracle.cylinder(pose, a, b));
                    break;
                case 2:
                    place(scene.addSolid(RayRound.cone(a, b), BeamScene.WORLD), pose);
                    oracle.surfaces.add(Oracle.cone(pose, a, b));
                    break;
                case 3:
                    place(scene.addSolid(new RayEllipsoid(a, b, c), BeamScene.WORLD), pose);
                    oracle.surfaces.add(Oracle.ellipsoid(pose, a, b, c));
                    break;
                default:
                    Triangles soup = soup(random.nextInt(60) + 1);
                    place(scene.addMesh(soup, a, -b, c, BeamScene.WORLD), pose);
                    oracle.surfaces.add(Oracle.mesh(pose, soup, a, -b, c));
            }
        }
        scene.commit();
    }

    Triangles soup(int triangles) {
        float[] vertices = new float[9 * triangles];
        int[] indices = new int[3 * triangles];
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] = (float) between(-1, 1);
        }
        for (int i = 0; i < indices.length; i++) {
            indices[i] = i;
        }
        return new Triangles(vertices, indices);
    }

    /** Returns hills of 2 * cells * cells triangles over a square, with elevations within +-height. */
    static Triangles terrain(int cells, double side, double height, long seed) {
        Random random = new Random(seed);
        double[] wave = new double[12];
        for (int i = 0; i < wave.length; i++) {
            wave[i] = random.nextDouble() * 2 * Math.PI;
        }
        float[] vertices = new float[3 * (cells + 1) * (cells + 1)];
        int[] indices = new int[6 * cells * cells];
        for (int i = 0; i <= cells; i++) {
            for (int j = 0; j <= cells; j++) {
                double x = side * ((double) i / cells - 0.5);
                double z = side * ((double) j / cells - 0.5);
                double y = 0;
                for (int k = 0; k < wave.length; k++) {
                    y += Math.sin((0.3 + 0.1 * k) * (x * Math.cos(wave[k]) + z * Math.sin(wave[k])) + 7 * wave[k]);
                }
                int at = 3 * (i * (cells + 1) + j);
                vertices[at] = (float) x;
                vertices[at + 1] = (float) (height * y / 4);
                vertices[at + 2] = (float) z;
            }
        }
        int n = 0;
        for (int i = 0; i < cells; i++) {
            for (int j = 0; j < cells; j++) {
                int a = i * (cells + 1) + j;
                int c = a + cells + 1;
                for (int index : new int[] {a, a + 1, c + 1, a, c + 1, c}) {
                    indices[n++] = index;
                }
            }
        }
        return new Triangles(vertices, indices);
    }
}
