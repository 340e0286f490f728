package org.SEAR.physics;

/**
 * One direction in which an impulse acts on a rigid body at a point: a row of the constraint matrix. Velocities are {vx, vy, vz, wx, wy, wz} of the
 * centre of mass, world frame. Simulation thread.
 */
public final class ConstraintRow {
    private double lx;
    private double ly;
    private double lz;
    private double ax;
    private double ay;
    private double az;
    private double ix;
    private double iy;
    private double iz;
    private double inverseMass;
    /** Change of the speed along the row for an impulse of 1 Ns, 1/kg. */
    public double mobility;
    /** Impulse of this step so far, Ns. */
    public double impulse;

    /**
     * Makes it a row of a body.
     *
     * @param dx unit direction, likewise dy and dz
     * @param x where the impulse acts, metres, likewise y and z; all in the world frame
     */
    public void set(double dx, double dy, double dz, double x, double y, double z, SolverBody body) {
        double rx = x - body.place.x;
        double ry = y - body.place.y;
        double rz = z - body.place.z;
        lx = dx;
        ly = dy;
        lz = dz;
        ax = ry * dz - rz * dy;
        ay = rz * dx - rx * dz;
        az = rx * dy - ry * dx;
        ix = body.i00 * ax + body.i01 * ay + body.i02 * az;
        iy = body.i01 * ax + body.i11 * ay + body.i12 * az;
        iz = body.i02 * ax + body.i12 * ay + body.i22 * az;
        inverseMass = body.inverseMass;
        mobility = inverseMass + ax * ix + ay * iy + az * iz;
    }

    /** Speed of the point along the direction, m/s. */
    public double speed(double[] v) {
        return lx * v[0] + ly * v[1] + lz * v[2] + ax * v[3] + ay * v[4] + az * v[5];
    }

    /** Changes the velocities by an impulse. */
    public void push(double[] v, double newtonSeconds) {
        double linear = newtonSeconds * inverseMass;
        v[0] += lx * linear;
        v[1] += ly * linear;
        v[2] += lz * linear;
        v[3] += ix * newtonSeconds;
        v[4] += iy * newtonSeconds;
        v[5] += iz * newtonSeconds;
    }

    /** Adds to the impulse within limits and changes the velocities accordingly. */
    public void add(double[] v, double change, double least, double most) {
        double sum = Math.max(least, Math.min(most, impulse + change));
        push(v, sum - impulse);
        impulse = sum;
    }

    public double dx() {
        return lx;
    }

    public double dy() {
        return ly;
    }

    public double dz() {
        return lz;
    }
}
