package org.SEAR.physics;

import org.junit.Test;

/** What turns without torque, and a top, keeps energy and angular momentum. */
public class SpinTest {
    private final Findings findings = new Findings();

    @Test
    public void aBoxTumbles() throws Exception {
        SpinScenes.tumblingBox(findings);
        findings.assertHold();
    }

    @Test
    public void aTTumbles() throws Exception {
        SpinScenes.tumblingT(findings);
        findings.assertHold();
    }

    @Test
    public void aRodTurnsAboutTwoAxes() throws Exception {
        SpinScenes.nutatingRod(findings);
        findings.assertHold();
    }

    @Test
    public void aDiscWobbles() throws Exception {
        SpinScenes.wobblingDisc(findings);
        findings.assertHold();
    }

    @Test
    public void aTopPrecesses() throws Exception {
        SpinScenes.top(findings);
        findings.assertHold();
    }
}
