// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

/** Meshes support bodies as the surfaces that they approximate do. */
public class BowlsTest {
    private static final double[] CELLS = {0.003, 0.01, 0.025, 0.05};
    private final Findings findings = new Findings();

    @Test
    public void aBallInABowlKeepsItsEnergyAndItsPeriod() throws Exception {
        for (double cell : CELLS) {
            BowlScenes.bowl(cell, 8, cell < CELLS[1] ? 1.8 : 3, findings);
        }
        findings.assertHold();
    }

    @Test
    public void aBallRollsOffADomeAsOffASmoothOne() throws Exception {
        for (double cell : CELLS) {
            BowlScenes.dome(cell, findings);
        }
        findings.assertHold();
    }

    @Test
    public void aBoxComesToRestOnABumpyMesh() throws Exception {
        BowlScenes.bumps(0.01, 0.002, 1, findings);
        for (int seed = 1; seed <= 3; seed++) {
            BowlScenes.bumps(0.03, 0.01, seed, findings);
        }
        findings.assertHold();
    }

    @Test
    public void theOrderOfTheTrianglesDoesNotCount() throws Exception {
        assertEquals(BowlScenes.onBumps(false), BowlScenes.onBumps(true));
    }
}
