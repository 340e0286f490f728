package org.myrobotlab.service;

import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.SEAR.grammar.ScriptText;
import org.SEAR.project.problems.Problem;
import org.SEAR.robot.DriveOrder;
import org.myrobotlab.framework.Message;
import org.myrobotlab.service.config.SEARConfig;
import org.myrobotlab.service.data.ImageData;
import org.myrobotlab.service.link.OwnConfigService;
import org.myrobotlab.service.link.PanelFiles;
import org.myrobotlab.service.sear.SensorReading;
import org.myrobotlab.service.sear.files.Edits;
import org.myrobotlab.service.sear.files.ExampleScripts;
import org.myrobotlab.service.sear.files.ScriptCalls;
import org.myrobotlab.service.sear.panel.Preview;
import org.myrobotlab.service.sear.records.Plots;
import org.myrobotlab.service.sear.records.Recording;
import org.myrobotlab.service.sear.records.Records;
import org.myrobotlab.service.sear.run.RunParameters;
import org.myrobotlab.service.sear.run.SimulationSession;

/**
 * SEAR, the Simulation Environment for Autonomous Robots, as a MyRobotLab service: starts the world that the objects of {@code org.SEAR.POJOs}
 * have described, and answers for its sensors.
 *
 * <pre>
 * sear = Runtime.start("sear", "SEAR")
 * sear.startSimulation()
 * sear.driveStraight(0.2)
 * sear.simSleep(2)
 * print sear.getDistanceResult("Ping1")
 * sear.stopSimulation()
 * </pre>
 *
 * <p>Calls may come from any thread. What goes wrong is published as an error status and thrown (IllegalStateException, or
 * IllegalArgumentException for values), so that scripts see it; a running simulation goes on.
 */
public class SEAR extends OwnConfigService<SEARConfig> {
    private static final long serialVersionUID = 1L;

    static {
        PanelFiles.install();
    }

    private final transient SearCalls calls = new SearCalls(this);
    private transient SearParts parts;
    private boolean simulating;
    private boolean paused;
    private boolean recorded;

    /** As MyRobotLab makes services. */
    public SEAR(String name, String id) {
        super(name, id);
    }

    @Override
    protected Class<SEARConfig> configType() {
        return SEARConfig.class;
    }

    @Override
    public synchronized void startService() {
        super.startService();
        if (parts == null) {
            try {
                parts = new SearParts(new SearHost(this));
            } catch (LinkageError e) {
                error("%s", SearCalls.missing(e));
            }
        }
    }

    // ---- simulation ------------------------------------------------------------------------------------------------

    /**
     * Starts the world of the project folder, {@code SEARproject} in MyRobotLab's working folder.
     *
     * @throws IllegalStateException with every problem of the project; if a simulation runs already
     * @example sear.startSimulation()
     */
    public void startSimulation() {
        startSimulation(false);
    }

    /**
     * The same, with a look at the physics.
     *
     * @param debugShapes whether the window shows collision shapes, contact points and wheel rays
     * @throws IllegalStateException with every problem of the project; if a simulation runs already
     * @example sear.startSimulation(True)
     */
    public void startSimulation(boolean debugShapes) {
        calls.act(() -> parts.start(debugShapes));
        changed();
    }

    /**
     * Ends the simulation; ports, window and thread go away.
     *
     * @throws IllegalStateException if none runs
     * @example sear.stopSimulation()
     */
    public void stopSimulation() {
        calls.act(() -> {
            parts.control().session();
            parts.stop();
        });
        changed();
    }

    /**
     * Whether a simulation runs (a paused one too).
     *
     * @example if not sear.isSimulating(): sear.startSimulation()
     */
    public boolean isSimulating() {
        return parts != null && parts.control().isRunning();
    }

    /**
     * Whether beams of all sensors see floors and terrain in the next simulations; true unless set. False: they pass through all of them, as a real
     * ultrasonic beam glances off a smooth floor. A single one is hidden by its object, {@code floor.setVisibleToSensors(False)}.
     *
     * @throws IllegalStateException while a simulation runs
     * @example sear.setGroundVisible(False)
     */
    public void setGroundVisible(boolean on) {
        calls.act(() -> parts.control().setGroundVisible(on));
    }

    /**
     * On how many threads, that of the simulation included, sensors and cameras measure, in this and later simulations; as many as the computer has
     * processors unless set, here or with {@code sear --threads}. What they measure does not depend on it.
     *
     * @param number 1 to 256
     * @throws IllegalArgumentException for another number
     * @example sear.setThreads(1)
     */
    public void setThreads(int number) {
        calls.act(() -> parts.control().setThreads(number));
    }

    // ---- time (a simulation must run, except for the settings) -----------------------------------------------------

    /**
     * Waits so many simulated seconds; in lock-step it makes them pass.
     *
     * @param seconds 0 or more
     * @throws IllegalStateException if the simulation ends meanwhile, or the script that waits has paused it itself
     * @example sear.simSleep(0.5)
     */
    public void simSleep(double seconds) {
        calls.act(() -> parts.control().session().simSleep(seconds));
    }

    /**
     * Simulated seconds since start or reset.
     *
     * @example print "%.2f s" % sear.getTime()
     */
    public double getTime() {
        return calls.attempt(() -> parts.control().session().time());
    }

    /**
     * Time stands still until {@link #resume}.
     *
     * @example sear.pause()
     */
    public void pause() {
        calls.act(() -> parts.control().session().pause());
        changed();
    }

    /**
     * Ends {@link #pause}.
     *
     * @example sear.resume()
     */
    public void resume() {
        calls.act(() -> parts.control().session().resume());
        changed();
    }

    /**
     * Whether the simulation is paused.
     *
     * @example print sear.isPaused()
     */
    public boolean isPaused() {
        return paused;
    }

    /**
     * Advances by so many steps of 1/60 s; pauses a simulation whose time runs by itself.
     *
     * @param n steps, 1 or more
     * @example sear.step(60)
     */
    public void step(int n) {
        calls.act(() -> parts.control().session().step(n));
        changed();
    }

    /**
     * Everything back to the start, as a fresh start with the same seed.
     *
     * @example sear.reset()
     */
    public void reset() {
        calls.act(() -> parts.control().session().reset());
    }

    /**
     * How fast time passes, in this and later simulations.
     *
     * @param factor simulated seconds a second, 0.001 or more; 1 = real time, infinity = as fast as possible
     * @example sear.setSpeed(2)
     */
    public void setSpeed(double factor) {
        calls.act(() -> parts.control().setSpeed(factor));
    }

    /**
     * Whether simulated time advances only inside {@link #simSleep} and {@link #step}; holds for later simulations too.
     *
     * @example sear.setLockStep(True)
     */
    public void setLockStep(boolean on) {
        calls.act(() -> parts.control().setLockStep(on));
    }

    /**
     * Whether a simulation runs whose time advances only inside {@link #simSleep} and {@link #step}.
     *
     * @example print sear.isLockStep()
     */
    public boolean isLockStep() {
        SimulationSession session = parts == null ? null : parts.control().sessionOrNull();
        return session != null && session.isLockStep();
    }

    // ---- devices (a simulation must run) ---------------------------------------------------------------------------

