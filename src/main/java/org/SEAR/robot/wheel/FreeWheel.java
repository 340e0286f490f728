// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.physics.ConstraintRow;

/** A wheel without a motor, which the ground spins up. Simulation thread. */
final class FreeWheel implements WheelMotor {
    @Override
    public void follow(double speed, double part) {
        // no motor obeys
    }

    @Override
    public boolean holds() {
        return false;
    }

    @Override
    public double holding(double seconds) {
        return 0;
    }

    @Override
    public void solve(ConstraintRow row, double[] v, double rolling, Rim rim, double grip, double seconds) {
        double change = -(rim.mass * (rolling - rim.before()) + row.impulse) / (1 + rim.mass * row.mobility);
        row.add(v, change, -grip, grip);
    }

    @Override
    public void feel(double impulse, double rolled, boolean grounded, double seconds) {
        // nothing to heat
    }

    @Override
    public double slipping(Rim rim, double impulse, double seconds) {
        return rim.before() - impulse / rim.mass;
    }

    @Override
    public double load() {
        return 0;
    }

    @Override
    public double fastest() {
        return Double.POSITIVE_INFINITY;
    }
}
