package org.SEAR.sensors;

import org.SEAR.POJOs.Shape;
import org.SEAR.camera.Appearances;
import org.SEAR.camera.PlainAppearance;
import org.SEAR.geometry.Pose;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.raycast.BeamScene;

/**
 * What a sensor may know: the exact state of its robot after one step. The simulator fills it; sensors only read it. Simulation thread.
 */
public interface Truth {
    /** Steps since start or reset; 0 before the first. */
    long step();

    /** Simulated seconds since start or reset. */
    double time();

    /** Length of a step, seconds. */
    double stepLength();

    /** UTC of simulated time 0, milliseconds since 1970. */
    long epochMillis();

    /** The robot's body in the world. */
    Pose body();

    /** Velocity of the body's origin in the world, m/s: {x, y, z}. Not to be kept or changed. */
    double[] velocity();

    /** Angular velocity in the world frame, rad/s: {x, y, z}. Not to be kept or changed. */
    double[] angularVelocity();

    /** Signed path of the body's origin along the body's forward axis since start or reset, metres. Vibration at rest does not count. */
    double path();

    /** What gravity gives to a falling body, m/s^2 along the world's -y; 9.81 unless the world says otherwise. */
    double gravity();

    /** Where the world lies on the Earth, and the magnetic field there: {@code Earth.of(project, robot)}, made once. */
    Earth earth();

    /** The geometry that beams meet, as of this step. */
    BeamScene scene();

    /** The owner number of this robot's parts in the scene. */
    int owner();

    /**
     * Whether a part of this robot touches anything that isn't the robot itself.
     *
     * @param part name of a component that is a shape; null for any of them but wheels
     */
    default boolean isTouched(String part) {
        return false;
    }

    /** Whether a shape of the scene is ground to drive on: a floor or the terrain. */
    default boolean isGround(int shape) {
        return false;
    }

    /**
     * The colour of a shape at a point of its surface.
     *
     * @param x of the world, metres, likewise y and z
     * @return 0xRRGGBB as in a picture (sRGB)
     */
    default int color(int shape, double x, double y, double z) {
        return 0x999999;
    }

    /** What eyes see: beams' geometry, and what is hidden from beams, with the same numbers of shapes. */
    default BeamScene sight() {
        return scene();
    }

    /** What the shapes look like to cameras. */
    default Appearances looks() {
        return shape -> new PlainAppearance(color(shape, 0, 0, 0), Shape.AMBIENT);
    }

    /** Who does work that a sensor shares among the machine's cores; at first nobody but the thread that asks. */
    default WorkerPool workers() {
        return WorkerPool.ALONE;
    }

    /** Name of the object that a shape of the scene belongs to. */
    String objectName(int shape);
}
