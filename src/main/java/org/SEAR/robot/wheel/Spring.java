// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

/** Spring of one wheel. Immutable. */
public final class Spring {
    /** Load of the wheel, kg. */
    final double carried;
    /** Stiffness, N/m. */
    final double stiffness;
    /** Damping in compression and in release, N s/m. */
    final double compressing;
    final double releasing;
    /** Greatest force, N. */
    final double mostForce;
    /** Distance of the wheel's centre below its mount without load, metres. */
    public final double rest;
    /** The same when the robot stands, metres. */
    public final double hangs;

    /**
     * Spring with damping as a share of the critical one.
     * @param critical damping of its load, N s/m
     */
    Spring(double carried, double stiffness, double critical, double compression, double damping, double mostForce,
        double rest, double hangs) {
        this.carried = carried;
        this.stiffness = stiffness;
        this.compressing = compression * critical;
        this.releasing = damping * critical;
        this.mostForce = mostForce;
        this.rest = rest;
        this.hangs = hangs;
    }
}