    /**
     * Switches the power of a serial device, as its user does when a driver has left it in a state that the next one does not expect. Off: it is
     * silent, what it moves stands still, what comes for it is gone. On: as at power-on, with its first baud rate, no mode, no stream. A Create 2
     * says its boot message, a GPS receiver its own, an LMS200 starts for 5 simulated seconds and then sends its power-on telegram; its written
     * configuration and a permanent baud rate stay.
     *
     * @param name of the object with ports: a robot's Dynamics, a LIDAR, a GPS; {@code "robot/part"} where several robots have a part of that name
     * @throws IllegalArgumentException that names the devices there are
     * @example sear.power("myLidar", False); sear.power("myLidar", True)
     */
    public void power(String name, boolean on) {
        calls.act(() -> parts.control().session().power(ScriptText.of(name), on));
    }

    // ---- driving (a simulation must run) ---------------------------------------------------------------------------

    /**
     * Drives the first robot straight on, until the next command.
     *
     * @param speed m/s, + forward, -100 to 100; 0 stops
     * @example sear.driveStraight(0.3)
     */
    public void driveStraight(double speed) {
        driveStraight(null, speed);
    }

    /**
     * Drives a robot straight on, until the next command.
     *
     * @param robot its name
     * @param speed m/s, + forward, -100 to 100; 0 stops
     * @throws IllegalArgumentException that names the robots there are, or the legal range
     * @example sear.driveStraight("myRoomba", -0.1)
     */
    public void driveStraight(String robot, double speed) {
        calls.act(() -> parts.driving().give(robot, DriveOrder.straight(speed)));
    }

    /**
     * Turns the first robot in place, until the next command.
     *
     * @param degPerSecond degrees a second, + to the left (counter-clockwise from above), -3600 to 3600; 0 stops
     * @example sear.spin(45); sear.simSleep(2); sear.spin(0)
     */
    public void spin(double degPerSecond) {
        spin(null, degPerSecond);
    }

    /**
     * Turns a robot in place, until the next command.
     *
     * @param robot its name
     * @param degPerSecond degrees a second, + to the left (counter-clockwise from above), -3600 to 3600; 0 stops
     * @throws IllegalArgumentException that names the robots there are, or the legal range, or says that the robot has no two sides that are driven
     * @example sear.spin("myRoomba", -90)
     */
    public void spin(String robot, double degPerSecond) {
        calls.act(() -> parts.driving().give(robot, DriveOrder.spin(degPerSecond)));
    }

    /**
     * Sets the wheels of the first robot, until the next command.
     *
     * @param left m/s over ground of the driven wheels on the left, + forward, -100 to 100
     * @param right likewise on the right
     * @example sear.setWheelSpeeds(0.2, 0.25)
     */
    public void setWheelSpeeds(double left, double right) {
        setWheelSpeeds(null, left, right);
    }

    /**
     * Sets the wheels of a robot, until the next command.
     *
     * @param robot its name
     * @param left m/s over ground of the driven wheels on the left, + forward, -100 to 100
     * @param right likewise on the right
     * @throws IllegalArgumentException that names the robots there are, or the legal range
     * @example sear.setWheelSpeeds("myRoomba", 0, 0)
     */
    public void setWheelSpeeds(String robot, double left, double right) {
        calls.act(() -> parts.driving().give(robot, DriveOrder.wheels(left, right)));
    }

    /**
     * Drives the first robot along a circle, as the Roomba's own command does, until the next command. One with steered wheels steers to it, at
     * radius 0 as far as they turn.
     *
     * @param speed m/s, + forward, -100 to 100
     * @param radius metres, + to the left; infinity = straight, 0 = in place to the left
     * @example sear.drive(0.2, 0.5)
     */
    public void drive(double speed, double radius) {
        drive(null, speed, radius);
    }

    /**
     * Drives a robot along a circle. One with steered wheels steers to it, at radius 0 as far as they turn.
     *
     * @param robot its name
     * @param speed m/s, + forward, -100 to 100
     * @param radius metres, + to the left; infinity = straight, 0 = in place to the left
     * @throws IllegalArgumentException that names the robots there are, or the legal range
     * @example sear.drive("myRoomba", 0.2, float("inf"))
     */
    public void drive(String robot, double speed, double radius) {
        calls.act(() -> parts.driving().give(robot, DriveOrder.circle(speed, radius)));
    }

    /**
     * Steers the first robot by its steered wheels, until the next order.
     *
     * @param degrees of a wheel in the middle between left and right, + to the left; the inner wheel turns farther, the outer one less
     * @example sear.setSteering(-10)
     */
    public void setSteering(double degrees) {
        setSteering(null, degrees);
    }

    /**
     * Steers a robot by its steered wheels, until the next order.
     *
     * @param robot its name
     * @param degrees of a wheel in the middle between left and right, + to the left; the inner wheel turns farther, the outer one less
     * @throws IllegalArgumentException that names the robots there are, or the legal range, or says that it has no steered wheels
     * @example sear.setSteering("car", 20)
     */
    public void setSteering(String robot, double degrees) {
        calls.act(() -> parts.driving().steer(robot, degrees));
    }

    // ---- motors, servos and lights (a simulation must run; the examples are of the car of vehicles.md) ---------------------

    /**
     * Gives a motor power, until the next order for it or for its robot. Its torque is stallTorque (power - speed / noLoadSpeed).
     *
     * @param name of the motor; {@code "robot/motor"} where several robots have one of that name
     * @param power share of the full voltage, + forward, -1 to 1; 0 brakes, as a motor does whose wires are joined
     * @throws IllegalArgumentException that names the motors there are, or the legal range
     * @example sear.setMotorPower("engine", 0.5)
     */
    public void setMotorPower(String name, double power) {
        calls.act(() -> parts.actuators().power(name, power));
    }

    /**
     * Has a motor's controller hold a speed, as far as its torque goes, until the next order for it or for its robot.
     *
     * @param name of the motor; {@code "robot/motor"} where several robots have one of that name
     * @param speed of its wheels, rad/s, + forward; at most what they reach without load
     * @throws IllegalArgumentException that names the motors there are, or the legal range
     * @example sear.setMotorSpeed("engine", 6.5)
     */
    public void setMotorSpeed(String name, double speed) {
        calls.act(() -> parts.actuators().speed(name, speed));
    }

    /**
     * How fast a motor's wheels turn now, rad/s, + forward; the mean of several.
     *
     * @param name of the motor
     * @throws IllegalArgumentException that names the motors there are
     * @example print "%.2f rad/s" % sear.getMotorSpeed("engine")
     */
    public double getMotorSpeed(String name) {
        return calls.attempt(() -> parts.actuators().speed(name));
    }

    /**
     * What a motor's encoder has counted since start or reset, + forward; 0 for a motor without one.
     *
     * @param name of the motor
     * @throws IllegalArgumentException that names the motors there are
     * @example print sear.getEncoder("engine"), "counts"
     */
    public long getEncoder(String name) {
        return calls.attempt(() -> parts.actuators().counts(name));
    }

    /**
     * Has a servo turn to an angle, as fast as it can, and with it what is mounted on it.
     *
     * @param name of the servo; {@code "robot/servo"} where several robots have one of that name
     * @param degrees within the servo's range, + counter-clockwise seen from above
     * @throws IllegalArgumentException that names the servos there are, or the legal range
     * @example sear.setServo("neck", 45)
     */
    public void setServo(String name, double degrees) {
        calls.act(() -> parts.actuators().angle(name, degrees));
    }

