// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import java.util.function.Function;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.devices.LightHardware;
import org.SEAR.devices.MotorHardware;
import org.SEAR.devices.SerialLine;
import org.SEAR.devices.ServoHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.solid.MassProperties;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.Robot;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.Sensor;
import org.SEAR.simulator.orders.BodyOrder;
import org.SEAR.simulator.orders.DragSpring;

/**
 * A running world: physics, robots, sensors and devices, advanced in steps of 1/60 s.
 *
 * <p>The thread that calls {@link #step} is the simulation thread. All instance methods belong to it, except those
 * marked "any thread", such as {@link #post} and {@link #ask}, which bring work to the simulation thread.
 */
public final class Simulation implements AutoCloseable {
    /** Length of a step, simulated seconds. */
    public static final double STEP = TimeStep.SECONDS;
    /** Resolution of device time between two steps, parts of a step. */
    public static final int PARTS = 256;
    /** Default UTC of simulated time 0, milliseconds since 1970. */
    public static final long EPOCH = Instant.parse("2026-01-01T12:00:00Z").toEpochMilli();

    private final Project project;
    private final World world;
    private final Instruments instruments;
    private final PoseLookup places;
    private final Actuators actuators;
    private final SnapshotRecorder observer;
    private final SimulationWarnings warnings = new SimulationWarnings();
    private final List<String> deviceWarnings;
    private final List<Robot> robots;
    private final ConcurrentLinkedQueue<Consumer<Simulation>> commands = new ConcurrentLinkedQueue<>();
    private final ConcurrentLinkedQueue<Runnable> questions = new ConcurrentLinkedQueue<>();
    private volatile Runnable wakeUp = () -> { };
    private volatile Snapshot snapshot;
    private volatile Thread thread;
    private volatile boolean closed;
    private long step;
    /** Device time within the next step, in {@link #PARTS}. */
    private int part;
    private RunOrigin origin;
    private RunListener listener;
    private final Consumer<BodyOrder> pulls = order -> report(who -> who.order(order));
    /** Events during the delivery of outputs; the listener gets them after the step. */
    private final List<Consumer<RunListener>> late = new ArrayList<>();
    private boolean delivering;
    /** Whether a reset waits for the end of the delivery. */
    private boolean resetting;

    private Simulation(Project project, long seed, long epochMillis, boolean groundVisible) throws ProjectException {
        this.project = project;
        origin = new RunOrigin(seed, epochMillis, groundVisible);
        world = new World(project, seed, epochMillis, groundVisible, warnings::add);
        instruments = new Instruments(world, project.getAssets(), seed, warnings::count);
        places = new PoseLookup(project, world);
        actuators = new Actuators(world.getRobots());
        deviceWarnings = warnings.list();
        observer = new SnapshotRecorder(world, instruments, warnings);
        robots = List.copyOf(world.getRobots());
        start();
    }

    /** Reads a SEARproject folder and builds its world. */
    public static Simulation load(Path folder, long seed) throws ProjectException {
        return load(folder, seed, true);
    }

    /**
     * Reads a SEARproject folder and builds its world; this program does not replace the project meanwhile.
     * @param groundVisible false: beams pass through all floors and terrain
     */
    public static Simulation load(Path folder, long seed, boolean groundVisible) throws ProjectException {
        return ProjectSwap.undisturbed(() -> new Simulation(Project.read(folder), seed, EPOCH, groundVisible));
    }

    /** Builds the world of a project. */
    public static Simulation of(Project project, long seed) throws ProjectException {
        return of(project, seed, EPOCH);
    }

    /** Builds the world of a project. Simulated time 0 is at {@code epochMillis} UTC, milliseconds since 1970. */
    public static Simulation of(Project project, long seed, long epochMillis) throws ProjectException {
        return new Simulation(project, seed, epochMillis, true);
    }

    /** Builds the world of a project with the settings of another run. */
    public static Simulation of(Project project, RunOrigin origin) throws ProjectException {
        return new Simulation(project, origin.seed, origin.epochMillis, origin.groundVisible);
    }

    private void start() {
        step = 0;
        part = 0;
        warnings.restart(project.getWarnings(), world.getWarnings(), deviceWarnings);
        instruments.warn();
        snapshot = observer.look(step);
    }

    /** Advances by one step: commands, physics, ground truth, sensors, devices, outputs. */
    public void step() {
        advance();
        deliver();
    }

    /** Runs a step up to its outputs; the snapshot shows the result. */
    void advance() {
        thread = Thread.currentThread();
        runCommands();
        instruments.accept(getDeviceTime());
        world.step(pulls);
        step++;
        part = 0;
        world.observe(step);
        instruments.track();
        instruments.run(getTime());
        snapshot = observer.look(step);
    }

