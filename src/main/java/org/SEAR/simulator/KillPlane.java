// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.RobotBodies;

/** Warns of bodies that have fallen out of the world, and stops them far below. Simulation thread. */
final class KillPlane {
    /** Depth below the lowest fixed body at which a body counts as fallen, metres; nothing can catch it there. */
    private static final double OUT = 10;
    /** Depth at which a fallen body stops, metres. Further down its pose would lose precision. */
    private static final double END = 1000;

    private final List<Body> bodies;
    /** Bodies that are not fixed. */
    private final Body[] movable;
    private final Consumer<String> warnings;
    private final boolean[] reported;
    private double lowest;

    KillPlane(List<Body> bodies, Consumer<String> warnings) {
        this.bodies = bodies;
        this.warnings = warnings;
        movable = bodies.stream().filter(body -> !body.isFixed()).toArray(Body[]::new);
        reported = new boolean[movable.length];
    }

    /** Finds the lowest fixed body, or the lowest body if none is fixed. Call it with all bodies at their start. */
    void restart() {
        lowest = Double.POSITIVE_INFINITY;
        Arrays.fill(reported, false);
        for (Body body : bodies) {
            if (body.isFixed()) {
                lowest = Math.min(lowest, body.lowest());
            }
        }
        for (int i = 0; lowest == Double.POSITIVE_INFINITY && i < movable.length; i++) {
            lowest = Math.min(lowest, movable[i].lowest());
        }
    }

    /** Checks all movable bodies after a step. */
    void look() {
        for (int i = 0; i < movable.length; i++) {
            Body body = movable[i];
            double y = body.getPose().y;
            if (y < lowest - OUT) {
                if (!reported[i] && !RobotBodies.isLink(body)) {
                    reported[i] = true;
                    report(body);
                }
                if (y < lowest - END) {
                    body.stop();
                }
            }
        }
    }

    private void report(Body body) {
        Pose pose = body.getPose();
        warnings.accept(String.format(Locale.ROOT, "%s has fallen out of the world, below everything, at x %.1f, z "
            + "%.1f; put ground there", body.name,
            pose.x, pose.z));
    }
}