    /**
     * Where a servo is now, degrees, + counter-clockwise seen from above.
     *
     * @param name of the servo
     * @throws IllegalArgumentException that names the servos there are
     * @example print "%.1f degrees" % sear.getServo("neck")
     */
    public double getServo(String name) {
        return calls.attempt(() -> parts.actuators().angle(name));
    }

    /**
     * Has a light shine, until the next order for it; one that is wired to an Arduino, until the board writes to its pin.
     *
     * @param name of the led; {@code "robot/led"} where several robots have one of that name
     * @param brightness 0 (dark) to 1
     * @throws IllegalArgumentException that names the leds there are, or the legal range
     * @example sear.setLed("lamp", 0.5)
     */
    public void setLed(String name, double brightness) {
        calls.act(() -> parts.actuators().brightness(name, brightness));
    }

    /**
     * How bright a light shines now, 0 to 1.
     *
     * @param name of the led
     * @throws IllegalArgumentException that names the leds there are
     * @example print "%.0f %%" % (100 * sear.getLed("lamp"))
     */
    public double getLed(String name) {
        return calls.attempt(() -> parts.actuators().brightness(name));
    }

    // ---- things that are thrown and pushed (a simulation must run) -------------------------------------------------

    /**
     * Pushes a thing or a robot at its centre of mass with a force, from the next step on, whatever direction it looks in. The call returns at once.
     * Several pushes add up; what slept wakes.
     *
     * @param name of a thing with a mass, or of a robot
     * @param force {@code [x, y, z]} in N along the world's axes: north, up, east
     * @param seconds simulated, above 0, at most 3600
     * @throws IllegalArgumentException if nothing of that name can move, or the force is too strong for its mass (1000 m/s more in a step)
     * @example sear.push("crate 1", [50, 0, 0], 0.2)
     */
    public void push(String name, List<?> force, double seconds) {
        calls.act(() -> parts.bodies().push(name, force, seconds));
    }

    /**
     * Gives a thing or a robot a velocity at once, between two steps. Files and the next start stay as they are: {@code crate.setVelocity(x, y, z)}
     * before the start says what a thing starts with.
     *
     * @param name of a thing with a mass, or of a robot
     * @param x m/s of its centre of mass along the world's x, north, -1000 to 1000
     * @param y upwards
     * @param z along the world's z, east
     * @throws IllegalArgumentException if nothing of that name can move, or with the legal range
     * @example sear.setVelocity("crate 1", 0.5, 2, 0)
     */
    public void setVelocity(String name, double x, double y, double z) {
        calls.act(() -> parts.bodies().velocity(name, x, y, z));
    }

    /**
     * Has a thing or a robot turn about its centre of mass at once, between two steps.
     *
     * @param name of a thing with a mass, or of a robot
     * @param x degrees a second about the world's x, by the right hand, -100000 to 100000
     * @param y about the world's y, counter-clockwise seen from above
     * @param z about the world's z
     * @throws IllegalArgumentException if nothing of that name can move, or with the legal range
     * @example sear.setSpin("crate 1", 0, 90, 0)
     */
    public void setSpin(String name, double x, double y, double z) {
        calls.act(() -> parts.bodies().spin(name, x, y, z));
    }

    /**
     * Pulls a thing or a robot by a spring, as the mouse does in SEAR's tab: with at most five times its weight. It lets go when this is not called
     * again within 1.5 s of the clock, or by {@link #letGo}.
     *
     * @param name of a thing with a mass, or of a robot
     * @param way {@code [x, y, z]} where to, metres along the world's axes from where it was at the first call
     * @throws IllegalArgumentException if nothing of that name can move
     * @example sear.hold("crate 1", [0, 0.5, 0])
     */
    public void hold(String name, List<?> way) {
        calls.act(() -> parts.bodies().hold(name, way));
    }

    /**
     * Lets go what {@link #hold} holds; of what is not held nothing happens.
     *
     * @param name of the thing or robot
     * @example sear.letGo("crate 1")
     */
    public void letGo(String name) {
        calls.act(() -> parts.bodies().letGo(name));
    }

    // ---- reading (a simulation must run) ---------------------------------------------------------------------------

    /**
     * Names of all sensors, as the calls below take them. Where several robots have a sensor of one name it is {@code "robot/sensor"}, for example
     * {@code "rover/ping"}, which is legal for every other sensor and part, too.
     *
     * @example print ", ".join(sear.getSensorNames())
     */
    public List<String> getSensorNames() {
        return calls.attempt(() -> parts.readings().names());
    }

    /**
     * What any sensor reads now, one from another jar, too: what the call for its kind answers, which is named below. An odometer is not cleared
     * by it.
     *
     * @param name of the sensor
     * @throws IllegalArgumentException that names the sensors there are
     * @example print sear.getReading("frontPing"), sear.getSensorUnit("frontPing")
     */
    public Object getReading(String name) {
        return calls.attempt(() -> parts.readings().any(name));
    }

    /**
     * The unit of a sensor's reading, for example {@code m}, {@code deg}, {@code m/s2}, {@code rad/s}; {@code deg, deg, m} for a GPS; empty if it has
     * none.
     *
     * @param name of the sensor
     * @throws IllegalArgumentException that names the sensors there are
     * @example print sear.getSensorUnit("compass")
     */
    public String getSensorUnit(String name) {
        return calls.attempt(() -> parts.readings().unit(name));
    }

    /**
     * Metres to the nearest hit of a distance sensor; its range where nothing was hit.
     *
     * @param name of the sensor
     * @throws IllegalArgumentException that names the sensors there are, and what they are
     * @example print "%.2f m ahead" % sear.getDistanceResult("frontPing")
     */
    public double getDistanceResult(String name) {
        return calls.attempt(() -> parts.readings().distance(name));
    }

    /**
     * Metres of a LIDAR's beams, right to left; its range where nothing was hit.
     *
     * @param name of the sensor
     * @throws IllegalArgumentException that names the sensors there are, and what they are
     * @example print "%.2f m" % min(sear.getLidarResult("myLidar"))
     */
    public float[] getLidarResult(String name) {
        return calls.attempt(() -> parts.readings().scan(name));
    }

    /**
     * Where the beams of a LIDAR point, in the order of its ranges.
     *
     * @param name of the sensor
     * @return an angle for each: degrees from straight ahead, + to the left
     * @throws IllegalArgumentException that names the sensors there are
     * @example print sear.getLidarAngles("myLidar")[0]
     */
    public double[] getLidarAngles(String name) {
        return calls.attempt(() -> parts.readings().angles(name));
    }

    /**
     * [latitude, longitude, altitude] of a GPS sensor: degrees, + north; degrees, + east; metres.
     *
     * @param name of the sensor
     * @throws IllegalArgumentException that names the sensors there are, and what they are
     * @example latitude, longitude, altitude = sear.getGpsResult("gpsUnit1")
     */
    public double[] getGpsResult(String name) {
        return calls.attempt(() -> parts.readings().position(name));
    }

    /**
     * Degrees of a compass, clockwise from north, (-180, 180].
     *
     * @param name of the sensor
     * @throws IllegalArgumentException that names the sensors there are, and what they are
     * @example print "%.0f degrees" % sear.getCompassResult("compass")
     */
    public double getCompassResult(String name) {
        return calls.attempt(() -> parts.readings().heading(name));
    }

