// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.util.Arrays;
import org.SEAR.files.FileLimits;

/** Affine transform of a node in double precision; shear and mirroring included. Immutable. */
final class AffineMatrix {
    static final AffineMatrix IDENTITY = new AffineMatrix(new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
    /** Largest deviation of the fourth row from 0 0 0 1: rounding of exporters. */
    private static final double ROUNDING = 1e-5;
    private static final String FOURTH_ROW = "a fourth row of 0 0 0 1";

    /** Three rows of four numbers. */
    private final double[] m;

    private AffineMatrix(double[] m) {
        this.m = m;
    }

    /** Returns a transform by its first three rows, four numbers each. */
    static AffineMatrix ofRows(double... rows) {
        return new AffineMatrix(Arrays.copyOf(rows, 12));
    }

    /** Returns a matrix of four rows; null if the last is not 0 0 0 1. */
    static AffineMatrix ofFourRows(double... rows) {
        double[] columns = new double[16];
        for (int i = 0; i < columns.length; i++) {
            columns[i] = rows[i % 4 * 4 + i / 4];
        }
        return isAffine(columns) ? ofColumns(columns, 0) : null;
    }

    /** Returns the transform of a node relative to its parent. */
    static AffineMatrix of(GltfJson json, JsonObject node, String what) throws IOException {
        double[] matrix = json.numbers(node, what, "matrix", 16);
        double[] move = json.numbers(node, what, "translation", 3);
        double[] turn = json.numbers(node, what, "rotation", 4);
        double[] scale = json.numbers(node, what, "scale", 3);
        if (matrix == null) {
            return of(move, turn == null ? null : unit(json.file, what, turn), scale);
        }
        if (move != null || turn != null || scale != null) {
            throw FileLimits.wrong(json.file, what, "with a matrix and a translation, rotation or scale",
                "one of both");
        }
        if (!isAffine(matrix)) {
            throw FileLimits.wrong(json.file, what + ".matrix", Arrays.toString(matrix), FOURTH_ROW);
        }
        return ofColumns(matrix, 0);
    }

    /** Returns a matrix of an accessor, in columns. */
    static AffineMatrix of(String file, String what, float[] columns, int first) throws IOException {
        double[] matrix = new double[16];
        for (int i = 0; i < matrix.length; i++) {
            matrix[i] = columns[first + i];
        }
        if (!isAffine(matrix)) {
            throw FileLimits.wrong(file, what, Arrays.toString(matrix), FOURTH_ROW);
        }
        return ofColumns(matrix, 0);
    }

    private static boolean isAffine(double[] columns) {
        return Math.abs(columns[3]) <= ROUNDING && Math.abs(columns[7]) <= ROUNDING && Math.abs(columns[11]) <= ROUNDING
            && Math.abs(columns[15] - 1) <= ROUNDING;
    }

    private static AffineMatrix ofColumns(double[] columns, int first) {
        double[] m = new double[12];
        for (int i = 0; i < m.length; i++) {
            m[i] = columns[first + i % 4 * 4 + i / 4];
        }
        return new AffineMatrix(m);
    }

    private static double[] unit(String file, String what, double[] q) throws IOException {
        double length = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (!(length > 0 && length < Double.MAX_VALUE)) {
            throw FileLimits.wrong(file, what + ".rotation", Arrays.toString(q), "a quaternion of length 1");
        }
        return new double[] {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
    }

    private static AffineMatrix of(double[] move, double[] q, double[] scale) {
        double[] m = IDENTITY.m.clone();
        if (q != null) {
            double x = q[0];
            double y = q[1];
            double z = q[2];
            double w = q[3];
            m = new double[] {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0,
                2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0,
                2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0};
        }
        for (int i = 0; i < m.length; i++) {
            if (i % 4 == 3) {
                m[i] = move == null ? 0 : move[i / 4];
            } else if (scale != null) {
                m[i] *= scale[i % 4];
            }
        }
        return new AffineMatrix(m);
    }

    /** Returns this transform after another one. */
    AffineMatrix times(AffineMatrix first) {
        double[] product = new double[12];
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 4; column++) {
                double sum = column == 3 ? m[4 * row + 3] : 0;
                for (int i = 0; i < 3; i++) {
                    sum += m[4 * row + i] * first.m[4 * i + column];
                }
                product[4 * row + column] = sum;
            }
        }
        return new AffineMatrix(product);
    }

    /** Returns the sum of transforms, each times its weight. */
    static AffineMatrix blend(AffineMatrix[] of, float[] weights) {
        double[] sum = new double[12];
        for (int k = 0; k < weights.length; k++) {
            for (int i = 0; i < sum.length && weights[k] != 0; i++) {
                sum[i] += weights[k] * of[k].m[i];
            }
        }
        return new AffineMatrix(sum);
    }

    boolean mirrors() {
        return m[0] * cofactor(0, 0) + m[1] * cofactor(0, 1) + m[2] * cofactor(0, 2) < 0;
    }

    /** Transforms the point at an index of an array in place. */
    void point(float[] points, int at) {
        double x = points[at];
        double y = points[at + 1];
        double z = points[at + 2];
        for (int row = 0; row < 3; row++) {
            points[at + row] = (float) (m[4 * row] * x + m[4 * row + 1] * y + m[4 * row + 2] * z + m[4 * row + 3]);
        }
    }

    /** Transforms the normal of a surface in place: by the cofactors, which shear and mirroring require. */
    void normal(float[] normals, int at) {
        double x = normals[at];
        double y = normals[at + 1];
        double z = normals[at + 2];
        double sign = mirrors() ? -1 : 1;
        double[] n = new double[3];
        for (int row = 0; row < 3; row++) {
            n[row] = sign * (cofactor(row, 0) * x + cofactor(row, 1) * y + cofactor(row, 2) * z);
        }
        double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int row = 0; row < 3; row++) {
            normals[at + row] = length > 0 ? (float) (n[row] / length) : 0;
        }
    }

    private double cofactor(int row, int column) {
        int r = (row + 1) % 3;
        int s = (row + 2) % 3;
        int c = (column + 1) % 3;
        int d = (column + 2) % 3;
        return m[4 * r + c] * m[4 * s + d] - m[4 * r + d] * m[4 * s + c];
    }
}
