// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.Slow;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Crowded bodies at one spot cost a bounded time and separate slowly. */
@Category(Slow.class)
public class CrowdClockTest {
    private final Findings findings = new Findings();

    @Test
    public void twoHundredAtOneSpot() throws Exception {
        CrowdScenes.oneSpot(200, findings);
        findings.assertHold();
    }
}
