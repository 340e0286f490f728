// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

/**
 * The free direction of a joint: an angle in radians or a distance in metres, with limits, friction, spring, damper and
 * drive. A drive has the characteristic of a DC motor: force = stall force (power - speed / no-load speed). "Force" is
 * a force in N along a distance and a torque in N m about an axis. Simulation thread.
 */
public final class JointAxis {
    /** Speed of approach below which a limit does not bounce, m/s or rad/s. */
    private static final double MIN_BOUNCE = 0.05;
    /**
     * Largest angle squared by which a spring may swing in a substep, and share of its speed that a damper may take,
     * for the mean of the forces before and after the substep. Beyond, the forces are those after it, which damps more.
     */
    private static final double SLOW_SPRING = 0.3;
    private static final double SLOW_DAMPER = 1;
    /** Share of the stall force with which a servo plans to brake: the rest is a reserve. */
    private static final double BRAKING = 0.9;
    /** The least such share, against a load that nearly exceeds the motor. */
    private static final double LEAST_BRAKING = 0.02;
    /** Share of the stall force from which a servo counts as overloaded. */
    private static final double OVERLOADED = 0.98;

    /** Quantity that a drive controls. */
    public enum Drive {
        /** Nothing: the joint moves freely. */
        NONE,
        /** The position, as a servo. */
        POSITION,
        /** The position, with the whole force of the motor up to the position itself, braking in time. */
        SERVO,
        /** The speed. */
        SPEED,
        /** The power of the motor, -1 to 1. */
        POWER
    }

    private double lower = Double.NEGATIVE_INFINITY;
    private double upper = Double.POSITIVE_INFINITY;
    private double restitution;
    private double friction;
    private double damping;
    private double stiffness;
    private double rest;
    private Drive drive = Drive.NONE;
    private double stall;
    private double fastest = Double.POSITIVE_INFINITY;
    /** Position error at which a position drive has full power. */
    private double range = 1;
    private double target;
    /** Whether a servo's load cannot move it, as with a worm gear. */
    private boolean locking;

    private double position;
    private double speed;
    /** Impulse of the drive in this step. */
    private double driven;
    private double effort;
    private boolean stale;
    /** Direction of a locking servo: 1 upwards, -1 downwards. */
    private double lockSide;
    /** Inertia that a servo's motor moves, kg or kg m^2; infinite before the first substep. */
    private double inertia = Double.POSITIVE_INFINITY;
    /** Force of the load along the axis in the last substep, and its sum over the step. */
    private double load;
    private double loads;
    private double meanLoad;
    /** Speed of the last substep, and its length. */
    private double before;
    private double substep;
    /** Force of spring and damper per speed in the last substep, N s/m or N m s/rad. */
    private double softness;
    /** Side of the nearer limit: 1 for the lower, -1 for the upper. */
    private int side = 1;

    /** @param newRestitution of the limits, 0 to 1 */
    public void setLimits(double newLower, double newUpper, double newRestitution) {
        stale |= (newLower > Double.NEGATIVE_INFINITY || newUpper < Double.POSITIVE_INFINITY) != isLimited();
        lower = newLower;
        upper = newUpper;
        restitution = newRestitution;
    }

    /**
     * @param newFriction Coulomb friction, N or N m
     * @param newDamping force per speed, N s/m or N m s/rad
     */
    public void setLosses(double newFriction, double newDamping) {
        stale |= newFriction > 0 != friction > 0 || (stiffness > 0 || newDamping > 0) != isSoft();
        friction = newFriction;
        damping = newDamping;
    }

    /**
     * @param rate of the spring, N/m or N m/rad; 0 for none
     * @param at position without force
     */
    public void setSpring(double rate, double at) {
        stale |= (rate > 0 || damping > 0) != isSoft();
        stiffness = rate;
        rest = at;
    }

    /**
     * Sets the motor.
     * @param stallForce N or N m
     * @param noLoadSpeed m/s or rad/s; infinite for a force that does not depend on the speed
     * @param fullPower position error at which a position drive has full power, metres or radians
     */
    public void setMotor(double stallForce, double noLoadSpeed, double fullPower) {
        stall = stallForce;
        fastest = noLoadSpeed;
        range = fullPower;
    }

    /**
     * Sets what the drive controls.
     * @param newTarget position, speed or power
     */
    public void drive(Drive newDrive, double newTarget) {
        stale |= (newDrive == Drive.NONE) != (drive == Drive.NONE)
            || (newDrive == Drive.SERVO) != (drive == Drive.SERVO);
        drive = newDrive;
        target = newTarget;
    }

