// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import org.SEAR.geometry.Vec3;

/** Contact of a wheel that moves along its suspension, see {@link WheelSweep}. */
public final class WheelTouch {
    /** Contact point and unit normal towards the wheel, world frame, metres. */
    public final Vec3 point = new Vec3();
    public final Vec3 normal = new Vec3();
    /** Height of the wheel's centre above its mount, metres. */
    public double height;
    /** Cosine between the normal and the suspension. */
    public double lean;
    /** Whether it is an edge or corner of a polygon. */
    public boolean edge;
    /** Number of the touched shape. */
    public int shape;

    void set(double newHeight, double newLean, boolean onEdge, int newShape) {
        height = newHeight;
        lean = newLean;
        edge = onEdge;
        shape = newShape;
    }
}
