// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.readings;

import static org.junit.Assert.assertEquals;

import java.util.Random;
import org.SEAR.Fuzz;
import org.SEAR.geometry.Pose;
import org.junit.Test;

/** The angles of getPose are those for rotate. */
public class EulerAnglesTest {
    private static void assertSameRotation(String message, Pose a, Pose b) {
        double dot = a.qx * b.qx + a.qy * b.qy + a.qz * b.qz + a.qw * b.qw;
        assertEquals(message, 1, Math.abs(dot), 1e-9);
    }

    @Test
    public void anglesReproduceTheRotation() {
        Random random = new Random(Fuzz.SEED);
        for (int i = 0; i < 1000; i++) {
            Pose pose = Pose.ofDegrees(0, 0, 0, random.nextDouble() * 720 - 360, random.nextDouble() * 720 - 360,
                random.nextDouble() * 720 - 360);
            double[] angles = EulerAngles.degrees(pose);
            assertSameRotation("seed " + Fuzz.SEED + " number " + i, pose,
                Pose.ofDegrees(0, 0, 0, angles[0], angles[1], angles[2]));
        }
    }

    @Test
    public void straightUpAndDownAreHandled() {
        for (double z : new double[] {90, -90}) {
            for (double y : new double[] {0, 30, -120}) {
                Pose pose = Pose.ofDegrees(0, 0, 0, 0, y, z);
                double[] angles = EulerAngles.degrees(pose);
                assertSameRotation("y " + y + " z " + z, pose,
                    Pose.ofDegrees(0, 0, 0, angles[0], angles[1], angles[2]));
            }
        }
    }

    @Test
    public void aHeadingIsAnAngleAboutY() {
        double[] angles = EulerAngles.degrees(Pose.ofDegrees(1, 2, 3, 0, 45, 0));
        assertEquals(0, angles[0], 1e-9);
        assertEquals(45, angles[1], 1e-9);
        assertEquals(0, angles[2], 1e-9);
    }
}
