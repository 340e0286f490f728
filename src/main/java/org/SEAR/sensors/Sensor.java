// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;

/**
 * One simulated sensor: reading = f(truth, parameters, own random numbers). Simulation thread only, except for
 * {@link #beamsAside}.
 *
 * <p>The reading of a step is a pure function of the truth up to that step and of the step's random numbers, which come
 * from (seed, sensor name, step number). It does not depend on who reads, how often, or which other sensors exist.
 *
 * @param <R> type of its reading
 */
public abstract class Sensor<R extends Reading> {
    /** Errors of this sensor's readings. */
    protected final ErrorModel errors;
    private final SearObject parameters;
    private Pose mount;
    private R last;
    private long lastStep = -1;
    /** Whether {@link ParallelSensing} has queued this sensor. */
    boolean isQueued;

    /**
     * Creates a sensor with the errors of its object.
     *
     * @param parameters the sensor's object; its pose is in the body frame
     * @param seed random seed of the simulation
     * @param channels values that drift independently, see {@link ErrorModel#of}
     */
    protected Sensor(SearObject parameters, long seed, int channels) {
        this(parameters, ErrorModel.of(parameters, seed, channels));
    }

    /** Creates a sensor with given errors. */
    Sensor(SearObject parameters, ErrorModel errors) {
        this.parameters = parameters;
        this.errors = errors;
        this.mount = ObjectPose.of(parameters);
    }

    /** Returns the name for scripts, see {@link SearObject#getFullName}. */
    public final String getName() {
        return parameters.getFullName();
    }

    /** Returns the object that describes this sensor. */
    public final SearObject getParameters() {
        return parameters;
    }

    /** Returns the sensor's pose in the body frame. */
    public final Pose getMount() {
        return mount;
    }

    /** Moves the sensor in the body frame, when its servo has turned. Before the step's readings. */
    public final void setMount(Pose newMount) {
        mount = newMount;
    }

    /** Returns whether the sensor is a camera, which readers must ask for pictures because each costs time. */
    public boolean takesPictures() {
        return false;
    }

    /** Returns the {@link Reading#names} of its readings. */
    public List<String> names(Truth truth) {
        return read(truth).names();
    }

    /** Returns the reading at the current step; measures at most once per step, on demand. */
    public final R read(Truth truth) {
        if (!isRead(truth)) {
            last = measure(truth);
            lastStep = truth.step();
        }
        return last;
    }

    /** Returns whether {@link #read} already has the step's reading. */
    final boolean isRead(Truth truth) {
        return last != null && lastStep == truth.step();
    }

    /**
     * Returns the number of beams of {@link #measure} if it may run on another thread, in parallel with other sensors.
     * It then changes nothing but its own sensor. 0, the default, forbids it.
     */
    public int beamsAside() {
        return 0;
    }

    /**
     * Updates the sensor after each step, before any reading. Sensors with a memory (integrators, windows) override it
     * and call this method first. Allocates nothing.
     */
    public void track(Truth truth) {
        errors.track(truth);
    }

    /** Notes that the robot was teleported. Sensors that remember earlier poses override it. */
    public void moved() {
    }

    /** Returns warnings for the user about this sensor in this world; called once after start and reset. */
    public List<String> warnings(Truth truth) {
        return Collections.emptyList();
    }

    /** Returns the sensor's pose in the world. */
    protected final Pose pose(Truth truth) {
        return truth.body().times(mount);
    }

    /** Makes the next {@link #read} measure again, even in the same step. */
    protected final void forget() {
        last = null;
        lastStep = -1;
    }

    /**
     * Takes random numbers from another seed from the next {@link #reset} on. Sensors with their own random numbers
     * override it and call this method first.
     */
    public void reseed(long seed) {
        errors.reseed(seed);
    }

    /** Returns to the state of a fresh start. Sensors with a memory override it and call this method first. */
    public void reset() {
        forget();
        errors.reset();
    }

    /** Measures the reading. */
    protected abstract R measure(Truth truth);
}
