package org.SEAR.simulator;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;

/** Tells of what has fallen out of the world, and stops it far below. Simulation thread. */
final class KillPlane {
    /** Below everything that is fixed by this much, metres, nothing can catch a body any more. */
    private static final double OUT = 10;
    /** Here it stops: 1000 m farther down poses lose their last digits, and nobody looks. */
    private static final double END = 1000;

    private final List<Body> bodies;
    /** Those that can fall: what is fixed costs nothing in a step. */
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

    /** Everything is where it started. */
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

    /** Looks at everything after a step. */
    void look() {
        for (int i = 0; i < movable.length; i++) {
            Body body = movable[i];
            double y = body.getPose().y;
            if (y < lowest - OUT) {
                if (!reported[i]) {
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
        warnings.accept(String.format(Locale.ROOT, "%s has fallen out of the world, below everything, at x %.1f, z %.1f; put ground there", body.name,
            pose.x, pose.z));
    }
}
