// SPDX-License-Identifier: Apache-2.0
package org.SEAR.scene;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.SEAR.geometry.Pose;

/**
 * State of the world after one step, for drawing in the window and the tab. Created by {@link SceneStates}. Immutable,
 * any thread.
 */
public final class SceneState {
    /** Steps since start or reset. */
    public final long step;
    /** Simulated time, seconds. */
    public final double time;
    /** Poses of the environment objects, in the project's order. */
    public final List<Pose> environment;
    /** The robots, in the project's order. */
    public final List<RobotState> robots;
    /** Beam lengths by sensor, metres, in the order of its {@link BeamFan}; infinite without a hit. */
    public final Map<String, double[]> beams;
    /** Readings as text with unit, by sensor name. */
    public final Map<String, String> values;
    /** Contact points {x, y, z} in the world, metres. */
    public final List<double[]> contacts;
    /** Warnings for the user. */
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

    /** State of one robot. Immutable. */
    public static final class RobotState {
        public final String name;
        public final Pose pose;
        /** Speed along the forward axis, m/s. */
        public final double speed;
        /** Turn rate about the up axis, rad/s, + counter-clockwise. */
        public final double turnRate;
        /** Poses of the wheels in the body frame, including rolling. */
        public final List<Pose> wheels;
        /**
         * Poses of the components in the body frame; empty if no servo can turn any. Components are then at their
         * objects' poses.
         */
        public final List<Pose> parts;
        /** Brightness of each light, 0 to 1, in the order of the components. */
        public final List<Double> lights;
        /** Status lines of the devices. */
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

        /** Returns the heading of the forward axis: degrees clockwise from north (+x), (-180, 180]. */
        public double heading() {
            return pose.heading();
        }
    }
}
