// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.physics.ConstraintRow;

/**
 * Motor of a wheel without a {@link org.SEAR.POJOs.Motor}: a speed servo of limited force. Its gears hold the wheel up
 * to the tyre's grip: it neither rolls back nor coasts. Simulation thread.
 */
final class GearedMotor implements WheelMotor {
    /** Stall time after which the controller reduces the current, seconds, and the remaining share of the force. */
    private static final double STALL_TIME = 0.25;
    private static final double STALL_SHARE = 0.05;
    /** Rate at which the force recovers when the wheel turns again. */
    private static final double RECOVERY = 0.25;
    /** Share of the target speed below which a wheel has stalled. */
    private static final double STALLED = 0.5;
    /** Speed below which a wheel has stalled, m/s; both conditions apply. */
    private static final double STANDING = 0.03;

    private double force;
    private double target;
    private double stalled;
    private boolean geared;
    private double load;

    /** @param newForce greatest force, N */
    void setForce(double newForce) {
        force = newForce;
    }

    /** @param on whether gears hold the wheel if the motor alone is too weak */
    void setGeared(boolean on) {
        geared = on;
    }

    @Override
    public void follow(double speed, double part) {
        if (speed * target <= 0) {
            stalled = 0;
        }
        target = speed;
    }

    @Override
    public boolean holds() {
        return target == 0 && geared;
    }

    @Override
    public double holding(double seconds) {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public void solve(ConstraintRow row, double[] v, double rolling, Rim rim, double grip, double seconds) {
        double motor = force * seconds * strength();
        double soft = 1 + rim.mass * row.mobility;
        double taken = rim.mass * (rolling - rim.before() - row.mobility * row.impulse);
        double back = Math.max(-grip, (-motor - taken) / soft);
        double forth = Math.min(grip, (motor - taken) / soft);
        double least = back;
        double most = forth;
        if (geared) {
            double standing = row.impulse - rolling / row.mobility;
            least = target < 0 ? -Math.min(grip, Math.max(-back, -standing)) : -grip;
            most = target > 0 ? Math.min(grip, Math.max(forth, standing)) : grip;
        }
        row.add(v, (target - rolling) / row.mobility, least, most);
    }

    /** Returns the share of the motor's force that its controller allows now. */
    private double strength() {
        return Math.max(STALL_SHARE, Math.min(1, 2 - stalled / STALL_TIME));
    }

    @Override
    public void feel(double impulse, double rolled, boolean grounded, double seconds) {
        load = 0;
        if (grounded) {
            load = force > 0 ? Math.min(1, Math.abs(impulse) / (force * seconds * strength())) : 0;
            boolean stands = rolled * Math.signum(target) < Math.min(STALLED * Math.abs(target), STANDING);
            stalled = target != 0 && stands ? Math.min(stalled + seconds, 2 * STALL_TIME)
                : Math.max(0, stalled - RECOVERY * seconds);
        }
    }

    @Override
    public double slipping(Rim rim, double impulse, double seconds) {
        double motor = force * seconds * strength();
        double free = rim.before() - impulse / rim.mass;
        double driven = Math.max(free - motor / rim.mass, Math.min(free + motor / rim.mass, target));
        // the ground cannot turn the gears backwards
        return geared && driven * target <= 0 ? 0 : driven;
    }

    @Override
    public double load() {
        return load;
    }

    @Override
    public double fastest() {
        return Double.POSITIVE_INFINITY;
    }
}
