// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

/**
 * A lens with Brown's distortion (D. C. Brown, "Decentering distortion of lenses", 1966), with OpenCV's order and
 * signs. A point (x, y) of the plane at 1 m, x to the right and y down, appears at x (1 + k1 r^2 + k2 r^4) + 2 p1 x y +
 * p2 (r^2 + 2 x^2), likewise y. Immutable, any thread.
 */
public final class BrownLens {
    private static final int MAX_STEPS = 60;
    /** Convergence threshold of the Newton iteration, metres in the plane at 1 m. */
    private static final double EXACT = 1e-14;
    private static final double GOOD = 1e-9;

    private final double focalLength;
    private final double cx;
    private final double cy;
    private final double k1;
    private final double k2;
    private final double p1;
    private final double p2;

    /**
     * @param focalLength pixels
     * @param cx column of the optical axis, likewise the row cy
     * @param distortion k1, k2, p1, p2
     */
    public BrownLens(double focalLength, double cx, double cy, double[] distortion) {
        this.focalLength = focalLength;
        this.cx = cx;
        this.cy = cy;
        k1 = distortion[0];
        k2 = distortion[1];
        p1 = distortion[2];
        p2 = distortion[3];
    }

    /** Returns the focal length, pixels. */
    public double getFocalLength() {
        return focalLength;
    }

    /** Returns the column of a point of the plane at 1 m: x metres to the right of the axis and y below it. */
    public double column(double x, double y) {
        return cx + focalLength * seenX(x, y);
    }

    /** Returns the row of a point of the plane at 1 m. */
    public double row(double x, double y) {
        return cy + focalLength * seenY(x, y);
    }

    private double seenX(double x, double y) {
        double r = x * x + y * y;
        return x * (1 + r * (k1 + r * k2)) + 2 * p1 * x * y + p2 * (r + 2 * x * x);
    }

    private double seenY(double x, double y) {
        double r = x * x + y * y;
        return y * (1 + r * (k1 + r * k2)) + p1 * (r + 2 * y * y) + 2 * p2 * x * y;
    }

    /**
     * Finds the point of the plane at 1 m that appears at a place of the picture, by Newton's method.
     *
     * @param point receives the metres to the right of the axis and below it
     * @return whether there is such a point that the distortion does not fold back
     */
    public boolean point(double column, double row, double[] point) {
        double wantedX = (column - cx) / focalLength;
        double wantedY = (row - cy) / focalLength;
        double x = wantedX;
        double y = wantedY;
        double turn = 1;
        double off = Double.POSITIVE_INFINITY;
        for (int step = 0; step < MAX_STEPS && off > EXACT; step++) {
            double r = x * x + y * y;
            double radial = 1 + r * (k1 + r * k2);
            double slope = 2 * k1 + 4 * k2 * r;
            double xx = radial + x * x * slope + 2 * p1 * y + 6 * p2 * x;
            double xy = x * y * slope + 2 * p1 * x + 2 * p2 * y;
            double yy = radial + y * y * slope + 6 * p1 * y + 2 * p2 * x;
            double errorX = seenX(x, y) - wantedX;
            double errorY = seenY(x, y) - wantedY;
            turn = xx * yy - xy * xy;
            x -= (yy * errorX - xy * errorY) / turn;
            y -= (xx * errorY - xy * errorX) / turn;
            off = Math.abs(errorX) + Math.abs(errorY);
        }
        point[0] = x;
        point[1] = y;
        return off <= GOOD && turn > 0 && isAhead(x, y);
    }

    /** Returns whether the distorted radius increases all the way from the axis to the point. */
    private boolean isAhead(double x, double y) {
        double r = x * x + y * y;
        for (int part = 1; part <= MAX_STEPS; part++) {
            double here = r * part / MAX_STEPS;
            if (1 + 3 * k1 * here + 5 * k2 * here * here <= 0) {
                return false;
            }
        }
        return true;
    }

    /** Returns whether the lens covers every pixel at the edge of a picture. */
    boolean isWhole(int width, int height) {
        double[] point = new double[2];
        boolean whole = true;
        for (int column = 0; column < width; column++) {
            whole &= point(column, 0, point) && point(column, height - 1, point);
        }
        for (int row = 0; row < height; row++) {
            whole &= point(0, row, point) && point(width - 1, row, point);
        }
        return whole;
    }
}
