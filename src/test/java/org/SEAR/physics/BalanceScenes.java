// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Sphere;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** Scenes with bodies slightly out of balance, which must move. */
final class BalanceScenes {
    private static final double G = 9.81;
    private static final double OFF = 0.02;

    private BalanceScenes() {
    }

    /** A pole on its edge, 0.02 degrees past its balance, falls as fast as the closed form says. */
    static void pole(double width, double height, Findings into) throws Exception {
        double past = Math.toRadians(OFF);
        double fallen = Math.toRadians(30);
        double reach = Math.hypot(width, height) / 2;
        try (Stage stage = new Stage(20)) {
            Box pole = new Box("pole", width, width, height, 1);
            pole.move(-reach * Math.sin(past), reach * Math.cos(past), 0);
            pole.rotate(0, 0, Math.toDegrees(Math.atan2(width, height)) + OFF);
            BodyRun run = stage.start();
            double expected = 0;
            double[] state = {past, 0};
            while (state[0] < fallen) {
                state = RollingScenes.pendulum(state[0], state[1], 0.75 * G / reach, 1e-3);
                expected += 1e-3;
            }
            while (run.time() < 10 && leant(run, width, height) < fallen) {
                run.step();
            }
            into.in("pole of " + height + " m " + OFF + " degrees past its balance");
            into.within("leans by 30 degrees after, s", expected, 0.03, run.time());
            run.run(5);
            into.atMost("upright after 5 s more (1: stands)", 0.05, Math.abs(run.pose("pole").rotate(0, 1, 0)[1]));
        }
    }

    /** Returns the angle of the pole's middle past its supporting edge, radians. */
    private static double leant(BodyRun run, double width, double height) {
        double[] up = run.pose("pole").rotate(0, 1, 0);
        return Math.atan2(-up[0], up[1]) - Math.atan2(width, height);
    }

    /** A ball without rolling friction rolls down a slope of 0.02 degrees. */
    static void ball(Findings into) throws Exception {
        double slope = Math.toRadians(OFF);
        try (Stage stage = new Stage()) {
            Floor floor = new Floor("slope", 100, 100);
            floor.rotate(0, 0, OFF);
            floor.setRollingFriction(0);
            Sphere ball = new Sphere("ball", 0.1, 1);
            ball.move(-0.1 * Math.sin(slope), 0.1 * Math.cos(slope), 0);
            ball.setRollingFriction(0);
            BodyRun run = stage.start();
            Pose from = run.pose("ball");
            run.run(20);
            into.in("ball on a slope of " + OFF + " degrees");
            into.within("way in 20 s, m", 5.0 / 7 * G * Math.sin(slope) * 200, 0.01,
                Rest.distance(from, run.pose("ball")));
        }
    }
}
