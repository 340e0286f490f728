// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.Slow;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Bodies dropped singly come to rest on a face, a rim or a side; {@code -Dsear.singles=1000} sets the number of drops
 * per seed.
 */
@Category(Slow.class)
public class SingleDropsTest {
    private static final int SINGLES = Integer.getInteger("sear.singles", 200);

    private final Findings findings = new Findings();

    @Test
    public void everyDroppedBodyComesToRestOnAFaceRimOrSide() throws Exception {
        for (long seed = 1; seed <= 3; seed++) {
            DropScenes.single(SINGLES, seed, findings);
        }
        findings.assertHold();
    }

    @Test
    public void noCubeGainsEnergyByLanding() throws Exception {
        DropScenes.landing(300, findings);
        findings.assertHold();
    }

    /**
     * The first three piles sway on without damping of rocking, because a cube hangs between others by its corners. The
     * others sway on with one pass per substep, because each contact sees the others' changes too late.
     */
    @Test
    public void pilesComeToRest() throws Exception {
        for (long seed : new long[] {15, 21, 37, 57, 58, 67}) {
            DropScenes.pile(100, seed, findings);
        }
        findings.assertHold();
    }

    /** Enough cubes that each has many neighbours. */
    @Test
    public void cubesOfALargePileDoNotOverlap() throws Exception {
        DropScenes.pile(500, 1, findings);
        findings.assertHold();
    }
}
