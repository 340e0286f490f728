// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.relief;

/** Deterministic smooth noise on the plane: random values at whole numbers, interpolated between. Any thread. */
final class ValueNoise {
    private ValueNoise() {
    }

    /** Returns three octaves of noise, from about -1 to 1, mean 0. */
    static double fractal(double x, double z) {
        return (4 * at(x, z) + 2 * at(2.03 * x + 31.7, 2.03 * z - 17.1) + at(4.1 * x - 7.9, 4.1 * z + 53.3)) / 7 * 1.6;
    }

    /** Returns one octave of noise, -1 to 1. */
    static double at(double x, double z) {
        int row = (int) Math.floor(x);
        int column = (int) Math.floor(z);
        double u = smooth(x - row);
        double v = smooth(z - column);
        double south = value(row, column) * (1 - v) + value(row, column + 1) * v;
        double north = value(row + 1, column) * (1 - v) + value(row + 1, column + 1) * v;
        return south * (1 - u) + north * u;
    }

    private static double smooth(double t) {
        return t * t * (3 - 2 * t);
    }

    /** Returns the random value of a lattice point, -1 to 1: both coordinates through the finaliser of MurmurHash3. */
    static double value(int row, int column) {
        int h = row * 0x9e3779b1 ^ column * 0x85ebca6b;
        h = (h ^ h >>> 16) * 0x85ebca6b;
        h = (h ^ h >>> 13) * 0xc2b2ae35;
        return (h ^ h >>> 16) / 2147483648.0;
    }
}
