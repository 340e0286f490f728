package org.SEAR.physics;

import org.SEAR.POJOs.Box;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** What sleeps on a support wakes when that goes, and what sleeps wakes when it is hit. */
final class WakeScenes {
    private WakeScenes() {
    }

    /**
     * A cube sleeps on a fixed slab that is put elsewhere.
     *
     * @param dx how far the slab goes, metres, likewise dy
     * @param expected how high the cube's middle is afterwards, metres
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

    /** A cube on a cube on a cube: the lowest is taken away. */
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

    /** A sleeping cube is hit by a sliding one. */
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
