package org.SEAR.physics.start;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.solid.Solid;

/** Tells of what is so large that its centimetres or millimetres must have been taken for metres, as those of models that were drawn in them. */
public final class SizeCheck {
    /** What can move and has less, kg/m^3, is lighter than a tenth of the air in its place; what is drawn in centimetres is so a million times. */
    private static final double LIGHTEST = 0.1;
    /** Air-filled balls and kites are not meant, metres. */
    private static final double LEAST = 2;
    /** A fixed model of this size, metres, is larger than any building. */
    private static final double LARGEST = 2000;
    /** More are not named one by one. */
    private static final int MAX_REPORTED = 5;
    private static final int CENTIMETRES = 100;
    private static final int MILLIMETRES = 1000;

    private SizeCheck() {
    }

    /** @param grounds which are as large as they like */
    public static void report(List<Body> bodies, Set<Body> grounds, List<String> warnings) {
        int reported = 0;
        for (Body body : bodies) {
            String name = body.isRobot() ? "robot " + body.name : body.name;
            double size = size(body);
            if (reported < MAX_REPORTED && isTooLight(body)) {
                reported++;
                int times = body.mass / volume(body) * Math.pow(CENTIMETRES, 3) > 1 ? CENTIMETRES : MILLIMETRES;
                warnings.add(String.format(Locale.ROOT, "%s is %s m large and weighs %s kg, so that it is lighter than air: lengths are metres; if"
                    + " it was drawn in %s, it is %s m: divide its lengths by %d, or scale(%s) a model", name, DensityCheck.number(size),
                    DensityCheck.number(body.mass), unit(times), DensityCheck.number(size / times), times, 1.0 / times));
            } else if (reported < MAX_REPORTED && body.isFixed() && size > LARGEST && body.solids.get(0).isMesh() && !grounds.contains(body)) {
                reported++;
                warnings.add(String.format(Locale.ROOT, "model %s is %s m large: lengths are metres; if it was drawn in %s, scale(%s) it; if it is"
                    + " the ground, setTerrain(True)", name, DensityCheck.number(size), unit(MILLIMETRES), 1.0 / MILLIMETRES));
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
