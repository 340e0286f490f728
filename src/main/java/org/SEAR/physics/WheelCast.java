// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.collision.PlacedConvex;
import org.SEAR.collision.WheelSweep;
import org.SEAR.collision.WheelTouch;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.solid.BoxSolid;
import org.SEAR.physics.solid.Solid;
import org.SEAR.raycast.ShapeFinder;

/**
 * Finds the ground under a wheel: the shape that the wheel touches first as it moves down along its suspension.
 * Simulation thread.
 */
public final class WheelCast {
    /** Smallest cosine between the normal of a box's face and the suspension of a face to test. */
    private static final double FACES_UP = 1e-9;

    private final RaycastScenes scenes;
    private final ShapeFinder finder;
    private final WheelSweep sweep = new WheelSweep();
    private final Aabb box = new Aabb();
    private final Vec3 up = new Vec3();
    private final double[] frame = new double[12];
    private final double[] corners = new double[12];
    private final PlacedConvex convex = new PlacedConvex();
    private final ShapeFinder.Triangles triangles = at -> sweep.polygon(at, 3);

    WheelCast(RaycastScenes scenes) {
        this.scenes = scenes;
        finder = new ShapeFinder(scenes.ground);
    }

    /**
     * Sets the wheel.
     * @param mount of its suspension, world frame, metres
     * @param newUp unit direction of the suspension, world frame
     * @param ahead unit direction of rolling, at right angles to it
     * @param half of the width, metres
     * @param ball whether it is a ball
     */
    public void set(Vec3 mount, Vec3 newUp, Vec3 ahead, double radius, double half, boolean ball) {
        up.set(newUp);
        sweep.set(mount, newUp, ahead, radius, half, ball);
    }

    /**
     * Searches contacts.
     * @param lowest height of the wheel's centre above its mount, metres, above which a contact counts
     * @param limit greatest height of a contact point above the mount, metres
     * @param least smallest cosine between the normal of a contact and the suspension
     * @param owner number of the robot, whose parts are not ground
     */
    public void find(double lowest, double limit, double least, int owner) {
        sweep.begin(lowest, limit, least);
        if (!sweep.bounds(box)) {
            return;
        }
        int count = finder.find(box, owner);
        for (int i = 0; i < count; i++) {
            sweep(finder.get(i));
        }
    }

    private void sweep(int number) {
        Solid solid = scenes.solid(number);
        sweep.setShape(number);
        if (finder.isMesh(number)) {
            finder.triangles(number, box, triangles);
            return;
        }
        scenes.ground.frame(number, frame);
        if (solid instanceof BoxSolid) {
            box(solid);
            return;
        }
        Placement at = convex.set(solid.convex());
        at.m00 = frame[0];
        at.m01 = frame[1];
        at.m02 = frame[2];
        at.m10 = frame[3];
        at.m11 = frame[4];
        at.m12 = frame[5];
        at.m20 = frame[6];
        at.m21 = frame[7];
        at.m22 = frame[8];
        at.x = frame[9];
        at.y = frame[10];
        at.z = frame[11];
        sweep.convex(convex);
    }

    /** Sweeps the wheel to the upper faces of a box, the most level one first. */
    private void box(Solid solid) {
        int level = 0;
        for (int axis = 1; axis < 3; axis++) {
            level = Math.abs(rise(axis)) > Math.abs(rise(level)) ? axis : level;
        }
        boolean done = face(level, solid);
        for (int axis = 0; axis < 3 && !done; axis++) {
            done = axis != level && Math.abs(rise(axis)) > FACES_UP && face(axis, solid);
        }
    }

    private double rise(int axis) {
        return frame[axis] * up.x + frame[3 + axis] * up.y + frame[6 + axis] * up.z;
    }

    private boolean face(int axis, Solid solid) {
        double x = axis == 0 ? Math.copySign(solid.halfX, rise(0)) : solid.halfX;
        double y = axis == 1 ? Math.copySign(solid.halfY, rise(1)) : solid.halfY;
        double z = axis == 2 ? Math.copySign(solid.halfZ, rise(2)) : solid.halfZ;
        for (int i = 0; i < 4; i++) {
            double first = i == 0 || i == 3 ? 1 : -1;
            double second = i < 2 ? 1 : -1;
            corner(i, axis == 0 ? x : first * x, axis == 1 ? y : (axis == 0 ? first : second) * y,
                axis == 2 ? z : second * z);
        }
        return sweep.polygon(corners, 4);
    }

    private void corner(int number, double x, double y, double z) {
        for (int k = 0; k < 3; k++) {
            corners[3 * number + k] = frame[9 + k] + frame[3 * k] * x + frame[3 * k + 1] * y + frame[3 * k + 2] * z;
        }
    }

    /** Returns the number of nodes that searches have visited so far. */
    public long getNodes() {
        return finder.getNodes();
    }

    /**
     * Returns the highest contact.
     * @param other a contact to leave out; null for none
     * @return null if there is none
     */
    public WheelTouch highest(WheelTouch other) {
        return sweep.highest(other);
    }
}
