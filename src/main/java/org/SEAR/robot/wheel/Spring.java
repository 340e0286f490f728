package org.SEAR.robot.wheel;

/** How one wheel is sprung. Immutable. */
public final class Spring {
    /** What the wheel carries, kg. */
    final double carried;
    /** N/m. */
    final double stiffness;
    /** Damping while it is compressed and released, N s/m. */
    final double compressing;
    final double releasing;
    /** N. */
    final double mostForce;
    /** How far the wheel hangs below where it is fastened when nothing presses it, metres. */
    public final double rest;
    /** The same when the robot stands, metres. */
    public final double hangs;

    /**
     * With damping as shares of the critical one.
     *
     * @param critical damping of what it carries, N s/m
     */
    Spring(double carried, double stiffness, double critical, double compression, double damping, double mostForce, double rest, double hangs) {
        this.carried = carried;
        this.stiffness = stiffness;
        this.compressing = compression * critical;
        this.releasing = damping * critical;
        this.mostForce = mostForce;
        this.rest = rest;
        this.hangs = hangs;
    }
}
