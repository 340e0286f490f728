package org.myrobotlab.service;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.SEAR.POJOs.ScriptText;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.problems.Reasons;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.SEARConfig;
import org.myrobotlab.service.link.PanelFiles;
import org.myrobotlab.service.sear.SensorReading;
import org.myrobotlab.service.sear.panel.Preview;
import org.myrobotlab.service.sear.run.SimulationSession;

/**
 * SEAR, the Simulation Environment for Autonomous Robots, as a MyRobotLab service: starts the world that the objects of {@code org.SEAR.POJOs}
 * have described, and answers for its sensors.
 *
 * <pre>
 * sear = Runtime.start("sear", "SEAR")
 * sear.startSimulation()
 * sear.drive(0.2, float("inf"))
 * sear.simSleep(2)
 * print sear.getDistanceResult("Ping1")
 * sear.stopSimulation()
 * </pre>
 *
 * <p>Calls may come from any thread. What goes wrong is published as an error status and thrown (IllegalStateException, or
 * IllegalArgumentException for values), so that scripts see it; a running simulation goes on.
 */
public class SEAR extends Service<SEARConfig> {
    private static final long serialVersionUID = 1L;
    private static final String UART_CALLBACK = "onUartBytes";

    static {
        PanelFiles.install(SEAR.class);
    }

    private transient SearParts parts;
    private boolean simulating;
    private boolean paused;

    /** As MyRobotLab makes services. */
    public SEAR(String name, String id) {
        super(name, id);
    }

    @Override
    public synchronized void startService() {
        super.startService();
        if (parts == null) {
            try {
                parts = new SearParts(new SearHost(this));
            } catch (LinkageError e) {
                error("%s", missing(e));
            }
        }
    }

    // ---- the simulation --------------------------------------------------------------------------------------------

    /** Starts the world of the project folder, {@code SEARproject} in MyRobotLab's working folder. */
    public void startSimulation() {
        startSimulation(false);
    }

    /** @param debugShapes whether the window shows collision shapes, contact points and wheel rays */
    public void startSimulation(boolean debugShapes) {
        attempt(() -> {
            parts.control().start(debugShapes);
            return null;
        });
        changed();
    }

    /** Ends the simulation; ports, window and thread go away. */
    public void stopSimulation() {
        attempt(() -> {
            parts.control().session();
            parts.stop();
            return null;
        });
        changed();
    }

    /** Time stands still until {@link #resume}. */
    public void pause() {
        attempt(() -> {
            parts.control().session().pause();
            return null;
        });
        changed();
    }

    /** Ends {@link #pause}. */
    public void resume() {
        attempt(() -> {
            parts.control().session().resume();
            return null;
        });
        changed();
    }

    /** Advances by so many steps of 1/60 s; pauses a simulation whose time runs by itself. */
    public void step(int n) {
        attempt(() -> {
            parts.control().session().step(n);
            return null;
        });
        changed();
    }

    /** Everything back to the start, as a fresh start with the same seed. */
    public void reset() {
        attempt(() -> {
            parts.control().session().reset();
            return null;
        });
    }

    /** @param factor simulated seconds a second, above 0; 1 = real time, infinity = as fast as possible; holds for later simulations too */
    public void setSpeed(double factor) {
        attempt(() -> {
            parts.control().setSpeed(factor);
            return null;
        });
    }

    /** Whether simulated time advances only inside {@link #simSleep} and {@link #step}; holds for later simulations too. */
    public void setLockStep(boolean on) {
        attempt(() -> {
            parts.control().setLockStep(on);
            return null;
        });
    }

    /**
     * Whether beams of all sensors see floors and terrain in the next simulations; true unless set. False: they pass through all of them, as a real
     * ultrasonic beam glances off a smooth floor. A single one is hidden by its object, {@code floor.setVisibleToSensors(False)}.
     */
    public void setGroundVisible(boolean on) {
        attempt(() -> {
            parts.control().setGroundVisible(on);
            return null;
        });
    }

    /** Whether a simulation runs whose time advances only inside {@link #simSleep} and {@link #step}. */
    public boolean isLockStep() {
        SimulationSession session = parts == null ? null : parts.control().sessionOrNull();
        return session != null && session.isLockStep();
    }

    /** Whether a simulation runs (a paused one too). */
    public boolean isSimulating() {
        return parts != null && parts.control().isRunning();
    }

    /** Simulated seconds since start or reset. */
    public double getTime() {
        return attempt(() -> parts.control().session().time());
    }

    /** Waits so many simulated seconds; in lock-step it makes them pass. */
    public void simSleep(double seconds) {
        attempt(() -> {
            parts.control().session().simSleep(seconds);
            return null;
        });
    }

    // ---- driving and reading ---------------------------------------------------------------------------------------

    /**
     * Drives the first robot.
     *
     * @param speed m/s, + forward
     * @param radius metres, + to the left; infinity = straight, 0 = in place to the left
     */
    public void drive(double speed, double radius) {
        drive(null, speed, radius);
    }

