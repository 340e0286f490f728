package org.SEAR.sensors;

import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;

/**
 * One simulated sensor: reading = f(truth, parameters, own random numbers). Simulation thread only.
 *
 * <p>The reading of a step is a pure function of the truth up to that step and of the random numbers of that step, which come from (seed, sensor
 * name, step number). So it does not matter who asks, how often, or which other sensors there are.
 *
 * @param <R> the immutable reading
 */
public abstract class Sensor<R> {
    private final SearObject parameters;
    private final Pose mount;
    private R last;
    private long lastStep = -1;

    /** @param parameters the sensor's object; its pose is in the body frame */
    protected Sensor(SearObject parameters) {
        this.parameters = parameters;
        this.mount = Pose.ofDegrees(parameters.getX(), parameters.getY(), parameters.getZ(),
            parameters.getRx(), parameters.getRy(), parameters.getRz());
    }

    /** The name that scripts ask for. */
    public final String getName() {
        return parameters.getName();
    }

    /** The object that describes this sensor. */
    public final SearObject getParameters() {
        return parameters;
    }

    /** Where the sensor sits in the body frame. */
    public final Pose getMount() {
        return mount;
    }

    /** The reading at the present step; computed once a step, and only when somebody asks. */
    public final R read(Truth truth) {
        if (last == null || lastStep != truth.step()) {
            last = measure(truth);
            lastStep = truth.step();
        }
        return last;
    }

    /** Called after each step, before anybody reads: only for sensors with a memory (integrators, windows). Allocates nothing. */
    public void track(Truth truth) {
    }

    /** What the user should know about this sensor in this world, in plain words; asked once after start and reset. */
    public List<String> warnings(Truth truth) {
        return Collections.emptyList();
    }

    /** The sensor's pose in the world. */
    protected final Pose pose(Truth truth) {
        return truth.body().times(mount);
    }

    /** The next {@link #read} measures again, even in the same step. */
    protected final void forget() {
        last = null;
        lastStep = -1;
    }

    /** Back to the state of a fresh start. */
    public void reset() {
        forget();
    }

    /** Computes the reading. */
    protected abstract R measure(Truth truth);
}
