// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.SEAR.geometry.Pose;
import org.SEAR.grammar.ScriptText;
import org.SEAR.project.ProjectOrigin;
import org.SEAR.project.problems.Problem;
import org.SEAR.robot.DriveOrder;
import org.SEAR.simulator.ActuatorOrder;
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
import org.myrobotlab.service.sear.python3.ScriptErrors;
import org.myrobotlab.service.sear.records.Plots;
import org.myrobotlab.service.sear.records.Recording;
import org.myrobotlab.service.sear.records.Records;
import org.myrobotlab.service.sear.run.RunParameters;
import org.myrobotlab.service.sear.run.SimulationSession;

/**
 * SEAR, the Simulation Environment for Autonomous Robots, as a MyRobotLab service. It simulates the project that the
 * objects of {@code org.SEAR.POJOs} describe and returns the readings of its sensors.
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
 * <p>Calls publish an error as an error status and throw it, so that scripts see it: IllegalArgumentException for a
 * value, otherwise IllegalStateException. A running simulation goes on. Any thread.
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
    /** Identifies this start of the service for panels, which ask for everything again; 0 before it. */
    private long started;
    /** Path of the bundle that the next save of a panel writes, and whether it has the project already. */
    private String project = ProjectOrigin.NONE.path;
    private boolean saved;

    /** Called by MyRobotLab. */
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
                parts = new SearParts(new SearHost(this, calls));
                ScriptErrors.listen(getName());
                started = System.currentTimeMillis();
                changed();
            } catch (LinkageError e) {
                error("%s", SearCalls.missing(e));
            }
        }
    }

    // ---- simulation -------------------------------------------------------------------------------------------------

    /**
     * Starts the project in the folder {@code SEARproject} of MyRobotLab's working folder.
     *
     * @throws IllegalStateException invalid project, or a simulation runs
     * @example sear.startSimulation()
     */
    public void startSimulation() {
        startSimulation(false);
    }

    /**
     * Starts the project and optionally draws its physics.
     *
     * @param debugShapes True draws collision shapes, contact points and wheel rays
     * @throws IllegalStateException invalid project, or a simulation runs
     * @example sear.startSimulation(True)
     */
    public void startSimulation(boolean debugShapes) {
        calls.act(() -> parts.start(debugShapes));
        changed();
    }

    /**
     * Stops the simulation and closes its ports and window.
     *
     * @throws IllegalStateException no simulation runs
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
     * Returns whether a simulation runs, paused or not.
     *
     * @example if not sear.isSimulating(): sear.startSimulation()
     */
    public boolean isSimulating() {
        return parts != null && parts.control().isRunning();
    }

    /**
     * Sets whether beams see floors and terrain in later simulations; default True. False lets beams through, as
     * ultrasound glances off smooth floors. {@code floor.setVisibleToSensors(False)} hides a single floor.
     *
     * @throws IllegalStateException a simulation runs
     * @example sear.setGroundVisible(False)
     */
    public void setGroundVisible(boolean on) {
        calls.act(() -> parts.control().setGroundVisible(on));
    }

    /**
     * Sets the number of threads that measure sensors and cameras, including the simulation's. Default:
     * {@code sear --threads}, otherwise all processors. Readings stay the same.
     *
     * @param number 1 to 256
     * @throws IllegalArgumentException number out of range
     * @example sear.setThreads(1)
     */
    public void setThreads(int number) {
        calls.act(() -> parts.control().setThreads(number));
    }

    // ---- time -------------------------------------------------------------------------------------------------------

    /**
     * Waits for simulated seconds. In lock-step the call advances time itself.
     *
     * @param seconds 0 or more
     * @throws IllegalStateException simulation ended, or the waiting script paused it
     * @example sear.simSleep(0.5)
     */
    public void simSleep(double seconds) {
        calls.act(() -> parts.control().session().simSleep(seconds));
    }

    /**
     * Returns simulated seconds since start or reset.
     *
     * @example print "%.2f s" % sear.getTime()
     */
    public double getTime() {
        return calls.attempt(() -> parts.control().session().time());
    }

    /**
     * Stops simulated time until {@link #resume}.
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
     * Returns whether the simulation is paused.
     *
     * @example print sear.isPaused()
     */
    public boolean isPaused() {
        return paused;
    }

    /**
     * Advances time by steps of 1/60 s. Pauses a simulation that runs by itself.
     *
     * @param n steps, 1 or more
     * @example sear.step(60)
     */
    public void step(int n) {
        calls.act(() -> parts.control().session().step(n));
        changed();
    }

    /**
     * Returns everything to the start, with the same random seed.
     *
     * @example sear.reset()
     */
    public void reset() {
        calls.act(() -> parts.control().session().reset());
    }

    /**
     * Sets the speed of time, also in later simulations.
     *
     * @param factor simulated seconds per second, 0.001 or more; 1 = real time, infinity = maximum
     * @example sear.setSpeed(2)
     */
    public void setSpeed(double factor) {
        calls.act(() -> parts.control().setSpeed(factor));
    }

    /**
     * Sets lock-step, also for later simulations: time advances only inside {@link #simSleep} and {@link #step}.
     *
     * @example sear.setLockStep(True)
     */
    public void setLockStep(boolean on) {
        calls.act(() -> parts.control().setLockStep(on));
    }

    /**
     * Returns whether a simulation runs in lock-step.
     *
     * @example print sear.isLockStep()
     */
    public boolean isLockStep() {
        SimulationSession session = parts == null ? null : parts.control().sessionOrNull();
        return session != null && session.isLockStep();
    }

    // ---- devices ----------------------------------------------------------------------------------------------------

    /**
     * Switches a serial device off or on, for example to clear an earlier driver's state. Off: it is silent, stops its
     * actuators and drops incoming bytes. On: it restarts at its power-on baud rate, without mode or stream. A Create 2
     * or GPS receiver sends its boot message. An LMS200 boots for 5 simulated seconds, then sends its power-on
     * telegram. Written configuration and permanent baud rate remain.
     *
     * @param name a robot's Dynamics, a LIDAR or a GPS; {@code "robot/part"} if ambiguous
     * @throws IllegalArgumentException unknown device
     * @example sear.power("myLidar", False); sear.power("myLidar", True)
     */
    public void power(String name, boolean on) {
        calls.act(() -> parts.control().session().power(ScriptText.of(name), on));
    }

    // ---- driving ----------------------------------------------------------------------------------------------------

    /**
     * Drives the first robot straight until the next command.
     *
     * @param speed m/s, + forward, -100 to 100; 0 stops
     * @example sear.driveStraight(0.3)
     */
    public void driveStraight(double speed) {
        driveStraight(null, speed);
    }

    /**
     * Drives a robot straight until the next command.
     *
     * @param robot name
     * @param speed m/s, + forward, -100 to 100; 0 stops
     * @throws IllegalArgumentException unknown robot or illegal speed
     * @example sear.driveStraight("myRoomba", -0.1)
     */
    public void driveStraight(String robot, double speed) {
        calls.act(() -> parts.driving().give(robot, DriveOrder.straight(speed)));
    }

    /**
     * Turns the first robot in place until the next command.
     *
     * @param degPerSecond degrees per second, + left, -3600 to 3600; 0 stops
     * @example sear.spin(45); sear.simSleep(2); sear.spin(0)
     */
    public void spin(double degPerSecond) {
        spin(null, degPerSecond);
    }

    /**
     * Turns a robot in place until the next command.
     *
     * @param robot name
     * @param degPerSecond degrees per second, + left, -3600 to 3600; 0 stops
     * @throws IllegalArgumentException unknown robot, illegal rate or robot without driven wheels on both sides
     * @example sear.spin("myRoomba", -90)
     */
    public void spin(String robot, double degPerSecond) {
        calls.act(() -> parts.driving().give(robot, DriveOrder.spin(degPerSecond)));
    }

    /**
     * Sets the wheel speeds of the first robot until the next command. Steered wheels follow the circle of different
     * speeds.
     *
     * @param left left ground speed, m/s, + forward, -100 to 100
     * @param right right ground speed
     * @example sear.setWheelSpeeds(0.2, 0.25)
     */
    public void setWheelSpeeds(double left, double right) {
        setWheelSpeeds(null, left, right);
    }

    /**
     * Sets the wheel speeds of a robot until the next command. Steered wheels follow the circle of different speeds.
     *
     * @param robot name
     * @param left left ground speed, m/s, + forward, -100 to 100
     * @param right right ground speed
     * @throws IllegalArgumentException unknown robot, illegal speed, or different speeds without driven wheels at both
     *     sides or with a steering servo
     * @example sear.setWheelSpeeds("myRoomba", 0, 0)
     */
    public void setWheelSpeeds(String robot, double left, double right) {
        calls.act(() -> parts.driving().give(robot, DriveOrder.wheels(left, right)));
    }

    /**
     * Drives the first robot along a circle until the next command. Steered wheels follow the circle, at radius 0 to
     * their limit.
     *
     * @param speed m/s, + forward, -100 to 100
     * @param radius metres, + to the left; infinity = straight, 0 = in place to the left
     * @example sear.drive(0.2, 0.5)
     */
    public void drive(double speed, double radius) {
        drive(null, speed, radius);
    }

    /**
     * Drives a robot along a circle until the next command. Steered wheels follow the circle, at radius 0 to their
     * limit.
     *
     * @param robot name
     * @param speed m/s, + forward, -100 to 100
     * @param radius metres, + to the left; infinity = straight, 0 = in place to the left
     * @throws IllegalArgumentException unknown robot or illegal speed
     * @example sear.drive("myRoomba", 0.2, float("inf"))
     */
    public void drive(String robot, double speed, double radius) {
        calls.act(() -> parts.driving().give(robot, DriveOrder.circle(speed, radius)));
    }

    /**
     * Drives the first robot at a speed and a turn rate until the next command, as ROS's {@code cmd_vel} does. Steered
     * wheels follow the circle.
     *
     * @param speed m/s, + forward, -100 to 100
     * @param degPerSecond degrees per second, + left, -3600 to 3600
     * @example sear.driveVelocity(0.2, 30)
     */
    public void driveVelocity(double speed, double degPerSecond) {
        driveVelocity(null, speed, degPerSecond);
    }

    /**
     * Drives a robot at a speed and a turn rate until the next command, as ROS's {@code cmd_vel} does. Steered wheels
     * follow the circle.
     *
     * @param robot name
     * @param speed m/s, + forward, -100 to 100
     * @param degPerSecond degrees per second, + left, -3600 to 3600
     * @throws IllegalArgumentException unknown robot, illegal speed or rate, or a turn in place by a robot without
     *     driven wheels on both sides
     * @example sear.driveVelocity("myRoomba", 0.2, -30)
     */
    public void driveVelocity(String robot, double speed, double degPerSecond) {
        calls.act(() -> parts.driving().give(robot, DriveOrder.velocity(speed, degPerSecond)));
    }

    /**
     * Steers the first robot until the next command.
     *
     * @param degrees virtual middle wheel's angle, + left (inner wheel more, outer less)
     * @example sear.setSteering(-10)
     */
    public void setSteering(double degrees) {
        setSteering(null, degrees);
    }

    /**
     * Steers a robot until the next command.
     *
     * @param robot name
     * @param degrees virtual middle wheel's angle, + left (inner wheel more, outer less)
     * @throws IllegalArgumentException unknown robot, illegal angle or robot without steered wheels
     * @example sear.setSteering("car", 20)
     */
    public void setSteering(String robot, double degrees) {
        calls.act(() -> parts.driving().steer(robot, degrees));
    }

    // ---- motors, servos and lights ----------------------------------------------------------------------------------

    /**
     * Powers a motor until the next command for it or its robot. Torque = stallTorque (power - speed / noLoadSpeed).
     *
     * @param name motor; {@code "robot/motor"} if ambiguous
     * @param power fraction of full voltage, + forward, -1 to 1; 0 brakes (short circuit)
     * @throws IllegalArgumentException unknown motor or illegal power
     * @example sear.setMotorPower("engine", 0.5)
     */
    public void setMotorPower(String name, double power) {
        calls.act(() -> parts.actuators().power(name, power));
    }

    /**
     * Holds a motor's speed, within its torque, until the next command for it or its robot.
     *
     * @param name motor; {@code "robot/motor"} if ambiguous
     * @param speed wheel speed, rad/s, + forward, up to the no-load speed
     * @throws IllegalArgumentException unknown motor or illegal speed
     * @example sear.setMotorSpeed("engine", 6.5)
     */
    public void setMotorSpeed(String name, double speed) {
        calls.act(() -> parts.actuators().speed(name, speed));
    }

    /**
     * Returns the current speed of a motor's wheels, rad/s, + forward. Several wheels are averaged.
     *
     * @param name motor
     * @throws IllegalArgumentException unknown motor
     * @example print "%.2f rad/s" % sear.getMotorSpeed("engine")
     */
    public double getMotorSpeed(String name) {
        return calls.attempt(() -> parts.actuators().speed(name));
    }

    /**
     * Returns encoder counts since start or reset, + forward; 0 without an encoder.
     *
     * @param name motor
     * @throws IllegalArgumentException unknown motor
     * @example print sear.getEncoder("engine"), "counts"
     */
    public long getEncoder(String name) {
        return calls.attempt(() -> parts.actuators().counts(name));
    }

    /**
     * Moves the motor of a joint to a position at full power.
     *
     * @param name hinge, slider or rope with a motor
     * @param position degrees of a hinge, metres of a slider or rope, within its limits
     * @throws IllegalArgumentException unknown joint, joint without motor, or illegal position
     * @example sear.setJointPosition("door_hinge", 80)
     */
    public void setJointPosition(String name, double position) {
        calls.act(() -> parts.actuators().joint(ActuatorOrder.Kind.JOINT_POSITION, name, position));
    }

    /**
     * Holds the speed of a joint's motor, within its force.
     *
     * @param name hinge, slider or rope with a motor
     * @param speed degrees a second of a hinge, m/s of a slider or rope
     * @throws IllegalArgumentException unknown joint, or joint without motor
     * @example sear.setJointSpeed("door_hinge", 30)
     */
    public void setJointSpeed(String name, double speed) {
        calls.act(() -> parts.actuators().joint(ActuatorOrder.Kind.JOINT_SPEED, name, speed));
    }

    /**
     * Powers the motor of a joint: force = force at standstill (power - speed / speed without load).
     *
     * @param name hinge, slider or rope with a motor
     * @param power fraction of full voltage, -1 to 1; 0 brakes
     * @throws IllegalArgumentException unknown joint, joint without motor, or illegal power
     * @example sear.setJointPower("door_hinge", 0.5)
     */
    public void setJointPower(String name, double power) {
        calls.act(() -> parts.actuators().joint(ActuatorOrder.Kind.JOINT_POWER, name, power));
    }

    /**
     * Returns position, speed and motor force of a joint: {degrees, degrees a second, N m} of a hinge, {m, m/s, N} of a
     * slider or rope.
     *
     * @param name hinge, slider or rope
     * @throws IllegalArgumentException unknown joint
     * @example print "%.1f deg, %.1f deg/s, %.2f N m" % tuple(sear.getJoint("door_hinge"))
     */
    public double[] getJoint(String name) {
        return calls.attempt(() -> parts.actuators().joint(name));
    }

    /**
     * Returns the mean force and torque of the last step on a joint's second object, at the joint.
     *
     * @param name joint
     * @return {fx, fy, fz, tx, ty, tz}, N and N m, world frame
     * @throws IllegalArgumentException unknown joint
     * @example print "%.1f N upwards" % sear.getJointForce("door_hinge")[1]
     */
    public double[] getJointForce(String name) {
        return calls.attempt(() -> parts.actuators().jointForce(name));
    }

    /**
     * Turns a servo and its parts to an angle at full speed.
     *
     * @param name servo; {@code "robot/servo"} if ambiguous
     * @param degrees within the servo's range, + counter-clockwise from above
     * @throws IllegalArgumentException unknown servo or illegal angle
     * @example sear.setServo("neck", 45)
     */
    public void setServo(String name, double degrees) {
        calls.act(() -> parts.actuators().angle(name, degrees));
    }

    /**
     * Returns a servo's current angle, degrees, + counter-clockwise from above.
     *
     * @param name servo
     * @throws IllegalArgumentException unknown servo
     * @example print "%.1f degrees" % sear.getServo("neck")
     */
    public double getServo(String name) {
        return calls.attempt(() -> parts.actuators().angle(name));
    }

    /**
     * Sets a light's brightness until the next command, or until an Arduino writes to its pin.
     *
     * @param name LED; {@code "robot/led"} if ambiguous
     * @param brightness 0 (dark) to 1
     * @throws IllegalArgumentException unknown LED or illegal brightness
     * @example sear.setLed("lamp", 0.5)
     */
    public void setLed(String name, double brightness) {
        calls.act(() -> parts.actuators().brightness(name, brightness));
    }

    /**
     * Returns a light's present brightness, 0 to 1.
     *
     * @param name LED
     * @throws IllegalArgumentException unknown LED
     * @example print "%.0f %%" % (100 * sear.getLed("lamp"))
     */
    public double getLed(String name) {
        return calls.attempt(() -> parts.actuators().brightness(name));
    }

    // ---- forces and velocities --------------------------------------------------------------------------------------

    /**
     * Applies a force at the centre of mass from the next step and returns immediately. Forces add up and wake sleeping
     * objects.
     *
     * @param name object with mass or robot
     * @param force {@code [x, y, z]}, N along the world's axes: north, up, east
     * @param seconds simulated, above 0 to 3600
     * @throws IllegalArgumentException no such movable object, or a force above 1000 m/s per step for its mass
     * @example sear.push("crate 1", [50, 0, 0], 0.2)
     */
    public void push(String name, List<?> force, double seconds) {
        calls.act(() -> parts.bodies().push(name, force, seconds));
    }

    /**
     * Sets the velocity of the centre of mass between two steps. Changes no file; {@code crate.setVelocity(x, y, z)}
     * before the start sets the initial velocity.
     *
     * @param name object with mass or robot
     * @param x north, m/s along the world's x axis, -1000 to 1000
     * @param y up
     * @param z east
     * @throws IllegalArgumentException no such movable object, or illegal velocity
     * @example sear.setVelocity("crate 1", 0.5, 2, 0)
     */
    public void setVelocity(String name, double x, double y, double z) {
        calls.act(() -> parts.bodies().velocity(name, x, y, z));
    }

    /**
     * Sets the angular velocity about the centre of mass between two steps.
     *
     * @param name object with mass or robot
     * @param x degrees per second about the world's x axis, right-handed, -100000 to 100000
     * @param y about the y axis, + counter-clockwise from above
     * @param z about the z axis
     * @throws IllegalArgumentException no such movable object, or illegal rate
     * @example sear.setSpin("crate 1", 0, 90, 0)
     */
    public void setSpin(String name, double x, double y, double z) {
        calls.act(() -> parts.bodies().spin(name, x, y, z));
    }

    /**
     * Changes the world's gravity between two steps, until {@link #reset}. Changes no file; a {@code Gravity} object
     * sets that of the start.
     *
     * @param acceleration m/s^2 downwards, 0 to 100: 9.81 on the Earth, 1.62 on the Moon, 3.71 on Mars
     * @throws IllegalArgumentException illegal acceleration
     * @example sear.setGravity(1.62)
     */
    public void setGravity(double acceleration) {
        calls.act(() -> parts.bodies().gravity(acceleration));
    }

    /**
     * Returns present gravity, m/s^2 downwards.
     *
     * @example print sear.getGravity()
     */
    public double getGravity() {
        return calls.attempt(() -> parts.bodies().gravity());
    }

    /**
     * Pulls an object with a spring, like the tab's mouse, with at most five times its weight. It lets go after
     * {@link #letGo} or {@link #reset}, or 1.5 s without another call: real time, in lock-step simulated time.
     *
     * @param name object with mass or robot
     * @param way {@code [x, y, z]}, metres along the world's axes from its position at the first call
     * @throws IllegalArgumentException no such movable object
     * @example sear.hold("crate 1", [0, 0.5, 0])
     */
    public void hold(String name, List<?> way) {
        calls.act(() -> parts.bodies().hold(name, way));
    }

    /**
     * Releases what {@link #hold} holds, if anything.
     *
     * @param name object or robot
     * @example sear.letGo("crate 1")
     */
    public void letGo(String name) {
        calls.act(() -> parts.bodies().letGo(name));
    }

    // ---- sensors ----------------------------------------------------------------------------------------------------

    /**
     * Returns all sensor names. Ambiguous names have the form {@code "robot/sensor"}, for example {@code "rover/ping"}.
     * This form is legal for every sensor and part.
     *
     * @example print ", ".join(sear.getSensorNames())
     */
    public List<String> getSensorNames() {
        return calls.attempt(() -> parts.readings().names());
    }

    /**
     * Returns any sensor's reading, also of another jar, like the call for its kind below. Does not reset an odometer.
     *
     * @param name sensor
     * @throws IllegalArgumentException unknown sensor
     * @example print sear.getReading("frontPing"), sear.getSensorUnit("frontPing")
     */
    public Object getReading(String name) {
        return calls.attempt(() -> parts.readings().any(name));
    }

    /**
     * Returns a sensor's unit, for example {@code m}, {@code deg}, {@code m/s2} or {@code rad/s}. A GPS has
     * {@code deg, deg, m}. Empty without a unit.
     *
     * @param name sensor
     * @throws IllegalArgumentException unknown sensor
     * @example print sear.getSensorUnit("compass")
     */
    public String getSensorUnit(String name) {
        return calls.attempt(() -> parts.readings().unit(name));
    }

    /**
     * Returns metres to the nearest hit of a distance sensor; without a hit, its range.
     *
     * @param name sensor
     * @throws IllegalArgumentException unknown sensor or wrong kind
     * @example print "%.2f m ahead" % sear.getDistanceResult("frontPing")
     */
    public double getDistanceResult(String name) {
        return calls.attempt(() -> parts.readings().distance(name));
    }

    /**
     * Returns a LIDAR's distances, metres, right to left; without a hit, its range.
     *
     * @param name sensor
     * @throws IllegalArgumentException unknown sensor or wrong kind
     * @example print "%.2f m" % min(sear.getLidarResult("myLidar"))
     */
    public float[] getLidarResult(String name) {
        return calls.attempt(() -> parts.readings().scan(name));
    }

    /**
     * Returns the angles of a LIDAR's beams, in the order of its distances.
     *
     * @param name sensor
     * @return degrees from straight ahead, + left
     * @throws IllegalArgumentException unknown sensor or wrong kind
     * @example print sear.getLidarAngles("myLidar")[0]
     */
    public double[] getLidarAngles(String name) {
        return calls.attempt(() -> parts.readings().angles(name));
    }

    /**
     * Returns a GPS sensor's [latitude, longitude, altitude]: degrees, + north; degrees, + east; metres.
     *
     * @param name sensor
     * @throws IllegalArgumentException unknown sensor or wrong kind
     * @example latitude, longitude, altitude = sear.getGpsResult("gpsUnit1")
     */
    public double[] getGpsResult(String name) {
        return calls.attempt(() -> parts.readings().position(name));
    }

    /**
     * Returns a compass heading, degrees clockwise from north, (-180, 180].
     *
     * @param name sensor
     * @throws IllegalArgumentException unknown sensor or wrong kind
     * @example print "%.0f degrees" % sear.getCompassResult("compass")
     */
    public double getCompassResult(String name) {
        return calls.attempt(() -> parts.readings().heading(name));
    }

    /**
     * Returns an accelerometer's "x,y,z", m/s^2, in its own axes: x left, y up, z forward unless rotated.
     *
     * @param name sensor
     * @throws IllegalArgumentException unknown sensor or wrong kind
     * @example ax, ay, az = [float(a) for a in sear.getAccelResult("accel").split(",")]
     */
    public String getAccelResult(String name) {
        return calls.attempt(() -> parts.readings().acceleration(name));
    }

    /**
     * Returns a gyroscope's "x,y,z", rad/s, in an accelerometer's axes; + y turns left.
     *
     * @param name sensor
     * @throws IllegalArgumentException unknown sensor or wrong kind
     * @example turning = float(sear.getGyroResult("gyro").split(",")[1])
     */
    public String getGyroResult(String name) {
        return calls.attempt(() -> parts.readings().rates(name));
    }

    /**
     * Returns the first robot's signed distance travelled by its wheels, metres. An Odometer object counts from the
     * last call, up to 32.767 m, like a Roomba. Without one, the distance counts from start or reset.
     *
     * @example print "%.3f m" % sear.getOdomResult()
     */
    public double getOdomResult() {
        return getOdomResult(null);
    }

    /**
     * Returns the same distance of a robot.
     *
     * @param robot name
     * @throws IllegalArgumentException unknown robot
     * @example print "%.3f m" % sear.getOdomResult("myRoomba")
     */
    public double getOdomResult(String robot) {
        return calls.attempt(() -> parts.readings().odometer(robot));
    }

    // ---- cameras ----------------------------------------------------------------------------------------------------

    /**
     * Returns a camera's last due picture as PNG. Depths and temperatures are 16-bit grey: millimetres (0 = no return)
     * or hundredths of a kelvin.
     *
     * @param name camera
     * @throws IllegalArgumentException unknown camera
     * @example print len(sear.getImage("eye")), "bytes"
     */
    public byte[] getImage(String name) {
        return calls.attempt(() -> parts.cameras().png(name));
    }

    /**
     * Returns the last picture's pixels by rows from the top left, 0xRRGGBB (sRGB). Depths and temperatures have false
     * colours, from red (near or warm) to blue.
     *
     * @param name camera
     * @throws IllegalArgumentException unknown camera
     * @example pixel = sear.getPixels("eye")[120 * 320 + 160]; print "#%06x" % pixel
     */
    public int[] getPixels(String name) {
        return calls.attempt(() -> parts.cameras().pixels(name));
    }

    /**
     * Returns the last depth picture by rows from the top left: metres along the camera's axis, infinite without a
     * return.
     *
     * @param name camera
     * @throws IllegalArgumentException unknown camera or wrong kind
     * @example print "%.2f m ahead" % min(sear.getDepth("kinect"))
     */
    public float[] getDepth(String name) {
        return calls.attempt(() -> parts.cameras().depths(name));
    }

    /**
     * Returns the last infrared picture by rows from the top left, degrees Celsius.
     *
     * @param name camera
     * @throws IllegalArgumentException unknown camera or wrong kind
     * @example print "%.1f degrees at most" % max(sear.getTemperatures("thermal"))
     */
    public float[] getTemperatures(String name) {
        return calls.attempt(() -> parts.cameras().temperatures(name));
    }

    /**
     * Returns the last depth picture's points in the camera's frame: x, y, z of each, metres left, up and ahead. Omits
     * pixels without a return.
     *
     * @param name camera
     * @throws IllegalArgumentException unknown camera or wrong kind
     * @example points = sear.getPointCloud("kinect"); print len(points) / 3, "points"
     */
    public float[] getPointCloud(String name) {
        return getPointCloud(name, false);
    }

    /**
     * Returns these points in the camera or world frame.
     *
     * @param name camera
     * @param world True: world axes, at the picture's time; False: camera axes
     * @throws IllegalArgumentException unknown camera or wrong kind
     * @example points = sear.getPointCloud("kinect", True); print "the highest point is at %.2f m" % max(points[1::3])
     */
    public float[] getPointCloud(String name, boolean world) {
        return calls.attempt(() -> parts.cameras().points(name, world));
    }

    /**
     * Finds regions of a colour's hue in the last picture, largest first, like a Pixy. Each is [x, y, width, height,
     * area]: box centre from the top left, box size and area, in pixels. Brightness hardly matters.
     *
     * @param name camera
     * @param color name such as {@code "red"}, or {@code "#rrggbb"}; grey has no hue
     * @throws IllegalArgumentException unknown camera, wrong kind or colour without hue
     * @example for x, y, width, height, area in sear.getBlobs("eye", "red"): print "at column %.0f" % x
     */
    public List<double[]> getBlobs(String name, String color) {
        return calls.attempt(() -> parts.cameras().blobs(name, color));
    }

    /**
     * Writes the picture of {@link #getImage} to a file and creates its folders.
     *
     * @param name camera
     * @param path {@code .png} file, relative to the working folder
     * @return the file's absolute path
     * @throws IllegalArgumentException unknown camera
     * @throws IllegalStateException file cannot be written
     * @example sear.saveImage("eye", "eye.png")
     */
    public String saveImage(String name, String path) {
        return calls.attempt(() -> text(parts.cameras().save(name, path)));
    }

    // ---- poses and plans --------------------------------------------------------------------------------------------

    /**
     * Returns [x, y, z, rx, ry, rz] in the world: metres north, up and east, and degrees about these axes. Heading is
     * 90 - ry when upright.
     *
     * @param name robot, part, sensor or object; {@code "robot/part"} if ambiguous
     * @throws IllegalArgumentException unknown or ambiguous name
     * @example x, y, z, rx, ry, rz = sear.getPose("myRoomba")
     */
    public double[] getPose(String name) {
        return calls.attempt(() -> parts.readings().pose(name));
    }

    /**
     * Returns mass, centre of mass and inertia tensor of an object with a mass, or of a robot. They are in its own
     * frame, of which {@link #getPose} returns the pose in the world.
     *
     * @param name of an object with a mass, or of a robot
     * @return {@code mass}: kg, {@code centre}: [x, y, z] of the centre of mass, metres, {@code tensor}: three rows of
     *     three numbers, the inertia tensor about the centre of mass, kg m^2; off the diagonal are the negative
     *     products of inertia
     * @throws IllegalArgumentException if nothing with a mass has this name
     * @example print sear.getMassProperties("crate 1")["tensor"]
     */
    public Map<String, Object> getMassProperties(String name) {
        return calls.attempt(() -> parts.bodies().massProperties(name));
    }

    /**
     * Returns the ground's y, metres: the highest terrain, floor or terrain model there. Needs no simulation.
     *
     * @param x metres north of the world's origin
     * @param z metres east of it
     * @throws IllegalArgumentException no ground there
     * @example y = sear.getGroundHeight(2.0, -1.5)
     */
    public double getGroundHeight(double x, double z) {
        return calls.attempt(() -> parts.readings().groundHeight(x, z));
    }

    /**
     * Returns a plan of the world, north up, as SVG: names, robot headings, beams of distance sensors and LIDARs, scale
     * and time. Needs no simulation.
     *
     * @throws IllegalStateException invalid project
     * @example print len(sear.getPlan()), "characters"
     */
    public String getPlan() {
        return getPlan(true);
    }

    /**
     * Returns the plan with or without beams.
     *
     * @param beams True draws them; no reading changes
     * @throws IllegalStateException invalid project
     * @example print len(sear.getPlan(False)), "characters"
     */
    public String getPlan(boolean beams) {
        return calls.attempt(() -> parts.plans().svg(beams));
    }

    /**
     * Writes the plan to a file.
     *
     * @param picture .png or .svg file, overwritten
     * @return the file's absolute path
     * @throws IllegalStateException invalid project
     * @example sear.savePlan("plan.png")
     */
    public String savePlan(String picture) {
        return calls.attempt(() -> text(parts.plans().save(picture)));
    }

    // ---- published readings -----------------------------------------------------------------------------------------

    /**
     * Publishes each reading: its name, time (simulated seconds) and value, as {@link #getReading} returns it.
     *
     * @example sear.addListener("publishReading", python.getName(), "onGuideReading")
     */
    public SensorReading publishReading(SensorReading reading) {
        return reading;
    }

    /**
     * Publishes pictures of cameras after {@link #startPublishing}, in MyRobotLab's form. {@code name} is the camera,
     * {@code src} a URL, {@code data:image/png;base64,...}.
     *
     * @example sear.addListener("publishImage", python.getName(), "onEyeImage")
     */
    public ImageData publishImage(ImageData image) {
        return image;
    }

    /**
     * Publishes a sensor's readings repeatedly.
     *
     * @param sensor name
     * @param rate readings per simulated second, above 0 to 60
     * @throws IllegalArgumentException unknown sensor or illegal rate
     * @example sear.startPublishing("frontPing", 10)
     */
    public void startPublishing(String sensor, double rate) {
        calls.act(() -> parts.publisher().start(sensor, rate));
    }

    /**
     * Ends {@link #startPublishing}.
     *
     * @param sensor name
     * @example sear.stopPublishing("frontPing")
     */
    public void stopPublishing(String sensor) {
        calls.act(() -> parts.publisher().stop(sensor));
    }

    // ---- projects ---------------------------------------------------------------------------------------------------

    /**
     * Begins an empty project and backs up the present one.
     *
     * @return the backup's path; None without a project, or for an unchanged example
     * @throws IllegalStateException a simulation runs
     * @example sear.newProject()
     */
    public String newProject() {
        return replaced(() -> text(parts.projects().restart()));
    }

    /**
     * Saves the project as a bundle, overwriting an existing file.
     *
     * @param path like {@code "robot.sear"}; ending optional; the folder must exist
     * @return the bundle's absolute path
     * @throws IllegalStateException file cannot be written
     * @example print sear.saveProject("mine.sear")
     */
    public String saveProject(String path) {
        return replaced(() -> text(parts.projects().save(bundle(path))));
    }

    /**
     * Saves a bundle, optionally with only the used area of elevation maps. The project stays unchanged.
     *
     * @param path as above
     * @param cutTerrain True: only setArea's area, as one GeoTIFF; False: whole maps
     * @return the bundle's absolute path
     * @throws IllegalStateException file cannot be written
     * @example sear.saveProject("mountain.sear", True)
     */
    public String saveProject(String path, boolean cutTerrain) {
        return calls.attempt(() -> text(cutTerrain ? parts.projects().saveCut(bundle(path)) : parts.projects()
            .save(bundle(path))));
    }

    /**
     * Backs up the project and replaces it with a valid bundle or folder.
     *
     * @param path bundle or folder; {@code "examples/NAME.sear"} for SEAR's examples
     * @throws IllegalStateException invalid project, or a simulation runs
     * @example sear.loadProject("examples/office.sear")
     */
    public void loadProject(String path) {
        replaced(() -> {
            parts.projects().load(bundle(path));
            return null;
        });
    }

    /**
     * Adds a robot from a bundle or folder and backs up the current project. Names and ports in use get a number. Parts
     * keep their names; ambiguous ones become {@code "robot/part"}.
     *
     * @param path bundle or folder
     * @param name robot name there; None or empty if it is the only one
     * @return its new name
     * @throws IllegalStateException invalid project, or a simulation runs
     * @example second = sear.importRobot("examples/maze.sear", "maze Roomba")
     */
    public String importRobot(String path, String name) {
        return calls.attempt(() -> parts.projects()
            .importRobot(bundle(path), name == null ? null : ScriptText.of(name)));
    }

    /**
     * Adds a robot in URDF: a robot for each rigid body, and its joints. It stands on the ground at the world's origin;
     * without a mass of its base it is fixed there. Statuses list what SEAR leaves out.
     *
     * @param path file, with its meshes beside it or in packages above it; or a zip file of both
     * @return name of its base
     * @throws IllegalStateException invalid file, or a simulation runs
     * @example arm = sear.importUrdf("arm.urdf")
     */
    public String importUrdf(String path) {
        return calls.attempt(() -> parts.projects().importUrdf(bundle(path), null, false, Map.of()));
    }

    /**
     * Adds a robot in URDF at a place, like {@link #importUrdf(String)}.
     *
     * @param path file
     * @param x metres north of its base
     * @param y metres up
     * @param z metres east
     * @param fixed True: the base is fixed to the world
     * @return name of its base
     * @throws IllegalStateException invalid file, or a simulation runs
     * @example arm = sear.importUrdf("arm.urdf", 0, 0.5, 1, True)
     */
    public String importUrdf(String path, double x, double y, double z, boolean fixed) {
        return importUrdf(path, x, y, z, fixed, Map.of());
    }

    /**
     * Adds a robot in URDF at a place with joint positions, like {@link #importUrdf(String)}.
     *
     * @param path file
     * @param x metres north of its base
     * @param y metres up
     * @param z metres east
     * @param fixed True: the base is fixed to the world
     * @param positions at the start by the names of the joints in the file, degrees or metres
     * @return name of its base
     * @throws IllegalStateException invalid file or positions, or a simulation runs
     * @example arm = sear.importUrdf("arm.urdf", 0, 0.5, 1, True, {"elbow": 90})
     */
    public String importUrdf(String path, double x, double y, double z, boolean fixed, Map<String, Number> positions) {
        Map<String, Double> all = new TreeMap<>();
        positions.forEach((joint, position) -> all.put(ScriptText.of(joint), position.doubleValue()));
        return calls.attempt(() -> parts.projects().importUrdf(bundle(path), new Pose(x, y, z, 0, 0, 0, 1), fixed,
            all));
    }

    /**
     * Adds the environment of a bundle or folder, like {@link #importRobot}.
     *
     * @param path bundle or folder
     * @return new object names
     * @throws IllegalStateException invalid project, or a simulation runs
     * @example walls = sear.importEnvironment("examples/maze.sear")
     */
    public List<String> importEnvironment(String path) {
        return calls.attempt(() -> parts.projects().importEnvironment(bundle(path)));
    }

    /**
     * Returns what prevents a start of the project: file, line, field, value, what is legal; empty if nothing does.
     * Builds the world like {@link #checkProject}.
     *
     * @example for problem in sear.getProblems(): print problem
     */
    public List<Problem> getProblems() {
        return calls.attempt(() -> parts.problems());
    }

    /**
     * Checks the project like {@code sear check}: takes one step in a separate world.
     *
     * @return {@code problems} that prevent a start, as {@link #getProblems}; {@code warnings} of a start, for example
     *     a tipping robot or missing ground
     * @example for warning in sear.checkProject()["warnings"]: print warning
     */
    public Map<String, Object> checkProject() {
        return calls.attempt(() -> parts.check());
    }

    /**
     * Returns the Python script that creates the project's objects. Same assets and beams give identical files.
     *
     * @throws IllegalStateException invalid project
     * @example print sear.getScript()
     */
    public String getScript() {
        return calls.attempt(() -> parts.projects().script());
    }

    /**
     * Copies a template to a folder.
     *
     * @param name {@code controller.py}, {@code userCode.py} or {@code arduino.py}
     * @param folder created if missing
     * @return the copy's absolute path
     * @throws IllegalStateException file exists
     * @example print sear.copyTemplate("controller.py", "SEARproject")
     */
    public String copyTemplate(String name, String folder) {
        return calls.attempt(() -> text(parts.projects().copyTemplate(name, folder)));
    }

    /**
     * Returns the example scripts that drive a robot, each with its project.
     *
     * @example print ", ".join(sear.getExampleScripts())
     */
    public List<String> getExampleScripts() {
        return calls.attempt(() -> ExampleScripts.names());
    }

    /**
     * Returns the text of an example script.
     *
     * @param name from {@link #getExampleScripts}
     * @throws IllegalArgumentException unknown script
     * @example code = sear.getExampleScript("maze_solver.py")
     */
    public String getExampleScript(String name) {
        return calls.attempt(() -> ExampleScripts.text(ScriptText.of(name)));
    }

    // ---- records ----------------------------------------------------------------------------------------------------

    /**
     * Records poses, readings, commands and port bytes until {@link #endRecord}, stopSimulation or 512 MB. Without a
     * simulation it begins at the next start. Only a record from a start or reset can be rerun.
     *
     * @param path like {@code "run.searlog"}; ending optional; replaces only records
     * @return the absolute path, with its ending
     * @throws IllegalStateException file cannot be written, or another record in progress
     * @example sear.recordRun("run.searlog"); sear.endRecord()
     */
    public String recordRun(String path) {
        return recordRun(path, Recording.MEGABYTES);
    }

    /**
     * Records a run up to another size.
     *
     * @param path the file
     * @param megabytes above 0; there the record ends with a warning
     * @example sear.recordRun("run.searlog", 20); sear.endRecord()
     */
    public String recordRun(String path, double megabytes) {
        return recordRun(path, megabytes, 0);
    }

    /**
     * Records a run with all cameras' pictures, for replay in the tab.
     *
     * @param path the file
     * @param megabytes above 0; there the record ends with a warning
     * @param pictures maximum per camera and simulated second, 0 to 30
     * @example sear.recordRun("run.searlog", 200, 5); sear.endRecord()
     */
    public String recordRun(String path, double megabytes, double pictures) {
        String file = calls.attempt(() -> parts.recording().begin(ScriptText.of(path), megabytes, pictures));
        changed();
        return file;
    }

    /**
     * Ends the record in progress.
     *
     * @return its simulated seconds
     * @throws IllegalStateException no record in progress, or file incomplete
     * @example sear.recordRun("run.searlog"); sear.simSleep(1); print sear.endRecord()
     */
    public double endRecord() {
        double seconds = calls.attempt(() -> parts.recording().end());
        changed();
        return seconds;
    }

    /**
     * Reruns a record's commands in a separate, fresh world and compares the results.
     *
     * @param path record that begins at a start or reset
     * @return {@code same}: whether all port bytes and poses match; {@code seconds}: simulated; {@code ports}: each
     *     port's result, as text; {@code apart}: largest position difference, metres
     * @throws IllegalStateException no record, another project's, or not from a start
     * @example sear.reset(); sear.recordRun("run.searlog"); sear.simSleep(1); sear.endRecord(); print
     * sear.rerunRecord("run.searlog")["same"]
     */
    public Map<String, Object> rerunRecord(String path) {
        return calls.attempt(() -> parts.records().rerun(path, parts.control().getFolder()));
    }

    /**
     * Returns the names of a record's values: poses, speeds, positions, readings, commands, byte counts.
     *
     * @param path record
     * @throws IllegalStateException no record
     * @example sear.recordRun("run.searlog"); sear.endRecord(); print ", ".join(sear.getRecordNames("run.searlog"))
     */
    public List<String> getRecordNames(String path) {
        return calls.attempt(() -> Records.names(path));
    }

    /**
     * Returns a record's values over time, at most 30 per second and 4000 in all.
     *
     * @param path record
     * @param names from {@link #getRecordNames}
     * @return {@code times}: simulated seconds since it began; {@code values}: an equally long list per name, None
     *     without a number
     * @throws IllegalArgumentException unknown value
     * @example sear.recordRun("run.searlog"); sear.simSleep(1); sear.endRecord(); print
     * sear.getRecordValues("run.searlog", ["myRoomba.x"])["times"]
     */
    public Map<String, Object> getRecordValues(String path, List<String> names) {
        return calls.attempt(() -> parts.records().values(path, names));
    }

    /**
     * Writes a record's values as a table, 30 lines per second, at most 200000.
     *
     * @param path record
     * @param names from {@link #getRecordNames}
     * @param csv new file, or .csv file, overwritten
     * @return the table's absolute path
     * @throws IllegalArgumentException unknown value
     * @example sear.recordRun("run.searlog"); sear.simSleep(1); sear.endRecord(); sear.saveRecordCsv("run.searlog",
     * ["myRoomba.x"], "run.csv")
     */
    public String saveRecordCsv(String path, List<String> names, String csv) {
        return calls.attempt(() -> text(parts.records().saveCsv(path, names, csv)));
    }

    /**
     * Plots a record's values over time; values of one unit share an axis.
     *
     * @param path record
     * @param names from {@link #getRecordNames}, up to 16
     * @param picture .png or .svg file, overwritten
     * @return the picture's absolute path
     * @throws IllegalArgumentException unknown value
     * @example sear.recordRun("run.searlog"); sear.simSleep(1); sear.endRecord(); sear.saveRecordPlot("run.searlog",
     * ["myRoomba.x"], "run.png")
     */
    public String saveRecordPlot(String path, List<String> names, String picture) {
        return calls.attempt(() -> text(parts.savePlot(path, names, picture)));
    }

    /**
     * Plots one list of numbers over another. Axis titles end in a unit in brackets. Needs no simulation.
     *
     * @param picture .png or .svg file, overwritten
     * @param xTitle horizontal axis title
     * @param xs its numbers
     * @param yTitle vertical axis title
     * @param ys equally many numbers; None leaves a gap
     * @return the picture's absolute path
     * @throws IllegalArgumentException different lengths, or other values than numbers
     * @example sear.savePlot("run.png", "time (s)", [0, 1, 2], "distance (m)", [1.2, 0.9, 0.7])
     */
    public String savePlot(String picture, String xTitle, List<?> xs, String yTitle, List<?> ys) {
        return calls.attempt(() -> text(
            Plots.save(picture, xTitle, xs, Collections.singletonMap(yTitle == null ? "" : yTitle, ys))));
    }

    /**
     * Plots several lines; those with the same unit share an axis.
     *
     * @param picture .png or .svg file, overwritten
     * @param xTitle horizontal axis title
     * @param xs its numbers
     * @param lines up to 16 equally long lists by name
     * @return the picture's absolute path
     * @throws IllegalArgumentException different lengths, or other values than numbers
     * @example sear.savePlot("run.svg", "time (s)", [0, 1, 2], {"left (m)": [1, 2, 2.5], "right (m)": [1, 1.5, 3],
     * "speed (m/s)": [0, 0.3, 0.3]})
     */
    public String savePlot(String picture, String xTitle, List<?> xs, Map<String, ?> lines) {
        return calls.attempt(() -> text(Plots.save(picture, xTitle, xs, lines)));
    }

    // ---- ports for other programs -----------------------------------------------------------------------------------

    /**
     * Exports a virtual port to local programs as a pseudo-terminal (Linux, macOS). The export may precede the start
     * and outlives the simulation. Without a simulation it is silent. Repeated calls return the same export.
     *
     * @param userPort port, for example {@code "/dev/SEAR_LIDAR_01"}
     * @return the path to open
     * @throws IllegalStateException no such port in the simulation, or in use
     * @example path = sear.exportPort("/dev/SEAR_LIDAR_01")
     */
    public String exportPort(String userPort) {
        return exportPort(userPort, null);
    }

    /**
     * Exports a port through a symbolic link, whose name stays the same.
     *
     * @param userPort name
     * @param link path of the link; replaces an earlier run's link, nothing else
     * @return the path to open
     * @throws IllegalStateException no such port in the simulation, port in use, or link path taken
     * @example path = sear.exportPort("/dev/SEAR_GPS_01", "ttyGPS")
     */
    public String exportPort(String userPort, String link) {
        return calls.attempt(() -> parts.exports().terminal(ScriptText.of(userPort), ScriptText.of(link)));
    }

    /**
     * Exports a port as a local TCP server, on every system: raw bytes at the device's own baud rate.
     *
     * @param userPort name
     * @param number TCP port, 0 = any free one
     * @return the port
     * @throws IllegalStateException no such port in the simulation, or in use
     * @example number = sear.exportTcp("/dev/SEAR_Robot_01", 0)
     */
    public int exportTcp(String userPort, int number) {
        return calls.attempt(() -> parts.exports().tcp(ScriptText.of(userPort), number));
    }

    /**
     * Exports a port as an RFC 2217 server, where programs set the baud rate: pyserial's
     * {@code rfc2217://localhost:5002}.
     *
     * @param userPort name
     * @param number TCP port, 0 = any free one
     * @return the port
     * @throws IllegalStateException no such port in the simulation, or in use
     * @example number = sear.exportRfc2217("/dev/SEAR_LIDAR_01", 0)
     */
    public int exportRfc2217(String userPort, int number) {
        return calls.attempt(() -> parts.exports().rfc2217(ScriptText.of(userPort), number));
    }

    /**
     * Returns all ports and cameras exported, also by {@code setExport}, with their addresses as text.
     *
     * @example for port, ways in sear.getExports().items(): print port, "is", ", ".join(ways)
     */
    public Map<String, List<String>> getExports() {
        return calls.attempt(() -> parts.allExports());
    }

    /**
     * Ends all exports of a port.
     *
     * @param userPort name
     * @throws IllegalArgumentException port not exported
     * @example sear.exportPort("/dev/SEAR_GPS_01"); sear.endExport("/dev/SEAR_GPS_01")
     */
    public void endExport(String userPort) {
        calls.act(() -> parts.exports().end(ScriptText.of(userPort)));
    }

    // ---- network cameras --------------------------------------------------------------------------------------------

    /**
     * Serves a camera to local programs: MJPEG at {@code http://localhost:PORT/stream.mjpg}, pictures at
     * {@code /image.jpg}, 16-bit depths at {@code /depth.png}. See docs/cameras.md. The export may precede the start
     * and outlives the simulation.
     *
     * @param name camera
     * @param number TCP port, 0 = any free one
     * @return the port
     * @throws IllegalArgumentException no such camera in the simulation
     * @throws IllegalStateException port in use
     * @example number = sear.exportCamera("eye", 0)
     */
    public int exportCamera(String name, int number) {
        return calls.attempt(() -> parts.networkCameras().plain(name, number));
    }

    /**
     * Serves a camera also at a product's addresses, for programs made for it.
     *
     * @param name camera
     * @param number TCP port, 0 = any free one
     * @param product {@code "ESP32-CAM"} ({@code /capture}, and {@code /stream} at the next port) or {@code "OctoPi"}
     *     ({@code /?action=snapshot} and {@code /?action=stream}, as mjpg-streamer)
     * @return the port
     * @throws IllegalArgumentException no such camera in the simulation, or unknown product
     * @throws IllegalStateException port in use
     * @example number = sear.exportCamera("eye", 0, "ESP32-CAM")
     */
    public int exportCamera(String name, int number, String product) {
        return calls.attempt(() -> parts.networkCameras().like(name, number, product));
    }

    /**
     * Ends all exports of a camera and closes their connections.
     *
     * @param name camera
     * @throws IllegalArgumentException camera not exported
     * @example sear.exportCamera("eye", 0); sear.stopExportCamera("eye")
     */
    public void stopExportCamera(String name) {
        calls.act(() -> parts.networkCameras().end(name));
    }

    // ---- parameters and results -------------------------------------------------------------------------------------

    /**
     * Returns a parameter from {@code sear SCRIPT.py --set speed=0.2} or {@code sear sweep}, see docs/sweeps.md.
     *
     * @param name letters, digits and _; "seed" returns the sensors' random seed
     * @param standard default: a number, text, True or False; a given value must be of the same kind
     * @throws IllegalArgumentException illegal name or value
     * @example speed = sear.getParameter("speed", 0.3)
     */
    public Object getParameter(String name, Object standard) {
        return calls.attempt(() -> RunParameters.get(name, standard));
    }

    /**
     * Reports a result: a column in the table of {@code sear sweep}, otherwise printed.
     *
     * @param name letters, digits and _; not a parameter's name
     * @param value number, text up to 10,000 characters, True or False; up to 1000 results per run
     * @throws IllegalArgumentException illegal name or value
     * @example sear.setResult("distance", 1.25)
     */
    public void setResult(String name, Object value) {
        calls.act(() -> RunParameters.setResult(name, value));
    }

    // ---- Python 3 ---------------------------------------------------------------------------------------------------

    /**
     * Admits local Python 3 programs: {@code sear.connect()}, see docs/python3.md. They can call what scripts can.
     * Their token is in {@code .sear/gateway-PORT} in the home folder, readable only by its user.
     *
     * @return the port: 25333, or the one already open
     * @throws IllegalStateException port in use
     * @example port = sear.startPython3(0); sear.stopPython3()
     */
    public int startPython3() {
        return calls.attempt(() -> parts.gateways().open());
    }

    /**
     * Admits Python 3 programs at another port: {@code sear.connect(PORT)}.
     *
     * @param port TCP port, 0 = any free one
     * @return the port
     * @throws IllegalArgumentException illegal port
     * @throws IllegalStateException port in use
     * @example port = sear.startPython3(0); sear.stopPython3()
     */
    public int startPython3(int port) {
        return calls.attempt(() -> parts.gateways().open(port));
    }

    /**
     * Closes the port and connections of Python 3 programs.
     *
     * @example sear.stopPython3()
     */
    public void stopPython3() {
        calls.act(() -> parts.gateways().close());
    }

    // ---- editing the project ----------------------------------------------------------------------------------------

    /**
     * Adds, sets, renames, duplicates, deletes, mounts or unmounts an object, like the tab. SEAR checks the edit like a
     * file and writes it immediately. A running simulation applies only new positions, the next start everything else.
     * docs/building.md lists the edits.
     *
     * @param edit the edit and its arguments
     * @return what was done; {@code object}: its name; {@code undo}, {@code redo}: what these would do now
     * @throws IllegalStateException invalid edit (lists problems and legal values); nothing has changed
     * @example print sear.edit({"do": "add", "type": "Box", "name": "crate", "set": {"x": 1, "mass": 2}})["object"]
     */
    public Map<String, Object> edit(Map<String, Object> edit) {
        return edited(calls.attempt(() -> parts.edits().apply(edit)));
    }

    /**
     * Undoes the last edit, by any user or script. It can undo 500 edits, even after a crash.
     *
     * @return as {@link #edit}
     * @throws IllegalStateException nothing to undo
     * @example sear.edit({"do": "add", "type": "Box"}); sear.undo()
     */
    public Map<String, Object> undo() {
        return edited(calls.attempt(() -> parts.edits().apply(Collections.singletonMap("do", "undo"))));
    }

    /**
     * Repeats the edit that {@link #undo} undid last.
     *
     * @return as {@link #edit}
     * @throws IllegalStateException nothing to redo, or a newer edit
     * @example sear.edit({"do": "add", "type": "Box"}); sear.undo(); sear.redo()
     */
    public Map<String, Object> redo() {
        return edited(calls.attempt(() -> parts.edits().apply(Collections.singletonMap("do", "redo"))));
    }

    /**
     * Returns what edits can create: {@code types} with parameters, units, ranges and documentation; robot
     * {@code templates}.
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

    // ---- for panels -------------------------------------------------------------------------------------------------

    /**
     * Publishes the world to panels ten times per second while one subscribes: first the whole world, then changes.
     * {@code WorldFeed} describes the form.
     */
    public Map<String, Object> publishSimulation() {
        return calls.attempt(() -> parts.nextState());
    }

    /** Returns the whole current world, for a panel that opens during a run. */
    public Map<String, Object> getWorld() {
        return calls.attempt(() -> parts.wholeState());
    }

    /**
     * Returns the project's world as it would start, with its problems, for panels without a simulation.
     * {@code Preview} describes the form.
     *
     * @param known stamp of the panel's preview; empty if none
     */
    public Map<String, Object> getPreview(String known) {
        try {
            return parts == null ? Collections.emptyMap() : parts.preview(known);
        } catch (LinkageError e) {
            return Preview.none(SearCalls.missing(e));
        }
    }

    /**
     * Returns the ground for panels, which ask once per world; empty without a terrain. {@code TerrainJson} describes
     * the form.
     */
    public Map<String, Object> getTerrain() {
        return calls.attempt(() -> parts.terrain());
    }

    /**
     * Returns the appearance of shapes for the 3D view of panels. {@code LookTable} describes the form.
     *
     * @param wanted keys of looks and pictures that the panel lacks
     */
    public List<Map<String, Object>> getLooks(List<String> wanted) {
        return calls.attempt(() -> parts.looks(wanted));
    }

    /**
     * Returns a camera's last due picture for panels; empty if there is none. {@code CameraPicture} describes the form.
     *
     * @param longest maximum of the longer side, pixels; smaller pictures are not enlarged
     * @param column column of the pixel to describe in words; negative for none
     */
    public Map<String, Object> getCameraPicture(String name, int longest, int column, int row) {
        return calls.attempt(() -> parts.cameraPicture(ScriptText.of(name), longest, column, row));
    }

    /** Applies a panel's edit; {@link #publishEdit} sends its result or errors to all panels. */
    public void tryEdit(Map<String, Object> edit) {
        edited(calls.attempt(() -> parts.edits().attempt(edit)));
    }

    /** Publishes an edit's result to panels. {@code Edits} describes the form. */
    public Map<String, Object> publishEdit(Map<String, Object> answer) {
        return answer;
    }

    /** Returns what undo and redo would do now, for panels. */
    public Map<String, Object> getEdits() {
        return calls.attempt(Edits::state);
    }

    /** Returns an object of the project as in its file, for panels. {@code ProjectEditor} describes the form. */
    public Map<String, Object> getProjectObject(String name) {
        return calls.attempt(() -> Edits.object(String.valueOf(ScriptText.of(name))));
    }

    /** Returns the records in the working folder, for panels. */
    public List<String> getRecords() {
        return calls.attempt(() -> Records.list());
    }

    /** Returns the poses of a record over time, for panels that replay it. {@code Records} describes the form. */
    public Map<String, Object> getRecordFrames(String path) {
        return calls.attempt(() -> parts.recordFrames(path));
    }

    /**
     * Returns a camera's last picture at a time of a record, for panels; empty if there is none. {@code CameraPicture}
     * describes the form.
     *
     * @param time seconds since the record began
     * @param longest maximum of the longer side, pixels; smaller pictures are not enlarged
     * @param column column of the pixel to describe in words; negative for none
     */
    public Map<String, Object> getRecordPicture(String path, String name, double time, int longest,
        int column, int row) {
        return calls.attempt(() -> parts.recordPicture(path, ScriptText.of(name), time, longest, column, row));
    }

    /**
     * Returns rotations and sensor readings of a record, for panels that share it. {@code RecordMotion} describes the
     * form.
     */
    public Map<String, Object> getRecordMotion(String path) {
        return calls.attempt(() -> parts.recordMotion(path));
    }

    /** Publishes to panels why a project could not be started or loaded. */
    public List<Problem> publishProblems(List<Problem> problems) {
        return problems;
    }

    /**
     * Saves the project for a panel; replaces a file only with {@code overwrite}. {@code Projects} describes the
     * result's form.
     */
    public Map<String, Object> saveProjectAs(String path, boolean overwrite) {
        return replaced(() -> parts.projects().saveAs(bundle(path).toString(), overwrite));
    }

    /**
     * Receives a part of a bundle from a panel, in base64. The last part loads the project and publishes
     * publishUploaded.
     */
    public void uploadProject(String name, int index, int count, String data) {
        if (calls.attempt(() -> parts.transfers().receive(name, index, count, data))) {
            changed();
            invoke("publishUploaded", "loaded " + name);
        }
    }

    /** Publishes that an uploaded project is loaded. */
    public String publishUploaded(String message) {
        return message;
    }

    /** Returns a part of the project's bundle for a panel: index, count, data in base64. Part 0 creates the bundle. */
    public Map<String, Object> getBundle(int index) {
        return calls.attempt(() -> parts.transfers().part(index));
    }

    /** Returns the user's own and kept projects, for panels. {@code Projects} describes the form. */
    public List<Map<String, Object>> getProjects() {
        return calls.attempt(() -> parts.projects().list());
    }

    /** Returns a picture of one of {@link #getProjects} from above, for panels. {@code Projects} describes the form. */
    public Map<String, Object> getProjectPicture(String path) {
        return calls.attempt(() -> parts.projects().picture(String.valueOf(ScriptText.of(path))));
    }

    /** Publishes to panels that another project has replaced the user's: path and contents of the backup. */
    public Map<String, Object> publishKept(Map<String, Object> kept) {
        return kept;
    }

    /** Returns the paths of example projects, for panels. */
    public List<String> getExamples() {
        return calls.attempt(() -> parts.projects().examples());
    }

    /** Returns the calls for scripts, for panels with an editor: type, name, parameters and doc of each. */
    public List<Map<String, String>> getScriptCalls() {
        return calls.attempt(ScriptCalls::list);
    }

    /** Makes the service named python run an example script, as that service's tab does; returns immediately. */
    public void runExampleScript(String name) {
        calls.act(() -> send(ExampleScripts.runner(), "exec", ExampleScripts.text(ScriptText.of(name)), false));
    }

    /** Runs a call that changes which project is open or where its file is. */
    private <T> T replaced(Callable<T> work) {
        T answer = calls.attempt(work);
        changed();
        return answer;
    }

    private static Path bundle(String path) {
        if (path == null) {
            throw new IllegalArgumentException("the path is missing (None), legal: the path of a bundle, such as "
                + "\"robot.sear\"");
        }
        return ScriptText.path(path);
    }

    private static String text(Path path) {
        return path == null ? null : path.toString();
    }

    // ---- MyRobotLab -------------------------------------------------------------------------------------------------

    /**
     * Sends bytes of a device's Serial service straight to the device, and handles lock-step's fences immediately.
     * MyRobotLab handles all other messages.
     */
    @Override
    public void in(Message message) {
        if (!isOurs(message)) {
            super.in(message);
        }
    }

    /** For a MyRobotLab that delivers messages without {@link #in}. */
    @Override
    public boolean preProcessHook(Message message) {
        return !isOurs(message) && super.preProcessHook(message);
    }

    private boolean isOurs(Message message) {
        return SearParts.takesBytes(parts, message) || SearParts.isFence(message)
            || ScriptErrors.takes(message, hint -> warn("%s", hint));
    }

    boolean isWhole() {
        return parts != null;
    }

    /** Publishes a change of the simulation's state. */
    void changed() {
        simulating = isSimulating();
        paused = simulating && parts.control().session().isPaused();
        recorded = parts != null && parts.recording().isOn();
        ProjectOrigin origin = parts == null ? ProjectOrigin.NONE : parts.projects().origin();
        project = origin.path;
        saved = origin.saved;
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
            present.publisher().finish();    // while there is still something to publish
        }
        parts = null;
        simulating = false;
        if (present != null) {
            present.close();
        }
    }
}
