package org.SEAR.robot;

import java.util.AbstractList;
import java.util.List;
import java.util.RandomAccess;
import org.SEAR.geometry.Pose;

/**
 * The wheels of one robot in the body frame after one step. Most steps are never looked at, so a pose is made only when it is asked for. Immutable,
 * any thread.
 */
public final class WheelPoses extends AbstractList<Pose> implements RandomAccess {
    private final List<RaycastWheel> wheels;
    /** How far each wheel hangs, metres, and its angle, radians. */
    private final double[] state;

    public WheelPoses(List<RaycastWheel> wheels) {
        this.wheels = wheels;
        state = new double[2 * wheels.size()];
        for (int i = 0; i < wheels.size(); i++) {
            state[2 * i] = wheels.get(i).getLength();
            state[2 * i + 1] = wheels.get(i).getAngle();
        }
    }

    @Override
    public Pose get(int index) {
        return wheels.get(index).place(state[2 * index], state[2 * index + 1]);
    }

    @Override
    public int size() {
        return state.length / 2;
    }
}