    /** Delivers the outputs of a step. A reader that asks for the time on receipt gets the time of this step. */
    void deliver() {
        delivering = true;
        try {
            instruments.deliver(getTime());
        } finally {
            delivering = false;
        }
        if (listener != null) {
            listener.stepped(this);
        }
        endDelivery();
        answerQueries();
    }

    /**
     * Services lines and devices between two steps, paced by the clock, with the ground truth of the last step.
     *
     * @param newPart elapsed parts of the next step, 1 to 255 of {@link #PARTS}; never counts less than an earlier
     *     value
     * @return part of the next service; {@link #PARTS} if the next step is early enough
     */
    public int serviceDevices(int newPart) {
        thread = Thread.currentThread();
        int before = part;
        part = Math.max(part, newPart);
        double next;
        delivering = true;
        try {
            next = instruments.serviceDevices(getDeviceTime());
        } finally {
            delivering = false;
        }
        if (next == Double.POSITIVE_INFINITY) {
            part = before;
        } else {
            devicesServiced(part);
        }
        double due = (Math.min(next, instruments.nextAction()) - getTime()) / STEP * PARTS;
        return (int) Math.min(PARTS, Math.max(Math.max(part, newPart) + 1, Math.ceil(due)));
    }

    /** Whether {@link #answer} has work or is doing it. Any thread. */
    public boolean hasQueries() {
        return instruments.hasQueries();
    }

    /** Whether {@link #answer} should be retried soon, as a host is just opening a port. Any thread. */
    boolean isOpening() {
        return instruments.areOpening();
    }

    /** Lets devices with {@code SerialDevice.answersAtOnce} process their input while time stands still. */
    public void answer() {
        if (!hasQueries()) {
            return;
        }
        thread = Thread.currentThread();
        delivering = true;
        try {
            instruments.answer(getDeviceTime());
        } finally {
            delivering = false;
        }
        devicesServiced(0);
    }

    /** Called while time stands still and nothing is requested. */
    void idle() {
        if (listener != null) {
            listener.idle();
        }
    }

    private void devicesServiced(int what) {
        if (listener != null) {
            listener.devicesServiced(what);
        }
        endDelivery();
    }

    private void endDelivery() {
        if (!late.isEmpty()) {
            late.forEach(this::report);
            late.clear();
        }
        if (resetting) {
            resetting = false;
            reset();
        }
    }

    /** Reports an event between two steps to the listener. */
    private void report(Consumer<RunListener> event) {
        if (delivering) {
            late.add(event);
        } else if (listener != null) {
            event.accept(listener);
        }
    }

    private void runCommands() {
        for (Consumer<Simulation> command = commands.poll(); command != null; command = commands.poll()) {
            try {
                if (listener != null && command instanceof DriveCommand) {
                    listener.drive((DriveCommand) command);
                }
                command.accept(this);
            } catch (RuntimeException e) {
                warnings.count("command", "a command failed: " + e);
            }
        }
    }

    /** Answers the questions of {@link #ask} without advancing. */
    public void answerQueries() {
        if (questions.isEmpty()) {
            return;
        }
        thread = Thread.currentThread();
        for (Runnable question = questions.poll(); question != null; question = questions.poll()) {
            question.run();
        }
    }

    /**
     * Resets everything to step 0, as a fresh start with the same seed. Watched sensors and the baud rates of the host
     * ports stay. During the delivery of outputs the reset waits for its end.
     */
    public void reset() {
        if (delivering) {
            resetting = true;
            return;
        }
        if (listener != null) {
            listener.reset();
        }
        world.restart(origin.seed);
        instruments.restart();
        start();
    }

    /** Sets the seed of random numbers from the next {@link #reset} on. Not while a listener is attached. */
    public void reseed(long seed) {
        origin = new RunOrigin(seed, origin.epochMillis, origin.groundVisible);
        instruments.reseed(seed);
    }

    /** Adds or removes a listener of the run. */
    public void setListener(RunListener who, boolean on) {
        listener = RunListener.Several.changed(listener, who, on);
        instruments.getPorts().forEach(port -> port.getCable().setListener(listener));
    }

    /** Returns the settings that determine the run besides project and commands. Any thread. */
    public RunOrigin getOrigin() {
        return origin;
    }

    /** Queues a command for the start of the next step. Any thread. An exception of the command becomes a warning. */
    public void post(Consumer<Simulation> command) {
        commands.add(command);
    }

