// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.Arrays;

/** Contact points of one pair of solids in one search. Not thread-safe. */
public final class ContactPoints {
    private static final int FIELDS = 7;

    private double[] found = new double[16 * FIELDS];
    private int count;

    public void clear() {
        count = 0;
    }

    /**
     * @param nx direction from B to A, likewise ny and nz
     * @param x on B, world frame, metres, likewise y and z
     * @param height of A above it, metres
     */
    void add(double nx, double ny, double nz, double x, double y, double z, double height) {
        if (FIELDS * (count + 1) > found.length) {
            found = Arrays.copyOf(found, 2 * found.length);
        }
        int i = FIELDS * count++;
        found[i] = nx;
        found[i + 1] = ny;
        found[i + 2] = nz;
        found[i + 3] = x;
        found[i + 4] = y;
        found[i + 5] = z;
        found[i + 6] = height;
    }

    public int size() {
        return count;
    }

    public double nx(int i) {
        return found[FIELDS * i];
    }

    public double ny(int i) {
        return found[FIELDS * i + 1];
    }

    public double nz(int i) {
        return found[FIELDS * i + 2];
    }

    public double x(int i) {
        return found[FIELDS * i + 3];
    }

    public double y(int i) {
        return found[FIELDS * i + 4];
    }

    public double z(int i) {
        return found[FIELDS * i + 5];
    }

    /** Height of A above B, metres. */
    public double height(int i) {
        return found[FIELDS * i + 6];
    }

    /** Compares two points by position, then by normal. */
    int compare(int i, int k) {
        int order = 0;
        for (int field = 3; field < 6 && order == 0; field++) {
            order = Double.compare(found[FIELDS * i + field], found[FIELDS * k + field]);
        }
        for (int field = 0; field < 3 && order == 0; field++) {
            order = Double.compare(found[FIELDS * i + field], found[FIELDS * k + field]);
        }
        return order;
    }

    /** Returns the cosine of the angle between two normals. */
    double cosine(int i, int k) {
        return nx(i) * nx(k) + ny(i) * ny(k) + nz(i) * nz(k);
    }

    /** Returns the squared distance of two points, m^2. */
    double square(int i, int k) {
        double x = x(i) - x(k);
        double y = y(i) - y(k);
        double z = z(i) - z(k);
        return x * x + y * y + z * z;
    }
}
