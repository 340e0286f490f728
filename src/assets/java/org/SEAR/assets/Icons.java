// SPDX-License-Identifier: Apache-2.0
package org.SEAR.assets;

/** The icons of the services' tabs in MyRobotLab's WebGui. */
final class Icons {
    /** Width and height of MyRobotLab's icons, pixels. */
    static final int SIZE = 16;

    private static final Rgb BODY = Rgb.of(0x2b6cb0);
    private static final Rgb RAY = Rgb.of(0xdd6b20);
    private static final double PIXEL = 1.0 / SIZE;
    private static final double BEAM = Math.PI / 9;

    private Icons() {
    }

    /** SEAR: a round robot from above, with the beam of a sensor in front. */
    static Rgb robot(double u, double v) {
        double fromRobot = Math.hypot(u - 0.5, v - 0.35);
        if (fromRobot < 0.33) {
            return fromRobot < 0.12 ? Rgb.WHITE : BODY;
        }
        double angle = Math.abs(Math.atan2(u - 0.5, v - 0.35));
        return angle < BEAM && v > 0.35 ? RAY : Rgb.WHITE;
    }

    /** LIDAR: a fan of beams. */
    static Rgb scan(double u, double v) {
        double distance = Math.hypot(u - 0.5, v - 0.15);
        if (distance < 0.15) {
            return BODY;
        }
        double angle = Math.atan2(v - 0.15, u - 0.5);
        double toBeam = Math.abs(angle / BEAM - Math.round(angle / BEAM)) * BEAM * distance;
        return distance < 0.8 && v > 0.1 && toBeam < 0.6 * PIXEL ? RAY : Rgb.WHITE;
    }

    /** GPS: a pin on a map. */
    static Rgb pin(double u, double v) {
        double fromHead = Math.hypot(u - 0.5, v - 0.65);
        if (fromHead < 0.3) {
            return fromHead < 0.12 ? Rgb.WHITE : RAY;
        }
        boolean inTip = v < 0.65 && Math.abs(u - 0.5) < 0.28 * (v - 0.05) / 0.6;
        return inTip ? RAY : Rgb.WHITE;
    }
}
