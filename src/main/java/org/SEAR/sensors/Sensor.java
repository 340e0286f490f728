package org.SEAR.sensors;

import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;

/**
 * One simulated sensor: reading = f(truth, parameters, own random numbers). Simulation thread only, but for {@link #beamsAside}.
 *
 * <p>The reading of a step is a pure function of the truth up to that step and of the random numbers of that step, which come from (seed, sensor
 * name, step number). So it does not matter who asks, how often, or which other sensors there are.
 *
 * @param <R> its reading
 */
public abstract class Sensor<R extends Reading> {
    /** What this sensor's readings differ from the truth by. */
    protected final ErrorModel errors;
    private final SearObject parameters;
    private Pose mount;
    private R last;
    private long lastStep = -1;
    /** Whether {@link ParallelSensing} has it among those that are to be measured. */
    boolean isQueued;

    /**
     * A sensor with the errors that its object asks for.
     *
     * @param parameters the sensor's object; its pose is in the body frame
     * @param seed of the simulation
     * @param channels values that drift by themselves, see {@link ErrorModel#of}
     */
    protected Sensor(SearObject parameters, long seed, int channels) {
        this(parameters, ErrorModel.of(parameters, seed, channels));
    }

    /** A sensor with errors of another's. */
    Sensor(SearObject parameters, ErrorModel errors) {
        this.parameters = parameters;
        this.errors = errors;
        this.mount = ObjectPose.of(parameters);
    }

    /** The name that scripts ask for, as {@link SearObject#getFullName}. */
    public final String getName() {
        return parameters.getFullName();
    }

    /** The object that describes this sensor. */
    public final SearObject getParameters() {
        return parameters;
    }

    /** Where the sensor sits in the body frame. */
    public final Pose getMount() {
        return mount;
    }

    /** Puts it elsewhere in the body frame: the servo that it is mounted on has turned. Before the step's readings. */
    public final void setMount(Pose newMount) {
        mount = newMount;
    }

    /** The reading at the present step; computed once a step, and only when somebody asks. */
    public final R read(Truth truth) {
        if (!isRead(truth)) {
            last = measure(truth);
            lastStep = truth.step();
        }
        return last;
    }

    /** Whether {@link #read} has its reading already. */
    final boolean isRead(Truth truth) {
        return last != null && lastStep == truth.step();
    }

    /**
     * How many beams {@link #measure} casts, if it may do so on another thread than the simulation's, at the same time as other sensors: it then
     * changes nothing but its own sensor. 0, which is so unless a sensor says otherwise: it may not.
     */
    public int beamsAside() {
        return 0;
    }

    /**
     * Called after each step, before anybody reads. Sensors with a memory (integrators, windows) override it and call this one first. Allocates
     * nothing.
     */
    public void track(Truth truth) {
        errors.track(truth);
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

    /** From the next {@link #reset} on random numbers come from another seed. Sensors with their own override it and call this one first. */
    public void reseed(long seed) {
        errors.reseed(seed);
    }

    /** Back to the state of a fresh start. Sensors with a memory override it and call this one first. */
    public void reset() {
        forget();
        errors.reset();
    }

    /** Computes the reading. */
    protected abstract R measure(Truth truth);
}