    /**
     * "x,y,z" of an accelerometer, m/s^2, in the sensor's axes: x left, y up, z forward unless it is turned.
     *
     * @param name of the sensor
     * @throws IllegalArgumentException that names the sensors there are, and what they are
     * @example ax, ay, az = [float(a) for a in sear.getAccelResult("accel").split(",")]
     */
    public String getAccelResult(String name) {
        return calls.attempt(() -> parts.readings().acceleration(name));
    }

    /**
     * "x,y,z" of a gyroscope, rad/s, in the sensor's axes as for an accelerometer; a turn to the left is + y.
     *
     * @param name of the sensor
     * @throws IllegalArgumentException that names the sensors there are, and what they are
     * @example turning = float(sear.getGyroResult("gyro").split(",")[1])
     */
    public String getGyroResult(String name) {
        return calls.attempt(() -> parts.readings().rates(name));
    }

    /**
     * Signed path of the first robot's centre, metres: since the last call if it has an Odometer object (which counts to 32.767 m, as a Roomba's),
     * else since start or reset.
     *
     * @example print "%.3f m" % sear.getOdomResult()
     */
    public double getOdomResult() {
        return getOdomResult(null);
    }

    /**
     * The same of a robot by name.
     *
     * @param robot its name
     * @throws IllegalArgumentException that names the robots there are
     * @example print "%.3f m" % sear.getOdomResult("myRoomba")
     */
    public double getOdomResult(String robot) {
        return calls.attempt(() -> parts.readings().odometer(robot));
    }

    // ---- cameras (a simulation must run; the examples are of the robot of cameras.md) ----------------------------------------------

    /**
     * The last picture of a camera as a PNG file: colours, or 16 bits of grey that are millimetres of depths (0: no return) or hundredths of a kelvin
     * of temperatures. A picture is taken at the camera's rate; this is the last one that was due.
     *
     * @param name of the camera
     * @throws IllegalArgumentException that names the cameras there are
     * @example print len(sear.getImage("eye")), "bytes"
     */
    public byte[] getImage(String name) {
        return calls.attempt(() -> parts.cameras().png(name));
    }

    /**
     * The pixels of a camera's last picture, row by row from the top left: each one number, 0xRRGGBB (sRGB). Depths and temperatures are in false
     * colours, from red, near or warm, to blue.
     *
     * @param name of the camera
     * @throws IllegalArgumentException that names the cameras there are
     * @example pixel = sear.getPixels("eye")[120 * 320 + 160]; print "#%06x" % pixel
     */
    public int[] getPixels(String name) {
        return calls.attempt(() -> parts.cameras().pixels(name));
    }

    /**
     * The depths of a depth camera's last picture, row by row from the top left: metres along its axis, infinite where nothing came back.
     *
     * @param name of the camera
     * @throws IllegalArgumentException that names the cameras there are, or says that it is of another kind
     * @example print "%.2f m ahead" % min(sear.getDepth("kinect"))
     */
    public float[] getDepth(String name) {
        return calls.attempt(() -> parts.cameras().depths(name));
    }

    /**
     * The temperatures of an infrared camera's last picture, row by row from the top left: degrees Celsius.
     *
     * @param name of the camera
     * @throws IllegalArgumentException that names the cameras there are, or says that it is of another kind
     * @example print "%.1f degrees at most" % max(sear.getTemperatures("thermal"))
     */
    public float[] getTemperatures(String name) {
        return calls.attempt(() -> parts.cameras().temperatures(name));
    }

    /**
     * The points at which a depth camera's last picture ends, in its own frame: x, y, z of each, metres to the left, up and ahead. Pixels without a
     * return have no point.
     *
     * @param name of the camera
     * @throws IllegalArgumentException that names the cameras there are, or says that it is of another kind
     * @example points = sear.getPointCloud("kinect"); print len(points) / 3, "points"
     */
    public float[] getPointCloud(String name) {
        return getPointCloud(name, false);
    }

    /**
     * The same in the frame of the camera or of the world.
     *
     * @param name of the camera
     * @param world True for metres north, up and east in the world at the time of the picture; False for the camera's own frame
     * @throws IllegalArgumentException that names the cameras there are, or says that it is of another kind
     * @example points = sear.getPointCloud("kinect", True); print "the highest point is at %.2f m" % max(points[1::3])
     */
    public float[] getPointCloud(String name, boolean world) {
        return calls.attempt(() -> parts.cameras().points(name, world));
    }

    /**
     * What has the hue of a colour in a camera's last picture, as a Pixy tells it: a list of [x, y, width, height, area], the largest first. x and y
     * are the middle of the box around it, pixels from the top left; area is how many pixels it has. The light hardly matters.
     *
     * @param name of the camera
     * @param color a name such as {@code "red"}, or {@code "#rrggbb"}; grey has no hue
     * @throws IllegalArgumentException that names the cameras there are, or says that it is of another kind or the colour has no hue
     * @example for x, y, width, height, area in sear.getBlobs("eye", "red"): print "at column %.0f" % x
     */
    public List<double[]> getBlobs(String name, String color) {
        return calls.attempt(() -> parts.cameras().blobs(name, color));
    }

    /**
     * Writes a camera's last picture into a file, as {@link #getImage} answers it. Folders on the way are made.
     *
     * @param name of the camera
     * @param path of the file, which ends with {@code .png}; relative to MyRobotLab's working folder
     * @throws IllegalArgumentException that names the cameras there are
     * @throws IllegalStateException if it can't be written
     * @example sear.saveImage("eye", "eye.png")
     */
    public void saveImage(String name, String path) {
        calls.act(() -> parts.cameras().save(name, path));
    }

    // ---- where things are (a simulation must run) ------------------------------------------------------------------

    /**
     * [x, y, z, rx, ry, rz] in the world of a robot, part, sensor or object: metres north, up and east, degrees about the three axes. The heading of
     * what stands upright is 90 - ry.
     *
     * @param name of the robot, part, sensor or object; {@code "robot/part"} where several robots have a part of that name
     * @throws IllegalArgumentException if there is none of that name, or on several robots, which it names
     * @example x, y, z, rx, ry, rz = sear.getPose("myRoomba")
     */
    public double[] getPose(String name) {
        return calls.attempt(() -> parts.readings().pose(name));
    }

    /**
     * The ground's height at a point of the world: its y, metres. Ground is the terrain, a floor, or a model that is the terrain; where one lies over
     * the other, the highest. While no simulation runs it is that of the project as it is.
     *
     * @param x metres north of the world's origin
     * @param z metres east of it
     * @throws IllegalArgumentException if there is no ground
     * @example y = sear.getGroundHeight(2.0, -1.5)
     */
    public double getGroundHeight(double x, double z) {
        return calls.attempt(() -> parts.readings().groundHeight(x, z));
    }

    /**
     * The plan of the world as a picture: from above, north upwards, with the names of things, robots as arrows that say their headings, the beams of
     * distance sensors and LIDARs up to what they meet, a scale, and the time. Before the start, of the project as it is.
     *
     * @return the text of an SVG file
     * @throws IllegalStateException with every problem of a project that does not run
     * @example print len(sear.getPlan()), "characters"
     */
    public String getPlan() {
        return getPlan(true);
    }

    /**
     * The same with or without beams.
     *
     * @param beams whether they are drawn; no reading is changed by it
     * @throws IllegalStateException with every problem of a project that does not run
     * @example print len(sear.getPlan(False)), "characters"
     */
    public String getPlan(boolean beams) {
        return calls.attempt(() -> parts.plans().svg(beams));
    }

