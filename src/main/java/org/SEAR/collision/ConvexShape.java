package org.SEAR.collision;

/** A convex solid in its own frame. Implementations are immutable. */
public interface ConvexShape {
    /**
     * Its support point: the point of it that is farthest in a direction.
     *
     * @param dx direction of any length but 0, likewise dy and dz
     * @param into takes {x, y, z}, metres
     */
    void support(double dx, double dy, double dz, double[] into);

    /**
     * The part of its surface that faces a direction.
     *
     * @param dx unit direction, likewise dy and dz
     * @param into empty before
     */
    void feature(double dx, double dy, double dz, ContactFeature into);

    /** Cubic metres. */
    double volume();

    /** Its centre of mass, filled evenly: {x, y, z}, metres. */
    double[] centre();

    /** Its moments of inertia about the axes through {@link #centre}, for each kg: {x, y, z}, m^2. */
    double[] inertia();

    /** Distance of its farthest point from the origin, metres, or more. */
    double radius();

    /** Half of its least size, metres. */
    double least();

    /** Whether it can roll. */
    default boolean isRound() {
        return true;
    }

    /** Whether it has a round rim. */
    default boolean isRimmed() {
        return false;
    }

    /** Whether it looks the same when turned about its y axis. */
    default boolean isTurned() {
        return false;
    }

    /** Whether a point of its surface is a corner, or may be one: where it touches something it goes along when the shape turns. */
    default boolean isCorner(double x, double y, double z) {
        return !isRound();
    }

    /** Whether it looks the same however it is turned. */
    default boolean isBall() {
        return false;
    }

    /**
     * Adds to a direction's support point of the core: the shape with a skin of {@link #skin} taken off, whose faces have the same normals. Cores of
     * things that touch are apart, so that the direction in which they touch is found exactly where a distance of nothing has none.
     *
     * @param into takes {x, y, z}, metres
     */
    void coreSupport(double dx, double dy, double dz, double[] into);

    /** How thick the skin around the core is at its faces, metres. */
    double skin();
}
