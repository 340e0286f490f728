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
 * What beams meet, and what wheels stand on. Both are the same scene unless an object is invisible to beams: wheels still stand on it.
 * Simulation thread.
 */
public final class RaycastScenes {
    /** Above everything, metres. */
    private static final double SKY = 2e5;
    /** The number of what is no ground. */
    private static final int NONE = -1;

    /** What sensors see. */
    public final BeamScene beams = new BeamScene();
    /** What wheels stand on. */
    public final BeamScene ground;
    /** Ground alone, and the number in it of each solid. */
    private final BeamScene heights = new BeamScene();
    private final List<Integer> numbers = new ArrayList<>();
    private final List<Body> owners = new ArrayList<>();
    private final List<Solid> solids = new ArrayList<>();
    private final Set<Body> grounds = Collections.newSetFromMap(new IdentityHashMap<>());

    /** @param invisible whether there is anything that beams don't see */
    public RaycastScenes(boolean invisible) {
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
        numbers.add(NONE);
        return shape;
    }

    /** Says that a body, whose solids were added, is ground to drive on: a floor or the terrain. */
    public void addGround(Body body) {
        grounds.add(body);
        for (int shape = 0; shape < owners.size(); shape++) {
            if (owners.get(shape) == body) {
                numbers.set(shape, solids.get(shape).addTo(heights, BeamScene.WORLD));
            }
        }
    }

    /** Height of the highest ground at a point of the world, metres, whatever stands on it; NaN where there is none. Looks at what was committed. */
    public double groundHeight(double x, double z) {
        double down = heights.cast(x, SKY, z, 0, -1, 0, Double.MAX_VALUE, BeamScene.WORLD, null);
        return down < Double.POSITIVE_INFINITY ? SKY - down : Double.NaN;
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
        if (numbers.get(shape) != NONE) {
            heights.setPose(numbers.get(shape), x, y, z, qx, qy, qz, qw);
        }
    }

    public void commit() {
        beams.commit();
        if (ground != beams) {
            ground.commit();
        }
        heights.commit();
    }
}
