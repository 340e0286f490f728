// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.orders;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.Body;
import org.SEAR.physics.RobotBodies;

/**
 * A damped spring that pulls an object or robot at its centre of mass, for dragging with the mouse. Each step it
 * applies one force, recorded as any other. It releases the object after a timeout without {@link #moveTo}, so a closed
 * page holds nothing. The timeout is real time, but simulated time in lock-step, where the computer's speed changes
 * nothing. {@code Simulation.hold} attaches it. {@link #moveTo}, {@link #letGo} and {@link #isHolding}: any
 * thread; the rest: simulation thread.
 */
public final class DragSpring {
    /** Strongest force, N per kg of the body: five times its weight. */
    public static final double STRONGEST = 50;
    /** Timeout without {@link #moveTo}, s. */
    private static final double TIMEOUT = 1.5;
    private static final long TIMEOUT_NANOS = (long) (TIMEOUT * TimeUnit.SECONDS.toNanos(1));
    private static final long TIMEOUT_STEPS = Math.round(TIMEOUT / TimeStep.SECONDS);
    /** Natural frequency of the spring, rad/s; its damping is critical. */
    private static final double FREQUENCY = 10;

    private final String name;
    private final BooleanSupplier lockStep;
    private final LongSupplier clock;
    /** Displacement of the target from the grab point, world frame, metres; null after the release. */
    private volatile double[] way;
    private volatile long moved;
    /** Steps since the last {@link #moveTo}. */
    private final AtomicLong steps = new AtomicLong();
    /** Centre of mass at the grab, world frame; null before the first step. */
    private double[] taken;
    private final double[] v = new double[6];

    /**
     * @param name of an object with a mass, or of a robot
     * @param lockStep whether only scripts advance simulated time
     * @param clock nanoseconds, as {@link System#nanoTime}
     */
    public DragSpring(String name, BooleanSupplier lockStep, LongSupplier clock) {
        this.name = name;
        this.lockStep = lockStep;
        this.clock = clock;
        moveTo(0, 0, 0);
    }

    /**
     * Sets the target, as a displacement in metres from the object's position at the grab, world frame.
     *
     * @param x north
     * @param y up
     * @param z east
     */
    public void moveTo(double x, double y, double z) {
        way = new double[] {x, y, z};
        moved = clock.getAsLong();
        steps.set(0);
    }

    public void letGo() {
        way = null;
    }

    /** Whether it holds the object or will from the next step on. */
    public boolean isHolding() {
        return way != null && (lockStep.getAsBoolean() ? steps.get() < TIMEOUT_STEPS : clock.getAsLong()
            - moved < TIMEOUT_NANOS);
    }

    String getName() {
        return name;
    }

    /** Force on the body in the next step; null after the release. */
    BodyOrder pull(Body body) {
        double[] to = way;
        if (to == null || !isHolding()) {
            return null;
        }
        steps.incrementAndGet();
        double[] centre = centre(body);
        if (taken == null) {
            taken = centre;
        }
        body.velocities(v);
        double[] force = new double[3];
        double size = 0;
        for (int i = 0; i < force.length; i++) {
            force[i] = FREQUENCY * FREQUENCY * (taken[i] + to[i] - centre[i]) - 2 * FREQUENCY * v[i];
            size += force[i] * force[i];
        }
        double most = Math.min(STRONGEST * RobotBodies.whole(body).mass, BodyOrder.STRONGEST);
        double scale = Math.min(RobotBodies.whole(body).mass, most / Math.max(Math.sqrt(size), Double.MIN_NORMAL));
        return new BodyOrder(BodyOrder.Kind.PUSH, name, force[0] * scale, force[1] * scale, force[2] * scale,
            TimeStep.SECONDS);
    }

    /** Returns the centre of mass in the world frame. */
    private static double[] centre(Body body) {
        Pose pose = body.getPose();
        double[] inside = body.getCentre();
        double[] turned = pose.rotate(inside[0], inside[1], inside[2]);
        return new double[] {pose.x + turned[0], pose.y + turned[1], pose.z + turned[2]};
    }
}
