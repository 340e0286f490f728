package org.SEAR.terrain.relief;

/** Smooth noise on the plane, the same for ever at the same place: random values at whole numbers, a smooth course between. Any thread. */
final class ValueNoise {
    private ValueNoise() {
    }

    /** Three octaves of it, from about -1 to 1, mean 0. */
    static double fractal(double x, double z) {
        return (4 * at(x, z) + 2 * at(2.03 * x + 31.7, 2.03 * z - 17.1) + at(4.1 * x - 7.9, 4.1 * z + 53.3)) / 7 * 1.6;
    }

    /** From -1 to 1. */
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

    /** The random value of a place in whole numbers, from -1 to 1: the finisher of MurmurHash3 over both. */
    static double value(int row, int column) {
        int h = row * 0x9e3779b1 ^ column * 0x85ebca6b;
        h = (h ^ h >>> 16) * 0x85ebca6b;
        h = (h ^ h >>> 13) * 0xc2b2ae35;
        return (h ^ h >>> 16) / 2147483648.0;
    }
}
