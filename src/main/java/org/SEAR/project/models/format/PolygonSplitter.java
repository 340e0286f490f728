// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import java.io.IOException;
import java.util.function.Consumer;
import org.SEAR.files.FileLimits;

/**
 * Splits polygons into triangles: a convex polygon into a fan from its first corner, any other by ear clipping
 * (Meisters, "Polygons have ears", 1975). Corners are compared in the plane of the polygon's normal (Newell). One file,
 * whose total work is bounded.
 */
final class PolygonSplitter {
    /** Most comparisons of a corner with an ear, in all polygons of a file: some seconds. */
    static final long MAX_WORK = 200_000_000;
    /** Area below which three corners lie on one line, relative to the square of the polygon's size. */
    private static final double FLAT = 1e-12;

    /** Angle between an edge and the way back, rad, below which the side to which it turns is unknown. */
    private static final double SPIKE = 1e-6;

    private final String file;
    /** Start of the name of a face in errors, before its number. */
    private final String kind;
    private long total;
    private int crossing;
    private long firstCrossing;
    private int corners;
    private double[] x = new double[16];
    private double[] y = new double[16];
    /** Number of each corner in the file's face. */
    private int[] number = new int[16];
    private int[] next = new int[16];
    private int[] before = new int[16];
    private boolean[] reflex = new boolean[16];
    private double flat;
    private boolean convex;
    private boolean simple;
    private long work;
    private int[] triangles = new int[42];
    private int made;

    /**
     * @param file in errors
     * @param kind start of the name of a face in errors, which its number follows: {@code "the face in line "}
     */
    PolygonSplitter(String file, String kind) {
        this.file = file;
        this.kind = kind;
    }

    /**
     * Splits a polygon. {@link #made} is the number of corners of its triangles.
     *
     * @param positions x, y and z of each vertex of the file
     * @param ring vertices of the polygon's corners
     * @param count number of corners, at least 3
     * @param number of the face, in errors
     * @return corners of the triangles, three each, in an array that the next call overwrites
     * @throws IOException if the polygon or the file's triangles exceed a limit
     */
    int[] split(float[] positions, int[] ring, int count, long number) throws IOException {
        set(positions, ring, count);
        if (!convex) {
            FileLimits.range(file, "the number of corners of " + kind + number + ", which is not convex,", count, 3,
                ModelLimits.MAX_CORNERS);
        }
        count(count - 2, number);
        split();
        if (work > MAX_WORK) {
            throw FileLimits.wrong(file, "the number of faces up to " + kind + number
                + " with many corners that are not convex", "too large",
                "faces that need " + MAX_WORK + " comparisons to split: export the model as triangles");
        }
        if (!simple && crossing++ == 0) {
            firstCrossing = number;
        }
        return triangles;
    }

    /** Counts triangles of a face that needs no split. */
    void count(long made, long number) throws IOException {
        total += made;
        FileLimits.range(file, "the number of triangles up to " + kind + number, total, 0, ModelLimits.MAX_TRIANGLES);
    }

    /** Warns of faces whose edges cross, as far as the split noticed. */
    void warn(Consumer<String> warnings) {
        if (crossing > 0) {
            warnings.accept("the edges of " + crossing + " faces cross, first those of " + kind + firstCrossing
                + "; their surface may be wrong");
        }
    }

    /** Prepares a polygon, without limits. */
    void set(float[] positions, int[] ring, int count) {
        corners = count;
        if (x.length < count) {
            x = new double[2 * count];
            y = new double[2 * count];
            number = new int[2 * count];
            next = new int[2 * count];
            before = new int[2 * count];
            reflex = new boolean[2 * count];
            triangles = new int[6 * count];
        }
        project(positions, ring);
        dropRepeated();
        convex = isConvex();
        simple = convex || turnsOnce();
    }

    /** Projects the corners to the polygon's plane, relative to the first one, anticlockwise. */
    private void project(float[] positions, int[] ring) {
        double[] normal = normal(positions, ring);
        double length = Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        double[] u = {1, 0, 0};
        double[] w = {0, 1, 0};
        if (length > 0) {
            for (int axis = 0; axis < 3; axis++) {
                normal[axis] /= length;
            }
            int least = Math.abs(normal[0]) < Math.abs(normal[1]) ? 0 : 1;
            least = Math.abs(normal[2]) < Math.abs(normal[least]) ? 2 : least;
            double[] axis = {least == 0 ? 1 : 0, least == 1 ? 1 : 0, least == 2 ? 1 : 0};
            u = cross(axis, normal);
            double scale = Math.sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
            u = new double[] {u[0] / scale, u[1] / scale, u[2] / scale};
            w = cross(normal, u);
        }
        double size = 0;
        for (int i = 0; i < corners; i++) {
            x[i] = 0;
            y[i] = 0;
            for (int axis = 0; axis < 3; axis++) {
                double from = (double) positions[3 * ring[i] + axis] - positions[3 * ring[0] + axis];
                x[i] += u[axis] * from;
                y[i] += w[axis] * from;
            }
            size = Math.max(size, Math.max(Math.abs(x[i]), Math.abs(y[i])));
        }
        flat = FLAT * size * size;
    }

