// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import java.util.Arrays;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.geometry.HeightTiles;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;
import org.SEAR.geometry.Triangles;
import org.SEAR.raycast.solid.Mesh;
import org.SEAR.raycast.solid.RaySolid;
import org.SEAR.raycast.solid.TileTree;
import org.SEAR.raycast.tree.Bvh;

/**
 * Exact geometry for ray casting: boxes, other convex solids, triangle meshes and elevation, each with a pose in the
 * world.
 *
 * <p>The simulation thread builds and moves shapes ({@code add...}, {@link #setPose}, {@link #setVisible},
 * {@link #commit}). Between two commits any number of threads may cast at the same time with identical results. Casting
 * allocates nothing except tiles of large grounds.
 *
 * <p>A shape has an owner: -1 for the world, otherwise the number of the robot whose rays do not see it. Surfaces
 * belong to their shapes: a ray that starts on a surface has distance 0. Of two equally near surfaces, the shape added
 * first is hit.
 */
public final class BeamScene {
    /** Owner of shapes that belong to no robot; as {@code ignoredOwner}, ignores nothing. */
    public static final int WORLD = Shapes.WORLD;

    /** Numbers per pose: x, y, z, metres, and the quaternion x, y, z, w. */
    public static final int POSE = Shapes.POSE;
    private static final ThreadLocal<Casters> CASTERS = ThreadLocal.withInitial(Casters::new);

    private final Shapes shapes = new Shapes();
    private final ShapeBvh tree = new ShapeBvh(shapes);
    private final Rotation rotation = new Rotation();
    private double[] poses = new double[16 * POSE];
    private boolean[] seen = new boolean[16];
    private boolean[] changed = new boolean[16];
    private int[] changes = new int[16];
    private int changeCount;
    private long moves;
    /** Null until the first {@link #remember}. */
    private ShapeMotion motion;

    /** Per-thread casters. */
    static final class Casters {
        final RayCaster rays = new RayCaster();
        final FanCaster fans = new FanCaster(rays);
        final BundleCaster bundles = new BundleCaster(rays);
        final PictureCaster pictures = new PictureCaster(rays);
        final ShadowCaster shadows = new ShadowCaster(rays);
    }

    /** Returns the casters of the calling thread. Their counters measure the work done. */
    static Casters casters() {
        return CASTERS.get();
    }

    /**
     * Adds a box centred at the origin.
     * @return the shape's number, counted from 0
     * @param halfX metres
     */
    public int addBox(double halfX, double halfY, double halfZ, int owner) {
        return add(Shapes.BOX, owner, halfX, halfY, halfZ);
    }

    /** Adds a convex solid with its own intersection. */
    public int addSolid(RaySolid solid, int owner) {
        int shape = add(Shapes.CONVEX, owner, solid.reach(1, 0, 0), solid.reach(0, 1, 0), solid.reach(0, 0, 1));
        shapes.solid[shape] = solid;
        return shape;
    }

    /** Adds triangles, visible from both sides, scaled by (sx, sy, sz). The same triangles share one hierarchy. */
    public int addMesh(Triangles triangles, double sx, double sy, double sz, int owner) {
        int shape = add(Shapes.MESH, owner, sx, sy, sz);
        shapes.mesh[shape] = Mesh.of(triangles);
        return shape;
    }

    /** Adds the triangles of an elevation grid, visible from both sides. */
    public int addHeights(HeightGrid grid, int owner) {
        if (grid instanceof HeightTiles) {
            int tiled = add(Shapes.TILES, owner, 1, 1, 1);
            shapes.tiles[tiled] = (HeightTiles) grid;
            shapes.tileTrees[tiled] = TileTree.of(shapes.tiles[tiled]);
            return tiled;
        }
        int shape = add(Shapes.HEIGHTS, owner, 1, 1, 1);
        shapes.heights[shape] = (HeightField) grid;
        return shape;
    }

    private int add(byte kind, int owner, double a, double b, double c) {
        int shape = shapes.add(kind, owner, a, b, c);
        grow(shape);
        return shape;
    }

    /** Extends the arrays for a new shape. */
    private void grow(int shape) {
        if (shape == changed.length) {
            int size = 2 * shape;
            poses = Arrays.copyOf(poses, size * POSE);
            seen = Arrays.copyOf(seen, size);
            changed = Arrays.copyOf(changed, size);
            changes = Arrays.copyOf(changes, size);
        }
        poses[shape * POSE + 6] = 1;
        seen[shape] = true;
        change(shape);
    }

    private void change(int shape) {
        if (!changed[shape]) {
            changed[shape] = true;
            changes[changeCount++] = shape;
        }
    }

    /** Moves a shape, with effect from the next {@link #commit}. The quaternion must have unit length. */
    public void setPose(int shape, double x, double y, double z, double qx, double qy, double qz, double qw) {
        int at = check(shape) * POSE;
        boolean same = poses[at] == x && poses[at + 1] == y && poses[at + 2] == z && poses[at + 3] == qx
            && poses[at + 4] == qy
            && poses[at + 5] == qz && poses[at + 6] == qw;
        if (same) {
            return;
        }
        poses[at] = x;
        poses[at + 1] = y;
        poses[at + 2] = z;
        poses[at + 3] = qx;
        poses[at + 4] = qy;
        poses[at + 5] = qz;
        poses[at + 6] = qw;
        change(shape);
    }

