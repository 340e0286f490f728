// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

/**
 * Convex polygon in which a fan's plane cuts a box. The fan is given in the box's frame by twelve numbers: its origin
 * and the directions of its left (x), up and forward (z) axes. Each edge lies on a face of the box, whose plane gives
 * the edge's line exactly.
 */
final class BoxCut {
    private static final int MOST = 12;

    /** Number of edges; 0 if the plane misses the box. */
    int size;
    /** Right and left end of the last edge as seen from the fan's origin, in the fan's frame. */
    double rightX;
    double rightZ;
    double leftX;
    double leftZ;
    /** Line of the last edge: inverse distance = a * x + b * z. */
    double a;
    double b;

    private final double[] half = new double[3];
    private boolean inside;
    private double[] vx = new double[MOST];
    private double[] vz = new double[MOST];
    private double[] over = new double[MOST];
    private int[] face = new int[MOST];
    private double[] vx2 = new double[MOST];
    private double[] vz2 = new double[MOST];
    private double[] over2 = new double[MOST];
    private int[] face2 = new int[MOST];

    /**
     * Returns whether the fan's origin lies within a distance of the box's surface. Stores the box's size for
     * {@link #cut}.
     */
    boolean touches(double[] fan, double hx, double hy, double hz, double distance) {
        half[0] = hx;
        half[1] = hy;
        half[2] = hz;
        double most = Math.max(Math.abs(fan[0]) - hx, Math.max(Math.abs(fan[1]) - hy, Math.abs(fan[2]) - hz));
        inside = most < 0;
        return Math.abs(most) <= distance;
    }

    /** Computes the polygon. Call {@link #touches} first. */
    void cut(double[] fan, double hx, double hy, double hz) {
        double nx = fan[6];
        double ny = fan[7];
        double nz = fan[8];
        double off = nx * fan[0] + ny * fan[1] + nz * fan[2];
        size = 0;
        if (Math.abs(off) > Math.abs(nx) * hx + Math.abs(ny) * hy + Math.abs(nz) * hz) {
            return;
        }
        int k = Math.abs(nx) >= Math.abs(ny) && Math.abs(nx) >= Math.abs(nz) ? 0 : Math.abs(ny) >= Math.abs(nz) ? 1 : 2;
        int i = k == 2 ? 0 : k + 1;
        int j = k == 0 ? 2 : k - 1;
        for (int corner = 0; corner < 4; corner++) {
            double ci = (corner == 0 || corner == 3 ? -half[i] : half[i]) - fan[i];
            double cj = (corner < 2 ? -half[j] : half[j]) - fan[j];
            double ck = -(fan[6 + i] * ci + fan[6 + j] * cj) / fan[6 + k];
            vx[corner] = fan[3 + i] * ci + fan[3 + j] * cj + fan[3 + k] * ck;
            vz[corner] = fan[9 + i] * ci + fan[9 + j] * cj + fan[9 + k] * ck;
            over[corner] = fan[k] + ck;
            face[corner] = corner == 0 ? 2 * j : corner == 1 ? 2 * i + 1 : corner == 2 ? 2 * j + 1 : 2 * i;
        }
        size = 4;
        clip(1, half[k], 2 * k + 1);
        clip(-1, half[k], 2 * k);
    }

    /** Clips to sign * over &lt;= limit; the new edge lies on the given face. */
    private void clip(double sign, double limit, int newFace) {
        boolean all = true;
        for (int m = 0; m < size; m++) {
            all &= sign * over[m] <= limit;
        }
        if (all) {
            return;
        }
        int n = 0;
        for (int m = 0; m < size; m++) {
            int next = m + 1 == size ? 0 : m + 1;
            double here = limit - sign * over[m];
            double there = limit - sign * over[next];
            if (here >= 0) {
                n = keep(n, vx[m], vz[m], over[m], face[m]);
            }
            if (here >= 0 != there >= 0) {
                double f = here / (here - there);
                n = keep(n, vx[m] + (vx[next] - vx[m]) * f, vz[m] + (vz[next] - vz[m]) * f,
                    over[m] + (over[next] - over[m]) * f, here >= 0 ? newFace : face[m]);
            }
        }
        swap();
        size = n;
    }

    private int keep(int n, double x, double z, double o, int f) {
        vx2[n] = x;
        vz2[n] = z;
        over2[n] = o;
        face2[n] = f;
        return n + 1;
    }

    private void swap() {
        double[] x = vx;
        double[] z = vz;
        double[] o = over;
        int[] f = face;
        vx = vx2;
        vz = vz2;
        over = over2;
        face = face2;
        vx2 = x;
        vz2 = z;
        over2 = o;
        face2 = f;
    }

    /**
     * Sets the right and left end of an edge.
     * @return false if the edge is seen end-on
     */
    boolean turn(int edge) {
        int next = edge + 1 == size ? 0 : edge + 1;
        double turn = vz[edge] * vx[next] - vx[edge] * vz[next];
        int right = turn > 0 ? edge : next;
        int left = turn > 0 ? next : edge;
        rightX = vx[right];
        rightZ = vz[right];
        leftX = vx[left];
        leftZ = vz[left];
        return turn != 0;
    }

    /**
     * Computes the line of an edge.
     * @return false if the edge is on the far side and the origin is outside the box
     */
    boolean line(double[] fan, int edge) {
        int axis = face[edge] >> 1;
        double gap = (face[edge] & 1) == 0 ? -half[axis] - fan[axis] : half[axis] - fan[axis];
        boolean facing = (face[edge] & 1) == 0 ? gap > 0 : gap < 0;
        if (!facing && !inside) {
            return false;
        }
        a = fan[3 + axis] / gap;
        b = fan[9 + axis] / gap;
        return true;
    }
}