    /** Drops corners at the place of the corner before. */
    private void dropRepeated() {
        int kept = 0;
        for (int i = 0; i < corners; i++) {
            x[kept] = x[i];
            y[kept] = y[i];
            number[kept] = i;
            kept += kept == 0 || !same(kept, kept - 1) ? 1 : 0;
        }
        while (kept > 1 && same(kept - 1, 0)) {
            kept--;
        }
        corners = kept;
    }

    /** Returns the normal with a length of twice the area. */
    private double[] normal(float[] positions, int[] ring) {
        double[] sum = new double[3];
        double[] a = new double[3];
        double[] b = new double[3];
        for (int i = 1; i + 1 < corners; i++) {
            for (int axis = 0; axis < 3; axis++) {
                a[axis] = (double) positions[3 * ring[i] + axis] - positions[3 * ring[0] + axis];
                b[axis] = (double) positions[3 * ring[i + 1] + axis] - positions[3 * ring[0] + axis];
            }
            double[] area = cross(a, b);
            for (int axis = 0; axis < 3; axis++) {
                sum[axis] += area[axis];
            }
        }
        return sum;
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /** Returns twice the signed area of a triangle of corners. */
    private double area(int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }

    /** A polygon is convex if it never turns right and goes around once: its x changes direction twice. */
    private boolean isConvex() {
        int changes = 0;
        int direction = 0;
        int first = 0;
        for (int i = 0; i < corners; i++) {
            int b = i + 1 < corners ? i + 1 : 0;
            int c = b + 1 < corners ? b + 1 : 0;
            if (area(i, b, c) < -flat) {
                return false;
            }
            int now = (int) Math.signum(x[b] - x[i]);
            if (now != 0) {
                changes += now == -direction ? 1 : 0;
                first = first == 0 ? now : first;
                direction = now;
            }
        }
        return changes + (first == -direction ? 1 : 0) <= 2;
    }

    /** Returns whether the edges turn by one revolution, as those of a simple polygon; spikes pass. */
    private boolean turnsOnce() {
        double sum = 0;
        for (int i = 0; i < corners; i++) {
            int b = i + 1 < corners ? i + 1 : 0;
            int c = b + 1 < corners ? b + 1 : 0;
            double turn = Math.IEEEremainder(Math.atan2(y[c] - y[b], x[c] - x[b]) - Math.atan2(y[b] - y[i],
                x[b] - x[i]), 2 * Math.PI);
            if (Math.abs(turn) > Math.PI - SPIKE) {
                return true;
            }
            sum += turn;
        }
        return Math.abs(sum - 2 * Math.PI) < 1;
    }

    /** Splits the prepared polygon, and returns the corners of its triangles. */
    int[] split() {
        made = 0;
        if (convex) {
            for (int i = 1; i + 1 < corners; i++) {
                add(0, i, i + 1);
            }
            return triangles;
        }
        for (int i = 0; i < corners; i++) {
            next[i] = i + 1 < corners ? i + 1 : 0;
            before[i] = i > 0 ? i - 1 : corners - 1;
        }
        for (int i = 0; i < corners; i++) {
            reflex[i] = isReflex(i);
        }
        clip();
        return triangles;
    }

    /** Returns whether the prepared polygon is convex. */
    boolean convex() {
        return convex;
    }

    /** Returns the number of comparisons in all polygons of the file. */
    long work() {
        return work;
    }

    /** Returns the number of corners of the last polygon's triangles. */
    int made() {
        return made;
    }

    private void add(int a, int b, int c) {
        triangles[made++] = number[a];
        triangles[made++] = number[b];
        triangles[made++] = number[c];
    }

    private boolean isReflex(int corner) {
        return area(before[corner], corner, next[corner]) <= flat;
    }

    private void clip() {
        int at = 0;
        int tried = 0;
        for (int left = corners; left > 2 && work <= MAX_WORK;) {
            double area = area(before[at], at, next[at]);
            boolean none = tried > left;
            if (Math.abs(area) > flat && !none && (area < 0 || !isEar(at))) {
                at = next[at];
                tried++;
                continue;
            }
            if (Math.abs(area) > flat) {
                add(before[at], at, next[at]);
                simple = simple && !none;
            }
            next[before[at]] = next[at];
            before[next[at]] = before[at];
            reflex[before[at]] = isReflex(before[at]);
            reflex[next[at]] = isReflex(next[at]);
            at = next[next[at]];
            tried = 0;
            left--;
        }
    }

    /** Returns whether the triangle of a corner and its neighbours contains no other corner. */
    private boolean isEar(int b) {
        int a = before[b];
        int c = next[b];
        for (int p = next[c]; p != a; p = next[p]) {
            work++;
            if (reflex[p] && area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0 && !same(p, a) && !same(p,
                b) && !same(p, c)) {
                return false;
            }
        }
        return true;
    }

    private boolean same(int p, int q) {
        return x[p] == x[q] && y[p] == y[q];
    }
}