    /** Drives a robot by name. */
    public void drive(String robot, double speed, double radius) {
        attempt(() -> {
            parts.readings().drive(robot, speed, radius);
            return null;
        });
    }

    /** Metres to the nearest hit of a distance sensor; its range where nothing was hit. */
    public double getDistanceResult(String name) {
        return attempt(() -> parts.readings().distance(name));
    }

    /** "x,y,z" of an accelerometer, m/s^2, body axes. */
    public String getAccelResult(String name) {
        return attempt(() -> parts.readings().acceleration(name));
    }

    /** "x,y,z" of a gyroscope, rad/s, body axes. */
    public String getGyroResult(String name) {
        return attempt(() -> parts.readings().rates(name));
    }

    /** Degrees of a compass, clockwise from north, (-180, 180]. */
    public double getCompassResult(String name) {
        return attempt(() -> parts.readings().heading(name));
    }

    /**
     * Signed path of the first robot's centre, metres: since the last call if it has an Odometer object (which counts to 32.767 m, as a Roomba's),
     * else since start or reset.
     */
    public double getOdomResult() {
        return getOdomResult(null);
    }

    /** The same of a robot by name. */
    public double getOdomResult(String robot) {
        return attempt(() -> parts.readings().odometer(robot));
    }

    /** Metres of a LIDAR's beams, right to left; its range where nothing was hit. */
    public float[] getLidarResult(String name) {
        return attempt(() -> parts.readings().scan(name));
    }

    /** [latitude, longitude, altitude] of a GPS sensor: degrees, degrees, metres. */
    public double[] getGpsResult(String name) {
        return attempt(() -> parts.readings().position(name));
    }

    /** [x, y, z, rx, ry, rz] in the world of a robot, part, sensor or object: metres and degrees. */
    public double[] getPose(String name) {
        return attempt(() -> parts.readings().pose(name));
    }

    /** Names of all sensors. */
    public List<String> getSensorNames() {
        return attempt(() -> parts.readings().names());
    }

    // ---- publishing ------------------------------------------------------------------------------------------------

    /**
     * Publishes a sensor's readings again and again, for those who subscribe to publishReading.
     *
     * @param rate readings a simulated second, to 60
     */
    public void startPublishing(String sensor, double rate) {
        attempt(() -> {
            parts.publisher().start(sensor, rate);
            return null;
        });
    }

    /** Ends {@link #startPublishing}. */
    public void stopPublishing(String sensor) {
        attempt(() -> {
            parts.publisher().stop(sensor);
            return null;
        });
    }

    /** A reading, with the sensor's name and the simulated time. */
    public SensorReading publishReading(SensorReading reading) {
        return reading;
    }

    /**
     * The world for panels, ten times a second while somebody subscribes: the whole when it begins, then what has changed; the form stands at
     * {@code WorldFeed}.
     */
    public Map<String, Object> publishSimulation() {
        return attempt(parts::nextState);
    }

    /** The whole world as it is now, for a panel that opens while it runs. */
    public Map<String, Object> getWorld() {
        return attempt(parts::wholeState);
    }

    /**
     * The project's world as it would start, for panels while nothing runs; its form stands at {@code Preview}. What is wrong stands in it, too.
     *
     * @param known the stamp of the one that the panel has; empty if none
     */
    public Map<String, Object> getPreview(String known) {
        try {
            return parts == null ? Collections.emptyMap() : parts.preview(known);
        } catch (LinkageError e) {
            return Preview.none(missing(e));
        }
    }

    /** What is wrong with the project, for panels; empty if nothing. */
    public List<Problem> getProblems() {
        return attempt(parts::problems);
    }

    /** Tells panels why a project could not be started or loaded. */
    public List<Problem> publishProblems(List<Problem> problems) {
        return problems;
    }

    // ---- projects and ports ----------------------------------------------------------------------------------------

    /**
     * Begins an empty project; the present one is kept.
     *
     * @return where it was put; null if there was none
     */
    public String newProject() {
        return attempt(() -> text(parts.projects().startAnew()));
    }

    /** Saves the project as a bundle, for example {@code "robot.sear"}; the ending .sear may be left out. A file of that name is replaced. */
    public void saveProject(String path) {
        attempt(() -> {
            parts.projects().save(bundle(path));
            return null;
        });
    }

    /** The same for a panel: a file of that name is only replaced if that is asked for; the answer's form stands at {@code Projects}. */
    public Map<String, Object> saveProjectAs(String path, boolean overwrite) {
        return attempt(() -> parts.projects().saveAs(bundle(path).toString(), overwrite));
    }

    /** Replaces the project by a bundle's, or a copy of a project folder, once that is read whole and valid; the present one is kept as backup. */
    public void loadProject(String path) {
        attempt(() -> {
            parts.projects().load(bundle(path));
            return null;
        });
    }

    /**
     * Adds a robot of a bundle or project folder to the present project, which is kept as backup. Names and ports that are taken get a number.
     *
     * @param path a bundle or a folder
     * @param name the robot's name there; None or empty if it is the only one
     * @return its name here
     */
    public String importRobot(String path, String name) {
        return attempt(() -> parts.projects().importRobot(bundle(path), name == null ? null : ScriptText.of(name)));
    }

