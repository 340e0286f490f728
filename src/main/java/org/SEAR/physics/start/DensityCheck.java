// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.start;

import java.util.List;
import java.util.Locale;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;

/** Warns of bodies that are too heavy for their size, mostly because grams were entered as kilograms. */
public final class DensityCheck {
    /** Three times the density of gold, kg/m^3; above the dissertation's Roombas of 400 kg. */
    private static final double DENSEST = 60000;
    /** Largest number of warnings. */
    private static final int MAX_REPORTED = 5;
    private static final double GRAMS = 1000;

    private DensityCheck() {
    }

    /** Checks the bounding boxes, which are larger than the bodies. */
    public static void report(List<Body> bodies, List<String> warnings) {
        long reported = 0;
        for (Body body : bodies) {
            if (!body.isFixed() && reported < MAX_REPORTED && isTooHeavy(body)) {
                reported++;
                warnings.add(String.format(Locale.ROOT, "%s weighs %s kg at a size of only %.2g m: that is denser than "
                    + "gold. Masses are in"
                    + " kilograms: if this is grams, use %s", body.isRobot() ? "robot " + body.name : body.name,
                    number(body.mass), size(body),
                    number(body.mass / GRAMS)));
            }
        }
    }

    private static boolean isTooHeavy(Body body) {
        Aabb box = new Overlap(body).bounds(Pose.IDENTITY);
        double volume = (box.maxX - box.minX) * (box.maxY - box.minY) * (box.maxZ - box.minZ);
        return body.mass > DENSEST * volume;
    }

    private static double size(Body body) {
        Aabb box = new Overlap(body).bounds(Pose.IDENTITY);
        return Math.max(Math.max(box.maxX - box.minX, box.maxY - box.minY), box.maxZ - box.minZ);
    }

    /** Formats a number for a warning: whole, or with three digits. */
    static String number(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.format(Locale.ROOT, "%.3g", value);
    }
}
