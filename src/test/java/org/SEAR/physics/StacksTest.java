// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.junit.Test;

/** Stacks, towers, and heavy bodies on light ones. */
public class StacksTest {
    private final Findings findings = new Findings();

    @Test
    public void tenBoxesStandForAMinute() throws Exception {
        StackScenes.ten(findings);
        findings.assertHold();
    }

    @Test
    public void fortyBoxesStand() throws Exception {
        StackScenes.forty(findings);
        findings.assertHold();
    }

    @Test
    public void aLightCubeCarriesOneOfATon() throws Exception {
        StackScenes.masses(1, 1000, findings);
        findings.assertHold();
    }

    @Test
    public void aCubeOfATonCarriesALightOne() throws Exception {
        StackScenes.masses(1000, 1, findings);
        findings.assertHold();
    }

    @Test
    public void aTonDroppedOntoAKilogramCausesNoThrow() throws Exception {
        StackScenes.dropOntoLight(findings);
        findings.assertHold();
    }
}
