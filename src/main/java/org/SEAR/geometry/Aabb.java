package org.SEAR.geometry;

/** A box along the axes that is computed in place: empty until something is put into it. Not for several threads. */
public final class Aabb {
    public final Vec3 low = new Vec3();
    public final Vec3 high = new Vec3();

    public Aabb() {
        clear();
    }

    /** Makes it empty. */
    public Aabb clear() {
        low.set(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
        high.set(Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY);
        return this;
    }

    public boolean isEmpty() {
        return low.x > high.x;
    }

    /** Grows so that it holds a point. */
    public Aabb add(double x, double y, double z) {
        low.set(Math.min(low.x, x), Math.min(low.y, y), Math.min(low.z, z));
        high.set(Math.max(high.x, x), Math.max(high.y, y), Math.max(high.z, z));
        return this;
    }

    /** Grows so that it holds another box. */
    public Aabb add(Aabb other) {
        low.set(Math.min(low.x, other.low.x), Math.min(low.y, other.low.y), Math.min(low.z, other.low.z));
        high.set(Math.max(high.x, other.high.x), Math.max(high.y, other.high.y), Math.max(high.z, other.high.z));
        return this;
    }

    /** Whether it has a point in common with another. */
    public boolean meets(Aabb other) {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y && low.z <= other.high.z
            && other.low.z <= high.z;
    }

    @Override
    public String toString() {
        return low + " to " + high;
    }
}
