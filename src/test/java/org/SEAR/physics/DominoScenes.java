// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.POJOs.Box;
import org.SEAR.simulator.BodyRun;

/** Rows of dominoes that must fall to the last. */
final class DominoScenes {
    static final double[] HEIGHTS = {0.05, 0.1, 0.2, 0.4};
    /** Distance between centres as a fraction of the height. */
    static final double[] GAPS = {0.25, 0.35, 0.45, 0.55, 0.65};
    private static final int COUNT = 30;

    private DominoScenes() {
    }

    /** One row, whose first domino is tilted by 20 degrees. */
    static void row(double height, double gap, Findings into) throws Exception {
        double thick = 0.15 * height;
        try (Stage stage = new Stage(60)) {
            Cuboids all = new Cuboids();
            for (int i = 0; i < COUNT; i++) {
                Box domino = new Box("domino" + i, height / 2, thick, height, 0.1);
                all.add("domino" + i, height / 2, height, thick);
                domino.move(0, height / 2, gap * height * i);
                if (i == 0) {
                    domino.move(0, height / 2 * Math.cos(0.35) + 0.075 * height * Math.sin(0.35), -0.2 * height);
                    domino.rotate(20, 0, 0);
                }
            }
            BodyRun run = stage.start();
            into.in(COUNT + " dominoes of " + height + " m, " + gap + " of that apart");
            run.run(10 - Rest.WATCH);
            all.remember(run);
            run.run(Rest.WATCH);
            int fallen = 0;
            for (int i = 0; i < COUNT; i++) {
                fallen += Math.abs(run.pose("domino" + i).rotate(0, 1, 0)[1]) < 0.9 ? 1 : 0;
            }
            into.equal("fallen", COUNT, fallen);
            into.equal("still moving after 10 s", 0, all.moving(run));
            into.atMost("deepest overlap, mm", 0.5, 1000 * all.deepest(run));
        }
    }
}
