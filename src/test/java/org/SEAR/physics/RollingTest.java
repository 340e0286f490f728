// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.junit.Test;

/** Bodies rolling down slopes agree with the closed forms within 0.1 %, up to 200 rad/s. */
public class RollingTest {
    private final Findings findings = new Findings();

    @Test
    public void aBallRolls() throws Exception {
        for (double degrees : new double[] {5, 15, 30}) {
            RollingScenes.ball(degrees, 3, findings);
        }
        findings.assertHold();
    }

    @Test
    public void aCylinderRolls() throws Exception {
        for (double degrees : new double[] {5, 15, 30}) {
            RollingScenes.cylinder(degrees, 3, findings);
        }
        findings.assertHold();
    }

    /** Their moments of inertia are 1e-5 and 2e-6 m^2 per kilogram. */
    @Test
    public void aMarbleAndAThinRodRoll() throws Exception {
        RollingScenes.ball(0.005, 5, 1, findings);
        RollingScenes.cylinder(0.002, 0.5, 5, 0.5, findings);
        findings.assertHold();
    }

    @Test
    public void aConeSwingsAboutItsApex() throws Exception {
        for (double degrees : new double[] {5, 15, 30}) {
            RollingScenes.cone(degrees, findings);
        }
        findings.assertHold();
    }
}
