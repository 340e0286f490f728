// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import java.util.Random;
import org.SEAR.geometry.InertiaTensor;
import org.SEAR.geometry.PrincipalAxes;
import org.junit.Test;

/** Torque-free bodies and a top conserve energy and angular momentum. */
public class AngularStateTest {
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
    public void anLTumblesAboutAnAxisOffItsOwn() throws Exception {
        SpinScenes.tumblingL(findings);
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

    /** A body held against a surface changes its angular velocity like a free one and keeps its orientation. */
    @Test
    public void aHeldRotationChangesTheAngularVelocityLikeAFreeOne() {
        Random random = new Random(1);
        for (int i = 0; i < 1000; i++) {
            AngularState free = spin(random.nextLong());
            AngularState held = new AngularState();
            PrincipalAxes axes = PrincipalAxes.of(new InertiaTensor(1, 2, 2.5));
            held.setInertia(axes);
            free.setInertia(axes);
            held.set(free.qx(), free.qy(), free.qz(), free.qw());
            double[] v = {0, 0, 0, 5 * random.nextGaussian(), 5 * random.nextGaussian(), 5 * random.nextGaussian()};
            double[] wanted = v.clone();
            double seconds = 1e-3 * random.nextDouble();
            String before = held.qx() + " " + held.qy() + " " + held.qz() + " " + held.qw();
            free.turn(wanted, seconds);
            held.gyrate(v, seconds);
            assertArrayEquals(wanted, v, 1e-5);
            assertEquals(before, held.qx() + " " + held.qy() + " " + held.qz() + " " + held.qw());
        }
    }

    private static AngularState spin(long seed) {
        Random random = new Random(seed);
        AngularState spin = new AngularState();
        spin.set(random.nextGaussian(), random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
        return spin;
    }
}
