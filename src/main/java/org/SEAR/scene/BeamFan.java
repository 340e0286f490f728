package org.SEAR.scene;

import org.SEAR.geometry.Pose;

/** The beams of one sensor as they are drawn: directions in the sensor's frame, greatest lengths, colours. Immutable, any thread. */
public final class BeamFan {
    public final String sensor;
    /** Number of the robot that carries the sensor. */
    public final int robot;
    /** Number of the sensor among the robot's components. */
    public final int part;
    /** The sensor in the robot's body frame, unless a servo turns it. */
    public final Pose mount;
    /** Unit vectors x, y, z of each beam, sensor frame. */
    public final float[] directions;
    /** Greatest length of each beam, metres. */
    public final float[] ranges;
    /** Red, green, blue of each beam. */
    public final float[] colors;
    /** Numbers of the beams that are drawn as lines: not all, where there are very many. */
    public final int[] lines;
    /** Colour of the spheres where beams end on something, 0xrrggbb. */
    public final int hitColor;
    /** Radius of these spheres, metres. */
    public final float hitRadius;
    /** Whether a beam ends where it hits; else it is drawn in full length and only the sphere shows the hit. */
    public final boolean cut;

    BeamFan(String sensor, int robot, int part, Pose mount, float[] directions, float[] ranges, float[] colors, int[] lines, int hitColor,
            float hitRadius, boolean cut) {
        this.sensor = sensor;
        this.robot = robot;
        this.part = part;
        this.mount = mount;
        this.directions = directions;
        this.ranges = ranges;
        this.colors = colors;
        this.lines = lines;
        this.hitColor = hitColor;
        this.hitRadius = hitRadius;
        this.cut = cut;
    }

    /** How many beams there are. */
    public int size() {
        return ranges.length;
    }
}
