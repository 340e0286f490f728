package org.SEAR.raycast;

import java.util.Arrays;

/**
 * What each beam of a fan has met so far: a depth buffer (Catmull 1974) with one place a beam. Kept as inverse distances, because along a straight
 * line in the fan's plane the inverse distance is linear in the beam's direction: 1 / t = a * x + b * z. The lower shape number wins a tie, so the
 * order in which shapes come does not matter.
 */
final class DepthBuffer {
    private static final int TABLES = 4;
    private final FanDirections[] tables = new FanDirections[TABLES];
    private int nextTable;

    FanDirections beams;
    double[] inverse = new double[0];
    int[] shape = new int[0];

    void start(double startAngle, double step, int count, double maxRange) {
        beams = table(startAngle, step, count);
        if (inverse.length < count) {
            inverse = new double[count];
            shape = new int[count];
        }
        Arrays.fill(inverse, 0, count, Math.max(0, Math.nextDown(1 / maxRange * (1 - 1e-15))));
        Arrays.fill(shape, 0, count, -1);
    }

    private FanDirections table(double startAngle, double step, int count) {
        for (FanDirections known : tables) {
            if (known != null && known.is(startAngle, step, count)) {
                return known;
            }
        }
        FanDirections made = new FanDirections(startAngle, step, count);
        tables[nextTable] = made;
        nextTable = (nextTable + 1) % TABLES;
        return made;
    }

    /** A beam meets a shape at a distance, which may be infinite. */
    void meet(int beam, double distance, int shapeNumber) {
        double value = distance <= 0 ? Double.POSITIVE_INFINITY : 1 / distance;
        if (value > inverse[beam] || value == inverse[beam] && shapeNumber < shape[beam]) {
            inverse[beam] = value;
            shape[beam] = shapeNumber;
        }
    }

    /**
     * The line from p to the point q to the left of it, seen by the beams from p up to before q.
     *
     * @param a inverse distance = a * x + b * z
     */
    void line(double px, double pz, double qx, double qz, double a, double b, int shapeNumber) {
        int first = beams.first(px, pz);
        fill(first, qx, qz, a, b, shapeNumber);
        if (first != 0 && beams.side(0, px, pz) <= 0 && beams.side(0, qx, qz) > 0) {
            fill(0, qx, qz, a, b, shapeNumber);
        }
    }

    private void fill(int first, double qx, double qz, double a, double b, int shapeNumber) {
        double[] x = beams.x;
        double[] z = beams.z;
        double[] seen = inverse;
        int count = beams.count;
        for (int i = first; i < count && z[i] * qx - x[i] * qz > 0; i++) {
            double value = a * x[i] + b * z[i];
            if (value > seen[i]) {
                seen[i] = value;
                shape[i] = shapeNumber;
            } else if (value == seen[i] && shapeNumber < shape[i]) {
                shape[i] = shapeNumber;
            }
        }
    }

    /** Whether some beam could see into a rectangle of the plane at this squared distance. */
    boolean sees(double minX, double maxX, double minZ, double maxZ, double distanceSquared) {
        if (distanceSquared == 0) {
            return true;
        }
        double rightX = maxZ < 0 || minZ <= 0 && minX <= 0 ? maxX : minX;
        double leftX = minZ > 0 || minZ <= 0 && maxZ >= 0 && minX <= 0 ? maxX : minX;
        double rightZ = maxX < 0 || minX <= 0 && minZ > 0 ? minZ : maxZ;
        double leftZ = maxX < 0 || minX <= 0 && maxZ < 0 ? maxZ : minZ;
        double right = beams.angle(rightX, rightZ);
        double left = beams.angle(leftX, leftZ);
        double enough = 1 / Math.sqrt(distanceSquared) * (1 + 1e-12);
        int from = beams.from(right);
        int to = beams.to(left);
        if (FanDirections.inOneGo(right, left)) {
            return open(from, to, enough);
        }
        return open(from, beams.count - 1, enough) || open(0, to, enough);
    }

    /** Whether a beam could see into a circle of the plane ahead of it, whose nearest point has an inverse distance. */
    boolean isOpen(int beam, double middleX, double middleZ, double radius, double enough) {
        return Math.abs(beams.z[beam] * middleX - beams.x[beam] * middleZ) <= radius && inverse[beam] <= enough;
    }

    /** The line of inverse distances a * x + b * z, seen by the beams from one up to before another. */
    void fill(int first, int end, double a, double b, int shapeNumber) {
        for (int i = first; i < end; i++) {
            double value = a * beams.x[i] + b * beams.z[i];
            if (value > inverse[i] || value == inverse[i] && shapeNumber < shape[i]) {
                inverse[i] = value;
                shape[i] = shapeNumber;
            }
        }
    }

    private boolean open(int from, int to, double enough) {
        for (int i = from; i <= to; i++) {
            if (inverse[i] <= enough) {
                return true;
            }
        }
        return false;
    }
}
