package org.SEAR.physics.start;

import java.util.List;
import java.util.Locale;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;

/** Tells of what weighs more than anything of its size can: mostly its grams were taken for kilograms. */
public final class DensityCheck {
    /** Three times as dense as gold, kg/m^3: the dissertation's Roombas of 400 kg are not meant. */
    private static final double DENSEST = 60000;
    /** More are not named one by one. */
    private static final int MAX_REPORTED = 5;
    private static final double GRAMS = 1000;

    private DensityCheck() {
    }

    /** Looks at the boxes around them, which are larger than what is in them. */
    public static void report(List<Body> bodies, List<String> warnings) {
        long reported = 0;
        for (Body body : bodies) {
            if (!body.isFixed() && reported < MAX_REPORTED && isTooHeavy(body)) {
                reported++;
                warnings.add(String.format(Locale.ROOT, "%s weighs %s kg, and is only %.2g m large, so that it is heavier than gold: masses are"
                    + " kilograms; if these are grams, it is %s", body.isRobot() ? "robot " + body.name : body.name, number(body.mass), size(body),
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

    /** For a warning: whole, or with three digits. */
    static String number(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.format(Locale.ROOT, "%.3g", value);
    }
}
