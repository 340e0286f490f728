package org.SEAR.robot.wheel;

/** Static friction in one direction: what was moved against it comes back, as a tyre that was bent does, until it slips. Simulation thread. */
final class Stick {
    /** Share of what was moved that comes back in a second. */
    private static final double RETURN = 12;
    /** More than this does not come back, metres. */
    private static final double MOST = 1e-3;

    private double moved;

    /** The speed that brings it back, m/s. */
    double back() {
        return -RETURN * moved;
    }

    /** @param way by which it was moved, metres */
    void move(double way) {
        moved = Math.max(-MOST, Math.min(MOST, moved + way));
    }

    /**
     * The wheel rolls on, and stands on another part of its tyre.
     *
     * @param way metres
     * @param length over which a tyre forgets, metres
     */
    void roll(double way, double length) {
        moved /= 1 + Math.abs(way) / length;
    }

    void release() {
        moved = 0;
    }
}
