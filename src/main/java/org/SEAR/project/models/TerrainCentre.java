// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import com.jme3.math.Vector3f;
import org.SEAR.geometry.Triangles;

/** Centre of a terrain model: the middle of its extent in x and z, on its highest surface there. */
final class TerrainCentre {
    private TerrainCentre() {
    }

    /** Returns the translation that moves the centre to the origin, metres. */
    static Vector3f toOrigin(Triangles terrain) {
        float[] low = {Float.MAX_VALUE, Float.MAX_VALUE, Float.MAX_VALUE};
        float[] high = {-Float.MAX_VALUE, -Float.MAX_VALUE, -Float.MAX_VALUE};
        for (int i = 0; i < terrain.vertices.length; i++) {
            low[i % 3] = Math.min(low[i % 3], terrain.vertices[i]);
            high[i % 3] = Math.max(high[i % 3], terrain.vertices[i]);
        }
        if (terrain.size() == 0) {
            return new Vector3f();
        }
        float x = (low[0] + high[0]) / 2;
        float z = (low[2] + high[2]) / 2;
        return new Vector3f(-x, -height(terrain, x, z, low[1]), -z);
    }

    /** Returns the highest surface at (x, z); {@code otherwise} if there is none. */
    private static float height(Triangles terrain, float x, float z, float otherwise) {
        double highest = Double.NEGATIVE_INFINITY;
        for (int t = 0; t < terrain.size(); t++) {
            highest = Math.max(highest, heightIn(terrain, t, x, z));
        }
        return highest == Double.NEGATIVE_INFINITY ? otherwise : (float) highest;
    }

    private static double heightIn(Triangles terrain, int triangle, double x, double z) {
        float[] v = terrain.vertices;
        int a = terrain.indices[triangle * 3] * 3;
        int b = terrain.indices[triangle * 3 + 1] * 3;
        int c = terrain.indices[triangle * 3 + 2] * 3;
        double area = cross(v[b] - v[a], v[b + 2] - v[a + 2], v[c] - v[a], v[c + 2] - v[a + 2]);
        if (area == 0) {
            return Double.NEGATIVE_INFINITY;
        }
        double shareB = cross(x - v[a], z - v[a + 2], v[c] - v[a], v[c + 2] - v[a + 2]) / area;
        double shareC = cross(v[b] - v[a], v[b + 2] - v[a + 2], x - v[a], z - v[a + 2]) / area;
        if (shareB < 0 || shareC < 0 || shareB + shareC > 1) {
            return Double.NEGATIVE_INFINITY;
        }
        return v[a + 1] + shareB * (v[b + 1] - v[a + 1]) + shareC * (v[c + 1] - v[a + 1]);
    }

    private static double cross(double ax, double az, double bx, double bz) {
        return ax * bz - az * bx;
    }
}
