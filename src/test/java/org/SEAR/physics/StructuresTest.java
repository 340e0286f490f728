// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import java.util.function.Supplier;
import org.SEAR.geometry.Pose;
import org.junit.Test;

/** Structures of many boxes stand still when left alone, and fall the same way each time when hit. */
public class StructuresTest {
    private static final double TENTH = 0.1;

    private static void stands(String name, double allowed, Supplier<StructureScenes> scene) throws Exception {
        Findings findings = new Findings();
        try (Stage stage = new Stage(40)) {
            scene.get().rest(stage, name, allowed, findings);
        }
        findings.assertHold();
    }

    /** Runs an arch for a second; returns how far its keystone has sunk, metres. */
    private static double sinks(double ratio) throws Exception {
        try (Stage stage = new Stage(40)) {
            return StructureScenes.arch(stage, 11, ratio).sinks(stage, 5, 1);
        }
    }

    @Test
    public void wallsInRunningBondStand() throws Exception {
        stands("wall of 10 rows", TENTH, () -> StructureScenes.wall(10, 11));
        stands("wall of 20 rows", TENTH, () -> StructureScenes.wall(20, 22));
    }

    @Test
    public void aWallInStackBondStands() throws Exception {
        stands("stack bond of 10 rows", TENTH, () -> StructureScenes.stackBond(10));
    }

    /** Limit analysis of rigid wedges (thrust line within every joint) gives 0.1046 for eleven of them. */
    @Test
    public void anArchStandsFromItsLeastThickness() throws Exception {
        assertEquals(0, sinks(0.106), 1e-4);
        assertTrue(sinks(0.103) > 0.01);
    }

    @Test
    public void aCardHouseStands() throws Exception {
        stands("card house of 3 storeys", TENTH, () -> StructureScenes.cards(3));
    }

    @Test
    public void stacksOfPlatesStand() throws Exception {
        stands("40 plates", TENTH, () -> StructureScenes.plates(40));
    }

    @Test
    public void pyramidsStand() throws Exception {
        stands("pyramid of 15 rows", TENTH, () -> StructureScenes.pyramid(15, false));
        stands("pyramid of 10 rows", TENTH, () -> StructureScenes.pyramid(10, false));
        stands("square pyramid of 8 rows", TENTH, () -> StructureScenes.pyramid(8, true));
    }

    @Test
    public void aJengaTowerStands() throws Exception {
        stands("Jenga tower of 18 storeys", TENTH, () -> StructureScenes.jenga(18, 0));
        stands("Jenga tower with 9 bricks pushed out", TENTH, () -> StructureScenes.jenga(18, 9));
    }

    @Test
    public void aHitWallFallsTheSameWayEachTime() throws Exception {
        List<Pose> first = fallen();
        List<Pose> again = fallen();
        for (int i = 0; i < first.size(); i++) {
            assertEquals("box " + i, first.get(i).x, again.get(i).x, 0);
            assertEquals("box " + i, first.get(i).y, again.get(i).y, 0);
            assertEquals("box " + i, first.get(i).z, again.get(i).z, 0);
        }
        assertTrue("the top brick stayed at " + first.get(first.size() - 1).y + " m",
            first.get(first.size() - 1).y < 0.5);
    }

    private static List<Pose> fallen() throws Exception {
        try (Stage stage = new Stage(40)) {
            return StructureScenes.wall(10, 33).hit(stage, 40, 4);
        }
    }
}
