package org.SEAR.physics;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.SEAR.geometry.Frame;
import org.SEAR.physics.solid.Solid;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.Hit;

/**
 * What beams meet, and what wheels stand on. Both are the same scene unless an object is invisible to beams: wheels still stand on it.
 * Simulation thread.
 */
public final class Scenes {
    /** Above everything, metres. */
    private static final double SKY = 2e5;
    /** So far behind what a beam has met the next one starts, metres. */
    private static final double BEHIND = 1e-9;

    /** What sensors see. */
    public final BeamScene beams = new BeamScene();
    /** What wheels stand on. */
    public final BeamScene ground;
    private final List<Body> owners = new ArrayList<>();
    private final List<Solid> solids = new ArrayList<>();
    private final Set<Body> grounds = Collections.newSetFromMap(new IdentityHashMap<>());

    /** @param invisible whether there is anything that beams don't see */
    public Scenes(boolean invisible) {
        ground = invisible ? new BeamScene() : beams;
    }

    /**
     * Adds a solid of a body.
     *
     * @return its number
     */
    public int add(Body body, Solid solid, boolean visible, int owner) {
        int shape = solid.addTo(beams, owner);
        if (ground != beams) {
            solid.addTo(ground, owner);
            beams.setVisible(shape, visible);
        }
        owners.add(body);
        solids.add(solid);
        return shape;
    }

    /** Says that a body is ground to drive on: a floor or the terrain. */
    public void addGround(Body body) {
        grounds.add(body);
    }

    /** Height of the highest ground at a point of the world, metres; NaN where there is none. Looks at what was committed. */
    public double groundHeight(double x, double z) {
        Hit hit = new Hit();
        double y = SKY;
        for (double down = below(x, y, z, hit); down < Double.POSITIVE_INFINITY; down = below(x, y, z, hit)) {
            if (isGround(hit.shape)) {
                return y - down;
            }
            y -= down + BEHIND;
        }
        return Double.NaN;
    }

    private double below(double x, double y, double z, Hit hit) {
        return ground.cast(x, y, z, 0, -1, 0, Double.MAX_VALUE, BeamScene.WORLD, hit);
    }

    /** All bodies that are ground. */
    public Set<Body> grounds() {
        return grounds;
    }

    /** Whether a shape belongs to the ground. */
    public boolean isGround(int shape) {
        return grounds.contains(owners.get(shape));
    }

    /** The body a shape belongs to. */
    public Body body(int shape) {
        return owners.get(shape);
    }

    /** What a shape is in the frame in which it was placed. */
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
    }

    public void commit() {
        beams.commit();
        if (ground != beams) {
            ground.commit();
        }
    }
}
