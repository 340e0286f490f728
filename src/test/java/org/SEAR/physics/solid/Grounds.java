// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.util.Random;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Triangles;

/** The same ground as a mesh and as a height field. */
public final class Grounds {
    private Grounds() {
    }

    /** Returns a mesh of exactly the triangles of a height field. */
    public static Solid mesh(HeightField field) {
        return new MeshSolid(triangles(field), new double[] {1, 1, 1}, Pose.IDENTITY);
    }

    /** Returns the triangles of a height field. */
    public static Triangles triangles(HeightField field) {
        float[] vertices = new float[3 * field.heights.length];
        int[] indices = new int[6 * (field.rows - 1) * (field.columns - 1)];
        int n = 0;
        for (int row = 0; row < field.rows; row++) {
            for (int column = 0; column < field.columns; column++) {
                int at = row * field.columns + column;
                vertices[3 * at] = field.x(row);
                vertices[3 * at + 1] = field.y(row, column);
                vertices[3 * at + 2] = field.z(column);
                if (row < field.rows - 1 && column < field.columns - 1) {
                    int north = at + field.columns;
                    for (int corner : new int[] {at, at + 1, north + 1, at, north + 1, north}) {
                        indices[n++] = corner;
                    }
                }
            }
        }
        return new Triangles(vertices, indices);
    }

    /** Returns gentle waves with some centimetres of roughness, 40 m x 40 m. */
    public static HeightField rough(int posts, double roughness, long seed) {
        Random random = new Random(seed);
        float[] heights = new float[posts * posts];
        double spacing = 40.0 / (posts - 1);
        for (int i = 0; i < heights.length; i++) {
            double x = i / posts * spacing;
            double z = i % posts * spacing;
            heights[i] = (float) (0.3 * Math.sin(0.4 * x) * Math.cos(0.3 * z)
                + roughness * (random.nextDouble() - 0.5));
        }
        return new HeightField(posts, posts, -20.013, -19.987, spacing, spacing, heights);
    }

    /** Returns a plane that rises to the north. */
    public static HeightField slope(double rise) {
        float[] heights = new float[81 * 81];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = (float) (rise * (i / 81 - 40) * 0.25);
        }
        return new HeightField(81, 81, -10, -10, 0.25, 0.25, heights);
    }
}
