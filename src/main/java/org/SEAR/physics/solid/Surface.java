// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import org.SEAR.POJOs.Shape;

/** Contact properties of a solid's surface. Immutable. */
public final class Surface {
    /** Coefficient of friction of objects; a contact has the product of both (0.64: cardboard on wood). */
    private static final double FRICTION = 0.8;
    /**
     * Coefficient of friction of robot parts: smooth plastic (0.24 on objects), so that a robot does not ride up a
     * wall.
     */
    private static final double ROBOT_FRICTION = 0.3;
    /** Coefficient of rolling friction of objects; a contact has the sum of both (0.002: hard on hard). */
    private static final double ROLLING_FRICTION = 0.001;

    private final Double friction;
    private final double restitution;
    private final double rollingFriction;

    private Surface(Double friction, Double restitution, Double rollingFriction) {
        this.friction = friction;
        this.restitution = restitution == null ? 0 : restitution;
        this.rollingFriction = rollingFriction == null ? ROLLING_FRICTION : rollingFriction;
    }

    /** Returns the surface of an object, with defaults for missing values. */
    static Surface of(Shape shape) {
        return new Surface(shape.getFriction(), shape.getRestitution(), shape.getRollingFriction());
    }

    /** Returns the default surface. */
    static Surface usual() {
        return new Surface(null, null, null);
    }

    /**
     * Returns the coefficient of friction.
     * @param ofRobot whether it belongs to a robot
     */
    public double friction(boolean ofRobot) {
        return friction != null ? friction : ofRobot ? ROBOT_FRICTION : FRICTION;
    }

    /** Coefficient of restitution: separating speed over approach speed. A contact has the greater of both. */
    public double restitution() {
        return restitution;
    }

    /** Coefficient of rolling friction: resistance as a share of the weight. */
    public double rollingFriction() {
        return rollingFriction;
    }
}
