package org.SEAR.collision;

import javax.vecmath.Vector3f;
import org.SEAR.geometry.Placement;

/** A triangle of a fixed mesh, in the world; it has two sides. */
public final class ContactTriangle implements Convex {
    private static final double NOTHING = 1e-14;
    private final double[] at = new double[9];
    private double nx;
    private double ny;
    private double nz;
    private final double[] point = new double[3];
    private double lowest;
    private double highest;

    /**
     * @param corners in the mesh's frame
     * @param place of that frame
     * @return false if it has no area
     */
    public boolean set(Vector3f[] corners, Placement place) {
        for (int i = 0; i < 3; i++) {
            place.transform(corners[i].x, corners[i].y, corners[i].z, at, 3 * i);
        }
        double ux = at[3] - at[0];
        double uy = at[4] - at[1];
        double uz = at[5] - at[2];
        double wx = at[6] - at[0];
        double wy = at[7] - at[1];
        double wz = at[8] - at[2];
        nx = uy * wz - uz * wy;
        ny = uz * wx - ux * wz;
        nz = ux * wy - uy * wx;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        nx /= length;
        ny /= length;
        nz /= length;
        return length > NOTHING;
    }

    /** Whether a set reaches within {@code reach} metres of the triangle's plane; measures {@link #depth} too. */
    public boolean isNear(Convex other, double reach) {
        double plane = nx * at[0] + ny * at[1] + nz * at[2];
        other.support(-nx, -ny, -nz, point);
        lowest = nx * point[0] + ny * point[1] + nz * point[2] - plane;
        other.support(nx, ny, nz, point);
        highest = nx * point[0] + ny * point[1] + nz * point[2] - plane;
        return lowest <= reach && highest >= -reach;
    }

    /** How far the set reaches through the plane, from the side on which most of it is. */
    public double depth() {
        return Math.min(-lowest, highest);
    }

    /** The side on which most of the set is. */
    public void front(ContactFeature into) {
        double side = highest > -lowest ? 1 : -1;
        feature(side * nx, side * ny, side * nz, into);
    }

    @Override
    public void support(double dx, double dy, double dz, double[] into) {
        int best = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < 9; i += 3) {
            double along = at[i] * dx + at[i + 1] * dy + at[i + 2] * dz;
            if (along > most) {
                most = along;
                best = i;
            }
        }
        into[0] = at[best];
        into[1] = at[best + 1];
        into[2] = at[best + 2];
    }

    /** The side that faces a direction. */
    public void feature(double dx, double dy, double dz, ContactFeature into) {
        into.clear();
        for (int i = 0; i < 9; i += 3) {
            into.add(at[i], at[i + 1], at[i + 2]);
        }
        double side = nx * dx + ny * dy + nz * dz < 0 ? -1 : 1;
        into.setNormal(side * nx, side * ny, side * nz);
    }
}
