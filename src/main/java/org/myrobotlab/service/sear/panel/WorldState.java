package org.myrobotlab.service.sear.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The state of the world as panels get it. Metres, degrees and seconds; a pose is {x, y, z, rx, ry, rz}, rounded to tenths of millimetres and
 * thousandths of degrees. What doesn't change from step to step is null in a state that tells movement only.
 */
class WorldState extends JsonForm {
    /** Seconds; null in a world without anything in it. */
    Double time;
    Long step;
    List<Thing> objects = new ArrayList<>();
    List<Mover> robots = new ArrayList<>();
    List<Probe> sensors = new ArrayList<>();

    /** An object of the environment, or a part of a robot that is seen. */
    static final class Thing extends JsonForm {
        /** Of a part: in its robot's body. */
        double[] pose;
        String name;
        /** {@code Box}. */
        String type;
        /** Enough points for its outline from any side, in its own frame. */
        double[][] corners;
        /** See {@link LookTable}; empty if it is not told. Of shapes, as the three that follow. */
        String look;
        /** {@code textures/cardboard.png}. */
        Optional<String> picture;
        /** {@code #c49a6c}. */
        String color;
        /** Whether the colour is its own, not its kind's. */
        Boolean colored;
        /** Whether it has a mass, and so can be moved. */
        Boolean loose;
        /** Of a floor with a picture of its own: metres after which that is repeated, 0 if it covers the floor once. */
        Double tile;
        /** Of a wheel: whether a motor may turn it. */
        Boolean driven;
        /** Of a wheel: the name of the motor that turns it, if one does. */
        String motor;
        /** Of a model: whether it is ground. */
        Boolean terrain;
        /** Of a terrain: its stamp, see {@link TerrainMap}. */
        String ground;
    }

    /** A robot. */
    static final class Mover extends JsonForm {
        double[] pose;
        /** Its pose after a reset. */
        double[] start;
        /** What its file says of that. */
        double[] written;
        /** Metres a second, along its forward axis. */
        Double speed;
        /** Radians a second about the axis up, + counter-clockwise. */
        Double turnRate;
        List<Device> devices;
        /** Poses in the body, as the wheels have turned; in their order among the parts. */
        double[][] wheels;
        /** Poses in the body of the other parts, if the robot has servos. */
        double[][] turned;
        /** How bright each of its lights is, 0 to 1; if it has any. */
        List<Double> lights;
        /** Poses in the body of the lights, if the robot has servos, too. */
        double[][] turnedLeds;
        String name;
        Double radius;
        /** Whether it has driven wheels. */
        Boolean drives;
        /** Whether its driven wheels turn it, by two sides at different speeds. */
        Boolean turns;
        /** If it has steered wheels. */
        SteeringKeys steered;
        /** Where it was, {x, z}. */
        List<double[]> path;
        List<Thing> parts;
        /** Its lights, if it has any. */
        List<Lamp> leds;
        Balance balance;
    }

    /** A device of a robot. */
    static final class Device extends JsonForm {
        String name;
        /** Whether it has power. */
        boolean on;
        /** What it is doing, in words. */
        String status;
        /** Of a board only. */
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
        /** In the body. */
        double[] pose;
        String name;
        /** {@code #00ff00}. */
        String color;
        /** What is seen of it when it is dark. */
        String dark;
        double size;
    }

    /** How a robot stands. */
    static final class Balance extends JsonForm {
        /** Of mass, in the body. */
        double[] centre;
        /** The corners of what it stands on. */
        double[][] support;
        /** Whether it tips over easily. */
        boolean critical;
        String words;
    }

    /** A sensor and what it reads. */
    static final class Probe extends JsonForm {
        double[] pose;
        /** What scripts get; of a scanner the ranges stand in its place. */
        Optional<Object> value;
        /** Of a scanner. */
        ScanRanges ranges;
        /** Where the nearest beam met something; only if beams meet something at a place. */
        Optional<double[]> hit;
        /** {@code 1.250 m}. */
        String words;
        /** As records keep them; null where there is none. */
        List<Double> numbers;
        /** An address of its own, {@code data:image/png;base64,..}; of a sensor that takes pictures. */
        String picture;
        /** With its robot's, {@code myRoomba/Ping1}. */
        String name;
        String type;
        String robot;
        /** Of the value. */
        String unit;
        /** Of the numbers, to be put behind the sensor's. */
        List<String> names;
        /** Of a distance sensor. */
        List<BeamForm> cones;
        /** Of a scanner: unit vectors of its beams in its own frame. */
        List<float[]> fan;
        /** Of a camera. */
        EyeForm eye;
    }

    /** What a camera is: its pictures are asked for, see {@link CameraPicture}. */
    static final class EyeForm extends JsonForm {
        /** {@code depth}. */
        String kind;
        /** Pixels of a row. */
        int width;
        /** Rows. */
        int height;
        /** The edge of its picture, as {@link org.SEAR.scene.ViewCone} has it: x, y, z of each point. */
        float[] edge;
    }

    /** A cone of beams. */
    static final class BeamForm extends JsonForm {
        double halfAngle;
        double range;
        double yaw;
    }
}
