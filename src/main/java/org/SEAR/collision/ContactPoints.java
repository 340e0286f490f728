package org.SEAR.collision;

import java.util.Arrays;

/** Contact points of one pair in one step, and the choice of the best ones. Not thread-safe. */
public final class ContactPoints {
    private static final int MOST = 12;
    private static final int FIELDS = 7;

    private double[] found = new double[16 * FIELDS];
    private int count;
    private final int[] chosen = new int[MOST];

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

    /** Index of a point chosen by {@link #choose}. */
    public int chosen(int i) {
        return chosen[i];
    }

    /**
     * Chooses the lowest point, then repeatedly the point furthest from the chosen ones; touching points first.
     * @param most number of points wanted
     * @return number of points chosen
     */
    public int choose(int most) {
        int taken = 0;
        while (taken < Math.min(Math.min(most, MOST), count)) {
            int next = -1;
            double best = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < count; i++) {
                if (isChosen(i, taken)) {
                    continue;
                }
                double worth = taken == 0 ? -height(i) : room(i, taken) - (height(i) > ManifoldClipper.SKIN ? 1e6 : 0);
                if (worth > best) {
                    best = worth;
                    next = i;
                }
            }
            chosen[taken++] = next;
        }
        return taken;
    }

    private boolean isChosen(int point, int taken) {
        for (int i = 0; i < taken; i++) {
            if (chosen[i] == point) {
                return true;
            }
        }
        return false;
    }

    /** Returns the squared distance to the nearest chosen point, m^2. */
    private double room(int i, int taken) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < taken; k++) {
            int a = FIELDS * i;
            int b = FIELDS * chosen[k];
            double square = 0;
            for (int axis = 3; axis < 6; axis++) {
                square += (found[a + axis] - found[b + axis]) * (found[a + axis] - found[b + axis]);
            }
            least = Math.min(least, square);
        }
        return least;
    }
}
