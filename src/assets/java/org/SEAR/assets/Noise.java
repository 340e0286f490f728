// SPDX-License-Identifier: Apache-2.0
package org.SEAR.assets;

/** Smooth tileable noise from integer hashes; identical on every machine. */
final class Noise {
    private Noise() {
    }

    /** Returns a pseudo-random number from 0 to 1 for a grid point. */
    static double at(int x, int y, int seed) {
        int h = x * 374761393 + y * 668265263 + seed * 1274126177;
        h = (h ^ h >>> 13) * 1103515245;
        h = (h ^ h >>> 16) * 668265263;
        return (h >>> 8 & 0xffff) / 65535.0;
    }

    /** Returns smooth noise from 0 to 1 with the given cells across the unit square; tileable. */
    static double smooth(double u, double v, int cellsU, int cellsV, int seed) {
        double x = u * cellsU;
        double y = v * cellsV;
        int x0 = (int) Math.floor(x);
        int y0 = (int) Math.floor(y);
        double fx = ease(x - x0);
        double fy = ease(y - y0);
        int left = Math.floorMod(x0, cellsU);
        int right = (left + 1) % cellsU;
        int low = Math.floorMod(y0, cellsV);
        int high = (low + 1) % cellsV;
        double a = at(left, low, seed) * (1 - fx) + at(right, low, seed) * fx;
        double b = at(left, high, seed) * (1 - fx) + at(right, high, seed) * fx;
        return a * (1 - fy) + b * fy;
    }

    /** Returns noise of five octaves, 0 to 1. */
    static double cloud(double u, double v, int cells, int seed) {
        double sum = 0;
        double weight = 0.5;
        int size = cells;
        for (int i = 0; i < 5; i++) {
            sum += weight * smooth(u, v, size, size, seed + i);
            weight /= 2;
            size *= 2;
        }
        return sum / 0.96875;
    }

    private static double ease(double t) {
        return t * t * (3 - 2 * t);
    }
}
