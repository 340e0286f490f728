package org.SEAR.physics.solid;

import com.bulletphysics.collision.shapes.BoxShape;
import com.bulletphysics.collision.shapes.CollisionShape;
import com.bulletphysics.collision.shapes.ConeShape;
import com.bulletphysics.collision.shapes.CylinderShape;
import java.io.IOException;
import java.util.Collections;
import javax.vecmath.Vector3f;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Wheel;
import org.SEAR.collision.ConvexBox;
import org.SEAR.collision.ConvexHull;
import org.SEAR.collision.ConvexRound;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Triangles;
import org.SEAR.project.Project;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.RayRound;

/** The geometry of one object of the grammar, scale included, as beams and as collisions need it. */
public final class Solid {
    /** The collision margin of jbullet, metres, for shapes that are large enough; contacts come from the solids themselves. */
    private static final float MARGIN = 0.01f;
    /** Greatest share of the smallest half size that may be margin. */
    private static final double MARGIN_SHARE = 0.3;
    /** Directions in which a drawing looks for a model's outermost corners. */
    private static final int DRAWN_DIRECTIONS = 48;
    /** Corners of the polygon that stands for an ellipse. */
    private static final int CORNERS = 64;
    private static final Pose AXLE_ALONG_X = Pose.ofDegrees(0, 0, 0, 0, 0, 90);

    private enum Kind { BOX, CYLINDER, CONE, MESH }

    /** What of the object beams see. */
    private final Kind kind;
    /** Half sizes along x, y and z. */
    public final double halfX;
    public final double halfY;
    public final double halfZ;
    /** Where the solid's own frame stands in the object's frame. */
    public final Pose offset;
    private final Triangles mesh;
    private final double scaleX;
    private final double scaleY;
    private final double scaleZ;
    private Surface surface = Surface.usual();
    private ConvexShape convex;

    private Solid(Kind kind, double halfX, double halfY, double halfZ, Pose offset) {
        this(kind, halfX, halfY, halfZ, offset, null, 1, 1, 1);
    }

    private Solid(Kind kind, double halfX, double halfY, double halfZ, Pose offset, Triangles mesh, double sx, double sy, double sz) {
        this.kind = kind;
        this.halfX = halfX;
        this.halfY = halfY;
        this.halfZ = halfZ;
        this.offset = offset;
        this.mesh = mesh;
        this.scaleX = sx;
        this.scaleY = sy;
        this.scaleZ = sz;
    }

    /**
     * The geometry of an object; null for an object without (a sensor).
     *
     * @throws ProjectException if a model can't be loaded
     */
    public static Solid of(SearObject object, Project project) throws ProjectException {
        if (!(object instanceof Shape)) {
            return null;
        }
        Solid solid = of((Shape) object, project);
        if (solid != null) {
            solid.surface = Surface.of((Shape) object);
        }
        return solid;
    }

    private static Solid of(Shape shape, Project project) throws ProjectException {
        double sx = shape.getScaleX();
        double sy = shape.getScaleY();
        double sz = shape.getScaleZ();
        if (shape instanceof Box) {
            Box box = (Box) shape;
            return box(box.getLength() / 2 * sx, box.getHeight() / 2 * sy, box.getWidth() / 2 * sz, Pose.IDENTITY);
        }
        if (shape instanceof Floor) {
            Floor floor = (Floor) shape;
            double half = Floor.THICKNESS / 2 * sy;
            return box(floor.getLength() / 2 * sx, half, floor.getWidth() / 2 * sz, new Pose(0, -half, 0, 0, 0, 0, 1));
        }
        if (shape instanceof Cylinder) {
            Cylinder cylinder = (Cylinder) shape;
            return round(Kind.CYLINDER, cylinder.getRadius(), cylinder.getHeight() / 2, sx, sy, sz, Pose.IDENTITY);
        }
        if (shape instanceof Cone) {
            Cone cone = (Cone) shape;
            return round(Kind.CONE, cone.getRadius(), cone.getHeight() / 2, sx, sy, sz, Pose.IDENTITY);
        }
        if (shape instanceof Wheel) {
            Wheel wheel = (Wheel) shape;
            return round(Kind.CYLINDER, wheel.getRadius(), wheel.getWidth() / 2, sy, sx, sz, AXLE_ALONG_X);
        }
        return shape instanceof Model ? model((Model) shape, project) : null;
    }

