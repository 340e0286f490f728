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
 * <p>One thread, the simulation thread, owns it: whoever calls {@link #step}. What other threads may call says so: {@link #post} and
 * {@link #ask}, which bring work to that thread, {@link #snapshot}, and what never changes.
 */
public final class Simulation implements AutoCloseable {
    /** Length of a step, simulated seconds. */
    public static final double STEP = TimeStep.SECONDS;
    /** So fine is time for devices that are attended between two steps. */
    public static final int PARTS = 256;
    /** UTC of simulated time 0 unless set, milliseconds since 1970. */
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
    /** How much of the next step the devices have seen, of {@link #PARTS}. */
    private int part;
    private RunOrigin origin;
    private RunListener listener;
    private final Consumer<BodyOrder> pulls = order -> report(who -> who.order(order));
    /** What comes after a step while its outputs still belong to it. */
    private final List<Consumer<RunListener>> late = new ArrayList<>();
    private boolean delivering;
    /** Whether a reset was asked for meanwhile. */
    private boolean resetting;

    private Simulation(Project project, long seed, long epochMillis, boolean groundVisible) throws ProjectException {
        this.project = project;
        origin = new RunOrigin(seed, epochMillis, groundVisible);
        world = new World(project, epochMillis, groundVisible, warnings::add);
        instruments = new Instruments(world.getRobots(), seed, world.getWorkers(), warnings::count);
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
     * Reads a SEARproject folder and builds its world. Waits while this program replaces the project, and lets nobody replace it meanwhile.
     *
     * @param groundVisible false: beams pass through all floors and terrain
     */
    public static Simulation load(Path folder, long seed, boolean groundVisible) throws ProjectException {
        return ProjectSwap.undisturbed(() -> new Simulation(Project.read(folder), seed, EPOCH, groundVisible));
    }

    /** Builds the world of a project. */
    public static Simulation of(Project project, long seed) throws ProjectException {
        return of(project, seed, EPOCH);
    }

    /** Builds the world of a project. Simulated time 0 is at that UTC, milliseconds since 1970. */
    public static Simulation of(Project project, long seed, long epochMillis) throws ProjectException {
        return new Simulation(project, seed, epochMillis, true);
    }

    /** Builds the world of a project as another run began. */
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

    /** Advances by one step: commands in, physics, truth, sensors, devices, outputs. Simulation thread. */
    public void step() {
        advance();
        deliver();
    }

    /** A step but for its outputs; the snapshot shows it. Simulation thread. */
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

    /** The outputs of a step: who gets bytes and asks for the time reads that of this step. Simulation thread. */
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
     * Between two steps, by the clock: bytes go over the lines and devices deal with them, from the truth of the last step. Simulation thread.
     *
     * @param newPart how much of the next step's time has passed, 1 to 255 of {@link #PARTS}; what is less than before counts as before
     * @return at which part to look again; {@link #PARTS} if the next step is early enough, or nothing was to be done
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
            return PARTS;
        }
        devicesServiced(part);
        return (int) Math.min(PARTS, Math.max(part + 1, Math.ceil((next - getTime()) / STEP * PARTS)));
    }

    /** Whether {@link #answer} has something to do, or does it. Any thread. */
    public boolean hasQueries() {
        return instruments.hasQueries();
    }

    /** Whether {@link #answer} is to be tried again soon: who has just opened a port does not wait for it yet. Any thread. */
    boolean isOpening() {
        return instruments.areOpening();
    }

    /** While time stands still: devices that {@link org.SEAR.devices.SerialDevice#answersAtOnce} deal with what was written. Simulation thread. */
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

    /** Time stands still, and nothing is asked for. Simulation thread. */
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

    /** Tells the tap what happens between two steps. */
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

    /** Runs what was asked for with {@link #ask}, without advancing. Simulation thread. */
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
     * Everything back to step 0, as a fresh start with the same seed. Who watches what and the speed of the user's ports stay. Who calls it while a
     * step's outputs are delivered gets it when all of them are. Simulation thread.
     */
    public void reset() {
        if (delivering) {
            resetting = true;
            return;
        }
        if (listener != null) {
            listener.reset();
        }
        world.restart();
        instruments.restart();
        start();
    }

    /** From the next {@link #reset} on random numbers come from another seed; not while somebody looks at the run. Simulation thread. */
    public void reseed(long seed) {
        origin = new RunOrigin(seed, origin.epochMillis, origin.groundVisible);
        instruments.reseed(seed);
    }

    /** Has somebody look at the run, beside those who do already, from now on or no longer. Simulation thread. */
    public void setListener(RunListener who, boolean on) {
        listener = RunListener.Several.changed(listener, who, on);
        instruments.getPorts().forEach(port -> port.getCable().setListener(listener));
    }

    /** What, beside project and commands, decides what happens. Any thread. */
    public RunOrigin getOrigin() {
        return origin;
    }

    /** A command for the start of the next step. Any thread. A command that throws becomes a warning. */
    public void post(Consumer<Simulation> command) {
        commands.add(command);
    }

    /** A question, answered on the simulation thread between two steps (while paused too). Any thread. Fails when the simulation has ended. */
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

    /** Who is to be told that there is a question, or something on a line. */
    void setWakeUp(Runnable newWakeUp) {
        wakeUp = newWakeUp;
        instruments.getPorts().forEach(port -> port.getCable().setWakeUp(newWakeUp));
    }

    /** The state after the last step. Any thread. */
    public Snapshot snapshot() {
        return snapshot;
    }

    /** The project this world was made from; immutable. Any thread. */
    public Project getProject() {
        return project;
    }

    /** Simulated seconds. Simulation thread; others look at the snapshot. */
    public double getTime() {
        return step * STEP;
    }

    /** The time up to which devices have been run. */
    private double getDeviceTime() {
        return part == 0 ? getTime() : (step + part / (double) PARTS) * STEP;
    }

    /** Steps since start or reset. Simulation thread. */
    public long getStep() {
        return step;
    }

    /** All robots, in the project's order. Simulation thread. */
    public List<Robot> getRobots() {
        return robots;
    }

    /**
     * Points of an object that are enough to draw its outline from any side: {x, y, z} in metres, scale included, in the object's frame. Any thread.
     *
     * @param object of this world's project
     * @return empty for an object without a shape
     */
    public double[][] getOutline(SearObject object) {
        return world.getOutline(object);
    }

    /** What a shape of this world's project looks like, in its own frame, metres; null for a terrain, drawn by its heights. Any thread. */
    public SurfaceMesh getSurface(Shape shape) {
        return world.getSurface(shape);
    }

    /**
     * A sensor by name; any thread, what the sensor does is up to the simulation thread.
     *
     * @param name as {@code rover/ping}, or without the robot where only one has a sensor of that name
     * @throws IllegalArgumentException that names the sensors there are, or the robots that have one of that name
     */
    public Sensor<?> getSensor(String name) {
        return instruments.sensor(name);
    }

    /**
     * The present reading of a sensor. Simulation thread.
     *
     * @throws IllegalArgumentException that names the sensors there are
     */
    public Reading read(String sensorName) {
        return instruments.read(sensorName);
    }

    /**
     * The present readings of several sensors, as {@link #read(String)} answers them; measured side by side where that pays. Simulation thread.
     *
     * @throws IllegalArgumentException that names the sensors there are
     */
    public List<Reading> read(List<String> sensorNames) {
        return instruments.read(sensorNames);
    }

    /**
     * The unit in which a sensor's reading is shown, empty if it has none. Any thread.
     *
     * @throws IllegalArgumentException that names the sensors there are
     */
    public String getUnit(String sensorName) {
        return instruments.unit(sensorName);
    }

    /** Names of all sensors, ordered. Any thread. */
    public List<String> getSensorNames() {
        return instruments.getNames();
    }

    /**
     * The world's y of the ground at a point, metres: of the terrain, a floor or a model that is the terrain; the highest of them. Simulation thread.
     *
     * @param x metres north
     * @param z metres east
     * @throws IllegalArgumentException if there is no ground
     */
    public double getGroundHeight(double x, double z) {
        return world.groundHeight(x, z);
    }

    /** What {@link #getGroundHeight} answers in the world of a project, of which only the ground is made (which can fail). Any thread. */
    public static double groundHeight(Project project, double x, double z) throws ProjectException {
        return World.groundHeight(World.ground(project), x, z);
    }

    /**
     * Where something is in the world. Simulation thread.
     *
     * @param name of a robot, a part of a robot ({@code rover/ping} where several have one of that name), or an environment object; a wheel is where
     *     its suspension and motor have it now, and a Dynamics, which has no place of its own on the robot, is where the robot is
     * @throws IllegalArgumentException if there is none of that name
     */
    public Pose getPose(String name) {
        return places.find(name);
    }

    /**
     * A motor by name; any thread, what it does is up to the simulation thread.
     *
     * @param name as {@code rover/left}, or without the robot where only one has a motor of that name
     * @throws IllegalArgumentException that names the motors there are, or the robots that have one of that name
     */
    public MotorHardware getMotor(String name) {
        return actuators.motor(name);
    }

    /** A servo by name, as {@link #getMotor} finds a motor and throws. Any thread, likewise. */
    public ServoHardware getServo(String name) {
        return actuators.servo(name);
    }

    /** A light by name, as {@link #getMotor} finds a motor and throws. Any thread, likewise. */
    public LightHardware getLight(String name) {
        return actuators.led(name);
    }

    /** Whether snapshots carry the sensor's reading from now on; never changes any reading. Any thread, through {@link #post}. */
    public void watch(String sensorName, boolean on) {
        instruments.sensor(sensorName);
        observer.watch(sensorName, on);
        snapshot = observer.look(step);
    }

    /** Snapshots carry fresh readings and status lines every so many steps, 1 or more, by default 2. Simulation thread. */
    void setDisplayInterval(int steps) {
        observer.setInterval(steps);
    }

    /** Whether snapshots carry the points of contact from now on; default false. Any thread, through {@link #post}. */
    public void showContacts(boolean on) {
        world.setWantsContacts(on);
    }

    /**
     * Tells a motor, servo, light or steering what to do from the next step on. Simulation thread.
     *
     * @throws IllegalArgumentException that names what there is, or the legal range
     */
    public void order(ActuatorOrder order) {
        order.giveTo(this);
        report(who -> who.order(order));
    }

    /** Gives a thing or a robot a velocity, or has it pushed from the next step on; throws as {@link World#order} does. Simulation thread. */
    public void order(BodyOrder order) {
        world.order(order);
        report(who -> who.order(order));
    }

    /** Has a hand pull a thing or a robot from the next step on, until it lets go; throws as {@link #order(BodyOrder)} does. Simulation thread. */
    public void hold(DragSpring hand, String name) {
        world.hold(hand, name);
    }

    /**
     * Switches the power of a serial device; what is on its line is gone. Simulation thread.
     *
     * @param name of the object with its ports, as {@link #getSensor} takes it
     * @throws IllegalArgumentException that names the devices there are
     */
    public void power(String name, boolean on) {
        instruments.power(name, on, getDeviceTime());
        report(who -> who.power(name, on));
        snapshot = observer.lookClosely(step);
    }

    /** The lines of all serial devices. Any thread (the list never changes). */
    public List<SerialLine> getLines() {
        return instruments.getLines();
    }

    /**
     * Puts a thing of the environment or a robot, at rest, to where it starts in a newer state of the project, on top of what is there; a reset finds
     * it there, too. All else stays as it was at the start. Simulation thread.
     *
     * @param back whether an edit was taken back: it goes to where it stood before that, if it was moved since the last start or reset
     * @return whether this world has it
     * @throws IllegalArgumentException if it has no place there
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
     * Puts a thing of the environment or a robot elsewhere, at rest. Simulation thread.
     *
     * @param start where a reset finds it
     * @param to where it is now
     * @throws IllegalArgumentException if there is none of that name
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
     * How much higher, in metres, a robot's start has to be than it is to stand on what is there, when it is moved. Simulation thread.
     *
     * @param by what its start is moved by, in the world
     * @return 0 for what is no robot; where nothing is below, as much as keeps it at its present height
     */
    public double rise(String robot, Pose by) {
        return world.getMoves().rise(robot, by);
    }

    World getWorld() {
        return world;
    }

    /**
     * On how many threads sensors measure from now on, that of the simulation included; at first as many as the machine has processors. What they
     * read does not depend on it. Simulation thread.
     *
     * @throws IllegalArgumentException that names the legal range
     */
    public void setThreads(int threads) {
        world.getWorkers().setThreads(threads);
    }

    /** Lets go of everything: questions that are still open fail. Simulation thread, after the last step. */
    @Override
    public void close() {
        world.getWorkers().close();
        closed = true;
        answerQueries();
    }
}
