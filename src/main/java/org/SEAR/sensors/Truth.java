// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Arrays;
import org.SEAR.POJOs.Shape;
import org.SEAR.camera.Appearances;
import org.SEAR.camera.PlainAppearance;
import org.SEAR.geometry.Pose;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.raycast.BeamScene;

/**
 * Ground truth for sensors: the exact state of their robot after one step. The simulator fills it; sensors only read
 * it. Simulation thread.
 */
public interface Truth {
    /** Returns steps since start or reset; 0 before the first. */
    long step();

    /** Returns simulated seconds since start or reset. */
    double time();

    /** Returns the length of a step, seconds. */
    double stepLength();

    /** Returns the UTC of simulated time 0, milliseconds since 1970. */
    long epochMillis();

    /** Returns the pose of the robot's body in the world. */
    Pose body();

    /** Returns the velocity of the body's origin in the world, m/s: {x, y, z}. Callers must not keep or change it. */
    double[] velocity();

    /** Returns the angular velocity in the world frame, rad/s: {x, y, z}. Callers must not keep or change it. */
    double[] angularVelocity();

    /**
     * Returns the signed distance that the body's origin has travelled along the body's forward axis since start or
     * reset, metres. Vibration at rest does not count.
     */
    double path();

    /**
     * Returns the distance since start or reset that a program computes from the encoders of the driven wheels and
     * their nominal radii, metres; {@link #path} of a robot without driven wheels.
     */
    default double odometry() {
        return path();
    }

    /** Returns the gravitational acceleration, m/s^2 along the world's -y; 9.81 on the Earth. */
    double gravity();

    /**
     * Returns the world's origin on Earth and the magnetic field there: {@code Earth.of(project, robot)}, created once.
     */
    Earth earth();

    /** Returns the geometry for beams at this step. */
    BeamScene scene();

    /** Returns the owner number of this robot's parts in the scene. */
    int owner();

    /**
     * Returns whether a part of this robot touches anything other than the robot itself.
     *
     * @param part name of a component that is a shape; null for any part except wheels
     */
    default boolean isTouched(String part) {
        return false;
    }

    /**
     * Returns the sum of the normal forces of the contacts on a part of this robot, the mean of the last step, N.
     *
     * @param part name of a component that is a shape; null for all parts except wheels
     */
    default double contactForce(String part) {
        return 0;
    }

    /** Returns whether a shape of the scene is ground: a floor or the terrain. */
    default boolean isGround(int shape) {
        return false;
    }

    /**
     * Returns the colour of a shape at a point of its surface.
     *
     * @param x in the world, metres, likewise y and z
     * @return 0xRRGGBB (sRGB)
     */
    default int color(int shape, double x, double y, double z) {
        return 0x999999;
    }

    /**
     * Returns the geometry for cameras: that of beams and everything hidden from beams, with the same shape numbers.
     */
    default BeamScene sight() {
        return scene();
    }

    /** Returns the appearance of shapes for cameras. */
    default Appearances looks() {
        return shape -> new PlainAppearance(color(shape, 0, 0, 0), Shape.AMBIENT);
    }

    /**
     * Copies the mean force and torque of the last step on a joint's second object, at the joint; default: zeros.
     *
     * @param into takes {fx, fy, fz, tx, ty, tz}, N and N m, world frame
     */
    default void wrench(String joint, double[] into) {
        Arrays.fill(into, 0);
    }

    /** Returns the pool that shares a sensor's work among the machine's cores; default: the calling thread alone. */
    default WorkerPool workers() {
        return WorkerPool.ALONE;
    }

    /** Returns the name of a scene shape's object. */
    String objectName(int shape);
}
