// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Aabb;
import org.SEAR.grammar.Parameter;
import org.SEAR.physics.solid.Solid;

/**
 * Warns of parts far away from their robot or much larger than it, mostly because centimetres were entered as metres.
 */
final class UnitMistakes {
    /** Distance above which a part is suspicious, metres, if it is also this many times the robot's size. */
    private static final double FAR = 2;
    private static final double TIMES = 2;
    /** Radius above which a wheel is suspicious, metres, if it is also this many times the robot's size. */
    private static final double LARGE_WHEEL = 1;
    private static final double TIMES_WHEEL = 3;
    private static final double CENTIMETRES = 100;
    private static final String METRES = ". Lengths are in metres: if these are centimetres, write ";

    private final SEARrobot robot;
    private final List<String> warnings;
    private final Aabb body = new Aabb().clear();
    private final Aabb wheels = new Aabb().clear();
    private boolean found;

    private UnitMistakes(SEARrobot robot, Map<SearObject, Solid> shapes, List<String> warnings) {
        this.robot = robot;
        this.warnings = warnings;
        for (SearObject part : robot.getComponents()) {
            if (part instanceof Shape) {
                Solid solid = shapes.get(part);
                add(body, part, solid == null ? 0 : Math.sqrt(solid.halfX * solid.halfX + solid.halfY * solid.halfY
                    + solid.halfZ * solid.halfZ));
            }
        }
        robot.getWheels().forEach(wheel -> add(wheels, wheel, wheel.getRadius()));
    }

    private static void add(Aabb box, SearObject part, double reach) {
        box.add(part.getX() - reach, part.getY() - reach, part.getZ() - reach);
        box.add(part.getX() + reach, part.getY() + reach, part.getZ() + reach);
    }

    /**
     * Warns of misplaced parts.
     * @param shapes of the parts that have one
     * @return whether a wheel is among them
     */
    static boolean report(SEARrobot robot, Map<SearObject, Solid> shapes, List<String> warnings) {
        UnitMistakes parts = new UnitMistakes(robot, shapes, warnings);
        boolean hasBody = shapes.keySet().stream().anyMatch(part -> robot.getComponents().contains(part));
        if (hasBody) {
            robot.getWheels().forEach(parts::look);
        }
        boolean onWheels = parts.found;
        if (hasBody || !robot.getWheels().isEmpty()) {
            parts.wheels.add(parts.body);
            robot.getComponents().stream().filter(part -> !(part instanceof Shape || part instanceof Dynamics))
                .forEach(part ->
                parts.look(part, parts.wheels));
        }
        return onWheels;
    }

    private void look(Wheel wheel) {
        double size = size(body);
        if (wheel.getRadius() > LARGE_WHEEL && wheel.getRadius() > TIMES_WHEEL * size) {
            found = true;
            warnings.add(String.format(Locale.ROOT, "%s has a radius of %s m, but the body of its robot %s is only "
                + "%.2g m large%s%s", wheel.getName(),
                Parameter.format(wheel.getRadius()), robot.getName(), size, METRES,
                    Parameter.format(wheel.getRadius() / CENTIMETRES)));
        } else {
            look(wheel, body);
        }
    }

    private void look(SearObject part, Aabb rest) {
        double gap = Math.sqrt(square(gap(part.getX(), rest.minX, rest.maxX))
            + square(gap(part.getY(), rest.minY, rest.maxY)) + square(gap(part.getZ(), rest.minZ, rest.maxZ)));
        if (gap > FAR && gap > TIMES * size(rest)) {
            found = true;
            warnings.add(String.format(Locale.ROOT, "%s is %.0f m away from the rest of its robot %s, at x %s, y %s, z "
                + "%s%smove(%s, %s, %s)",
                part.getName(), gap, robot.getName(), Parameter.format(part.getX()), Parameter.format(part.getY()),
                Parameter.format(part.getZ()),
                METRES, Parameter.format(part.getX() / CENTIMETRES), Parameter.format(part.getY() / CENTIMETRES),
                Parameter.format(part.getZ() / CENTIMETRES)));
        }
    }

    private static double gap(double value, double min, double max) {
        return Math.max(0, Math.max(min - value, value - max));
    }

    private static double square(double value) {
        return value * value;
    }

    private static double size(Aabb box) {
        return Math.max(Math.max(box.maxX - box.minX, box.maxY - box.minY), box.maxZ - box.minZ);
    }
}
