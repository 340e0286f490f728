// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.readings;

import org.SEAR.geometry.Pose;

/** Converts rotations to the degrees of {@code rotate(rx, ry, rz)}. */
public final class EulerAngles {
    private static final double POLE = 1 - 1e-12;

    private EulerAngles() {
    }

    /**
     * Returns the inverse of {@link Pose#ofDegrees}: degrees about x in (-180, 180], y in (-180, 180], z in [-90, 90].
     */
    public static double[] degrees(Pose pose) {
        double[] right = pose.rotate(1, 0, 0);
        double[] up = pose.rotate(0, 1, 0);
        double[] forward = pose.rotate(0, 0, 1);
        double sinZ = Math.max(-1, Math.min(1, right[1]));
        double z = Math.asin(sinZ);
        double x;
        double y;
        if (Math.abs(sinZ) < POLE) {
            y = Math.atan2(-right[2], right[0]);
            x = Math.atan2(-forward[1], up[1]);
        } else {
            y = Math.atan2(forward[0], forward[2]);
            x = 0;
        }
        return new double[] {Math.toDegrees(x), Math.toDegrees(y), Math.toDegrees(z)};
    }
}