    /**
     * A box.
     *
     * @param halfX metres
     */
    public static Solid box(double halfX, double halfY, double halfZ, Pose offset) {
        return new Solid(Kind.BOX, halfX, halfY, halfZ, offset);
    }

    /**
     * A cylinder with its axle along x.
     *
     * @param radius metres
     */
    public static Solid wheel(double radius, double halfWidth, Pose pose) {
        return new Solid(Kind.CYLINDER, radius, halfWidth, radius, pose.times(AXLE_ALONG_X));
    }

    private static Solid round(Kind kind, double radius, double halfHeight, double sx, double sy, double sz, Pose offset) {
        if (sx == sz) {
            return new Solid(kind, radius * sx, halfHeight * sy, radius * sz, offset);
        }
        return mesh(elliptic(radius, halfHeight, kind == Kind.CONE), sx, sy, sz, offset);
    }

    /** A cylinder or cone with a polygon as base, for what is scaled into an ellipse. */
    private static Triangles elliptic(double radius, double halfHeight, boolean cone) {
        float[] vertices = new float[(2 * CORNERS + 2) * 3];
        int[] indices = new int[CORNERS * 12];
        put(vertices, 2 * CORNERS, 0, -halfHeight, 0);
        put(vertices, 2 * CORNERS + 1, 0, halfHeight, 0);
        for (int i = 0; i < CORNERS; i++) {
            double angle = 2 * Math.PI * i / CORNERS;
            double top = cone ? 0 : radius;
            put(vertices, 2 * i, radius * Math.sin(angle), -halfHeight, radius * Math.cos(angle));
            put(vertices, 2 * i + 1, top * Math.sin(angle), halfHeight, top * Math.cos(angle));
            int next = (i + 1) % CORNERS;
            int[] four = {2 * i, 2 * next, 2 * next + 1, 2 * i, 2 * next + 1, 2 * i + 1,
                2 * CORNERS, 2 * next, 2 * i, 2 * CORNERS + 1, 2 * i + 1, 2 * next + 1};
            System.arraycopy(four, 0, indices, i * 12, 12);
        }
        return new Triangles(vertices, indices);
    }

    private static void put(float[] vertices, int vertex, double x, double y, double z) {
        vertices[vertex * 3] = (float) x;
        vertices[vertex * 3 + 1] = (float) y;
        vertices[vertex * 3 + 2] = (float) z;
    }

    private static Solid model(Model model, Project project) throws ProjectException {
        Triangles triangles;
        try {
            triangles = ModelLoader.withoutPictures(project.getAssets()).triangles(model);
        } catch (IOException e) {
            throw problem(model, project, "a model that can be loaded (" + e.getMessage() + ")");
        }
        return mesh(triangles, model.getScaleX(), model.getScaleY(), model.getScaleZ(), Pose.IDENTITY);
    }

    private static ProjectException problem(Model model, Project project, String legal) {
        String file = (project.getEnvironment().contains(model) ? "environment/" : "robot/") + model.getName() + ".xml";
        return new ProjectException(Collections.singletonList(new Problem(file, 0, "path", model.getPath(), legal)));
    }

    private static Solid mesh(Triangles triangles, double sx, double sy, double sz, Pose offset) {
        double[] half = new double[3];
        double[] scale = {sx, sy, sz};
        for (int i = 0; i < triangles.vertices.length; i++) {
            half[i % 3] = Math.max(half[i % 3], Math.abs(triangles.vertices[i] * scale[i % 3]));
        }
        return new Solid(Kind.MESH, half[0], half[1], half[2], offset, triangles, sx, sy, sz);
    }