    /** @param on whether only the motor moves a servo, not its load */
    public void setLocking(boolean on) {
        stale |= on != locking;
        locking = on;
    }

    private boolean isLimited() {
        return lower > Double.NEGATIVE_INFINITY || upper < Double.POSITIVE_INFINITY;
    }

    private boolean isSoft() {
        return stiffness > 0 || damping > 0 || losses() > 0;
    }

    /** Force that a servo's motor loses per speed. */
    private double losses() {
        return drive == Drive.SERVO ? stall / fastest : 0;
    }

    private boolean isLocking() {
        return locking && drive == Drive.SERVO;
    }

    /** Number of its rows. The first one only measures the speed. */
    int rows() {
        return 1 + (isLimited() ? 1 : 0) + (friction > 0 ? 1 : 0) + (isSoft() ? 1 : 0) + (drive == Drive.NONE ? 0 : 1)
            + (isLocking() ? 1 : 0);
    }

    boolean isStale() {
        return stale;
    }

    void fresh() {
        stale = false;
    }

    void restart(double at) {
        position = at;
        speed = 0;
        driven = 0;
        effort = 0;
        inertia = Double.POSITIVE_INFINITY;
        load = 0;
        meanLoad = 0;
        beginStep();
    }

    void beginStep() {
        driven = 0;
        loads = 0;
    }

    /** Sets the position from which an angle counts turns. After the joint is attached. */
    public void begin(double at) {
        position = at;
    }

    /** Position, m or rad; an angle counts full turns. */
    public double getPosition() {
        return position;
    }

    /** Speed, m/s or rad/s. */
    public double getSpeed() {
        return speed;
    }

    /** Mean force of the drive in the last step, N or N m. */
    public double getEffort() {
        return effort;
    }

    /** Mean force of the load on a servo along the axis in the last step, N or N m. */
    public double getLoad() {
        return meanLoad;
    }

    /** Whether a servo's motor is too weak for the load against which it turns or holds. */
    public boolean isOverloaded() {
        return meanLoad * Math.signum(position - target) >= OVERLOADED * stall;
    }

    void setPosition(double at) {
        position = at;
    }

    /** Takes an angle between -pi and pi; the position changes by less than half a turn. */
    void setAngle(double angle) {
        position = angle + 2 * Math.PI * Math.rint((position - angle) / (2 * Math.PI));
    }

    /** Sets up a row along the axis or about it. */
    interface Direction {
        void set(int row, double scale);
    }

    /** Sets up the rows from number {@code at} on. */
    void fill(JointRows rows, int at, Direction direction, double seconds) {
        rows.beginMeasuring(at);
        direction.set(at, 1);
        int row = at + 1;
        if (isLimited()) {
            fillLimit(rows, row++, direction, seconds);
        }
        if (friction > 0) {
            JointRows.State before = rows.states[row];
            rows.begin(row);
            direction.set(row, 1);
            rows.bound(row, before, -friction * seconds, friction * seconds);
            row++;
        }
        if (isSoft()) {
            rows.begin(row);
            direction.set(row, 1);
            rows.kept[row] = false;
            double mobility = rows.mobility(row);
            double all = damping + losses();
            double ahead = stiffness * seconds * seconds * mobility < SLOW_SPRING ? 0 : stiffness * seconds;
            double mean = ahead == 0 && all * seconds * mobility < SLOW_DAMPER ? all / 2 : 0;
            softness = all - mean + ahead;
            soften(rows, row, softness, stiffness * (position - rest) + mean * speed, seconds);
            row++;
        }
        substep = seconds;
        if (drive != Drive.NONE) {
            JointRows.State before = rows.states[row];
            rows.begin(row);
            direction.set(row, 1);
            rows.kept[row] = false;
            fillDrive(rows, row, before, seconds);
            row++;
        }
        if (isLocking()) {
            JointRows.State last = rows.states[row];
            rows.begin(row);
            lockSide = Math.signum(target - position);
            direction.set(row, lockSide);
            rows.bound(row, last, 0, Double.POSITIVE_INFINITY);
        }
    }

    private void fillLimit(JointRows rows, int row, Direction direction, double seconds) {
        JointRows.State before = rows.states[row];
        int last = side;
        double ofLower = position - lower;
        double ofUpper = upper - position;
        side = ofLower <= ofUpper ? 1 : -1;
        rows.begin(row);
        direction.set(row, side);
        if (lower == upper) {
            rows.error[row] = side * (position - lower);
            return;
        }
        double gap = Math.min(ofLower, ofUpper);
        double approach = rows.speed(row);
        rows.bound(row, side == last && before == JointRows.State.FREE ? before : JointRows.State.LOW, 0,
            Double.POSITIVE_INFINITY);
        rows.kept[row] = true;
        rows.error[row] = Math.min(0, gap);
        boolean bounces = restitution > 0 && approach < -MIN_BOUNCE && gap + approach * seconds <= 0;
        rows.target[row] = bounces ? -restitution * approach : -Math.max(0, gap) / seconds;
    }

