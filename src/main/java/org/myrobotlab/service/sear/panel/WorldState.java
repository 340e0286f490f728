// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.SEAR.POJOs.BeamCone;
import org.SEAR.POJOs.Led;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;
import org.SEAR.robot.Stability;
import org.SEAR.scene.Glow;
import org.SEAR.scene.ViewCone;
import org.SEAR.simulator.Snapshot;

/**
 * A snapshot and the constant data of its world as JSON for panels. Metres, degrees and seconds; a pose is {x, y, z,
 * rx, ry, rz}, rounded to tenths of a millimetre and thousandths of a degree. Constant fields are null in a state of
 * movement. An object's {@link #more} has the properties of its kind, see
 * {@link org.SEAR.POJOs.SearObject#getDrawingProperties}.
 */
class WorldState extends JsonForm {
    /** Seconds; null in an empty world. */
    Double time;
    Long step;
    List<Thing> objects = new ArrayList<>();
    List<Mover> robots = new ArrayList<>();
    List<Probe> sensors = new ArrayList<>();
    List<Link> joints = new ArrayList<>();

    /** An object of the environment, or a visible part of a robot. */
    static final class Thing extends JsonForm {
        /** For a part: pose in its robot's body. */
        final Pose pose;
        String name;
        /** For example {@code Box}. */
        String type;
        /** Points that give the outline from any side, in the object's frame. */
        double[][] corners;
        /** Areas from above: corners of each in the object's frame; null if the outline's hull shows it. */
        double[][][] areas;
        /** See {@link LookTable}; empty for a look without mesh. Shapes only. */
        String look;
        /** For example {@code textures/cardboard.png}. */
        Optional<String> picture;

        Thing(Pose pose) {
            this.pose = pose;
        }
    }

    /** A robot. */
    static final class Mover extends JsonForm {
        Pose pose;
        /** Pose after a reset. */
        Pose start;
        /** Start pose in the robot's file. */
        double[] written;
        /** Metres per second along the forward axis. */
        Double speed;
        /** Radians per second about the up axis, counter-clockwise positive. */
        Double turnRate;
        List<Device> devices;
        /** Poses of the rotated wheels in the body, in their order among the parts. */
        List<Pose> wheels;
        /** Poses of the other parts in the body, if the robot has servos. */
        List<Pose> turned;
        /** Brightness of each light, 0 to 1, if the robot has any. */
        List<Double> lights;
        /** Poses of the lights in the body, if the robot also has servos. */
        List<Pose> turnedLeds;
        String name;
        Double radius;
        /** Whether the robot has driven wheels. */
        Boolean drives;
        /** Whether driven wheels on two sides turn the robot. */
        Boolean turns;
        /** Present if the robot has steered wheels. */
        SteeringKeys steered;
        /** Travelled path, {x, z}. */
        List<double[]> path;
        List<Thing> parts;
        /** The robot's lights, if any. */
        List<Lamp> leds;
        Balance balance;
    }

    /** A device of a robot. */
    static final class Device extends JsonForm {
        final String name;
        /** Whether the device has power. */
        final boolean on;
        /** Activity as text. */
        final String status;
        /** See {@link org.SEAR.devices.PinState}; boards only. */
        final List<Map<String, Object>> pins;

        Device(Snapshot.DeviceState state) {
            name = state.name;
            on = state.powered;
            status = state.status;
            pins = state.pins.isEmpty() ? null : state.pins.stream().map(JsonForm::fields).collect(Collectors.toList());
        }
    }

    /** A light of a robot. */
    static final class Lamp extends JsonForm {
        /** Pose in the body. */
        final Pose pose;
        final String name;
        /** For example {@code #00ff00}. */
        final String color;
        /** Colour of the unlit light. */
        final String dark;
        final double size;

        Lamp(Led led) {
            pose = ObjectPose.of(led);
            name = led.getName();
            color = led.getColor();
            dark = Glow.of(color, 0);
            size = led.getSize();
        }
    }

    /** Stability of a robot. */
    static final class Balance extends JsonForm {
        /** Centre of mass in the body. */
        final double[] centre;
        /** Corners of the support polygon. */
        final double[][] support;
        /** Whether the robot tips over easily. */
        final boolean critical;
        final String words;

        Balance(Stability stability) {
            centre = JsonNumbers.point(stability.getCentre());
            support = JsonNumbers.points(stability.getSupport());
            critical = stability.isCritical();
            words = stability.getWords();
        }
    }

    /** A sensor and its reading. */
    static final class Probe extends JsonForm {
        Pose pose;
        /** The value for scripts; a scanner has ranges instead. */
        Optional<Object> value;
        /** Scanners only. */
        ScanRanges ranges;
        /** Nearest hit of the beams; only for sensors whose beams hit at a point. */
        Optional<double[]> hit;
        /** For example {@code 1.250 m}. */
        String words;
        /** Numbers as in records; null for a missing one. */
        List<Double> numbers;
        /** {@code data:image/png;base64,..}, for sensors that take pictures. */
        String picture;
        /** Full name, for example {@code myRoomba/Ping1}. */
        String name;
        String type;
        String robot;
        /** Unit of the value. */
        String unit;
        /** Names of the numbers, to append to the sensor's. */
        List<String> names;
        /** Distance sensors only. */
        List<BeamForm> cones;
        /** Scanners only: unit vectors of the beams in the sensor's frame. */
        List<float[]> fan;
        /** Cameras only. */
        EyeForm eye;
    }

    /** A joint and its reading. */
    static final class Link extends JsonForm {
        /** Frame on the first object, and on the second. */
        Pose pose;
        Pose end;
        Boolean broken;
        /** For example {@code 45.0 deg, 0.0 deg/s, 1.500 N m}; null without a position, likewise numbers. */
        String words;
        List<Double> numbers;
        String name;
        /** Name of the robot that has it as a part; empty for a joint of the environment. */
        String robot;
        /** For example {@code Hinge}. */
        String type;
        /** Names of the objects or parts; empty for the world or the robot's body. */
        String first;
        String second;
        /** Names of the numbers, to append to the joint's, and their units. */
        List<String> names;
        String unit;
        /** Command that moves its motor, such as {@code setJointPosition}, and its range; null without a motor. */
        String command;
        Double least;
        Double most;
        /** Why it does not move, as text; null if it can. */
        String still;
    }

    /** Properties of a camera; panels request its pictures, see {@link CameraPicture}. */
    static final class EyeForm extends JsonForm {
        /** For example {@code depth}. */
        final String kind;
        /** Pixels per row. */
        final int width;
        final int height;
        /** Edge of the field of view, see {@link ViewCone}: x, y, z of each point. */
        final float[] edge;

        EyeForm(ViewCone cone) {
            kind = cone.camera.getKind();
            width = cone.camera.getWidth();
            height = cone.camera.getHeight();
            edge = cone.edge;
        }
    }

    /** A cone of beams. */
    static final class BeamForm extends JsonForm {
        final double halfAngle;
        final double range;
        final double yaw;

        BeamForm(BeamCone cone) {
            halfAngle = cone.getHalfAngle();
            range = cone.getRange();
            yaw = cone.getYaw();
        }
    }
}
