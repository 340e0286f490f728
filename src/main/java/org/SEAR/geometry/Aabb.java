// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/** Axis-aligned bounding box, metres, mutable so that a step allocates none. Not thread-safe. */
public final class Aabb {
    public double minX;
    public double minY;
    public double minZ;
    public double maxX;
    public double maxY;
    public double maxZ;

    /** Makes an empty box. */
    public Aabb() {
        clear();
    }

    /** Empties the box: it overlaps nothing until something is added. */
    public Aabb clear() {
        minX = Double.POSITIVE_INFINITY;
        minY = Double.POSITIVE_INFINITY;
        minZ = Double.POSITIVE_INFINITY;
        maxX = Double.NEGATIVE_INFINITY;
        maxY = Double.NEGATIVE_INFINITY;
        maxZ = Double.NEGATIVE_INFINITY;
        return this;
    }

    public Aabb set(Aabb other) {
        minX = other.minX;
        minY = other.minY;
        minZ = other.minZ;
        maxX = other.maxX;
        maxY = other.maxY;
        maxZ = other.maxZ;
        return this;
    }

    /** Sets the interval of an axis, 0 for x to 2 for z. */
    public Aabb set(int axis, double min, double max) {
        switch (axis) {
            case 0:
                minX = min;
                maxX = max;
                break;
            case 1:
                minY = min;
                maxY = max;
                break;
            default:
                minZ = min;
                maxZ = max;
        }
        return this;
    }

    /** Lower end along an axis, 0 for x to 2 for z. */
    public double min(int axis) {
        return axis == 0 ? minX : axis == 1 ? minY : minZ;
    }

    /** Upper end along an axis. */
    public double max(int axis) {
        return axis == 0 ? maxX : axis == 1 ? maxY : maxZ;
    }

    /** Extends the box to a point. */
    public Aabb add(double x, double y, double z) {
        minX = Math.min(minX, x);
        minY = Math.min(minY, y);
        minZ = Math.min(minZ, z);
        maxX = Math.max(maxX, x);
        maxY = Math.max(maxY, y);
        maxZ = Math.max(maxZ, z);
        return this;
    }

    /** Extends the box to another box. */
    public Aabb add(Aabb other) {
        return add(other.minX, other.minY, other.minZ).add(other.maxX, other.maxY, other.maxZ);
    }

    /** Widens every side by a margin, metres; negative: narrows. */
    public Aabb grow(double margin) {
        minX -= margin;
        minY -= margin;
        minZ -= margin;
        maxX += margin;
        maxY += margin;
        maxZ += margin;
        return this;
    }

    /** Extends the box by a translation of itself by (dx, dy, dz). */
    public Aabb sweep(double dx, double dy, double dz) {
        minX += Math.min(0, dx);
        minY += Math.min(0, dy);
        minZ += Math.min(0, dz);
        maxX += Math.max(0, dx);
        maxY += Math.max(0, dy);
        maxZ += Math.max(0, dz);
        return this;
    }

    /** Whether both have a point in common. */
    public boolean overlaps(Aabb other) {
        return minX <= other.maxX && other.minX <= maxX && minY <= other.maxY && other.minY <= maxY
            && minZ <= other.maxZ && other.minZ <= maxZ;
    }

    /** Whether both overlap if this one is widened by a margin. */
    public boolean overlaps(Aabb other, double margin) {
        return minX - margin <= other.maxX && other.minX <= maxX + margin && minY - margin <= other.maxY
            && other.minY <= maxY + margin && minZ - margin <= other.maxZ && other.minZ <= maxZ + margin;
    }

    /** Whether another box is inside this one. */
    public boolean contains(Aabb other) {
        return other.minX >= minX && other.minY >= minY && other.minZ >= minZ && other.maxX <= maxX
            && other.maxY <= maxY && other.maxZ <= maxZ;
    }

    /** Computes a corner, 0 to 7: bit 0 chooses the end along x, bit 1 along y, bit 2 along z. */
    public Vec3 corner(int number, Vec3 into) {
        return into.set((number & 1) == 0 ? minX : maxX, (number & 2) == 0 ? minY : maxY, (number & 4) == 0
            ? minZ : maxZ);
    }

    @Override
    public String toString() {
        return "(" + minX + ", " + minY + ", " + minZ + ") to (" + maxX + ", " + maxY + ", " + maxZ + ")";
    }
}