    /** Corners of a mesh, scale included, that are enough to draw its outline from any side, metres in the object's frame; empty for other shapes. */
    public double[][] corners() {
        if (mesh == null) {
            return new double[0][];
        }
        return MeshShapes.corners(mesh, scaleX, scaleY, scaleZ, DRAWN_DIRECTIONS).stream().map(corner -> new double[] {corner.x, corner.y, corner.z})
            .toArray(double[][]::new);
    }

    /**
     * Adds it to what beams meet.
     *
     * @return its number there
     */
    public int addTo(BeamScene scene, int owner) {
        switch (kind) {
            case BOX:
                return scene.addBox(halfX, halfY, halfZ, owner);
            case CYLINDER:
                return scene.addSolid(RayRound.cylinder(halfX, halfY), owner);
            case CONE:
                return scene.addSolid(RayRound.cone(halfX, halfY), owner);
            default:
                return scene.addMesh(mesh, scaleX, scaleY, scaleZ, owner);
        }
    }

    /**
     * A new collision shape.
     *
     * @param moving whether the body it is for can move: a mesh then becomes its convex hull
     */
    public CollisionShape collision(boolean moving) {
        Vector3f half = new Vector3f((float) halfX, (float) halfY, (float) halfZ);
        CollisionShape shape;
        switch (kind) {
            case BOX:
                shape = new BoxShape(half);
                break;
            case CYLINDER:
                shape = new CylinderShape(half);
                break;
            case CONE:
                shape = new ConeShape((float) halfX, (float) (2 * halfY));
                break;
            default:
                shape = moving ? MeshShapes.hull((ConvexHull) convex()) : MeshShapes.fixed(mesh, scaleX, scaleY, scaleZ);
        }
        if (kind != Kind.MESH) {
            shape.setMargin(margin());
        }
        shape.setUserPointer(this);
        return shape;
    }

    private float margin() {
        return (float) Math.min(MARGIN, MARGIN_SHARE * Math.min(halfX, Math.min(halfY, halfZ)));
    }

    /** What of it collides: a mesh counts as its convex hull. */
    public ConvexShape convex() {
        if (convex == null) {
            convex = makeConvex();
        }
        return convex;
    }

    private ConvexShape makeConvex() {
        switch (kind) {
            case BOX:
                return new ConvexBox(halfX, halfY, halfZ);
            case CYLINDER:
                return ConvexRound.cylinder(halfX, halfY);
            case CONE:
                return ConvexRound.cone(halfX, halfY);
            default:
                return hull();
        }
    }

    private ConvexHull hull() {
        double[] points = new double[mesh.vertices.length];
        double[] scale = {scaleX, scaleY, scaleZ};
        for (int i = 0; i < points.length; i++) {
            points[i] = mesh.vertices[i] * scale[i % 3];
        }
        return ConvexHull.of(points);
    }

    /** What it does where it touches. */
    public Surface getSurface() {
        return surface;
    }

    public boolean isMesh() {
        return kind == Kind.MESH;
    }

    public Triangles getMesh() {
        return mesh;
    }

    /**
     * A corner of the mesh.
     *
     * @param place of the solid's frame
     * @param into takes {x, y, z} there
     */
    public void corner(int vertex, Pose place, double[] into) {
        double[] at = place.transform(mesh.vertices[vertex * 3] * scaleX, mesh.vertices[vertex * 3 + 1] * scaleY,
            mesh.vertices[vertex * 3 + 2] * scaleZ);
        System.arraycopy(at, 0, into, 0, 3);
    }

    /** The farthest point in a direction of its own frame: {x, y, z}. */
    public double[] farthest(double dx, double dy, double dz) {
        double[] point = new double[3];
        if (kind == Kind.MESH) {
            int vertex = MeshShapes.outermost(mesh, dx * scaleX, dy * scaleY, dz * scaleZ);
            corner(vertex, Pose.IDENTITY, point);
        } else {
            convex().support(dx, dy, dz, point);
        }
        return point;
    }
}
