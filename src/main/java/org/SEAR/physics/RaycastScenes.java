// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.SEAR.geometry.Frame;
import org.SEAR.physics.solid.Solid;
import org.SEAR.raycast.BeamScene;

/**
 * Scenes for the rays of sensors and of wheels. Both are one scene unless an object is invisible to sensors: wheels
 * still stand on it. Simulation thread.
 */
public final class RaycastScenes {
    /** Height above all objects, metres. */
    private static final double SKY = 2e5;
    /** Number of a shape that is not ground. */
    private static final int NONE = -1;

    /** Scene of the sensors. */
    public final BeamScene beams = new BeamScene();
    /** Scene of the wheels. */
    public final BeamScene ground;
    /** Casts of wheels in it. */
    public final WheelCast wheels;
    /** Ground only, and the number of each solid in it. */
    private final BeamScene heights = new BeamScene();
    private final List<Integer> numbers = new ArrayList<>();
    private final List<Body> owners = new ArrayList<>();
    private final List<Solid> solids = new ArrayList<>();
    private final Set<Body> grounds = Collections.newSetFromMap(new IdentityHashMap<>());

    /** @param invisible whether an object is invisible to sensors */
    public RaycastScenes(boolean invisible) {
        ground = invisible ? new BeamScene() : beams;
        wheels = new WheelCast(this);
    }

    /**
     * Adds a solid of a body.
     * @return its shape number
     */
    public int add(Body body, Solid solid, boolean visible, int owner) {
        int shape = solid.addTo(beams, owner);
        if (ground != beams) {
            solid.addTo(ground, owner);
            beams.setVisible(shape, visible);
        }
        owners.add(body);
        solids.add(solid);
        numbers.add(NONE);
        return shape;
    }

    /** Marks a body as ground to drive on: a floor or the terrain. Its solids must have been added. */
    public void addGround(Body body) {
        grounds.add(body);
        for (int shape = 0; shape < owners.size(); shape++) {
            if (owners.get(shape) == body) {
                numbers.set(shape, solids.get(shape).addTo(heights, BeamScene.WORLD));
            }
        }
    }

    /**
     * Returns the elevation of the highest ground at a point of the world, metres, ignoring objects on it; NaN without
     * ground. Uses the committed poses.
     */
    public double groundHeight(double x, double z) {
        double down = heights.cast(x, SKY, z, 0, -1, 0, Double.MAX_VALUE, BeamScene.WORLD, null);
        return down < Double.POSITIVE_INFINITY ? SKY - down : Double.NaN;
    }

    /** Bodies that are ground. */
    public Set<Body> grounds() {
        return grounds;
    }

    /** Whether a shape belongs to the ground. */
    public boolean isGround(int shape) {
        return grounds.contains(owners.get(shape));
    }

    public Body body(int shape) {
        return owners.get(shape);
    }

    /** Solid of a shape, in its own frame. */
    public Solid solid(int shape) {
        return solids.get(shape);
    }

    public void setPose(int shape, Frame pose) {
        setPose(shape, pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw);
    }

    public void setPose(int shape, double x, double y, double z, double qx, double qy, double qz, double qw) {
        beams.setPose(shape, x, y, z, qx, qy, qz, qw);
        if (ground != beams) {
            ground.setPose(shape, x, y, z, qx, qy, qz, qw);
        }
        if (numbers.get(shape) != NONE) {
            heights.setPose(numbers.get(shape), x, y, z, qx, qy, qz, qw);
        }
    }

    /** Commits after a teleport or a restart, which no sensor sees as movement. */
    public void settle() {
        commit();
        beams.forgetMotion();
    }

    public void commit() {
        beams.commit();
        if (ground != beams) {
            ground.commit();
        }
        heights.commit();
    }
}
