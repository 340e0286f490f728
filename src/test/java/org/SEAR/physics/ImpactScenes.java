// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Sphere;
import org.SEAR.simulator.BodyRun;

/** Newton's cradle: balls without friction in a row on a floor. */
final class ImpactScenes {
    private static final double RADIUS = 0.05;
    private static final double SPEED = 1;
    private static final int BALLS = 5;

    private ImpactScenes() {
    }

    /**
     * Some balls arrive with 1 m/s; the same number leaves at the other end.
     * @param gap between the waiting balls, metres
     */
    static void cradle(int coming, double gap, Findings into) throws Exception {
        try (Stage stage = new Stage()) {
            new Floor("floor", 50, 50).setFriction(0);
            for (int i = 0; i < BALLS; i++) {
                Sphere ball = new Sphere("ball" + i, RADIUS, 1);
                ball.setFriction(0);
                ball.setRollingFriction(0);
                ball.setRestitution(1);
                ball.move(i * (2 * RADIUS + gap) - (i < coming ? 0.3 : 0), RADIUS, 0);
            }
            BodyRun run = stage.start();
            for (int i = 0; i < coming; i++) {
                run.set("ball" + i, SPEED, 0, 0, 0, 0, 0);
            }
            into.in("cradle of five, " + coming + " coming, gaps of " + 1000 * gap + " mm");
            run.run(0.7);
            double momentum = 0;
            double energy = 0;
            double lowest = RADIUS;
            for (int i = 0; i < BALLS; i++) {
                double[] v = run.velocities("ball" + i);
                into.near("ball " + (i + 1) + " afterwards, m/s", i >= BALLS - coming ? SPEED : 0, 0.05 * SPEED, v[0]);
                momentum += v[0];
                energy += Rest.speed(v) * Rest.speed(v) / 2;
                lowest = Math.min(lowest, run.pose("ball" + i).y);
            }
            into.within("momentum, Ns", coming * SPEED, 1e-3, momentum);
            into.within("energy, J", coming * SPEED * SPEED / 2, 0.05, energy);
            into.atMost("deepest in the floor, mm", 0.5, 1000 * (RADIUS - lowest));
        }
    }
}
