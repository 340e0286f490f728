// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import java.util.AbstractList;
import java.util.List;
import java.util.RandomAccess;
import org.SEAR.geometry.Pose;

/**
 * Poses of one robot's wheels in the body frame after one step. Few steps are ever displayed, so poses are computed on
 * demand. Immutable, any thread; holds numbers only, nothing of the running world.
 */
final class WheelPoses extends AbstractList<Pose> implements RandomAccess {
    /** Mount of each wheel: x, y, z in the body frame, metres. */
    private final double[] mounts;
    /** Suspension length of each wheel, metres, and its rotation, radians. */
    private final double[] state;
    /**
     * Centre of each swivelling wheel, x and z in the body frame, metres, and its heading, radians; null if none
     * swivels.
     */
    private final double[] swivels;

    private WheelPoses(double[] mounts, double[] state, double[] swivels) {
        this.mounts = mounts;
        this.state = state;
        this.swivels = swivels;
    }

    /**
     * Returns the present poses.
     * @param mounts from {@link #mounts}
     * @param swivels whether a wheel does not simply point ahead
     */
    static WheelPoses of(List<RaycastWheel> wheels, double[] mounts, boolean swivels) {
        double[] state = new double[2 * wheels.size()];
        for (int i = 0; i < wheels.size(); i++) {
            state[2 * i] = wheels.get(i).getLength();
            state[2 * i + 1] = wheels.get(i).getAngle();
        }
        return new WheelPoses(mounts, state, swivels ? swivels(wheels) : null);
    }

    private static double[] swivels(List<RaycastWheel> wheels) {
        double[] swivels = new double[3 * wheels.size()];
        for (int i = 0; i < wheels.size(); i++) {
            Swivel swivel = wheels.get(i).getSwivel();
            swivels[3 * i] = swivel == null ? wheels.get(i).x : swivel.x();
            swivels[3 * i + 1] = swivel == null ? wheels.get(i).z : swivel.z();
            swivels[3 * i + 2] = swivel == null ? 0 : swivel.heading();
        }
        return swivels;
    }

    /** Returns the mounts of the wheels, for all steps. */
    static double[] mounts(List<RaycastWheel> wheels) {
        double[] mounts = new double[3 * wheels.size()];
        for (int i = 0; i < wheels.size(); i++) {
            mounts[3 * i] = wheels.get(i).x;
            mounts[3 * i + 1] = wheels.get(i).y;
            mounts[3 * i + 2] = wheels.get(i).z;
        }
        return mounts;
    }

    @Override
    public Pose get(int index) {
        if (swivels != null) {
            return place(swivels[3 * index], mounts[3 * index + 1], swivels[3 * index + 1], state[2 * index],
                state[2 * index + 1],
                swivels[3 * index + 2]);
        }
        return place(mounts[3 * index], mounts[3 * index + 1], mounts[3 * index + 2], state[2 * index],
            state[2 * index + 1]);
    }

    @Override
    public int size() {
        return state.length / 2;
    }

    /** Returns the pose of a wheel mounted at (x, y, z), with a suspension length, metres, and a rotation, radians. */
    static Pose place(double x, double y, double z, double hanging, double turned) {
        double half = Math.IEEEremainder(turned, 2 * Math.PI) / 2;
        return new Pose(x, y - hanging, z, Math.sin(half), 0, 0, Math.cos(half));
    }

    /** The same for a wheel with a heading to the left of ahead, radians. */
    static Pose place(double x, double y, double z, double hanging, double turned, double heading) {
        double half = Math.IEEEremainder(turned, 2 * Math.PI) / 2;
        double sin = Math.sin(heading / 2);
        double cos = Math.cos(heading / 2);
        return new Pose(x, y - hanging, z, cos * Math.sin(half), sin * Math.cos(half), -sin * Math.sin(half),
            cos * Math.cos(half));
    }
}
