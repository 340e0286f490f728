package org.SEAR.geometry;

/** An axis-aligned bounding box, metres, changed in place so that a step needs no new ones. Not for several threads. */
public final class Aabb {
    public double minX;
    public double minY;
    public double minZ;
    public double maxX;
    public double maxY;
    public double maxZ;

    /** An empty one. */
    public Aabb() {
        clear();
    }

    /** Becomes empty: it overlaps nothing until something is added. */
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

    /** The interval of an axis, 0 for x to 2 for z. */
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

    /** The lower end along an axis, 0 for x to 2 for z. */
    public double min(int axis) {
        return axis == 0 ? minX : axis == 1 ? minY : minZ;
    }

    /** The upper end along an axis. */
    public double max(int axis) {
        return axis == 0 ? maxX : axis == 1 ? maxY : maxZ;
    }

    /** Reaches as far as a point. */
    public Aabb add(double x, double y, double z) {
        minX = Math.min(minX, x);
        minY = Math.min(minY, y);
        minZ = Math.min(minZ, z);
        maxX = Math.max(maxX, x);
        maxY = Math.max(maxY, y);
        maxZ = Math.max(maxZ, z);
        return this;
    }

    /** Reaches as far as another box. */
    public Aabb add(Aabb other) {
        return add(other.minX, other.minY, other.minZ).add(other.maxX, other.maxY, other.maxZ);
    }

    /** Is wider on every side, metres; less than 0: narrower. */
    public Aabb grow(double margin) {
        minX -= margin;
        minY -= margin;
        minZ -= margin;
        maxX += margin;
        maxY += margin;
        maxZ += margin;
        return this;
    }

    /** Holds what it holds now and all of that moved on by (dx, dy, dz). */
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
        return minX <= other.maxX && other.minX <= maxX && minY <= other.maxY && other.minY <= maxY && minZ <= other.maxZ && other.minZ <= maxZ;
    }

    /** Whether both would have one if this were wider on every side by a margin. */
    public boolean overlaps(Aabb other, double margin) {
        return minX - margin <= other.maxX && other.minX <= maxX + margin && minY - margin <= other.maxY && other.minY <= maxY + margin
            && minZ - margin <= other.maxZ && other.minZ <= maxZ + margin;
    }

    /** Whether another lies in this one. */
    public boolean contains(Aabb other) {
        return other.minX >= minX && other.minY >= minY && other.minZ >= minZ && other.maxX <= maxX && other.maxY <= maxY && other.maxZ <= maxZ;
    }

    /** A corner, 0 to 7: bit 0 chooses the end along x, bit 1 along y, bit 2 along z. */
    public Vec3 corner(int number, Vec3 into) {
        return into.set((number & 1) == 0 ? minX : maxX, (number & 2) == 0 ? minY : maxY, (number & 4) == 0 ? minZ : maxZ);
    }

    @Override
    public String toString() {
        return "(" + minX + ", " + minY + ", " + minZ + ") to (" + maxX + ", " + maxY + ", " + maxZ + ")";
    }
}
