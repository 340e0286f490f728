// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The state of the world for panels. Metres, degrees and seconds; a pose is {x, y, z, rx, ry, rz}, rounded to tenths of
 * a millimetre and thousandths of a degree. Constant fields are null in a state of movement.
 */
class WorldState extends JsonForm {
    /** Seconds; null in an empty world. */
    Double time;
    Long step;
    List<Thing> objects = new ArrayList<>();
    List<Mover> robots = new ArrayList<>();
    List<Probe> sensors = new ArrayList<>();

    /** An object of the environment, or a visible part of a robot. */
    static final class Thing extends JsonForm {
        /** For a part: pose in its robot's body. */
        double[] pose;
        String name;
        /** For example {@code Box}. */
        String type;
        /** Points that give the outline from any side, in the object's frame. */
        double[][] corners;
        /** See {@link LookTable}; empty for a look without mesh. Shapes only, like the next three. */
        String look;
        /** For example {@code textures/cardboard.png}. */
        Optional<String> picture;
        /** For example {@code #c49a6c}. */
        String color;
        /** Whether the colour is set, not the type's default. */
        Boolean colored;
        /** Whether the object has a mass and can be moved. */
        Boolean loose;
        /** For a floor with its own picture: size of its repetition, metres; 0 if it covers the floor once. */
        Double tile;
        /** For a wheel: whether it can be driven. */
        Boolean driven;
        /** For a wheel: name of its motor, if any. */
        String motor;
        /** For a model: whether it is ground. */
        Boolean terrain;
        /** For a terrain: its stamp, see {@link TerrainMap}. */
        String ground;
    }

    /** A robot. */
    static final class Mover extends JsonForm {
        double[] pose;
        /** Pose after a reset. */
        double[] start;
        /** Start pose in the robot's file. */
        double[] written;
        /** Metres per second along the forward axis. */
        Double speed;
        /** Radians per second about the up axis, counter-clockwise positive. */
        Double turnRate;
        List<Device> devices;
        /** Poses of the rotated wheels in the body, in their order among the parts. */
        double[][] wheels;
        /** Poses of the other parts in the body, if the robot has servos. */
        double[][] turned;
        /** Brightness of each light, 0 to 1, if the robot has any. */
        List<Double> lights;
        /** Poses of the lights in the body, if the robot also has servos. */
        double[][] turnedLeds;
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
        String name;
        /** Whether the device has power. */
        boolean on;
        /** Activity as text. */
        String status;
        /** Boards only. */
        List<Pin> pins;
    }

    /** A pin of a board. */
    static final class Pin extends JsonForm {
        String pin;
        String wired;
        String mode;
        String value;
    }

    /** A light of a robot. */
    static final class Lamp extends JsonForm {
        /** Pose in the body. */
        double[] pose;
        String name;
        /** For example {@code #00ff00}. */
        String color;
        /** Colour of the unlit light. */
        String dark;
        double size;
    }

    /** Stability of a robot. */
    static final class Balance extends JsonForm {
        /** Centre of mass in the body. */
        double[] centre;
        /** Corners of the support polygon. */
        double[][] support;
        /** Whether the robot tips over easily. */
        boolean critical;
        String words;
    }

    /** A sensor and its reading. */
    static final class Probe extends JsonForm {
        double[] pose;
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

    /** Properties of a camera; panels request its pictures, see {@link CameraPicture}. */
    static final class EyeForm extends JsonForm {
        /** For example {@code depth}. */
        String kind;
        /** Pixels per row. */
        int width;
        int height;
        /** Edge of the field of view, see {@link org.SEAR.scene.ViewCone}: x, y, z of each point. */
        float[] edge;
    }

    /** A cone of beams. */
    static final class BeamForm extends JsonForm {
        double halfAngle;
        double range;
        double yaw;
    }
}
