// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.List;
import org.SEAR.POJOs.BeamCone;

/**
 * The rays of a distance sensor in its own frame (+z forward, +x left, +y up), as unit vectors with a length and a
 * colour. A cone's rays lie on its surface. The first is at its left rim, the others follow counter-clockwise as seen
 * from the front. Immutable; any thread.
 */
public final class BeamPattern {
    private final double[] directions;
    private final double[] ranges;
    private final int[] colors;
    private final double maxRange;

    private BeamPattern(double[] directions, double[] ranges, int[] colors) {
        this.directions = directions;
        this.ranges = ranges;
        this.colors = colors;
        double longest = 0;
        for (double range : ranges) {
            longest = Math.max(longest, range);
        }
        this.maxRange = longest;
    }

    /** Returns the rays of all cones in order. */
    public static BeamPattern of(List<BeamCone> cones) {
        int count = cones.stream().mapToInt(BeamCone::getLines).sum();
        double[] directions = new double[3 * count];
        double[] ranges = new double[count];
        int[] colors = new int[count];
        int line = 0;
        for (BeamCone cone : cones) {
            int color = Integer.parseInt(cone.getColor().substring(1), 16);
            for (int i = 0; i < cone.getLines(); i++) {
                direct(cone, i, directions, 3 * line);
                ranges[line] = cone.getRange();
                colors[line] = color;
                line++;
            }
        }
        return new BeamPattern(directions, ranges, colors);
    }

    private static void direct(BeamCone cone, int number, double[] out, int at) {
        double half = Math.toRadians(cone.getHalfAngle());
        double around = 2 * Math.PI * number / cone.getLines();
        double pitch = Math.toRadians(cone.getPitch());
        double yaw = Math.toRadians(cone.getYaw());
        double x = Math.sin(half) * Math.cos(around);
        double y = Math.sin(half) * Math.sin(around);
        double z = Math.cos(half);
        double level = z * Math.cos(pitch) - y * Math.sin(pitch);
        out[at] = x * Math.cos(yaw) + level * Math.sin(yaw);
        out[at + 1] = y * Math.cos(pitch) + z * Math.sin(pitch);
        out[at + 2] = level * Math.cos(yaw) - x * Math.sin(yaw);
    }

    /** Returns the number of rays. */
    public int size() {
        return ranges.length;
    }

    /** Returns the component to the left. */
    public double getX(int line) {
        return directions[3 * line];
    }

    /** Returns the component up. */
    public double getY(int line) {
        return directions[3 * line + 1];
    }

    /** Returns the component forward. */
    public double getZ(int line) {
        return directions[3 * line + 2];
    }

    /** Returns the length of a ray, metres. */
    public double getRange(int line) {
        return ranges[line];
    }

    /** Returns the lengths of all rays; the caller must not change them. */
    double[] ranges() {
        return ranges;
    }

    /** Returns 0xrrggbb. */
    public int getColor(int line) {
        return colors[line];
    }

    /** Returns the length of the longest ray, metres. */
    public double getMaxRange() {
        return maxRange;
    }
}