    /**
     * Draws the plan into a file.
     *
     * @param picture a file whose name ends in .png or .svg; one of that name is replaced
     * @throws IllegalStateException with every problem of a project that does not run
     * @example sear.savePlan("plan.png")
     */
    public void savePlan(String picture) {
        calls.act(() -> parts.plans().save(picture));
    }

    // ---- readings that come by themselves --------------------------------------------------------------------------

    /**
     * Comes with each reading: its name, time (simulated seconds) and value, which is what {@link #getReading} answers.
     *
     * @example sear.addListener("publishReading", python.getName(), "onGuideReading")
     */
    public SensorReading publishReading(SensorReading reading) {
        return reading;
    }

    /**
     * Comes with each picture of a camera that {@link #startPublishing} was called for, as MyRobotLab's services hand pictures on: {@code name} is
     * the camera, {@code src} an address that a page shows, {@code data:image/png;base64,...}.
     *
     * @example sear.addListener("publishImage", python.getName(), "onEyeImage")
     */
    public ImageData publishImage(ImageData image) {
        return image;
    }

    /**
     * Publishes a sensor's readings again and again, for those who subscribe to publishReading.
     *
     * @param sensor its name
     * @param rate readings a simulated second, above 0 to 60
     * @throws IllegalArgumentException that names the sensors there are, or the legal range
     * @example sear.startPublishing("frontPing", 10)
     */
    public void startPublishing(String sensor, double rate) {
        calls.act(() -> parts.publisher().start(sensor, rate));
    }

    /**
     * Ends {@link #startPublishing}.
     *
     * @param sensor its name
     * @example sear.stopPublishing("frontPing")
     */
    public void stopPublishing(String sensor) {
        calls.act(() -> parts.publisher().stop(sensor));
    }

    // ---- projects (no simulation may run, except to save and to check) ---------------------------------------------

    /**
     * Begins an empty project; the present one is kept.
     *
     * @return where it was put; None if there was none, or only an example that nobody has changed
     * @throws IllegalStateException while a simulation runs
     * @example sear.newProject()
     */
    public String newProject() {
        return calls.attempt(() -> text(parts.projects().restart()));
    }

    /**
     * Saves the project as a bundle. A file of that name is replaced.
     *
     * @param path for example {@code "robot.sear"}; the ending .sear may be left out, its folder must be there
     * @throws IllegalStateException if it can't be written
     * @example sear.saveProject("mine.sear")
     */
    public void saveProject(String path) {
        calls.act(() -> parts.projects().save(bundle(path)));
    }

    /**
     * Saves the project as a bundle, and of the terrain's elevation maps only the area that is used, so that it is small. The project stays as it is.
     *
     * @param path as for {@link #saveProject(String)}
     * @param cutTerrain True: only the area that setArea names goes along, as one GeoTIFF; False: all of the maps
     * @throws IllegalStateException if it can't be written
     * @example sear.saveProject("mountain.sear", True)
     */
    public void saveProject(String path, boolean cutTerrain) {
        calls.act(() -> {
            if (cutTerrain) {
                parts.projects().saveCut(bundle(path));
            } else {
                parts.projects().save(bundle(path));
            }
        });
    }

    /**
     * Replaces the project by a bundle's, or a copy of a project folder, once that is read whole and valid; the present one is kept as backup.
     *
     * @param path a bundle or a folder; {@code "examples/NAME.sear"} for those that come with SEAR, in every working folder
     * @throws IllegalStateException with every problem of the project; while a simulation runs
     * @example sear.loadProject("examples/office.sear")
     */
    public void loadProject(String path) {
        calls.act(() -> parts.projects().load(bundle(path)));
    }

    /**
     * Adds a robot of a bundle or project folder to the present project, which is kept as backup. Names and ports that are taken get a number; parts
     * keep their names, and where another robot has one of that name both are {@code "robot/part"}.
     *
     * @param path a bundle or a folder
     * @param name the robot's name there; None or empty if it is the only one
     * @return its name here
     * @throws IllegalStateException with every problem of the project; while a simulation runs
     * @example second = sear.importRobot("examples/maze.sear", "maze Roomba")
     */
    public String importRobot(String path, String name) {
        return calls.attempt(() -> parts.projects().importRobot(bundle(path), name == null ? null : ScriptText.of(name)));
    }

    /**
     * Adds the environment of a bundle or project folder to the present project, as {@link #importRobot} a robot.
     *
     * @param path a bundle or a folder
     * @return the objects' names here
     * @throws IllegalStateException with every problem of the project; while a simulation runs
     * @example walls = sear.importEnvironment("examples/maze.sear")
     */
    public List<String> importEnvironment(String path) {
        return calls.attempt(() -> parts.projects().importEnvironment(bundle(path)));
    }

    /**
     * What is wrong with the project: file, line, field, value, what is legal; empty if nothing.
     *
     * @example for problem in sear.getProblems(): print problem
     */
    public List<Problem> getProblems() {
        return calls.attempt(() -> parts.problems());
    }

    /**
     * Checks the project as {@code sear check} does: builds its world, and takes a step in it, apart from any simulation that runs.
     *
     * @return {@code problems} that keep it from starting, as {@link #getProblems} has them, and {@code warnings}, what the start would warn of: a
     *         robot that tips over, one without ground below it
     * @example for warning in sear.checkProject()["warnings"]: print warning
     */
    public Map<String, Object> checkProject() {
        return calls.attempt(() -> parts.check());
    }

    /**
     * The Python script that makes the project's objects. Run in another project with the same assets and beams, or in this one, it gives the same
     * files to the byte.
     *
     * @throws IllegalStateException with every problem of the project
     * @example print sear.getScript()
     */
    public String getScript() {
        return calls.attempt(() -> parts.projects().script());
    }

    /**
     * Copies a template into a folder.
     *
     * @param name {@code controller.py}, {@code userCode.py} or {@code arduino.py}
     * @param folder is made if it is missing
     * @return the copy's path
     * @throws IllegalStateException if there is such a file already
     * @example print sear.copyTemplate("controller.py", "SEARproject")
     */
    public String copyTemplate(String name, String folder) {
        return calls.attempt(() -> text(parts.projects().copyTemplate(name, folder)));
    }

    /**
     * Names of the example scripts that drive a robot, each with its project.
     *
     * @example print ", ".join(sear.getExampleScripts())
     */
    public List<String> getExampleScripts() {
        return calls.attempt(() -> ExampleScripts.names());
    }

    /**
     * The text of an example script.
     *
     * @param name one of {@link #getExampleScripts}
     * @throws IllegalArgumentException that names those there are
     * @example code = sear.getExampleScript("maze_solver.py")
     */
    public String getExampleScript(String name) {
        return calls.attempt(() -> ExampleScripts.text(ScriptText.of(name)));
    }

    // ---- records of runs -------------------------------------------------------------------------------------------

    /**
     * Records a run into a file: poses, readings, commands and the bytes of every port, until {@link #endRecord}, stopSimulation or 512 MB. If
     * nothing runs, from the next start on. Only a record from the start of its run, or from a reset, can be run again.
     *
     * @param path for example {@code "run.searlog"}; the ending may be left out. Another record of that name is replaced, no other file
     * @return the path with its ending
     * @throws IllegalStateException if it can't be written, or one is being written already
     * @example sear.recordRun("run.searlog"); sear.endRecord()
     */
    public String recordRun(String path) {
        return recordRun(path, Recording.MEGABYTES);
    }