    /**
     * Asks a question, answered on the simulation thread between two steps, also while paused. Any thread. The future
     * fails when the simulation has ended.
     */
    public <T> Future<T> ask(Function<Simulation, T> question) {
        CompletableFuture<T> answer = new CompletableFuture<>();
        Runnable job = () -> {
            if (closed) {
                answer.completeExceptionally(new IllegalStateException("the simulation has ended"));
                return;
            }
            try {
                answer.complete(question.apply(this));
            } catch (RuntimeException e) {
                answer.completeExceptionally(e);
            }
        };
        if (closed || Thread.currentThread() == thread) {
            job.run();
        } else {
            questions.add(job);
            wakeUp.run();
            if (closed) {
                answerQueries();
            }
        }
        return answer;
    }

    /** Sets the callback that runs when a question or bytes on a line arrive. */
    void setWakeUp(Runnable newWakeUp) {
        wakeUp = newWakeUp;
        instruments.getPorts().forEach(port -> port.getCable().setWakeUp(newWakeUp));
    }

    /** The state after the last step. Any thread. */
    public Snapshot snapshot() {
        return snapshot;
    }

    /** The project of this world; immutable. Any thread. */
    public Project getProject() {
        return project;
    }

    /** Simulated seconds; other threads read the snapshot. */
    public double getTime() {
        return step * STEP;
    }

    /** Simulated time up to which devices have run, s. */
    private double getDeviceTime() {
        return part == 0 ? getTime() : (step + part / (double) PARTS) * STEP;
    }

    /** Steps since start or reset. */
    public long getStep() {
        return step;
    }

    /** All robots, in the project's order. */
    public List<Robot> getRobots() {
        return robots;
    }

    /**
     * Points {x, y, z} that suffice to draw an object's outline from any side, metres, object frame; empty without a
     * shape. Any thread.
     */
    public double[][] getOutline(SearObject object) {
        return world.getOutline(object);
    }

    /**
     * Areas of an object from above, {x, y, z} of the corners of each, metres, object frame; none if the convex hull of
     * its outline shows it. Any thread.
     */
    public double[][][] getAreas(SearObject object) {
        return world.getAreas(object);
    }

    /** Surface of a shape, shape frame, metres; null for a terrain, which is drawn from its elevations. Any thread. */
    public SurfaceMesh getSurface(Shape shape) {
        return world.getSurface(shape);
    }

    /**
     * Finds a sensor by name. Any thread; the sensor itself belongs to the simulation thread.
     *
     * @param name for example {@code rover/ping}; the robot's name can be omitted if only one robot has such a sensor
     * @throws IllegalArgumentException that lists the valid sensors, or the robots that have one of that name
     */
    public Sensor<?> getSensor(String name) {
        return instruments.sensor(name);
    }

    /** Returns the present reading of a sensor, or of a joint with a position. Throws as {@link #getSensor}. */
    public Reading read(String name) {
        return instruments.read(name);
    }

    /**
     * Returns the present readings of several sensors and joints, equal to those of {@link #read(String)}; measures in
     * parallel where that pays. Throws as {@link #getSensor}.
     */
    public List<Reading> read(List<String> names) {
        return instruments.read(names);
    }

    /** Display unit of a reading, empty if it has none. Any thread. Throws as {@link #getSensor}. */
    public String getUnit(String name) {
        return instruments.unit(name);
    }

    /** Names of all sensors, sorted. Any thread. */
    public List<String> getSensorNames() {
        return instruments.getNames();
    }

    /**
     * Height (y) of the highest ground at a point, metres: terrain, floor, or a model that is the terrain.
     *
     * @param x metres north
     * @param z metres east
     * @throws IllegalArgumentException if there is no ground
     */
    public double getGroundHeight(double x, double z) {
        return world.groundHeight(x, z);
    }

    /** Result of {@link #getGroundHeight} for a project without a simulation; builds only its ground. Any thread. */
    public static double groundHeight(Project project, double x, double z) throws ProjectException {
        return World.groundHeight(World.ground(project), x, z);
    }

    /**
     * Pose of an object in the world. A wheel's includes suspension and rotation; a Dynamics has that of its robot.
     * @param name of a robot, an environment object or a part, {@code rover/ping} where several robots have such a part
     * @throws IllegalArgumentException if the name is unknown
     */
    public Pose getPose(String name) {
        return places.find(name);
    }

    /** Returns the joints; the simulation thread's. */
    public WorldJoints getJoints() {
        return world.getJoints();
    }

    /** Present gravity, m/s^2 downwards. */
    public double getGravity() {
        return world.getPhysics().getGravity();
    }

