// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.List;
import java.util.Map;
import org.SEAR.devices.PinState;
import org.SEAR.geometry.Pose;
import org.SEAR.sensors.Reading;

/** State of the world after one step. Immutable, any thread. */
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
    public final Map<String, Reading> readings;
    /**
     * Contact points of this step, {x, y, z}, world frame, metres; empty unless {@link Simulation#showContacts} is on.
     */
    public final List<double[]> contacts;
    /** Warnings for the user. */
    public final List<String> warnings;

    public Snapshot(long step, double time, List<Pose> environment, List<RobotState> robots,
        Map<String, Reading> readings, List<double[]> contacts, List<String> warnings) {
        this.step = step;
        this.time = time;
        this.environment = environment;
        this.robots = robots;
        this.readings = readings;
        this.contacts = contacts;
        this.warnings = warnings;
    }

    /** One serial device. Immutable. */
    public static final class DeviceState {
        /** Name of the object with its ports, as {@link Simulation#power} takes it. */
        public final String name;
        public final boolean powered;
        /** Present activity, as text. */
        public final String status;
        /** Its connected pins. */
        public final List<PinState> pins;

        public DeviceState(String name, boolean powered, String status, List<PinState> pins) {
            this.name = name;
            this.powered = powered;
            this.status = status;
            this.pins = pins;
        }

        /** Returns its status line for users. */
        @Override
        public String toString() {
            return name + ": " + status;
        }
    }

    /** One robot's share of a snapshot. Immutable. */
    public static final class RobotState {
        public final String name;
        public final Pose pose;
        /** Speed along the body's forward axis, m/s. */
        public final double speed;
        /** Turn rate about the body's up axis, rad/s, + counter-clockwise. */
        public final double turnRate;
        /** Pose of each wheel in the body frame, rotation included, in the order of {@code SEARrobot.getWheels()}. */
        public final List<Pose> wheels;
        /**
         * Pose of each component in the body frame, in the order of {@code SEARrobot.getComponents()}; empty if no
         * servo can turn any.
         */
        public final List<Pose> parts;
        /** Brightness of each of its lights, 0 to 1, in the order of {@code SEARrobot.getComponents()}. */
        public final List<Double> lights;
        public final List<DeviceState> devices;
        /** Whether one of its devices accepts drive commands, so that its host drives the robot. */
        public final boolean commanded;

        public RobotState(String name, Pose pose, double speed, double turnRate, List<Pose> wheels, List<Pose> parts,
                List<Double> lights, List<DeviceState> devices, boolean commanded) {
            this.name = name;
            this.pose = pose;
            this.speed = speed;
            this.turnRate = turnRate;
            this.wheels = wheels;
            this.parts = parts;
            this.lights = lights;
            this.devices = devices;
            this.commanded = commanded;
        }
    }
}
