// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import org.SEAR.geometry.InertiaTensor;

/** Box centred in the origin. Immutable. */
public final class ConvexBox implements ConvexShape {
    private final double hx;
    private final double hy;
    private final double hz;
    private final double skin;

    /** @param hx half extent along x, metres, likewise hy and hz */
    public ConvexBox(double hx, double hy, double hz) {
        this.hx = hx;
        this.hy = hy;
        this.hz = hz;
        skin = ConvexRadius.of(least());
    }

    @Override
    public void support(double dx, double dy, double dz, double[] into) {
        into[0] = Math.copySign(hx, dx);
        into[1] = Math.copySign(hy, dy);
        into[2] = Math.copySign(hz, dz);
    }

    /** Adds a face. */
    @Override
    public void feature(double dx, double dy, double dz, ContactFeature into) {
        double ax = Math.abs(dx);
        double ay = Math.abs(dy);
        double az = Math.abs(dz);
        for (int i = 0; i < 4; i++) {
            double u = i == 0 || i == 3 ? 1 : -1;
            double v = i < 2 ? 1 : -1;
            if (ax >= ay && ax >= az) {
                into.add(Math.copySign(hx, dx), u * hy, v * hz);
            } else if (ay >= az) {
                into.add(u * hx, Math.copySign(hy, dy), v * hz);
            } else {
                into.add(u * hx, v * hy, Math.copySign(hz, dz));
            }
        }
        if (ax >= ay && ax >= az) {
            into.setNormal(Math.signum(dx), 0, 0);
        } else if (ay >= az) {
            into.setNormal(0, Math.signum(dy), 0);
        } else {
            into.setNormal(0, 0, Math.signum(dz));
        }
    }

    @Override
    public double volume() {
        return 8 * hx * hy * hz;
    }

    @Override
    public double[] centre() {
        return new double[3];
    }

    @Override
    public InertiaTensor inertia() {
        return new InertiaTensor((hy * hy + hz * hz) / 3, (hx * hx + hz * hz) / 3, (hx * hx + hy * hy) / 3);
    }

    @Override
    public double radius() {
        return Math.sqrt(hx * hx + hy * hy + hz * hz);
    }

    @Override
    public double least() {
        return Math.min(hx, Math.min(hy, hz));
    }

    @Override
    public boolean isRound() {
        return false;
    }

    @Override
    public void coreSupport(double dx, double dy, double dz, double[] into) {
        into[0] = Math.copySign(hx - skin, dx);
        into[1] = Math.copySign(hy - skin, dy);
        into[2] = Math.copySign(hz - skin, dz);
    }

    @Override
    public double skin() {
        return skin;
    }
}
