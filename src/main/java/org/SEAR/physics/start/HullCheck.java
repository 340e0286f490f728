// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.start;

import java.util.List;
import java.util.Locale;
import org.SEAR.physics.Body;
import org.SEAR.physics.solid.Solid;

/**
 * Warns of models with hollows that move: their contacts use the convex hull, which fills the hollows. Compares the
 * volume of the hull with that inside the triangles, if these are closed.
 */
public final class HullCheck {
    /** Smallest ratio of the volumes that is reported. */
    private static final double LEAST_RATIO = 1.3;
    /** Largest number of warnings. */
    private static final int MAX_REPORTED = 5;

    private HullCheck() {
    }

    /** Adds a warning for each movable model with hollows, at most five. */
    public static void report(List<Body> bodies, List<String> warnings) {
        int reported = 0;
        for (Body body : bodies) {
            for (Solid solid : body.isFixed() ? List.<Solid>of() : body.solids) {
                double ratio = solid.isMesh() ? solid.convex().volume() / solid.volume() : 0;
                if (ratio >= LEAST_RATIO && reported++ < MAX_REPORTED) {
                    warnings.add(String.format(Locale.ROOT, "contacts of a model of %s use its convex hull, which "
                        + "has %.1f times"
                        + " the volume inside its triangles: its hollows are filled. setCollision(\"parts\") "
                        + "on the model"
                        + " keeps them open", body.isRobot() ? "robot " + body.name : body.name, ratio));
                }
            }
        }
    }
}
