// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.junit.Test;

/** Bodies slightly out of balance move. */
public class BalanceTest {
    private final Findings findings = new Findings();

    @Test
    public void aPolePastItsBalanceFalls() throws Exception {
        BalanceScenes.pole(0.05, 1, findings);
        BalanceScenes.pole(0.15, 3, findings);
        findings.assertHold();
    }

    @Test
    public void aBallRollsDownTheSlightestSlope() throws Exception {
        BalanceScenes.ball(findings);
        findings.assertHold();
    }
}
