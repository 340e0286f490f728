package org.SEAR.physics;

/**
 * Whether a body rests: for half a second it has stayed where it was, nearly. Its mean speed over that time counts, not the speed at a moment, which
 * trembles more in a pile than a ball moves that has just been let go. Simulation thread.
 */
final class SleepTimer {
    /** Steps for which it has to stay, half a second. */
    private static final int STEPS = 30;
    /**
     * How far a body's middle, and by turning its farthest point, may move meanwhile, metres. A ball on a slope of 0.05 degrees, let go, moves
     * 0.8 mm; the top of a pole that is as far past its balance 1 mm, or more if the pole is longer than a metre.
     */
    private static final double OBJECT = 5e-4;
    /** The same of a robot: slow ones drive at millimetres a second. */
    private static final double ROBOT = 5e-5;
    /** And it may not move as fast as this at the end, m/s, which is no rest but a turning point. */
    private static final double SPEED = 0.02;

    private double x;
    private double y;
    private double z;
    private double qx;
    private double qy;
    private double qz;
    private double qw;
    private int steps;

    /** The time begins anew. */
    void begin(SolverBody body) {
        steps = 0;
        x = body.place.x;
        y = body.place.y;
        z = body.place.z;
        qx = body.spin().qx();
        qy = body.spin().qy();
        qz = body.spin().qz();
        qw = body.spin().qw();
    }

    /** Looks at a body after a step. */
    void look(Body body) {
        double band = body.isRobot() ? ROBOT : OBJECT;
        if (body.isDriven() || hasLeft(body.getSolver(), band, body.getReach())) {
            begin(body.getSolver());
        } else {
            steps++;
        }
    }

    private boolean hasLeft(SolverBody body, double band, double reach) {
        double dx = body.place.x - x;
        double dy = body.place.y - y;
        double dz = body.place.z - z;
        // the vector part of the rotation since then is half its angle
        double rx = qw * body.spin().qx() - qx * body.spin().qw() - qy * body.spin().qz() + qz * body.spin().qy();
        double ry = qw * body.spin().qy() + qx * body.spin().qz() - qy * body.spin().qw() - qz * body.spin().qx();
        double rz = qw * body.spin().qz() - qx * body.spin().qy() + qy * body.spin().qx() - qz * body.spin().qw();
        double turn = band / reach / 2;
        double[] v = body.v;
        return dx * dx + dy * dy + dz * dz > band * band || rx * rx + ry * ry + rz * rz > turn * turn
            || v[0] * v[0] + v[1] * v[1] + v[2] * v[2] > SPEED * SPEED;
    }

    /** Whether it has rested long enough to sleep. */
    boolean isOver() {
        return steps >= STEPS;
    }
}
