// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.start;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.SEAR.geometry.Aabb;
import org.SEAR.physics.Body;
import org.SEAR.physics.RaycastScenes;

/**
 * Warns of bodies that start far from the ground or are many times larger, mostly because centimetres were entered as
 * metres.
 */
public final class GroundDistanceCheck {
    /** Distance beside or above the ground above which SEAR warns, metres. */
    private static final double FAR = 50;
    /** Size of a body above which SEAR warns, metres, if the body is also this many times larger than the ground. */
    private static final double LARGE = 50;
    private static final double TIMES = 3;
    /** Largest number of warnings. */
    private static final int MAX_REPORTED = 5;
    private static final double CENTIMETRES = 100;

    private GroundDistanceCheck() {
    }

    /** @param scenes with the ground, if there is one */
    public static void report(List<Body> bodies, RaycastScenes scenes, List<String> warnings) {
        Aabb ground = new Aabb().clear();
        scenes.grounds().forEach(body -> ground.add(new Overlap(body).bounds(body.getStart())));
        if (scenes.grounds().isEmpty()) {
            return;
        }
        List<String> reported = new ArrayList<>();
        for (Body body : bodies) {
            if (!scenes.grounds().contains(body)) {
                report(body, new Overlap(body).bounds(body.getStart()), ground, reported);
            }
        }
        warnings.addAll(reported.subList(0, Math.min(reported.size(), MAX_REPORTED)));
        if (reported.size() > MAX_REPORTED) {
            warnings.add((reported.size() - MAX_REPORTED) + " more objects are far beside the ground or many "
                + "times larger");
        }
    }

    private static void report(Body body, Aabb box, Aabb ground, List<String> reported) {
        double beside = Math.hypot(gap(box.minX, box.maxX, ground.minX, ground.maxX),
            gap(box.minZ, box.maxZ, ground.minZ, ground.maxZ));
        double above = box.minY - ground.maxY;
        double size = Math.max(Math.max(box.maxX - box.minX, box.maxZ - box.minZ), box.maxY - box.minY);
        double groundSize = Math.max(ground.maxX - ground.minX, ground.maxZ - ground.minZ);
        double x = body.getStart().x;
        double z = body.getStart().z;
        if (beside > FAR) {
            reported.add(String.format(Locale.ROOT,
                "%s starts %.0f m beside the ground, at x %s, z %s. Lengths are in metres: if these are centimetres,"
                + " use x %s, z %s", body.name, beside, number(x), number(z), number(x / CENTIMETRES),
                    number(z / CENTIMETRES)));
        } else if (size > LARGE && size > TIMES * groundSize && !SizeCheck.isTooLight(body)) {
            reported.add(String.format(Locale.ROOT,
                "%s is %.0f m large, but the ground only %.0f m. Lengths are in metres: if these are centimetres,"
                + " divide them by 100", body.name, size, groundSize));
        } else if (above > FAR && above > TIMES * groundSize && !body.isFixed()) {
            reported.add(String.format(Locale.ROOT, "%s starts %.0f m above the ground and will fall. Lengths "
                + "are in metres", body.name, above));
        }
    }

    private static double gap(double min, double max, double otherMin, double otherMax) {
        return Math.max(0, Math.max(otherMin - max, min - otherMax));
    }

    private static String number(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.format(Locale.ROOT, "%.2f", value);
    }
}
