// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.orders;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.Body;

/**
 * Forces that act on bodies for a limited time. In its last step a force is scaled by its remaining share of the step.
 * Simulation thread.
 */
final class Pushes {
    private final List<Push> all = new ArrayList<>();

    /** One force with its remaining time, s. */
    private static final class Push {
        private final Body body;
        private final BodyOrder order;
        private double left;

        Push(Body body, BodyOrder order) {
            this.body = body;
            this.order = order;
            left = order.seconds;
        }
    }

    void add(Body body, BodyOrder order) {
        all.add(new Push(body, order));
    }

    /** Removes all forces on a body. */
    void forget(Body body) {
        all.removeIf(push -> push.body == body);
    }

    void restart() {
        all.clear();
    }

    /** Applies the forces before a step. */
    void act() {
        for (int i = all.size() - 1; i >= 0; i--) {
            Push push = all.get(i);
            double now = Math.min(push.left, TimeStep.SECONDS);
            double share = now / TimeStep.SECONDS;
            push.body.wake();
            push.body.pull(push.order.x * share, push.order.y * share, push.order.z * share);
            push.left -= now;
            if (push.left <= 0) {
                all.remove(i);
            }
        }
    }
}
