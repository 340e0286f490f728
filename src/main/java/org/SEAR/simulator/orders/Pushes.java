package org.SEAR.simulator.orders;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.Body;

/**
 * Forces that act on bodies for some time; in the step in which one ends it is as much weaker as it is shorter. Simulation thread.
 */
final class Pushes {
    private final List<Push> all = new ArrayList<>();

    /** One force, and for how long it still acts. */
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

    /** Nothing pushes a body any more. */
    void forget(Body body) {
        all.removeIf(push -> push.body == body);
    }

    /** Nothing is pushed. */
    void restart() {
        all.clear();
    }

    /** Before a step. */
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
