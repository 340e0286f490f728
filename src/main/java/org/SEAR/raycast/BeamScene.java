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

/**
 * The exact geometry that beams meet: boxes, other convex solids, triangle meshes and heights, each with a pose in the world.
 *
 * <p>Building and moving ({@code add...}, {@link #setPose}, {@link #setVisible}, {@link #commit}) belong to the simulation thread; between two
 * commits any number of threads may cast at the same time and get the same bytes. Casting allocates nothing but tiles of large grounds.
 *
 * <p>A shape has an owner: -1 for the world, else the number of the robot whose beams do not see it. Surfaces belong to their shapes: a beam that
 * starts on one answers 0. Where two surfaces are equally near, the shape that was added first is the one that was hit.
 */
public final class BeamScene {
    /** The owner of shapes that belong to no robot; as {@code ignoredOwner}: nothing is ignored. */
    public static final int WORLD = Shapes.WORLD;

    /** Numbers of a pose: x, y, z, metres, and the quaternion x, y, z, w. */
    public static final int POSE = 7;
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

    /** What one thread needs to cast. */
    static final class Casters {
        final RayCaster rays = new RayCaster();
        final FanCaster fans = new FanCaster(rays);
        final BundleCaster bundles = new BundleCaster(rays);
        final PictureCaster pictures = new PictureCaster(rays);
        final ShadowCaster shadows = new ShadowCaster(rays);
    }

    /** The casters of the calling thread; their counters tell the work done. */
    static Casters casters() {
        return CASTERS.get();
    }

    /**
     * Adds a box with its centre in the origin.
     *
     * @return the shape's number, counted from 0
     * @param halfX metres
     */
    public int addBox(double halfX, double halfY, double halfZ, int owner) {
        return add(Shapes.BOX, owner, halfX, halfY, halfZ);
    }

    /** Adds a convex solid with a kernel of its own. */
    public int addSolid(RaySolid solid, int owner) {
        int shape = add(Shapes.CONVEX, owner, solid.reach(1, 0, 0), solid.reach(0, 1, 0), solid.reach(0, 0, 1));
        shapes.solid[shape] = solid;
        return shape;
    }

    /** Adds triangles, seen from both sides, scaled by (sx, sy, sz). The hierarchy of the same triangles is built only once. */
    public int addMesh(Triangles triangles, double sx, double sy, double sz, int owner) {
        int shape = add(Shapes.MESH, owner, sx, sy, sz);
        shapes.mesh[shape] = Mesh.of(triangles);
        return shape;
    }

    /** Adds the triangles of heights, seen from both sides. */
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

    /** Makes room for what is known of a new shape. */
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

