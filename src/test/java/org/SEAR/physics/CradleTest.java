// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.junit.Test;

/** Newton's cradle of five balls. */
public class CradleTest {
    private final Findings findings = new Findings();

    @Test
    public void touchingBalls() throws Exception {
        ImpactScenes.cradle(1, 0, findings);
        findings.assertHold();
    }

    @Test
    public void ballsAMillimetreApart() throws Exception {
        ImpactScenes.cradle(1, 1e-3, findings);
        findings.assertHold();
    }

    @Test
    public void twoOfTouchingBalls() throws Exception {
        ImpactScenes.cradle(2, 0, findings);
        findings.assertHold();
    }

    @Test
    public void twoOfBallsAMillimetreApart() throws Exception {
        ImpactScenes.cradle(2, 1e-3, findings);
        findings.assertHold();
    }
}
