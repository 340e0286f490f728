// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.Slow;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Structures of up to 300 bodies, which take longer than those of {@link StructuresTest}. */
@Category(Slow.class)
public class LargeStructuresTest {
    private static final double TENTH = 0.1;
    /** Some bodies of a pile rock between others for half a minute. */
    private static final double PILE_SECONDS = 45;

    private final Findings findings = new Findings();

    /** Builds a structure of a stage. */
    private interface Scene {
        StructureScenes build();
    }

    private void stands(String name, double allowed, Scene scene) throws Exception {
        try (Stage stage = new Stage(40)) {
            scene.build().rest(stage, name, allowed, findings);
        }
    }

    private void settles(String name, double seconds, Scene scene) throws Exception {
        try (Stage stage = new Stage(40)) {
            scene.build().settle(stage, name, seconds, findings);
        }
    }

    @Test
    public void highWallsStand() throws Exception {
        stands("wall of 30 rows", TENTH, () -> StructureScenes.wall(30, 22));
        stands("stack bond of 20 rows", TENTH, () -> StructureScenes.stackBond(20));
        stands("stack bond of 30 rows", TENTH, () -> StructureScenes.stackBond(30));
        findings.assertHold();
    }

    @Test
    public void largePyramidsStand() throws Exception {
        stands("pyramid of 20 rows", TENTH, () -> StructureScenes.pyramid(20, false));
        stands("pyramid of 105 cans", TENTH, () -> StructureScenes.cans(14));
        findings.assertHold();
    }

    @Test
    public void ballsInATrayComeToRest() throws Exception {
        settles("100 balls in a tray", 15, () -> StructureScenes.tray(5, 4));
        findings.assertHold();
    }

    @Test
    public void mixedPilesComeToRest() throws Exception {
        for (int seed = 1; seed <= 3; seed++) {
            int own = seed;
            settles("pile of 200, seed " + seed, PILE_SECONDS, () -> StructureScenes.mixed(200, own));
        }
        findings.assertHold();
    }
}
