package org.SEAR.simulator.orders;

/**
 * What is done to a thing or a robot from outside of its world, by {@code Simulation.order}: it gets a velocity, or somebody pushes it. A
 * record knows it again. Immutable, any thread.
 */
public final class BodyOrder {
    /** Longest push, seconds. */
    public static final double LONGEST = 3600;
    /** Strongest push along an axis, N. */
    public static final double STRONGEST = 1e7;
    /** No order may change a speed by more in a step, m/s. */
    public static final double FASTEST = 1000;
    /** Fastest turning, degrees a second about an axis. */
    public static final double TURNING = 100_000;

    /** What is done. A record has their places in this list. */
    public enum Kind {
        /** Velocity of the centre of mass, m/s. */
        VELOCITY(FASTEST, "m/s"),
        /** Turning, degrees a second about the axes. */
        SPIN(TURNING, "degrees a second"),
        /** A force on the centre of mass, N, for some time. */
        PUSH(STRONGEST, "N");

        private final double most;
        private final String unit;

        Kind(double most, String unit) {
            this.most = most;
            this.unit = unit;
        }
    }

    public final Kind kind;
    /** Of the thing or robot. */
    public final String name;
    /** Along or about the world's axes. */
    public final double x;
    public final double y;
    public final double z;
    /** Of a push; else 0. */
    public final double seconds;

    /**
     * @param seconds of a push, above 0; else 0
     * @throws IllegalArgumentException that names value and legal range
     */
    public BodyOrder(Kind kind, String name, double x, double y, double z, double seconds) {
        this.kind = kind;
        this.name = name;
        this.x = x;
        this.y = y;
        this.z = z;
        this.seconds = seconds;
        for (double value : new double[] {x, y, z}) {
            if (!(Math.abs(value) <= kind.most)) {
                throw new IllegalArgumentException(name + ": " + kind.name().toLowerCase() + " is " + value + " along an axis, legal: " + -kind.most
                    + " to " + kind.most + " " + kind.unit);
            }
        }
        if (kind == Kind.PUSH && !(seconds > 0 && seconds <= LONGEST)) {
            throw new IllegalArgumentException(name + ": push for " + seconds + " s, legal: above 0, at most " + LONGEST + " s");
        }
    }
}
