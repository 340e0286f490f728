// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.readings;

import java.util.List;
import java.util.stream.IntStream;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.grammar.ScriptText;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.Robot;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.OdometerSensor;
import org.SEAR.sensors.Sensor;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.service.sear.run.SimulationControl;

/** Readings in the types and units of the dissertation's script calls. Any thread. */
public final class ScriptReadings {
    private final SimulationControl control;

    public ScriptReadings(SimulationControl control) {
        this.control = control;
    }

    /** Returns metres to the nearest hit; the sensor's range without a hit. */
    public double distance(String name) throws InterruptedException {
        return (Double) read(name, Distance.class);
    }

    /** Returns "x,y,z" in m/s^2. */
    public String acceleration(String name) throws InterruptedException {
        return (String) read(name, Accelerometer.class);
    }

    /** Returns "x,y,z" in rad/s. */
    public String rates(String name) throws InterruptedException {
        return (String) read(name, Gyroscope.class);
    }

    /** Returns degrees clockwise from north, (-180, 180]. */
    public double heading(String name) throws InterruptedException {
        return (Double) read(name, Compass.class);
    }

    /** Returns metres, right to left; the sensor's range without a hit. */
    public float[] scan(String name) throws InterruptedException {
        return (float[]) read(name, LIDAR.class);
    }

    /** Returns the direction of each range of a scan, degrees from straight ahead, left positive. */
    public double[] angles(String asked) throws InterruptedException {
        String name = given(asked);
        return control.session().ask(world -> {
            mustBe(LIDAR.class, world, name);
            LidarScan scan = world.read(name).scan();
            return IntStream.range(0, scan.size()).mapToDouble(scan::angle).toArray();
        });
    }

    /** Returns [latitude, longitude, altitude] in degrees and metres. */
    public double[] position(String name) throws InterruptedException {
        return (double[]) read(name, GPS.class);
    }

    /** Returns the result of the sensor's get...Result call, for publishing. */
    public Object any(String name) throws InterruptedException {
        return read(name, SearObject.class);
    }

    /** Returns the unit of the sensor's reading; empty if it has none. */
    public String unit(String asked) {
        return control.session().getSimulation().getUnit(given(asked));
    }

    private Object read(String asked, Class<? extends SearObject> type) throws InterruptedException {
        String name = given(asked);
        return control.session().ask(world -> {
            if (type != SearObject.class || !world.getJoints().isRead(name)) {
                mustBe(type, world, name);
            }
            return world.read(name).value();
        });
    }

    private static void mustBe(Class<? extends SearObject> type, Simulation world, String name) {
        SearObject object = world.getSensor(name).getParameters();
        if (!type.isInstance(object)) {
            throw new IllegalArgumentException("sensor " + name + " is a " + object.getClass()
                .getSimpleName() + ", not a"
                + (type.getSimpleName().matches("[AEIOU].*") ? "n " : " ") + type.getSimpleName() + "; sensors: "
                    + describe(world));
        }
    }

    /**
     * Checks that the sensor or joint exists.
     *
     * @throws IllegalArgumentException with the available sensors
     */
    void check(String name) {
        Simulation world = control.session().getSimulation();
        if (!world.getJoints().isRead(name)) {
            world.getSensor(name);
        }
    }

    private static String describe(Simulation world) {
        StringBuilder text = new StringBuilder();
        for (String name : world.getSensorNames()) {
            text.append(text.length() == 0 ? "" : ", ").append(name).append(" (")
                .append(world.getSensor(name).getParameters().getClass().getSimpleName()).append(')');
        }
        return text.toString();
    }

    /**
     * Returns a robot's odometer reading, metres, forward positive. An Odometer object counts like a Roomba: since the
     * last call, at most 32.767 m either way. A robot without one returns the distance since start or reset.
     *
     * @param robot its name, or null for the first
     */
    public double odometer(String robot) throws InterruptedException {
        return control.session().ask(world -> {
            Robot asked = robot(world, robot);
            for (Sensor<?> sensor : asked.getSensors()) {
                if (sensor instanceof OdometerSensor) {
                    return ((OdometerSensor) sensor).take(asked.getTruth()).getMetres();
                }
            }
            return asked.getTruth().odometry();
        });
    }

    /** Returns the names of all sensors. */
    public List<String> names() {
        return control.session().getSimulation().getSensorNames();
    }

    /**
     * Returns a robot by name, or the first.
     *
     * @throws IllegalArgumentException with the available robots
     */
    static Robot robot(Simulation world, String asked) {
        String name = ScriptText.of(asked);
        for (Robot robot : world.getRobots()) {
            if (name == null || robot.getObject().getName().equals(name)) {
                return robot;
            }
        }
        StringBuilder names = new StringBuilder();
        world.getRobots().forEach(robot -> names.append(' ').append(robot.getObject().getName()));
        throw new IllegalArgumentException(name == null ? "the project has no robot" : "there is no robot \"" + name
            + "\"; robots:" + names);
    }

    /** Returns [x, y, z, rx, ry, rz] in the world, metres and degrees, of a robot, an object, a part or a sensor. */
    public double[] pose(String asked) throws InterruptedException {
        String name = given(asked);
        return control.session().ask(world -> asNumbers(world.getPose(name)));
    }

    /** Returns the world's y of the ground, metres; before the start from the project's files. */
    public double groundHeight(double x, double z) throws InterruptedException, ProjectException {
        if (!control.isRunning()) {
            return ProjectSwap.undisturbed(() -> Simulation.groundHeight(Project.read(Project.presentFolder()), x, z));
        }
        return control.session().ask(world -> world.getGroundHeight(x, z));
    }

    private static String given(String name) {
        if (name == null) {
            throw new IllegalArgumentException("the name is missing (None), legal: the name of a sensor, robot, "
                + "part or object");
        }
        return ScriptText.of(name);
    }

    private static double[] asNumbers(Pose pose) {
        double[] angles = EulerAngles.degrees(pose);
        return new double[] {pose.x, pose.y, pose.z, angles[0], angles[1], angles[2]};
    }
}