    /**
     * Adds the environment of a bundle or project folder to the present project, as {@link #importRobot} a robot.
     *
     * @return the objects' names here
     */
    public List<String> importEnvironment(String path) {
        return attempt(() -> parts.projects().importEnvironment(bundle(path)));
    }

    /** Takes a part of a bundle from a panel, base64; the last part loads the project and publishes publishUploaded. */
    public void uploadProject(String name, int index, int count, String data) {
        if (attempt(() -> parts.transfers().receive(name, index, count, data))) {
            invoke("publishUploaded", "loaded " + name);
        }
    }

    /** Says that an uploaded project is loaded. */
    public String publishUploaded(String message) {
        return message;
    }

    /** A part of the project's bundle for a panel: index, count, data in base64; part 0 makes the bundle. */
    public Map<String, Object> getBundle(int index) {
        return attempt(() -> parts.transfers().part(index));
    }

    /** Paths of example projects, for panels. */
    public List<String> getExamples() {
        return attempt(() -> parts.projects().examples());
    }

    /**
     * Copies a template, {@code controller.py} or {@code userCode.py}, into a folder.
     *
     * @return the copy's path
     */
    public String copyTemplate(String name, String folder) {
        return attempt(() -> text(parts.projects().copyTemplate(name, folder)));
    }

    /**
     * Lets any program on this computer open a virtual port, as a pseudo-terminal (Linux, macOS).
     *
     * @return the path to open
     */
    public String exportPort(String userPort) {
        return exportPort(userPort, null);
    }

    /**
     * @param link path of a symbolic link that is to lead to the pseudo-terminal, so that its name stays the same
     * @return the path to open
     */
    public String exportPort(String userPort, String link) {
        return attempt(() -> parts.exports().terminal(userPort, link));
    }

    /**
     * The same as a TCP server on the loopback address, raw bytes, on every system.
     *
     * @param number TCP port, 0 for any free one
     * @return the number
     */
    public int exportTcp(String userPort, int number) {
        return attempt(() -> parts.exports().tcp(userPort, number));
    }

    private static Path bundle(String path) {
        if (path == null) {
            throw new IllegalArgumentException("the path is missing (None), legal: the path of a bundle, such as \"robot.sear\"");
        }
        return Paths.get(ScriptText.of(path));
    }

    private static String text(Path path) {
        return path == null ? null : path.toString();
    }

    // ---- MyRobotLab ------------------------------------------------------------------------------------------------

    /** Bytes of a device's Serial service go straight to the device, and lock-step hears at once what it waits for; all else takes its usual way. */
    @Override
    public void in(Message message) {
        if (!toDevice(message) && !SearParts.isFence(message)) {
            super.in(message);
        }
    }

    /** Where a MyRobotLab brings messages another way than {@link #in}. */
    @Override
    public boolean preProcessHook(Message message) {
        return !toDevice(message) && !SearParts.isFence(message) && super.preProcessHook(message);
    }

    private boolean toDevice(Message message) {
        if (!UART_CALLBACK.equals(message.method)) {
            return false;
        }
        try {
            if (parts != null && message.data != null && message.data.length == 1 && message.data[0] instanceof byte[]) {
                parts.toDevice(message.getSrcName(), (byte[]) message.data[0]);
            }
        } catch (RuntimeException e) {
            log.error("bytes from {} did not reach their device", message.sender, e);
        }
        return true;
    }

    /** The simulation has changed its state. */
    void changed() {
        simulating = isSimulating();
        paused = simulating && parts.control().session().isPaused();
        broadcastState();
    }

    /** Whether the simulation is paused. */
    public boolean isPaused() {
        return paused;
    }

    private <T> T attempt(Callable<T> work) {
        try {
            if (parts == null) {
                throw new IllegalStateException(getName() + " is not started: Runtime.start(\"" + getName() + "\", \"SEAR\")");
            }
            return work.call();
        } catch (IllegalArgumentException e) {
            error("%s", message(e));
            throw e;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("the script was stopped while it waited", e);
        } catch (LinkageError e) {
            error("%s", missing(e));
            throw new IllegalStateException(missing(e), e);
        } catch (Exception e) {
            if (e instanceof ProjectException) {
                invoke("publishProblems", ((ProjectException) e).getProblems());
            }
            error("%s", message(e));
            throw e instanceof IllegalStateException ? (IllegalStateException) e : new IllegalStateException(message(e), e);
        }
    }

    private static String message(Exception e) {
        return Reasons.of(e);
    }

    private static String missing(LinkageError e) {
        return "SEAR can't work here, a library is missing or broken (" + e + "): run \"sear install\" for this MyRobotLab again, or put the jars"
            + " that come with SEAR into libraries/jar";
    }

    @Override
    public void stopService() {
        shutDown();
        super.stopService();
    }

    @Override
    public synchronized void releaseService() {
        shutDown();
        super.releaseService();
    }

    private void shutDown() {
        SearParts present = parts;
        parts = null;
        simulating = false;
        if (present != null) {
            present.close();
        }
    }
}
