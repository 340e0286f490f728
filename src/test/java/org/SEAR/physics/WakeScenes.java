// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.POJOs.Box;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** Scenes of sleeping bodies that wake when their support goes or when they are hit. */
final class WakeScenes {
    private WakeScenes() {
    }

    /**
     * A cube sleeps on a fixed slab, which is then moved.
     * @param dx distance of the slab's move, metres, likewise dy
     * @param expected height of the cube's middle afterwards, metres
     */
    static void support(double dx, double dy, double expected, Findings into) throws Exception {
        try (Stage stage = new Stage(20)) {
            new Box("slab", 1, 1, 0.2, 0).move(0, 0.3, 0);
            new Box("cube", 0.2, 0.2, 0.2, 1).move(0, 0.5, 0);
            BodyRun run = stage.start();
            run.run(5);
            into.in("support moved by " + dx + ", " + dy + " m");
            into.equal("bodies looked at while it sleeps", 0, run.busy());
            Pose slab = run.pose("slab");
            run.move("slab", new Pose(slab.x + dx, slab.y + dy, slab.z, slab.qx, slab.qy, slab.qz, slab.qw));
            run.run(3);
            into.near("height of the cube 3 s later, m", expected, 1e-3, run.pose("cube").y);
            into.equal("bodies looked at then", 0, run.busy());
        }
    }

    /** Removes the lowest of three stacked cubes. */
    static void lowest(Findings into) throws Exception {
        try (Stage stage = new Stage(20)) {
            for (int i = 0; i < 3; i++) {
                new Box("cube" + i, 0.2, 0.2, 0.2, 1).move(0, 0.1 + 0.2 * i, 0);
            }
            BodyRun run = stage.start();
            run.run(5);
            into.in("the lowest of three is taken away");
            run.move("cube0", new Pose(3, 0.1, 0, 0, 0, 0, 1));
            run.run(3);
            into.near("height of the uppermost 3 s later, m", 0.3, 1e-3, run.pose("cube2").y);
        }
    }

    /** A sliding cube hits a sleeping one. */
    static void hit(Findings into) throws Exception {
        try (Stage stage = new Stage(20)) {
            new Box("sleeper", 0.2, 0.2, 0.2, 1).move(0, 0.1, 0);
            new Box("other", 0.2, 0.2, 0.2, 1).move(-3, 0.1, 0);
            BodyRun run = stage.start();
            run.run(5);
            into.in("a sleeping cube is hit");
            into.equal("bodies looked at while both sleep", 0, run.busy());
            run.set("other", 6.5, 0, 0, 0, 0, 0);
            run.run(5);
            into.atLeast("way of the sleeper, m", 0.05, run.pose("sleeper").x);
        }
    }
}