    /** Measures the error of the limit after the bodies have moved. */
    void measure(JointRows rows, int at) {
        if (isLimited()) {
            double gap = side > 0 ? position - lower : upper - position;
            rows.error[at + 1] = lower == upper ? gap : Math.min(0, gap);
        }
    }

    /** Sets up a row with the force {@code -force - damper speed}, where the speed is that after the substep. */
    private static void soften(JointRows rows, int row, double damper, double force, double seconds) {
        if (damper > 0) {
            rows.softness[row] = 1 / (seconds * damper);
            rows.target[row] = -force / damper;
        } else {
            rows.states[row] = JointRows.State.OFF;
            rows.push(row, -seconds * force);
        }
    }

    private void fillDrive(JointRows rows, int row, JointRows.State before, double seconds) {
        double losses = stall / fastest;
        if (drive == Drive.SERVO) {
            double ahead = Math.signum(target - position);
            boolean locks = isLocking();
            rows.bound(row, before, locks && ahead >= 0 ? Double.NEGATIVE_INFINITY : -stall * seconds,
                locks && ahead <= 0 ? Double.POSITIVE_INFINITY : stall * seconds);
            rows.target[row] = ahead
                * Math.min(fastest, approach(Math.abs(target - position) / seconds, braking(ahead) * seconds));
        } else if (drive == Drive.SPEED) {
            double now = rows.speed(row);
            rows.bound(row, before, -Math.max(0, stall + losses * now) * seconds,
                Math.max(0, stall - losses * now) * seconds);
            rows.target[row] = target;
        } else if (drive == Drive.POWER) {
            soften(rows, row, losses, -stall * target, seconds);
        } else if (Math.abs(position - target) >= range) {
            soften(rows, row, losses, stall * Math.signum(position - target), seconds);
        } else {
            soften(rows, row, losses + stall / range * seconds, stall / range * (position - target), seconds);
        }
    }

    /** Returns the deceleration with which a servo can brake, m/s^2 or rad/s^2. */
    private double braking(double ahead) {
        double force = isLocking() ? stall : BRAKING * stall - Math.max(0, ahead * load);
        return Math.max(LEAST_BRAKING * stall, force) / inertia;
    }

    /**
     * Returns the greatest speed from which it can still stop, in the fewest substeps with the same loss each.
     * @param within speed that reaches the target in one substep
     * @param loss of speed per substep
     */
    private static double approach(double within, double loss) {
        if (loss <= 0) {
            return 0;
        }
        double steps = Math.max(1, Math.ceil((Math.sqrt(1 + 8 * within / loss) - 1) / 2));
        return within / steps + loss * (steps - 1) / 2;
    }

    /** Number of the motor's row among its rows if it is a servo; else -1. */
    int servoRow() {
        return drive == Drive.SERVO ? rows() - (isLocking() ? 2 : 1) : -1;
    }

    /** @param impulse that changes the speed of a servo by 1 */
    void setInertia(double impulse) {
        inertia = Math.max(0, impulse - substep * softness);
    }

    /** Notes speed and impulses of a substep; returns the whole impulse along the axis. */
    double note(JointRows rows, int at) {
        before = speed;
        speed = rows.speed(at);
        double sum = 0;
        double locked = isLocking() ? lockSide * rows.impulse[at + rows() - 1] : 0;
        for (int row = at + 1; row < at + rows() - (isLocking() ? 1 : 0); row++) {
            sum += (isLimited() && row == at + 1 ? side : 1) * rows.impulse[row];
        }
        sum += locked;
        if (drive == Drive.SERVO) {
            double lost = isSoft() ? rows.impulse[at + servoRow() - 1] : 0;
            double force = (rows.impulse[at + servoRow()] + lost) / substep;
            driven += force * substep;
            load = Double.isInfinite(inertia) ? 0 : inertia * (speed - before) / substep - force - locked / substep;
            loads += load * substep;
        } else if (drive != Drive.NONE) {
            driven += rows.impulse[at + rows() - 1];
        }
        return sum;
    }

    /** Ends a step. */
    void endStep(double seconds) {
        effort = driven / seconds;
        meanLoad = loads / seconds;
    }
}