    /**
     * The same up to another size.
     *
     * @param path of the file
     * @param megabytes above 0; there the record ends by itself, whole, and a warning says so
     * @example sear.recordRun("run.searlog", 20); sear.endRecord()
     */
    public String recordRun(String path, double megabytes) {
        return recordRun(path, megabytes, 0);
    }

    /**
     * The same with the pictures of all cameras, which a replay in the tab shows.
     *
     * @param path of the file
     * @param megabytes above 0; there the record ends by itself, whole, and a warning says so
     * @param pictures of each camera a simulated second, 0 to 30, as far as it takes so many
     * @example sear.recordRun("run.searlog", 200, 5); sear.endRecord()
     */
    public String recordRun(String path, double megabytes, double pictures) {
        String file = calls.attempt(() -> parts.recording().begin(ScriptText.of(path), megabytes, pictures));
        changed();
        return file;
    }

    /**
     * Ends the record that is being written.
     *
     * @return simulated seconds that it has
     * @throws IllegalStateException if there is none, or it could not be written to its end
     * @example sear.recordRun("run.searlog"); sear.simSleep(1); print sear.endRecord()
     */
    public double endRecord() {
        double seconds = calls.attempt(() -> parts.recording().end());
        changed();
        return seconds;
    }

    /**
     * Gives the commands of a record to a fresh world of the present project, apart from any simulation that runs, and compares what comes out.
     *
     * @param path of a record from the start of its run
     * @return {@code same}: whether every port gave the same bytes and everything was where it had been, {@code seconds}: simulated, {@code ports}:
     *     by port, in words, {@code apart}: how far something was at most from where it had been, metres
     * @throws IllegalStateException if it is no record, of another project, or not from the start
     * @example sear.reset(); sear.recordRun("run.searlog"); sear.simSleep(1); sear.endRecord(); print sear.rerunRecord("run.searlog")["same"]
     */
    public Map<String, Object> rerunRecord(String path) {
        return calls.attempt(() -> parts.records().rerun(path, parts.control().getFolder()));
    }

    /**
     * Names of the values over time in a record: places and speeds of robots, places of objects, numbers of readings, commands, bytes so far.
     *
     * @param path of a record
     * @throws IllegalStateException if it is none
     * @example sear.recordRun("run.searlog"); sear.endRecord(); print ", ".join(sear.getRecordNames("run.searlog"))
     */
    public List<String> getRecordNames(String path) {
        return calls.attempt(() -> Records.names(path));
    }

    /**
     * Values of a record over time, 30 a second, or so much fewer that there are at most 4000.
     *
     * @param path of a record
     * @param names of {@link #getRecordNames}
     * @return {@code times}: simulated seconds since it began, {@code values}: by name a list as long, None where there is no number
     * @throws IllegalArgumentException that names the values there are
     * @example sear.recordRun("run.searlog"); sear.simSleep(1); sear.endRecord(); print sear.getRecordValues("run.searlog", ["myRoomba.x"])["times"]
     */
    public Map<String, Object> getRecordValues(String path, List<String> names) {
        return calls.attempt(() -> parts.records().values(path, names));
    }

    /**
     * Writes values of a record as a table, 30 lines a second, at most 200000.
     *
     * @param path of a record
     * @param names of {@link #getRecordNames}
     * @param csv a new file, or one whose name ends in .csv, which is replaced
     * @throws IllegalArgumentException that names the values there are
     * @example sear.recordRun("run.searlog"); sear.simSleep(1); sear.endRecord(); sear.saveRecordCsv("run.searlog", ["myRoomba.x"], "run.csv")
     */
    public void saveRecordCsv(String path, List<String> names, String csv) {
        calls.act(() -> parts.records().saveCsv(path, names, csv));
    }

    /**
     * Draws values of a record over time as a picture; those of one unit share an axis.
     *
     * @param path of a record
     * @param names of {@link #getRecordNames}, up to 16
     * @param picture a file whose name ends in .png or .svg; one of that name is replaced
     * @throws IllegalArgumentException that names the values there are
     * @example sear.recordRun("run.searlog"); sear.simSleep(1); sear.endRecord(); sear.saveRecordPlot("run.searlog", ["myRoomba.x"], "run.png")
     */
    public void saveRecordPlot(String path, List<String> names, String picture) {
        calls.act(() -> parts.savePlot(path, names, picture));
    }

    /**
     * Draws a list of numbers over another as a picture. A unit in brackets stands behind the names of both axes. No simulation has to run.
     *
     * @param picture a file whose name ends in .png or .svg; one of that name is replaced
     * @param xTitle name of the axis to the right
     * @param xs its numbers
     * @param yTitle name of the axis upwards
     * @param ys as many numbers; None leaves a gap
     * @throws IllegalArgumentException that names the list that has too many, too few or other things than numbers
     * @example sear.savePlot("run.png", "time (s)", [0, 1, 2], "distance (m)", [1.2, 0.9, 0.7])
     */
    public void savePlot(String picture, String xTitle, List<?> xs, String yTitle, List<?> ys) {
        calls.act(() -> Plots.save(picture, xTitle, xs, Collections.singletonMap(yTitle == null ? "" : yTitle, ys)));
    }

    /**
     * The same with several lines; those whose names end in the same unit share an axis.
     *
     * @param picture a file whose name ends in .png or .svg; one of that name is replaced
     * @param xTitle name of the axis to the right
     * @param xs its numbers
     * @param lines lists of as many numbers by name, up to 16
     * @throws IllegalArgumentException that names the list that has too many, too few or other things than numbers
     * @example sear.savePlot("run.svg", "time (s)", [0, 1, 2], {"left (m)": [1, 2, 2.5], "right (m)": [1, 1.5, 3], "speed (m/s)": [0, 0.3, 0.3]})
     */
    public void savePlot(String picture, String xTitle, List<?> xs, Map<String, ?> lines) {
        calls.act(() -> Plots.save(picture, xTitle, xs, lines));
    }

    // ---- ports for other programs (before, while and after a simulation runs) -------------------------------------

    /**
     * Lets any program on this computer open a virtual port, as a pseudo-terminal (Linux, macOS). An export belongs to the port's name: it may be
     * made before the start, and stays when the simulation stops, silent until one with such a port runs again. Asked for again, it is the same one.
     *
     * @param userPort the port's name, for example {@code "/dev/SEAR_LIDAR_01"}
     * @return the path to open
     * @throws IllegalStateException if the running simulation has no such port, or it is in use
     * @example path = sear.exportPort("/dev/SEAR_LIDAR_01")
     */
    public String exportPort(String userPort) {
        return exportPort(userPort, null);
    }

    /**
     * The same, by a path that stays.
     *
     * @param userPort the port's name
     * @param link path of a symbolic link that is to lead to the pseudo-terminal, so that its name stays the same; one that an earlier run has
     *     left is replaced, anything else of that name is not touched
     * @return the path to open
     * @throws IllegalStateException if the running simulation has no such port, or it is in use, or something else has the link's name
     * @example path = sear.exportPort("/dev/SEAR_GPS_01", "ttyGPS")
     */
    public String exportPort(String userPort, String link) {
        return calls.attempt(() -> parts.exports().terminal(ScriptText.of(userPort), ScriptText.of(link)));
    }

