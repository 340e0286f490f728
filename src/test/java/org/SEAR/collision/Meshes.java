// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** Closed meshes for tests, made from boxes and turned profiles. */
public final class Meshes {
    private final List<double[]> points = new ArrayList<>();
    private final List<int[]> faces = new ArrayList<>();

    /** Adds a box between two corners. */
    public Meshes box(double x, double y, double z, double toX, double toY, double toZ) {
        int first = points.size();
        for (int i = 0; i < 8; i++) {
            points.add(new double[] {i % 2 == 0 ? x : toX, i / 2 % 2 == 0 ? y : toY, i / 4 == 0 ? z : toZ});
        }
        for (int[] side : new int[][] {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1},
            {4, 5, 7, 6}}) {
            face(first + side[0], first + side[1], first + side[2]);
            face(first + side[0], first + side[2], first + side[3]);
        }
        return this;
    }

    private void face(int a, int b, int c) {
        faces.add(new int[] {a, b, c});
    }

    /**
     * Adds a body of revolution about y.
     * @param profile radius and y of each corner of a closed polygon
     */
    public Meshes turned(int sides, double[]... profile) {
        int first = points.size();
        int count = profile.length;
        for (int i = 0; i < sides; i++) {
            for (double[] corner : profile) {
                double angle = 2 * Math.PI * i / sides;
                points.add(new double[] {corner[0] * Math.cos(angle), corner[1], corner[0] * Math.sin(angle)});
            }
        }
        for (int i = 0; i < sides; i++) {
            for (int k = 0; k < count; k++) {
                int next = (i + 1) % sides * count + (k + 1) % count;
                face(first + i * count + k, first + i * count + (k + 1) % count, first + next);
                face(first + i * count + k, first + next, first + (i + 1) % sides * count + k);
            }
        }
        return this;
    }

    /** Adds a torus about y. */
    public Meshes torus(double large, double small, int sides, int around) {
        double[][] profile = new double[around][];
        for (int i = 0; i < around; i++) {
            double angle = 2 * Math.PI * i / around;
            profile[i] = new double[] {large + small * Math.cos(angle), small * Math.sin(angle)};
        }
        return turned(sides, profile);
    }

    /** Turns all points about z and then about x, radians. */
    public Meshes rotated(double aboutZ, double aboutX) {
        for (double[] p : points) {
            double x = p[0] * Math.cos(aboutZ) - p[1] * Math.sin(aboutZ);
            double y = p[0] * Math.sin(aboutZ) + p[1] * Math.cos(aboutZ);
            p[0] = x;
            p[1] = y * Math.cos(aboutX) - p[2] * Math.sin(aboutX);
            p[2] = y * Math.sin(aboutX) + p[2] * Math.cos(aboutX);
        }
        return this;
    }

    /** Removes a triangle, which opens the mesh. */
    public Meshes without(int triangle) {
        faces.remove(triangle);
        return this;
    }

    /** x, y, z of each vertex, rounded as in models. */
    public double[] points() {
        return points.stream().flatMapToDouble(p -> Arrays.stream(p)).map(x -> (float) x).toArray();
    }

    /** Three vertices per triangle. */
    public int[] indices() {
        return faces.stream().flatMapToInt(Arrays::stream).toArray();
    }

    /** Text of an .obj file. */
    public String obj() {
        StringBuilder text = new StringBuilder();
        points.forEach(p -> text.append(String.format(Locale.ROOT, "v %.7f %.7f %.7f%n", p[0], p[1], p[2])));
        faces.forEach(f -> text.append(String.format(Locale.ROOT, "f %d %d %d%n", f[0] + 1, f[1] + 1, f[2] + 1)));
        return text.toString();
    }
}
