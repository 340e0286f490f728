package org.SEAR.scene;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.SEAR.geometry.Pose;

/** What is to be drawn of the world after one step, for window and tab. {@link SceneStates} makes it. Immutable, any thread. */
public final class SceneState {
    /** Steps since start or reset. */
    public final long step;
    /** Simulated seconds. */
    public final double time;
    /** Poses of the environment objects, in the project's order. */
    public final List<Pose> environment;
    /** The robots, in the project's order. */
    public final List<RobotState> robots;
    /** Lengths of a beam sensor's beams in metres, in the order of its {@link BeamFan}; infinite where nothing was hit. */
    public final Map<String, double[]> beams;
    /** Readings in words with unit, by sensor name. */
    public final Map<String, String> values;
    /** Contact points {x, y, z} in the world, metres. */
    public final List<double[]> contacts;
    /** What the user should know, in plain words. */
    public final List<String> warnings;

    public SceneState(long step, double time, List<Pose> environment, List<RobotState> robots, Map<String, double[]> beams,
            Map<String, String> values, List<double[]> contacts, List<String> warnings) {
        this.step = step;
        this.time = time;
        this.environment = Collections.unmodifiableList(environment);
        this.robots = Collections.unmodifiableList(robots);
        this.beams = Collections.unmodifiableMap(beams);
        this.values = Collections.unmodifiableMap(values);
        this.contacts = Collections.unmodifiableList(contacts);
        this.warnings = Collections.unmodifiableList(warnings);
    }

    /** One robot's share. Immutable. */
    public static final class RobotState {
        public final String name;
        public final Pose pose;
        /** m/s along the forward axis. */
        public final double speed;
        /** rad/s about the up axis, + counter-clockwise. */
        public final double turnRate;
        /** Wheels in the body frame, spin included. */
        public final List<Pose> wheels;
        /** Components in the body frame; empty if no servo can turn any: they are where their objects are. */
        public final List<Pose> parts;
        /** How bright each of its lights is, 0 to 1, in the order of its components. */
        public final List<Double> lights;
        /** Status lines of its devices. */
        public final List<String> status;

        public RobotState(String name, Pose pose, double speed, double turnRate, List<Pose> wheels, List<Pose> parts, List<Double> lights,
                List<String> status) {
            this.name = name;
            this.pose = pose;
            this.speed = speed;
            this.turnRate = turnRate;
            this.wheels = wheels;
            this.parts = parts;
            this.lights = lights;
            this.status = status;
        }

        /** Heading of the forward axis: degrees clockwise from north (+x), (-180, 180]. */
        public double heading() {
            return pose.heading();
        }
    }
}
