// SPDX-License-Identifier: Apache-2.0
package org.SEAR.scene;

import java.util.List;
import org.SEAR.POJOs.BeamCone;
import org.SEAR.geometry.Pose;

/**
 * Drawing data of one sensor's beams: directions in the sensor's frame, maximum lengths and colours. Immutable, any
 * thread.
 */
public final class BeamFan {
    public final String sensor;
    /** Number of the robot that carries the sensor. */
    public final int robot;
    /** Number of the sensor among the robot's components. */
    public final int part;
    /** Pose of the sensor in the robot's body frame, unless a servo turns it. */
    public final Pose mount;
    /** Unit vectors x, y, z of each beam, sensor frame. */
    public final float[] directions;
    /** Maximum length of each beam, metres. */
    public final float[] ranges;
    /** Red, green, blue of each beam. */
    public final float[] colors;
    /** Numbers of the beams drawn as lines; a subset if there are very many. */
    public final int[] lines;
    /** Colour of the spheres at hits, 0xrrggbb. */
    public final int hitColor;
    /** Radius of these spheres, metres. */
    public final float hitRadius;
    /** Cones of a distance sensor; empty for a plane of beams. */
    public final List<BeamCone> cones;
    /** Whether a beam ends at its hit. Otherwise it has its full length, and only the sphere shows the hit. */
    public final boolean cut;

    BeamFan(String sensor, int robot, int part, Pose mount, float[] directions, float[] ranges, float[] colors,
        int[] lines, int hitColor, float hitRadius, List<BeamCone> cones) {
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
        this.cones = cones;
        cut = cones.isEmpty();
    }

    public int size() {
        return ranges.length;
    }
}