    /**
     * The same as a TCP server on the loopback address, raw bytes, on every system. It has no baud rate: the device's own holds.
     *
     * @param userPort the port's name
     * @param number TCP port, 0 for any free one
     * @return the number
     * @throws IllegalStateException if the running simulation has no such port, or it is in use, or the number is
     * @example number = sear.exportTcp("/dev/SEAR_Robot_01", 0)
     */
    public int exportTcp(String userPort, int number) {
        return calls.attempt(() -> parts.exports().tcp(ScriptText.of(userPort), number));
    }

    /**
     * The same as a TCP server that speaks RFC 2217, by which a program sets the baud rate: pyserial's {@code rfc2217://localhost:5002}.
     *
     * @param userPort the port's name
     * @param number TCP port, 0 for any free one
     * @return the number
     * @throws IllegalStateException if the running simulation has no such port, or it is in use, or the number is
     * @example number = sear.exportRfc2217("/dev/SEAR_LIDAR_01", 0)
     */
    public int exportRfc2217(String userPort, int number) {
        return calls.attempt(() -> parts.exports().rfc2217(ScriptText.of(userPort), number));
    }

    /**
     * The exports that there are: the names of ports and cameras, each with what programs open in words, those of {@code setExport} too.
     *
     * @example for port, ways in sear.getExports().items(): print port, "is", ", ".join(ways)
     */
    public Map<String, List<String>> getExports() {
        return calls.attempt(() -> parts.allExports());
    }

    /**
     * Ends all exports of a port.
     *
     * @param userPort the port's name
     * @throws IllegalArgumentException that names the exported ports
     * @example sear.exportPort("/dev/SEAR_GPS_01"); sear.endExport("/dev/SEAR_GPS_01")
     */
    public void endExport(String userPort) {
        calls.act(() -> parts.exports().end(ScriptText.of(userPort)));
    }

    // ---- network cameras (before, while and after a simulation runs; the examples are of the robot of cameras.md) ---

    /**
     * Makes a camera a network camera: programs on this computer find MJPEG at {@code http://localhost:PORT/stream.mjpg} and a picture at
     * {@code /image.jpg}, and depths as 16-bit PNG at {@code /depth.png}; docs/cameras.md lists the addresses. As with ports it may be made before
     * the start, and stays when the simulation stops, silent, until one with such a camera runs again.
     *
     * @param name the camera's name
     * @param number TCP port, 0 for any free one
     * @return the number
     * @throws IllegalArgumentException that names the cameras there are, if the running simulation has no such camera
     * @throws IllegalStateException if the port is in use
     * @example number = sear.exportCamera("eye", 0)
     */
    public int exportCamera(String name, int number) {
        return calls.attempt(() -> parts.networkCameras().plain(name, number));
    }

    /**
     * The same, with the addresses of a product beside its own, so that programs for that one find them.
     *
     * @param name the camera's name
     * @param number TCP port, 0 for any free one
     * @param product {@code "ESP32-CAM"} ({@code /capture}, and {@code /stream} at the port after this one) or {@code "OctoPi"}
     *     ({@code /?action=snapshot} and {@code /?action=stream}, as mjpg-streamer has them)
     * @return the number
     * @throws IllegalArgumentException that names the cameras there are, if the running simulation has no such camera, or the products
     * @throws IllegalStateException if a port is in use
     * @example number = sear.exportCamera("eye", 0, "ESP32-CAM")
     */
    public int exportCamera(String name, int number, String product) {
        return calls.attempt(() -> parts.networkCameras().like(name, number, product));
    }

    /**
     * Ends all exports of a camera, with the connections of those who look.
     *
     * @param name the camera's name
     * @throws IllegalArgumentException that names the exported cameras
     * @example sear.exportCamera("eye", 0); sear.stopExportCamera("eye")
     */
    public void stopExportCamera(String name) {
        calls.act(() -> parts.networkCameras().end(name));
    }

    // ---- parameters and results of a run (with or without a simulation; see sweeps.md) ----------------------------------------

    /**
     * What this run of the script is to be made with: {@code sear SCRIPT.py --set speed=0.2} gives it, and {@code sear sweep} each value in turn.
     *
     * @param name letters, digits and _; "seed" answers where the random numbers of the sensors begin
     * @param standard what it is unless one was given: a number, a text, True or False; what was given has to be of the same kind
     * @throws IllegalArgumentException that names parameter, value and what is legal
     * @example speed = sear.getParameter("speed", 0.3)
     */
    public Object getParameter(String name, Object standard) {
        return calls.attempt(() -> RunParameters.get(name, standard));
    }

    /**
     * Says what has come of this run: a column in the table of {@code sear sweep}. Without a sweep it is printed.
     *
     * @param name letters, digits and _, and not the name of a parameter
     * @param value a number, a text of at most 10,000 characters, True or False; at most 1000 results of a run
     * @throws IllegalArgumentException that names result, value and what is legal
     * @example sear.setResult("distance", 1.25)
     */
    public void setResult(String name, Object value) {
        calls.act(() -> RunParameters.setResult(name, value));
    }

    // ---- Python 3 ---------------------------------------------------------------------------------------------------

    /**
     * Lets Python 3 programs on this computer in: {@code sear.connect()} of the package {@code sear}, docs/python3.md. They can do what a script can.
     * The token that they show stands in the file {@code .sear/gateway-PORT} of the user's home folder, which only that user can read.
     *
     * @return the port: 25333, or that at which they are let in already
     * @throws IllegalStateException if it is in use
     * @example port = sear.startPython3(0); sear.stopPython3()
     */
    public int startPython3() {
        return calls.attempt(() -> parts.gateways().open());
    }

    /**
     * The same at another port: {@code sear.connect(PORT)}.
     *
     * @param port TCP port, 0 for any free one
     * @return the number
     * @throws IllegalArgumentException if it is no port
     * @throws IllegalStateException if it is in use
     * @example port = sear.startPython3(0); sear.stopPython3()
     */
    public int startPython3(int port) {
        return calls.attempt(() -> parts.gateways().open(port));
    }

    /**
     * Lets no more Python 3 programs in, and ends the connections of those that are.
     *
     * @example sear.stopPython3()
     */
    public void stopPython3() {
        calls.act(() -> parts.gateways().close());
    }

    // ---- editing the project ---------------------------------------------------------------------------------------

    /**
     * Changes the project as the tab does: an object is added, set, renamed, duplicated, deleted, mounted on a robot or taken off. It is checked as
     * its file would be, written at once, and can be undone. While a simulation runs, what gets another place moves; all else takes effect at the
     * next start. docs/building.md lists the edits.
     *
     * @param edit what to do, and with what
     * @return what was done, {@code object}: what edits call the object, {@code undo} and {@code redo}: what these would do now
     * @throws IllegalStateException with everything that is wrong, and what is legal; nothing has changed then
     * @example print sear.edit({"do": "add", "type": "Box", "name": "crate", "set": {"x": 1, "mass": 2}})["object"]
     */
    public Map<String, Object> edit(Map<String, Object> edit) {
        return edited(calls.attempt(() -> parts.edits().apply(edit)));
    }

    /**
     * Takes back the last edit of the project, by whomever; the last 500 can be taken back, also after a crash.
     *
     * @return as {@link #edit}
     * @throws IllegalStateException if there is none
     * @example sear.edit({"do": "add", "type": "Box"}); sear.undo()
     */
    public Map<String, Object> undo() {
        return edited(calls.attempt(() -> parts.edits().apply(Collections.singletonMap("do", "undo"))));
    }

