// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.Locale;
import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.Pose;

/**
 * A cube, cylinder or cone dropped onto a floor at height 0: its lowest point and its resting orientations in closed
 * form.
 */
final class Dropped {
    /** Sine of one degree. */
    private static final double SLANT = 0.01745;
    /** Rolling friction, high enough that cylinders and cones stop rolling within some seconds. */
    private static final double ROLLING = 0.1;

    final String name;
    final String what;
    /** 0 for a cube, 1 for a cylinder, 2 for a cone. */
    private final int kind;
    private final double radius;
    private final double half;

    /** Makes a body of 5 to 30 cm in a random orientation and drops it from half a metre. */
    Dropped(int kind, String name, double x, double z, Random random) {
        this.kind = kind;
        this.name = name;
        double size = size(random);
        double height = kind == 0 ? size : size(random);
        radius = size / 2;
        half = height / 2;
        what = String.format(Locale.ROOT, "%s %s of %.3f x %.3f m", new String[] {"cube", "cylinder", "cone"}[kind],
            name, size, height);
        Shape shape = kind == 0 ? new Box(name, size, size, size, 1)
            : kind == 1 ? new Cylinder(name, radius, height, 1) : new Cone(name, radius, height, 1);
        if (kind > 0) {
            shape.setRollingFriction(ROLLING);
        }
        shape.move(x, 0.5 + Math.hypot(size, height), z);
        shape.rotate(360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
    }

    private static double size(Random random) {
        return 0.05 + 0.25 * random.nextDouble();
    }

    /** Returns the height of the lowest point, metres. */
    double lowest(Pose pose) {
        double up = pose.rotate(0, 1, 0)[1];
        double across = Math.sqrt(Math.max(0, 1 - up * up));
        if (kind == 0) {
            return pose.y - radius * (Math.abs(pose.rotate(1, 0, 0)[1]) + Math.abs(up)
                + Math.abs(pose.rotate(0, 0, 1)[1]));
        }
        double base = pose.y - half * up - radius * across;
        return Math.min(base, kind == 1 ? pose.y + half * up - radius * across : pose.y + half * up);
    }

    /** Returns whether the body rests on a face, or on the contact line of its curved side. */
    boolean isSettled(Pose pose) {
        double up = pose.rotate(0, 1, 0)[1];
        if (kind == 0) {
            return Math.max(Math.abs(pose.rotate(1, 0, 0)[1]),
                Math.max(Math.abs(up), Math.abs(pose.rotate(0, 0, 1)[1]))) > Rest.FLAT;
        }
        if (kind == 1) {
            return Math.abs(up) > Rest.FLAT || Math.abs(up) < SLANT;
        }
        double leant = Math.asin(-up) - Math.atan2(radius, 2 * half);
        return up > Rest.FLAT || Math.abs(leant) < SLANT;
    }
}
