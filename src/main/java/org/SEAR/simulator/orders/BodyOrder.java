// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.orders;

import org.SEAR.POJOs.Gravity;

/**
 * A velocity or force that a script or page gives to an object or robot by {@code Simulation.order}, or a change of the
 * world's gravity. Records store it.
 * Immutable, any thread.
 */
public final class BodyOrder {
    /** Longest duration of a force, seconds. */
    public static final double LONGEST = 3600;
    /** Strongest force along an axis, N. */
    public static final double STRONGEST = 1e7;
    /** Largest change of speed by a command in one step, m/s. */
    public static final double FASTEST = 1000;
    /** Largest angular velocity about an axis, degrees per second. */
    public static final double TURNING = 100_000;

    /** Name of the world in a change of gravity. */
    public static final String WORLD = "world";

    /** Quantity of a command. Records store the ordinal. */
    public enum Kind {
        /** Velocity of the centre of mass, m/s. */
        VELOCITY(FASTEST, "m/s"),
        /** Angular velocity about the world's axes, degrees per second. */
        SPIN(TURNING, "degrees per second"),
        /** A force on the centre of mass, N, for a limited time. */
        PUSH(STRONGEST, "N"),
        /** Gravity of the world, m/s^2: x and z are 0, y is 0 or less. */
        GRAVITY(Gravity.STRONGEST, "m/s^2");

        private final double most;
        private final String unit;

        Kind(double most, String unit) {
            this.most = most;
            this.unit = unit;
        }
    }

    public final Kind kind;
    /** Name of the object or robot; {@link #WORLD} for gravity. */
    public final String name;
    /** Components along or about the world's axes. */
    public final double x;
    public final double y;
    public final double z;
    /** Duration of a force; else 0. */
    public final double seconds;

    /**
     * Returns a change of the world's gravity.
     *
     * @param acceleration m/s^2 downwards
     * @throws IllegalArgumentException that names value and legal range
     */
    public static BodyOrder gravity(double acceleration) {
        return new BodyOrder(Kind.GRAVITY, WORLD, 0, 0 - acceleration, 0, 0);
    }

    /**
     * @param seconds duration of a force, above 0; else 0
     * @throws IllegalArgumentException that names value and legal range
     */
    public BodyOrder(Kind kind, String name, double x, double y, double z, double seconds) {
        this.kind = kind;
        this.name = name;
        this.x = x;
        this.y = y;
        this.z = z;
        this.seconds = seconds;
        if (kind == Kind.GRAVITY && !(x == 0 && z == 0 && y <= 0 && y >= -Gravity.STRONGEST)) {
            throw new IllegalArgumentException("gravity is " + -y + (x == 0 && z == 0 ? "" : ", sideways " + x + " and "
                + z) + ", legal: 0 to " + Gravity.STRONGEST + " m/s^2 downwards");
        }
        for (double value : new double[] {x, y, z}) {
            if (!(Math.abs(value) <= kind.most)) {
                throw new IllegalArgumentException(name + ": " + kind.name().toLowerCase() + " is " + value
                    + " along an axis, legal: " + -kind.most + " to " + kind.most + " " + kind.unit);
            }
        }
        if (kind == Kind.PUSH && !(seconds > 0 && seconds <= LONGEST)) {
            throw new IllegalArgumentException(name + ": push for " + seconds + " s, legal: above 0, at most "
                + LONGEST + " s");
        }
    }
}
