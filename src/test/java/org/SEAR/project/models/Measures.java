// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import org.SEAR.geometry.Triangles;

/** Bounding box, area and volume of triangles. */
final class Measures {
    final Triangles triangles;
    final double[] low = {Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE};
    final double[] high = {-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
    /** Sum of the areas of all triangles, m2. */
    double area;
    /** Signed volume inside the triangles, m3: positive if they are anticlockwise from outside. */
    double volume;

    Measures(Triangles triangles) {
        this.triangles = triangles;
        for (int i = 0; i < triangles.indices.length; i += 3) {
            double[][] p = new double[3][3];
            for (int corner = 0; corner < 3; corner++) {
                for (int axis = 0; axis < 3; axis++) {
                    p[corner][axis] = triangles.vertices[3 * triangles.indices[i + corner] + axis];
                    low[axis] = Math.min(low[axis], p[corner][axis]);
                    high[axis] = Math.max(high[axis], p[corner][axis]);
                }
            }
            double[] n = cross(minus(p[1], p[0]), minus(p[2], p[0]));
            area += Math.sqrt(dot(n, n)) / 2;
            volume += dot(p[0], n) / 6;
        }
    }

    static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    Measures hasBox(double... lowThenHigh) {
        assertArrayEquals(lowThenHigh, new double[] {low[0], low[1], low[2], high[0], high[1], high[2]}, 1e-5);
        return this;
    }

    Measures hasArea(double expected) {
        assertEquals(expected, area, 1e-5 * Math.max(1, expected));
        return this;
    }

    Measures hasVolume(double expected) {
        assertEquals(expected, volume, 1e-5 * Math.max(1, Math.abs(expected)));
        return this;
    }

    Measures hasTriangles(int expected) {
        assertEquals(expected, triangles.size());
        return this;
    }
}