    /** Mass properties of an object or robot in its frame. Throws as {@link World#getMassProperties}. */
    public MassProperties getMassProperties(String name) {
        return world.getMassProperties(name);
    }

    /**
     * Finds a motor by name. Any thread; the motor itself belongs to the simulation thread.
     *
     * @param name for example {@code rover/left}; the robot's name can be omitted if only one robot has such a motor
     * @throws IllegalArgumentException that lists the valid motors, or the robots that have one of that name
     */
    public MotorHardware getMotor(String name) {
        return actuators.motor(name);
    }

    /** Finds a servo by name, see {@link #getMotor}. */
    public ServoHardware getServo(String name) {
        return actuators.servo(name);
    }

    /** Finds a light by name, see {@link #getMotor}. */
    public LightHardware getLight(String name) {
        return actuators.led(name);
    }

    /** Starts or stops adding a sensor's reading to snapshots; never changes a reading. Call through {@link #post}. */
    public void watch(String sensorName, boolean on) {
        instruments.sensor(sensorName);
        observer.watch(sensorName, on);
        snapshot = observer.look(step);
    }

    /** Sets the interval of new readings and status lines in snapshots, steps, at least 1, by default 2. */
    void setDisplayInterval(int steps) {
        observer.setInterval(steps);
    }

    /** Starts or stops adding contact points to snapshots; off by default. Call through {@link #post}. */
    public void showContacts(boolean on) {
        world.setWantsContacts(on);
    }

    /**
     * Commands a motor, servo, light or steering from the next step on.
     *
     * @throws IllegalArgumentException that lists the valid names or the legal range
     */
    public void order(ActuatorOrder order) {
        order.giveTo(this);
        report(who -> who.order(order));
    }

    /** Sets a body's velocity or gravity, or applies a force from the next step on. Throws as {@link World#order}. */
    public void order(BodyOrder order) {
        world.order(order);
        report(who -> who.order(order));
    }

    /** Lets a drag spring pull a body from the next step until its release. Throws as {@link #order(BodyOrder)}. */
    public void hold(DragSpring hand, String name) {
        world.hold(hand, name);
    }

    /**
     * Switches the power of a serial device; bytes on its line are lost.
     *
     * @param name of the object with its ports, as {@link #getSensor} takes it
     * @throws IllegalArgumentException that lists the valid devices
     */
    public void power(String name, boolean on) {
        instruments.power(name, on, getDeviceTime());
        report(who -> who.power(name, on));
        snapshot = observer.lookClosely(step);
    }

    /** Lines of all serial devices; the list never changes. Any thread. */
    public List<SerialLine> getLines() {
        return instruments.getLines();
    }

    /**
     * Moves an object or robot, at rest, to its start in a newer state of the project, on top of what is there. A reset
     * uses the new start. Everything else keeps its start.
     *
     * @param back true for an undone edit: restores the pose before it, if the object was moved since start or reset
     * @return whether this world has the object
     * @throws IllegalArgumentException if it has no valid place there
     */
    public boolean place(String name, Project now, boolean back) {
        try {
            Teleports moves = world.getMoves();
            Pose start = moves.start(name, now);
            if (start == null) {
                return false;
            }
            if (!back) {
                moves.remember(name);
            }
            moves.write(name, now);
            move(name, start, back ? moves.undo(name, start) : start);
            return true;
        } catch (ProjectException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    /**
     * Moves an object or robot, which is then at rest.
     *
     * @param start its pose after a reset
     * @param to its pose now
     * @throws IllegalArgumentException if the name is unknown
     */
    public void move(String name, Pose start, Pose to) {
        if (!world.getMoves().has(name)) {
            throw new IllegalArgumentException("nothing that can be moved is named \"" + name + "\"");
        }
        world.move(name, start, to);
        report(who -> who.moved(name, start, to));
        snapshot = observer.lookClosely(step);
    }

    /**
     * Rise, in metres, that a moved robot's start needs to stand on the ground or objects there.
     *
     * @param by displacement of its start, world frame
     * @return 0 if the name is no robot's; where nothing is below, the rise that keeps the robot at its present height
     */
    public double rise(String robot, Pose by) {
        return world.getMoves().rise(robot, by);
    }

    World getWorld() {
        return world;
    }

    /**
     * Sets the number of measuring threads, including the simulation's; default: the processors. Readings do not depend
     * on it.
     *
     * @throws IllegalArgumentException that names the legal range
     */
    public void setThreads(int threads) {
        world.getWorkers().setThreads(threads);
    }

    /** Releases all resources; open questions fail. Call it after the last step. */
    @Override
    public void close() {
        world.getWorkers().close();
        closed = true;
        answerQueries();
    }
}