    /** Shows or hides a shape for all rays, with effect from the next {@link #commit}. New shapes are visible. */
    public void setVisible(int shape, boolean visible) {
        if (seen[check(shape)] != visible) {
            seen[shape] = visible;
            change(shape);
        }
    }

    private int check(int shape) {
        if (shape < 0 || shape >= shapes.count) {
            throw new IllegalArgumentException("beam scene: shape " + shape + ", legal: 0 to " + (shapes.count - 1)
                + ", as add... returned it");
        }
        return shape;
    }

    /** Applies all changes since the last commit, including new shapes. Unchanged shapes cost nothing. */
    public void commit() {
        for (int i = 0; i < changeCount; i++) {
            int shape = changes[i];
            changed[shape] = false;
            shapes.visible[shape] = seen[shape];
            shapes.place(shape, poses, shape * POSE);
        }
        tree.update(changes, changeCount);
        moves += changeCount;
        if (motion != null && changeCount > 0) {
            motion.share();
        }
        changeCount = 0;
    }

    /**
     * Remembers the committed poses of a step for {@link #castAt}, which needs those of each step. Repeated calls for a
     * step have no effect. Simulation thread.
     */
    public void remember(long step) {
        if (motion == null) {
            motion = new ShapeMotion(shapes);
            motion.forget(poses);
        }
        motion.add(step, poses);
    }

    /** Takes the committed poses as those of all times, as after a teleport or a reset. Simulation thread. */
    public void forgetMotion() {
        if (motion != null) {
            motion.forget(poses);
        }
    }

    /**
     * Returns whether a shape has moved between two times.
     *
     * @param since in steps, within the last two seconds; likewise until, which may be up to one step ahead
     */
    public boolean hasMoved(double since, double until) {
        return motion != null && motion.hasMoved(since, until);
    }

    /**
     * Returns whether a ray touches the surroundings of a moving shape at one of two times, in steps. If not,
     * {@link #cast} and {@link #castAt} return the same.
     */
    public boolean isNearMoving(double a, double b, double ox, double oy, double oz, double dx, double dy, double dz,
        double maxRange, int ignoredOwner) {
        for (int i = 0; motion != null && i < motion.count; i++) {
            if (shapes.isSeen(motion.shape(i), ignoredOwner)
                && (motion.isNear(i, a, ox, oy, oz, dx, dy, dz, maxRange)
                || motion.isNear(i, b, ox, oy, oz, dx, dy, dz, maxRange))) {
                return true;
            }
        }
        return false;
    }

    /**
     * Transforms a point from the world into the frame of a shape's latest pose. Simulation thread.
     * @param point {x, y, z}, metres, replaced
     */
    public void toFrame(int shape, double[] point) {
        int at = check(shape) * POSE;
        double x = point[0] - poses[at];
        double y = point[1] - poses[at + 1];
        double z = point[2] - poses[at + 2];
        rotation.set(poses[at + 3], poses[at + 4], poses[at + 5], poses[at + 6]);
        point[0] = rotation.inX(x, y, z);
        point[1] = rotation.inY(x, y, z);
        point[2] = rotation.inZ(x, y, z);
    }

    /**
     * Returns the number of shape changes that {@link #commit} has applied since construction, as a measure of work.
     * Simulation thread.
     */
    public long getMoves() {
        return moves;
    }

    public int size() {
        return shapes.count;
    }

    /**
     * Returns the distance along a unit direction to the nearest surface, {@code Double.POSITIVE_INFINITY} if none is
     * within maxRange. From inside a solid, returns the exit distance.
     * @param hit receives the shape's number and the surface normal of a hit; may be null
     */
    public double cast(double ox, double oy, double oz, double dx, double dy, double dz, double maxRange,
        int ignoredOwner, Hit hit) {
        return casters().rays.cast(shapes, tree.tree(), ox, oy, oz, dx, dy, dz, maxRange, ignoredOwner, hit);
    }

    /**
     * Returns {@link #cast} at a time: moving shapes have the poses between those of the {@link #remember remembered}
     * steps.
     *
     * @param time in steps, within the last two seconds or up to one step ahead
     */
    public double castAt(double time, double ox, double oy, double oz, double dx, double dy, double dz,
        double maxRange, int ignoredOwner) {
        RayCaster rays = casters().rays;
        return motion == null ? rays.cast(shapes, tree.tree(), ox, oy, oz, dx, dy, dz, maxRange, ignoredOwner, null)
            : rays.castAt(motion, time, tree.tree(), ox, oy, oz, dx, dy, dz, maxRange, ignoredOwner);
    }

