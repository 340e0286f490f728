package org.SEAR.physics.solid;

import org.SEAR.POJOs.Shape;

/** What a solid's surface does where it touches another. Immutable. */
public final class Surface {
    /** Coefficient of friction of objects; the product of both counts (0.64: cardboard on wood). */
    private static final double FRICTION = 0.8;
    /** The same of a robot's parts: smooth plastic (0.24 on objects), so that a robot does not ride up a wall that it pushes against. */
    private static final double ROBOT_FRICTION = 0.3;
    /** Coefficient of rolling friction of objects; the sum of both counts (0.002: hard on hard). */
    private static final double ROLLING_FRICTION = 0.001;

    private final Double friction;
    private final double restitution;
    private final double rollingFriction;

    private Surface(Double friction, Double restitution, Double rollingFriction) {
        this.friction = friction;
        this.restitution = restitution == null ? 0 : restitution;
        this.rollingFriction = rollingFriction == null ? ROLLING_FRICTION : rollingFriction;
    }

    /** That of an object, with the defaults for what it does not say. */
    static Surface of(Shape shape) {
        return new Surface(shape.getFriction(), shape.getRestitution(), shape.getRollingFriction());
    }

    /** That of a part that nobody described. */
    static Surface usual() {
        return new Surface(null, null, null);
    }

    /**
     * Coefficient of friction.
     *
     * @param ofRobot whether it belongs to a robot
     */
    public double friction(boolean ofRobot) {
        return friction != null ? friction : ofRobot ? ROBOT_FRICTION : FRICTION;
    }

    /** Share of the speed at which another comes that it goes with afterwards; the greater of both counts. */
    public double restitution() {
        return restitution;
    }

    /** Resistance to rolling as a share of the weight. */
    public double rollingFriction() {
        return rollingFriction;
    }
}