    /**
     * Does again what {@link #undo} took back last.
     *
     * @return as {@link #edit}
     * @throws IllegalStateException if there is nothing, or something else was edited since
     * @example sear.edit({"do": "add", "type": "Box"}); sear.undo(); sear.redo()
     */
    public Map<String, Object> redo() {
        return edited(calls.attempt(() -> parts.edits().apply(Collections.singletonMap("do", "redo"))));
    }

    /**
     * What edits can make: {@code types} with their parameters, units, legal ranges and documentation, and {@code templates} of robots.
     *
     * @example print ", ".join([one["type"] for one in sear.getGrammar()["types"]])
     */
    public Map<String, Object> getGrammar() {
        return calls.attempt(Edits::grammar);
    }

    private Map<String, Object> edited(Map<String, Object> answer) {
        invoke("publishEdit", answer);
        return answer;
    }

    // ---- for panels ------------------------------------------------------------------------------------------------

    /**
     * The world for panels, ten times a second while somebody subscribes: the whole when it begins, then what has changed; the form stands at
     * {@code WorldFeed}.
     */
    public Map<String, Object> publishSimulation() {
        return calls.attempt(() -> parts.nextState());
    }

    /** The whole world as it is now, for a panel that opens while it runs. */
    public Map<String, Object> getWorld() {
        return calls.attempt(() -> parts.wholeState());
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
            return Preview.none(SearCalls.missing(e));
        }
    }

    /** The ground of the world for panels, which ask once for each: its form stands at {@code TerrainJson}; empty for a world without a terrain. */
    public Map<String, Object> getTerrain() {
        return calls.attempt(() -> parts.terrain());
    }

    /**
     * What shapes look like, for panels that show them in space; the form stands at {@code LookTable}.
     *
     * @param wanted keys of looks and pictures that the panel has not got
     */
    public List<Map<String, Object>> getLooks(List<String> wanted) {
        return calls.attempt(() -> parts.looks(wanted));
    }

    /**
     * The last picture of a camera that was due, for panels that show it; the form stands at {@code CameraPicture}; empty if there is none.
     *
     * @param longest pixels of the longer side; a smaller one is not enlarged
     * @param column of the pixel that is to be told in words; below 0 for none
     */
    public Map<String, Object> getCameraPicture(String name, int longest, int column, int row) {
        return calls.attempt(() -> parts.cameraPicture(ScriptText.of(name), longest, column, row));
    }

    /** An edit by a panel; its answer, also what is wrong with it, goes to all panels by {@link #publishEdit}. */
    public void tryEdit(Map<String, Object> edit) {
        edited(calls.attempt(() -> parts.edits().attempt(edit)));
    }

    /** Tells panels what an edit has come to; the form stands at {@code Edits}. */
    public Map<String, Object> publishEdit(Map<String, Object> answer) {
        return answer;
    }

    /** What undo and redo would do now, for panels. */
    public Map<String, Object> getEdits() {
        return calls.attempt(Edits::state);
    }

    /** An object of the project as its file has it, for panels; the form stands at {@code ProjectEditor}. */
    public Map<String, Object> getProjectObject(String name) {
        return calls.attempt(() -> Edits.object(String.valueOf(ScriptText.of(name))));
    }

    /** Records in the working folder, for panels. */
    public List<String> getRecords() {
        return calls.attempt(() -> Records.list());
    }

    /** Where everything was over time, for panels that show a record; the form stands at {@code Records}. */
    public Map<String, Object> getRecordFrames(String path) {
        return calls.attempt(() -> parts.recordFrames(path));
    }

    /**
     * The picture that a camera had taken last at a time of a record, for panels; the form stands at {@code CameraPicture}; empty if there is none.
     *
     * @param time seconds since the record began
     * @param longest pixels of the longer side; a smaller one is not enlarged
     * @param column of the pixel that is to be told in words; below 0 for none
     */
    public Map<String, Object> getRecordPicture(String path, String name, double time, int longest, int column, int row) {
        return calls.attempt(() -> parts.recordPicture(path, ScriptText.of(name), time, longest, column, row));
    }

    /** How things turned and what sensors saw in a record, for panels that share it; the form stands at {@code Motion}. */
    public Map<String, Object> getRecordMotion(String path) {
        return calls.attempt(() -> parts.recordMotion(path));
    }

    /** Tells panels why a project could not be started or loaded. */
    public List<Problem> publishProblems(List<Problem> problems) {
        return problems;
    }

    /** Saves the project for a panel: a file of that name is only replaced if that is asked for; the answer's form stands at {@code Projects}. */
    public Map<String, Object> saveProjectAs(String path, boolean overwrite) {
        return calls.attempt(() -> parts.projects().saveAs(bundle(path).toString(), overwrite));
    }

    /** Takes a part of a bundle from a panel, base64; the last part loads the project and publishes publishUploaded. */
    public void uploadProject(String name, int index, int count, String data) {
        if (calls.attempt(() -> parts.transfers().receive(name, index, count, data))) {
            invoke("publishUploaded", "loaded " + name);
        }
    }

    /** Says that an uploaded project is loaded. */
    public String publishUploaded(String message) {
        return message;
    }

    /** A part of the project's bundle for a panel: index, count, data in base64; part 0 makes the bundle. */
    public Map<String, Object> getBundle(int index) {
        return calls.attempt(() -> parts.transfers().part(index));
    }

    /** Paths of example projects, for panels. */
    public List<String> getExamples() {
        return calls.attempt(() -> parts.projects().examples());
    }

    /** What scripts can call, for panels with an editor: type, name, parameters and doc of each call. */
    public List<Map<String, String>> getScriptCalls() {
        return calls.attempt(ScriptCalls::list);
    }

    /** Has the service named python run an example script, as the tab of that does; returns at once. */
    public void runExampleScript(String name) {
        calls.act(() -> send(ExampleScripts.runner(), "exec", ExampleScripts.text(ScriptText.of(name)), false));
    }

    private static Path bundle(String path) {
        if (path == null) {
            throw new IllegalArgumentException("the path is missing (None), legal: the path of a bundle, such as \"robot.sear\"");
        }
        return ScriptText.path(path);
    }

    private static String text(Path path) {
        return path == null ? null : path.toString();
    }

    // ---- MyRobotLab ------------------------------------------------------------------------------------------------

    /** Bytes of a device's Serial service go straight to the device, and lock-step hears at once what it waits for; all else takes its usual way. */
    @Override
    public void in(Message message) {
        if (!isOurs(message)) {
            super.in(message);
        }
    }

    /** Where a MyRobotLab brings messages another way than {@link #in}. */
    @Override
    public boolean preProcessHook(Message message) {
        return !isOurs(message) && super.preProcessHook(message);
    }

    private boolean isOurs(Message message) {
        return SearParts.takesBytes(parts, message) || SearParts.isFence(message);
    }

    boolean isWhole() {
        return parts != null;
    }

    /** The simulation has changed its state. */
    void changed() {
        simulating = isSimulating();
        paused = simulating && parts.control().session().isPaused();
        recorded = parts != null && parts.recording().isOn();
        broadcastState();
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
        if (present != null) {
            present.publisher().finish();    // before there is nothing to publish any more
        }
        parts = null;
        simulating = false;
        if (present != null) {
            present.close();
        }
    }
}
