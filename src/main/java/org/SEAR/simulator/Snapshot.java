package org.SEAR.simulator;

import java.util.List;
import java.util.Map;
import org.SEAR.geometry.Pose;

/** The state of the world after one step, for everybody who looks. Immutable, any thread. */
public final class Snapshot {
    /** Steps since start or reset. */
    public final long step;
    /** Simulated seconds. */
    public final double time;
    /** Poses of the environment objects, in the order of {@code Project.getEnvironment()}. */
    public final List<Pose> environment;
    /** In the order of {@code Project.getRobots()}. */
    public final List<RobotState> robots;
    /** Readings of the watched sensors by name. */
    public final Map<String, Object> readings;
    /** Contact points of this step, world frame {x, y, z}; empty unless debug shapes were asked for. */
    public final List<double[]> contacts;
    /** What the user should know, in plain words. */
    public final List<String> warnings;

    Snapshot(long step, double time, List<Pose> environment, List<RobotState> robots, Map<String, Object> readings,
            List<double[]> contacts, List<String> warnings) {
        this.step = step;
        this.time = time;
        this.environment = environment;
        this.robots = robots;
        this.readings = readings;
        this.contacts = contacts;
        this.warnings = warnings;
    }

    /** One robot's share of a snapshot. Immutable. */
    public static final class RobotState {
        public final String name;
        public final Pose pose;
        /** m/s along the body's forward axis. */
        public final double speed;
        /** rad/s about the body's up axis, + counter-clockwise. */
        public final double turnRate;
        /** Pose of each wheel in the body frame, spin included, in the order of {@code SEARrobot.getWheels()}. */
        public final List<Pose> wheels;
        /** Status lines of its devices. */
        public final List<String> status;
        /** Whether one of its devices takes drive commands: who sends them drives. */
        public final boolean commanded;

        RobotState(String name, Pose pose, double speed, double turnRate, List<Pose> wheels, List<String> status, boolean commanded) {
            this.name = name;
            this.pose = pose;
            this.speed = speed;
            this.turnRate = turnRate;
            this.wheels = wheels;
            this.status = status;
            this.commanded = commanded;
        }
    }
}
