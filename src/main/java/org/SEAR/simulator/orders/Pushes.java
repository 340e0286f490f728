package org.SEAR.simulator.orders;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.Body;

/**
 * Forces that act on bodies for some time. A step's share of a force acts as two impulses, half of it before the step and half before the next: so a
 * free body is after each step where the constant force would have brought it. Simulation thread.
 */
final class Pushes {
    private final List<Push> all = new ArrayList<>();
    private final double[] impulse = new double[3];

    /** One force, and for how long it still acts. */
    private static final class Push {
        private final Body body;
        private final BodyOrder order;
        private double left;
        /** For how much of the step that went by its second half is still to come, seconds. */
        private double owed;

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
            double share = (now + push.owed) / 2;
            impulse[0] = push.order.x * share;
            impulse[1] = push.order.y * share;
            impulse[2] = push.order.z * share;
            push.body.wake();
            push.body.push(impulse, centre(push.body));
            push.left -= now;
            push.owed = now;
            if (now == 0) {
                all.remove(i);
            }
        }
    }

    private static double[] centre(Body body) {
        double[] centre = body.getCentre();
        return body.getPose().transform(centre[0], centre[1], centre[2]);
    }
}
