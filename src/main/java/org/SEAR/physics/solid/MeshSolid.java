// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.io.IOException;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Model;
import org.SEAR.collision.ConvexHull;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.geometry.Triangles;
import org.SEAR.geometry.VolumeIntegrals;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.raycast.BeamScene;

/** Triangle mesh, as of a model. */
class MeshSolid extends Solid {
    /** Directions in which a drawing searches a model's outermost corners. */
    private static final int DRAWN_DIRECTIONS = 48;
    /** Share of the convex hull above which an enclosed volume counts: two sides of a sheet enclose only rounding. */
    private static final double LEAST_SHARE = 1e-4;

    private final Triangles mesh;
    private final double[] scale;
    private final double[][] corners;
    /** How it collides, see {@link Model#getCollision}; exact also for the default: only fixed bodies use triangles. */
    private final String collision;
    /** Name of the model. */
    private final String name;
    private List<ConvexShape> pieces;
    private boolean integrated;
    /** 0 until known. */
    private double thickness;
    private VolumeIntegrals integrals;

    /** @param scale along x, y and z */
    MeshSolid(Triangles mesh, double[] scale, Pose offset) {
        this(mesh, scale, offset, Model.EXACT, "");
    }

    private MeshSolid(Triangles mesh, double[] scale, Pose offset, String collision, String name) {
        super(half(mesh, scale, 0), half(mesh, scale, 1), half(mesh, scale, 2), offset);
        this.mesh = mesh;
        this.collision = collision;
        this.name = name;
        this.scale = scale;
        corners = MeshShapes.corners(mesh, scale[0], scale[1], scale[2], DRAWN_DIRECTIONS).stream()
            .map(corner -> new double[] {corner.x, corner.y, corner.z}).toArray(double[][]::new);
    }

    static MeshSolid of(Model model, ModelLoader models) throws IOException {
        Triangles mesh = models.triangles(model);
        if (model.getCollision().equals(Model.PARTS)) {
            MeshPieces.check(mesh, model);
        }
        return new MeshSolid(mesh, new double[] {model.getScaleX(), model.getScaleY(), model.getScaleZ()},
            Pose.IDENTITY, model.hasCollision() ? model.getCollision() : Model.EXACT, model.getName());
    }

    private static double half(Triangles mesh, double[] scale, int axis) {
        double half = 0;
        for (int i = axis; i < mesh.vertices.length; i += 3) {
            half = Math.max(half, Math.abs(mesh.vertices[i] * scale[axis]));
        }
        return half;
    }

    @Override
    public int addTo(BeamScene scene, int owner) {
        return scene.addMesh(mesh, scale[0], scale[1], scale[2], owner);
    }

    @Override
    protected ConvexShape makeConvex() {
        return ConvexHull.of(points());
    }

    @Override
    public List<ConvexShape> pieces() {
        if (pieces == null) {
            pieces = collision.equals(Model.PARTS) ? MeshPieces.of(mesh, scale, points(), name) : super.pieces();
        }
        return pieces;
    }

    private double[] points() {
        double[] points = new double[mesh.vertices.length];
        for (int i = 0; i < points.length; i++) {
            points[i] = mesh.vertices[i] * scale[i % 3];
        }
        return points;
    }

    /** Returns the volume that the mesh encloses; of an open mesh that of its convex parts. */
    @Override
    public double volume() {
        VolumeIntegrals inside = integrals();
        return inside == null ? pieces().stream().mapToDouble(ConvexShape::volume).sum() : inside.volume();
    }

    /** Returns the solid that the mesh encloses; of an open mesh its convex parts. */
    @Override
    public MassProperties perKilogram() {
        VolumeIntegrals inside = integrals();
        if (inside != null) {
            return new MassProperties(1, inside.centre(), inside.inertia());
        }
        return pieces().size() == 1 ? MassProperties.of(pieces().get(0)) : MassProperties.sum(pieces().stream()
            .map(piece -> MassProperties.of(piece).withMass(piece.volume())).collect(Collectors.toList())).withMass(1);
    }

    /** Returns the integrals over the enclosed volume; null if it is not closed or encloses next to nothing. */
    private VolumeIntegrals integrals() {
        if (!integrated) {
            integrated = true;
            VolumeIntegrals found = ClosedMesh.integrate(mesh, points());
            integrals = found != null && found.volume() > LEAST_SHARE * convex().volume() ? found : null;
        }
        return integrals;
    }

    @Override
    public TriangleSearch triangles() {
        return new MeshTriangles(mesh, scale);
    }

    @Override
    public SurfaceMesh look() {
        SurfaceMesh look = new SurfaceMesh();
        look.addFlat(mesh, scale);
        return look;
    }

    @Override
    protected double[][] corners() {
        return corners;
    }

    @Override
    public boolean isMesh() {
        return collision.equals(Model.EXACT);
    }

    @Override
    public boolean anyTriangle(Aabb box, Predicate<double[]> test) {
        double[] at = new double[9];
        for (int first = 0; first < mesh.indices.length; first += 3) {
            for (int i = 0; i < at.length; i++) {
                at[i] = mesh.vertices[3 * mesh.indices[first + i / 3] + i % 3] * scale[i % 3];
            }
            if (test.test(at)) {
                return true;
            }
        }
        return false;
    }

    @Override
    public double thickness() {
        if (thickness == 0) {
            thickness = Math.min(extent(0), Math.min(extent(1), extent(2)));
        }
        return thickness;
    }

    private double extent(int axis) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = axis; i < mesh.vertices.length; i += 3) {
            low = Math.min(low, mesh.vertices[i] * scale[axis]);
            high = Math.max(high, mesh.vertices[i] * scale[axis]);
        }
        return high - low;
    }

    @Override
    public boolean encloses(double x, double y, double z) {
        return integrals() != null && ClosedMesh.encloses(points(), mesh.indices, x, y, z);
    }

    @Override
    public double[] farthest(double dx, double dy, double dz) {
        int corner = 3 * MeshShapes.outermost(mesh, dx * scale[0], dy * scale[1], dz * scale[2]);
        return new double[] {mesh.vertices[corner] * scale[0], mesh.vertices[corner + 1] * scale[1],
            mesh.vertices[corner + 2] * scale[2]};
    }
}
