// SPDX-License-Identifier: Apache-2.0
package org.SEAR.learning;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.devices.RobotHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.DriveOrder;
import org.SEAR.robot.Robot;
import org.SEAR.sensors.Truth;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;

/**
 * A world in which one robot learns; it restarts repeatedly. {@link #step} applies an action for a number of steps and
 * writes state and observation into a buffer. Public because Python calls it. Only the thread that created it.
 */
public final class Episode implements AutoCloseable {
    /** Count of the state's numbers, doubles; the observation's floats and pictures follow. */
    private static final int STATE = 13;
    private static final int STATE_BYTES = STATE * Double.BYTES;
    private static final long MAX_STEPS = 216_000;

    private final Simulation simulation;
    private final Robot robot;
    private final int number;
    private final Pose start;
    private final Observation observation;
    private final double fastest;
    private Controls controls;
    private ByteBuffer memory;
    private boolean bumpedLeft;
    private boolean bumpedRight;
    private boolean touched;

    /**
     * Builds the world of a project.
     *
     * @param name robot name; empty if there is only one
     * @param sensors sensors and joints to observe, in this order; null: all of the robot's sensors except cameras, or
     *     its cameras if it has no others
     * @param things objects whose poses are observed, too
     * @param fastest highest wheel speed over ground, m/s
     * @param seed random seed of the sensors
     * @throws IllegalArgumentException with the legal names
     */
    public Episode(Project project, String name, List<String> sensors, List<String> things, double fastest, long seed)
        throws ProjectException {
        simulation = Simulation.of(project, seed);
        simulation.setThreads(1);
        robot = find(simulation.getRobots(), name);
        number = simulation.getRobots().indexOf(robot);
        start = robot.getStart();
        this.fastest = fastest;
        observation = new Observation(simulation, robot, sensors == null ? Observation.usual(robot) : sensors, things);
        setMemory(ByteBuffer.allocate(getBytes()));
    }

    private static Robot find(List<Robot> robots, String name) {
        List<String> names = robots.stream().map(one -> one.getObject().getName()).collect(Collectors.toList());
        if (robots.isEmpty()) {
            throw new IllegalArgumentException("the project has no robot; legal: one with a robot that drives");
        } else if (name.isEmpty() && robots.size() == 1) {
            return robots.get(0);
        } else if (!names.contains(name)) {
            throw new IllegalArgumentException("robot is " + (name.isEmpty() ? "not given" : "\"" + name + "\"")
                + ", legal: " + String.join(", ", names));
        }
        return robots.get(names.indexOf(name));
    }

    /** Returns the size of state and observation in bytes. */
    public int getBytes() {
        return STATE_BYTES + observation.bytes();
    }

    /** Returns the count of the observation's numbers, floats; the pictures follow. */
    public int getCount() {
        return observation.size();
    }

    /** Returns the observed cameras. */
    public List<String> getPictureNames() {
        return observation.pictureNames();
    }

    /** Returns width and height of each observed camera's picture, pixels. */
    public int[] getPictureSizes() {
        return observation.pictureSizes();
    }

    /** Returns the size of the state in bytes; the observation follows. */
    public int getStateBytes() {
        return STATE_BYTES;
    }

    /** @param newMemory buffer that receives state and observation from now on, in native byte order */
    public void setMemory(ByteBuffer newMemory) {
        if (newMemory.capacity() < getBytes()) {
            throw new IllegalArgumentException("the buffer has " + newMemory.capacity() + " bytes, legal: " + getBytes()
                + " or more");
        }
        memory = newMemory.order(ByteOrder.nativeOrder());
        observation.clear(memory, STATE_BYTES);
        write();
    }

    /** Returns the observed sensors and objects. */
    public List<String> getNames() {
        return observation.names();
    }

    /** Returns the count of numbers of each observed sensor or object. */
    public int[] getSizes() {
        return observation.sizes();
    }

    /** Returns the lower limit of each observed sensor or object. */
    public double[] getLows() {
        return observation.lows();
    }

    /** Returns the upper limit of each observed sensor or object. */
    public double[] getHighs() {
        return observation.highs();
    }

    /** Returns to the start, as in a new world with this seed. */
    public void reset(long seed) {
        simulation.reseed(seed);
        simulation.reset();
        begin();
    }

    /**
     * Returns to the start, with the robot elsewhere on the ground.
     *
     * @param x metres north
     * @param z metres east
     * @param heading degrees, 0 = north, 90 = east
     */
    public void reset(long seed, double x, double z, double heading) {
        if (!Double.isFinite(x) || !Double.isFinite(z) || !Double.isFinite(heading)) {
            throw new IllegalArgumentException("robot " + getRobot() + ": start is x " + x + ", z " + z
                + ", heading " + heading + ", legal: finite numbers");
        }
        simulation.reseed(seed);
        simulation.reset();
        Pose to = Pose.ofDegrees(x, start.y, z, 0, 90 - heading, 0);
        double rise = simulation.rise(getRobot(), between(start, to));
        simulation.move(getRobot(), start, new Pose(x, start.y + rise, z, to.qx, to.qy, to.qz, to.qw));
        begin();
    }