    /**
     * Casts all rays of a plane fan. Ray i starts at the pose's origin in the direction (sin a, 0, cos a) of the pose's
     * frame, where a = startAngle + i * stepAngle radians. Positive angles are to the left (+x), counter-clockwise from
     * above. Results equal those of {@link #cast} except for rounding in the last digits. Much faster than single rays
     * if 0 &lt; stepAngle &lt;= 0.2 and the fan spans at most one turn.
     * @param ranges receives the distance of each ray, {@code Double.POSITIVE_INFINITY} without a hit
     * @param shapes receives the number of each hit shape, or -1; may be null
     */
    public void castFan(Pose pose, double startAngle, double stepAngle, int count, double maxRange, int ignoredOwner,
        double[] ranges, int[] shapes) {
        casters().fans.cast(this.shapes, tree.tree(), pose, startAngle, stepAngle, count, maxRange, ignoredOwner,
            ranges, shapes);
    }

    /**
     * Finds the shortest of several rays from one point; each ray's length is that of {@link #cast}. Fast for narrow
     * bundles.
     * @param directions unit vectors, x, y and z of each ray
     * @param ranges maximum distance of each ray, metres
     * @param shortest receives the shortest length, {@code Double.POSITIVE_INFINITY} without a hit
     * @return the number of the shortest ray, the first of equals, or -1
     */
    public int castBundle(double ox, double oy, double oz, double[] directions, double[] ranges, int ignoredOwner,
        double[] shortest) {
        BundleCaster bundles = casters().bundles;
        shortest[0] = bundles.cast(shapes, tree.tree(), ox, oy, oz, directions, ranges, ignoredOwner);
        return bundles.getLine();
    }

    /**
     * Casts the rays of some tiles of a picture. Depths are measured along the pose's z axis: {@link #cast} times the
     * cosine between ray and axis, except for rounding in the last digits.
     * @param pose camera pose; x to the left, y up, z ahead
     * @param start depth at which rays begin, metres, 0 or more
     * @param range depth at which rays end, metres
     * @param firstTile first tile, counted row by row from the top left
     * @param endTile tile after the last one
     * @param depths receives the depth of each pixel of these tiles, metres, in full picture rows from the first tile's
     *     first row on; {@code Double.POSITIVE_INFINITY} without a hit
     * @param shapesHit receives the shape's number, or -1
     * @param partsHit receives the number of a mesh's triangle in its {@link Triangles}; -1 for other shapes
     */
    public void castPicture(PictureBeams beams, Pose pose, double start, double range, int ignoredOwner, int firstTile,
        int endTile, double[] depths,
            int[] shapesHit, int[] partsHit) {
        PictureCaster pictures = casters().pictures;
        pictures.begin(shapes, beams, pose, start, range, firstTile);
        for (int tile = firstTile; tile < endTile; tile++) {
            pictures.cast(tree.tree(), tile, ignoredOwner, depths, shapesHit, partsHit);
        }
    }

    /**
     * Determines which points are in the shadow of an infinitely distant light. Fast for points close together.
     * @param light unit direction to the light: {x, y, z} in the world
     * @param casting whether each shape casts a shadow
     * @param points x, y, z of each point, metres
     * @param own the shape on whose surface each point lies; a convex shape does not shade its own points
     * @param lit 1 for each point to test, whose surface faces the light; set to 0 for points in shadow
     * @param count number of points
     */
    public void castShadows(double[] light, boolean[] casting, double[] points, int[] own, byte[] lit, int count) {
        ShadowCaster shadows = casters().shadows;
        shadows.begin(light[0], light[1], light[2]);
        shadows.cast(shapes, tree.tree(), casting, points, own, lit, count);
    }

    /**
     * Copies the committed frame of a shape: a point p of the shape is at R p + position in the world.
     * @param frame receives R, row by row, then the position, metres: 12 numbers
     */
    public void frame(int shape, double[] frame) {
        System.arraycopy(shapes.data, check(shape) * Shapes.STRIDE, frame, 0, Shapes.SIZE);
    }

    /** Copies the latest poses of all shapes, {@link #POSE} numbers each. Simulation thread. */
    public void poses(double[] taken) {
        System.arraycopy(poses, 0, taken, 0, shapes.count * POSE);
    }

    /** Sets the poses of all shapes from a copy by {@link #poses} and commits. Thread that owns the scene. */
    public void setPoses(double[] taken) {
        for (int shape = 0; shape < shapes.count; shape++) {
            int at = shape * POSE;
            setPose(shape, taken[at], taken[at + 1], taken[at + 2], taken[at + 3], taken[at + 4], taken[at + 5],
                taken[at + 6]);
        }
        commit();
    }

    /**
     * Returns an independent scene with the same shapes and poses. Models and elevation are shared. Simulation thread.
     */
    public BeamScene copy() {
        BeamScene copy = new BeamScene();
        for (int shape = 0; shape < shapes.count; shape++) {
            copy.shapes.addAs(shapes, shape);
            copy.grow(shape);
            copy.setVisible(shape, seen[shape]);
        }
        copy.setPoses(poses);
        return copy;
    }

    Shapes shapes() {
        return shapes;
    }

    /** Hierarchy over the shapes as of the last commit. */
    Bvh tree() {
        return tree.tree();
    }
}
