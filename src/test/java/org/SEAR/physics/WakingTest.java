// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.junit.Test;

/** Sleeping bodies wake when their support goes and when they are hit. */
public class WakingTest {
    private final Findings findings = new Findings();

    @Test
    public void supportTakenAway() throws Exception {
        WakeScenes.support(5, 0, 0.1, findings);
        findings.assertHold();
    }

    @Test
    public void supportLowered() throws Exception {
        WakeScenes.support(0, -0.1, 0.4, findings);
        findings.assertHold();
    }

    @Test
    public void supportRaisedIntoIt() throws Exception {
        WakeScenes.support(0, 0.05, 0.55, findings);
        findings.assertHold();
    }

    @Test
    public void theLowestOfThreeTakenAway() throws Exception {
        WakeScenes.lowest(findings);
        findings.assertHold();
    }

    @Test
    public void aSleeperIsHit() throws Exception {
        WakeScenes.hit(findings);
        findings.assertHold();
    }
}
