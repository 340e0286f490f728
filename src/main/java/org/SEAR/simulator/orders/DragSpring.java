package org.SEAR.simulator.orders;

import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.Body;

/**
 * Somebody's hand that pulls a thing or a robot by a damped spring, at its centre of mass: in each step a push, which a record has as any other. It
 * lets go when nobody has moved it for a while by the computer's clock, so that a page that goes away holds nothing. {@code Simulation.hold} has it
 * begin. {@link #moveTo}, {@link #letGo} and {@link #isHolding} from any thread, all else simulation thread.
 */
public final class DragSpring {
    /** Strongest pull, N for each kilogram: five times its weight. */
    public static final double STRONGEST = 50;
    /** By the computer's clock. */
    private static final long TIMEOUT_NANOS = TimeUnit.MILLISECONDS.toNanos(1500);
    /** How fast the spring would swing, radians a second; critically damped it does not. */
    private static final double FREQUENCY = 10;

    private final String name;
    private final LongSupplier clock;
    /** Metres from where the thing was taken, in the world; null when it is let go. */
    private volatile double[] way;
    private volatile long moved;
    /** Its centre of mass when it was taken; null before the first step. */
    private double[] taken;
    private final double[] v = new double[6];

    /**
     * @param name of a thing with a mass, or of a robot
     * @param clock nanoseconds, as {@link System#nanoTime}
     */
    public DragSpring(String name, LongSupplier clock) {
        this.name = name;
        this.clock = clock;
        moveTo(0, 0, 0);
    }

    /**
     * Where it pulls to, in metres from where the thing was when it was taken.
     *
     * @param x north
     * @param y up
     * @param z east
     */
    public void moveTo(double x, double y, double z) {
        way = new double[] {x, y, z};
        moved = clock.getAsLong();
    }

    public void letGo() {
        way = null;
    }

    /** Whether it still holds, or will from the next step on. */
    public boolean isHolding() {
        return way != null && clock.getAsLong() - moved < TIMEOUT_NANOS;
    }

    String getName() {
        return name;
    }

    /** What the body of that name gets in the next step; null when it is let go. */
    BodyOrder pull(Body body) {
        double[] to = way;
        if (to == null || !isHolding()) {
            return null;
        }
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
        double most = Math.min(STRONGEST * body.mass, BodyOrder.STRONGEST);
        double scale = Math.min(body.mass, most / Math.max(Math.sqrt(size), Double.MIN_NORMAL));
        return new BodyOrder(BodyOrder.Kind.PUSH, name, force[0] * scale, force[1] * scale, force[2] * scale, TimeStep.SECONDS);
    }

    /** In the world. */
    private static double[] centre(Body body) {
        Pose pose = body.getPose();
        double[] inside = body.getCentre();
        double[] turned = pose.rotate(inside[0], inside[1], inside[2]);
        return new double[] {pose.x + turned[0], pose.y + turned[1], pose.z + turned[2]};
    }
}
