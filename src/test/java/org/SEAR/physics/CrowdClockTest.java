package org.SEAR.physics;

import org.junit.Test;

/** Far too much at one spot costs a bounded time and comes apart slowly. */
public class CrowdClockTest {
    private final Findings findings = new Findings();

    @Test
    public void twoHundredAtOneSpot() throws Exception {
        CrowdScenes.oneSpot(200, findings);
        findings.assertHold();
    }
}
