// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.start;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.solid.Solid;

/**
 * Warns of bodies whose centimetres or millimetres were probably entered as metres, as in models drawn in these units.
 */
public final class SizeCheck {
    /**
     * Smallest density of a movable body, kg/m^3: less than a tenth of air. A body in centimetres has a millionth of
     * its density.
     */
    private static final double LIGHTEST = 0.1;
    /** Smallest size of a body in this test, metres: excludes air-filled balls and kites. */
    private static final double LEAST = 2;
    /** Largest size of a fixed model, metres: larger than any building. */
    private static final double LARGEST = 2000;
    /** Largest number of warnings. */
    private static final int MAX_REPORTED = 5;
    private static final int CENTIMETRES = 100;
    private static final int MILLIMETRES = 1000;

    private SizeCheck() {
    }

    /** @param grounds bodies of any size */
    public static void report(List<Body> bodies, Set<Body> grounds, List<String> warnings) {
        int reported = 0;
        for (Body body : bodies) {
            String name = body.isRobot() ? "robot " + body.name : body.name;
            double size = size(body);
            if (reported < MAX_REPORTED && isTooLight(body)) {
                reported++;
                int times = body.mass / volume(body) * Math.pow(CENTIMETRES, 3) > 1 ? CENTIMETRES : MILLIMETRES;
                warnings.add(String.format(Locale.ROOT, "%s is %s m large and weighs %s kg: it is lighter than air. "
                    + "Lengths are in metres: if"
                    + " it was drawn in %s, it is %s m. Divide its lengths by %d, or call scale(%s) on a model", name,
                    DensityCheck.number(size),
                    DensityCheck.number(body.mass), unit(times), DensityCheck.number(size / times), times,
                        1.0 / times));
            } else if (reported < MAX_REPORTED && body.isFixed() && size > LARGEST && body.solids.get(0).isMesh()
                && !grounds.contains(body)) {
                reported++;
                warnings.add(String.format(Locale.ROOT, "model %s is %s m large. Lengths are in metres: if it was "
                    + "drawn in %s, call scale(%s); if it"
                    + " is the ground, call setTerrain(True)", name, DensityCheck.number(size), unit(MILLIMETRES),
                        1.0 / MILLIMETRES));
            }
        }
    }

    static boolean isTooLight(Body body) {
        return !body.isFixed() && size(body) > LEAST && body.mass < LIGHTEST * volume(body);
    }

    private static double volume(Body body) {
        double volume = 0;
        for (Solid solid : body.solids) {
            volume += solid.convex().volume();
        }
        return volume;
    }

    private static String unit(int times) {
        return times == CENTIMETRES ? "centimetres" : "millimetres";
    }

    private static double size(Body body) {
        Aabb box = new Overlap(body).bounds(Pose.IDENTITY);
        return Math.max(Math.max(box.maxX - box.minX, box.maxY - box.minY), box.maxZ - box.minZ);
    }
}