    /** Returns the transformation from one pose to another. */
    private static Pose between(Pose from, Pose to) {
        Pose turn = new Pose(0, 0, 0, to.qx, to.qy, to.qz, to.qw)
            .times(new Pose(0, 0, 0, -from.qx, -from.qy, -from.qz, from.qw));
        double[] at = turn.rotate(from.x, from.y, from.z);
        return new Pose(to.x - at[0], to.y - at[1], to.z - at[2], turn.qx, turn.qy, turn.qz, turn.qw);
    }

    private void begin() {
        bumpedLeft = false;
        bumpedRight = false;
        touched = false;
        observation.clear(memory, STATE_BYTES);
        write();
    }

    /**
     * Drives the wheels at these speeds for a number of steps of 1/60 s.
     *
     * @param left m/s over ground, + forward, likewise right
     */
    public void step(double left, double right, int steps) {
        if (!(Math.abs(left) <= fastest && Math.abs(right) <= fastest)) {
            throw new IllegalArgumentException("robot " + getRobot() + ": wheel speeds are " + left + " and " + right
                + " m/s, legal: -" + fastest + " to " + fastest);
        }
        checkSteps(steps);
        if (left != 0 || right != 0) {
            DriveOrder.checkWheels(robot, left, right);
        }
        simulation.post(DriveCommand.wheels(number, left, right));
        run(steps);
    }

    /**
     * Chooses what the actions of {@link #act} set.
     *
     * @param names each a motor (power, -1 to 1) or servo (degrees) of the robot, a joint with a motor (its position
     *     between limits, else its speed; or with the ending ".position", ".speed" or ".power"), else "left", "right"
     *     or "speed" (wheel speeds, m/s; "speed" for both), or "steering" (degrees, + left)
     * @throws IllegalArgumentException with the legal names
     */
    public void setControls(List<String> names) {
        controls = new Controls(simulation, robot, number, fastest, names);
    }

    /**
     * Checks an action of {@link #act}.
     *
     * @throws IllegalArgumentException with the name, the value and the legal range
     */
    public void check(double... values) {
        controls.check(values);
    }

    /**
     * Sets the controls for a number of steps of 1/60 s.
     *
     * @param values one for each of {@link #setControls}
     */
    public void act(double[] values, int steps) {
        checkSteps(steps);
        controls.check(values);
        controls.give(values);
        run(steps);
    }

    private static void checkSteps(int steps) {
        if (steps < 1 || steps > MAX_STEPS) {
            throw new IllegalArgumentException("steps of an action are " + steps + ", legal: 1 to " + MAX_STEPS);
        }
    }

    private void run(int steps) {
        RobotHardware hardware = robot.getHardware();
        Truth truth = robot.getTruth();
        bumpedLeft = false;
        bumpedRight = false;
        touched = false;
        for (int i = 0; i < steps; i++) {
            simulation.step();
            bumpedLeft |= hardware.isBumpedLeft();
            bumpedRight |= hardware.isBumpedRight();
            touched |= truth.isTouched(null);
        }
        write();
    }

    private void write() {
        Pose pose = robot.getPose();
        Truth truth = robot.getTruth();
        double[] ahead = pose.rotate(0, 0, 1);
        double[] up = pose.rotate(0, 1, 0);
        double[] velocity = truth.velocity();
        double[] turn = truth.angularVelocity();
        put(0, simulation.getTime());
        put(1, pose.x);
        put(2, pose.y);
        put(3, pose.z);
        put(4, pose.heading());
        put(5, Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, up[1])))));
        put(6, ahead[0] * velocity[0] + ahead[1] * velocity[1] + ahead[2] * velocity[2]);
        put(7, Math.toDegrees(up[0] * turn[0] + up[1] * turn[1] + up[2] * turn[2]));
        put(8, truth.path());
        put(9, Math.toDegrees(robot.getHardware().getTurned()));
        put(10, bumpedLeft ? 1 : 0);
        put(11, bumpedRight ? 1 : 0);
        put(12, touched ? 1 : 0);
        observation.write(memory, STATE_BYTES);
    }

    private void put(int at, double value) {
        memory.putDouble(at * Double.BYTES, value);
    }

    /** Returns the name of the learning robot. */
    public String getRobot() {
        return robot.getObject().getName();
    }

    Simulation getSimulation() {
        return simulation;
    }

    /** Returns the world from above as a picture, see {@link EpisodePlan#draw}. */
    public byte[] draw(int width, int height) {
        return new EpisodePlan(simulation).draw(width, height);
    }

    /** Releases the world. */
    @Override
    public void close() {
        simulation.close();
    }
}