    /** Moves a shape; counts from the next {@link #commit}. The quaternion has to have unit length. */
    public void setPose(int shape, double x, double y, double z, double qx, double qy, double qz, double qw) {
        int at = check(shape) * POSE;
        boolean same = poses[at] == x && poses[at + 1] == y && poses[at + 2] == z && poses[at + 3] == qx && poses[at + 4] == qy
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

    /** Whether beams see the shape at all (true after adding); counts from the next {@link #commit}. */
    public void setVisible(int shape, boolean visible) {
        if (seen[check(shape)] != visible) {
            seen[shape] = visible;
            change(shape);
        }
    }

    private int check(int shape) {
        if (shape < 0 || shape >= shapes.count) {
            throw new IllegalArgumentException("beam scene: shape " + shape + ", legal: 0 to " + (shapes.count - 1) + ", as add... returned it");
        }
        return shape;
    }

    /** Makes all changes since the last commit count, new shapes included. Costs nothing for shapes that did not change. */
    public void commit() {
        for (int i = 0; i < changeCount; i++) {
            int shape = changes[i];
            changed[shape] = false;
            shapes.visible[shape] = seen[shape];
            shapes.place(shape, poses, shape * POSE);
        }
        tree.update(changes, changeCount);
        moves += changeCount;
        changeCount = 0;
    }

    /**
     * Brings a point of the world into the frame of a shape, as it was placed last. Simulation thread.
     *
     * @param point {x, y, z}, metres, which is changed
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

    /** How many shapes {@link #commit} has taken over since the scene was made: the work it has done. Simulation thread. */
    public long getMoves() {
        return moves;
    }

    /** Number of shapes. */
    public int size() {
        return shapes.count;
    }

    /**
     * The distance along a unit direction to the nearest surface, {@code Double.POSITIVE_INFINITY} where nothing is within maxRange. From inside a
     * solid it is the way out to its surface.
     *
     * @param hit takes the number of the shape and the surface normal when something was hit; null if nobody asks
     */
    public double cast(double ox, double oy, double oz, double dx, double dy, double dz, double maxRange, int ignoredOwner, Hit hit) {
        return casters().rays.cast(shapes, tree.tree(), ox, oy, oz, dx, dy, dz, maxRange, ignoredOwner, hit);
    }

    /**
     * All beams of a plane fan at once: beam i leaves the pose's origin in the direction (sin a, 0, cos a) of the pose's frame, a = startAngle + i *
     * stepAngle radians; positive angles are to the left (+x), counter-clockwise from above. Answers what {@link #cast} would, but for rounding in
     * the last digits. Much faster than single beams while 0 &lt; stepAngle &lt;= 0.2 and the fan makes no more than a turn.
     *
     * @param ranges takes a distance or {@code Double.POSITIVE_INFINITY} for each beam
     * @param shapes takes the number of the shape that was hit, or -1; null if nobody asks
     */
    public void castFan(Pose pose, double startAngle, double stepAngle, int count, double maxRange, int ignoredOwner, double[] ranges, int[] shapes) {
        casters().fans.cast(this.shapes, tree.tree(), pose, startAngle, stepAngle, count, maxRange, ignoredOwner, ranges, shapes);
    }

    /**
     * The shortest of several beams from one point, as {@link #cast} would answer them one by one. Fast when they make a narrow bundle.
     *
     * @param directions unit vectors, x, y and z of each beam
     * @param ranges of the beams, metres
     * @param shortest takes its length, {@code Double.POSITIVE_INFINITY} if none meets anything within its range
     * @return the number of the shortest beam, the first one if several are, or -1
     */
    public int castBundle(double ox, double oy, double oz, double[] directions, double[] ranges, int ignoredOwner, double[] shortest) {
        BundleCaster bundles = casters().bundles;
        shortest[0] = bundles.cast(shapes, tree.tree(), ox, oy, oz, directions, ranges, ignoredOwner);
        return bundles.getLine();
    }

    /**
     * Some tiles of a picture's beams. Each answers how far ahead, along the pose's z axis, it meets something: {@link #cast} times the cosine
     * between beam and axis, but for rounding in the last digits.
     *
     * @param pose the eye in its origin; x to the left, y up, z ahead
     * @param start metres ahead of the eye where beams begin, 0 or more
     * @param range metres ahead where they end
     * @param firstTile the first one, counted row by row from the top left
     * @param endTile the one behind the last one
     * @param depths takes metres ahead for each pixel of these tiles, row by row from the first tile's first row on, each row as
     *     long as the picture's; {@code Double.POSITIVE_INFINITY} for none
     * @param shapesHit takes the number of the shape, or -1
     * @param partsHit takes the number of a model's triangle, as its {@link Triangles} have it; -1 for what is not made of such
     */
    public void castPicture(PictureBeams beams, Pose pose, double start, double range, int ignoredOwner, int firstTile, int endTile, double[] depths,
            int[] shapesHit, int[] partsHit) {
        PictureCaster pictures = casters().pictures;
        pictures.begin(shapes, beams, pose, start, range, firstTile);
        for (int tile = firstTile; tile < endTile; tile++) {
            pictures.cast(tree.tree(), tile, ignoredOwner, depths, shapesHit, partsHit);
        }
    }

    /**
     * Which points lie in the shadow of a light that is infinitely far away. Fast when they lie close together.
     *
     * @param light the unit direction in which it stands: {x, y, z} of the world
     * @param casting of each shape whether it casts a shadow
     * @param points x, y, z of each point, metres
     * @param own the shape on whose surface each point lies; where that is convex it doesn't shade itself
     * @param lit 1 for the points that are asked for, whose surfaces look to the light; those in the shadow become 0
     * @param count how many points there are
     */
    public void castShadows(double[] light, boolean[] casting, double[] points, int[] own, byte[] lit, int count) {
        ShadowCaster shadows = casters().shadows;
        shadows.begin(light[0], light[1], light[2]);
        shadows.cast(shapes, tree.tree(), casting, points, own, lit, count);
    }

    /**
     * The frame of a shape as it was committed last: a point p of it is R p + position in the world.
     *
     * @param frame takes R, row by row, then the position, metres: 12 numbers
     */
    public void frame(int shape, double[] frame) {
        System.arraycopy(shapes.data, check(shape) * Shapes.STRIDE, frame, 0, Shapes.SIZE);
    }

    /** The poses of all shapes, {@link #POSE} numbers each, as they were set last. Simulation thread. */
    public void poses(double[] taken) {
        System.arraycopy(poses, 0, taken, 0, shapes.count * POSE);
    }

    /** Sets the poses of all shapes, as {@link #poses} has taken them, and commits. Belongs to whoever owns the scene. */
    public void setPoses(double[] taken) {
        for (int shape = 0; shape < shapes.count; shape++) {
            int at = shape * POSE;
            setPose(shape, taken[at], taken[at + 1], taken[at + 2], taken[at + 3], taken[at + 4], taken[at + 5], taken[at + 6]);
        }
        commit();
    }

    /** A scene of its own of the same shapes where they are now; models and heights are shared. Simulation thread. */
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

    /** For tests. */
    Shapes shapes() {
        return shapes;
    }
}
