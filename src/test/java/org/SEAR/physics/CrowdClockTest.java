package org.SEAR.physics;

import org.SEAR.Slow;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Far too much at one spot costs a bounded time and comes apart slowly. */
@Category(Slow.class)
public class CrowdClockTest {
    private final Findings findings = new Findings();

    @Test
    public void twoHundredAtOneSpot() throws Exception {
        CrowdScenes.oneSpot(200, findings);
        findings.assertHold();
    }
}
