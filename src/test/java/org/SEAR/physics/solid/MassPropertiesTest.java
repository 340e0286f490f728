// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Sphere;
import org.SEAR.geometry.InertiaTensor;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Triangles;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** Volume, centre of mass and inertia tensor of solids, against closed forms. */
public class MassPropertiesTest {
    private static final double EXACT = 1e-12;
    /** Rounding of a mesh's single-precision vertices, relative. */
    private static final double SINGLE = 1e-6;
    private static final double[] UNSCALED = {1, 1, 1};
    /** Sides of a box, counter-clockwise seen from outside; its corners are numbered by bits: 1 +x, 2 +y, 4 +z. */
    private static final int[] BOX = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6,
        0, 6, 2, 1, 3, 7, 1, 7, 5};

    @Rule
    public final ProjectRule project = new ProjectRule();

    private final List<Float> vertices = new ArrayList<>();
    private final List<Integer> indices = new ArrayList<>();

    /** Adds a box to the mesh: {minX, maxX, minY, maxY, minZ, maxZ}; its corners are in a frame. */
    private void box(Pose frame, boolean insideOut, double... box) {
        int first = vertices.size() / 3;
        for (int i = 0; i < 8; i++) {
            for (double value : frame.transform(box[i & 1], box[2 + (i >> 1 & 1)], box[4 + (i >> 2)])) {
                vertices.add((float) value);
            }
        }
        for (int i = 0; i < BOX.length; i += 3) {
            indices.add(first + BOX[i]);
            indices.add(first + BOX[insideOut ? i + 2 : i + 1]);
            indices.add(first + BOX[insideOut ? i + 1 : i + 2]);
        }
    }

    private MeshSolid mesh(double... scale) {
        float[] points = new float[vertices.size()];
        for (int i = 0; i < points.length; i++) {
            points[i] = vertices.get(i);
        }
        return new MeshSolid(new Triangles(points, indices.stream().mapToInt(index -> index).toArray()), scale,
            Pose.IDENTITY);
    }

    /** Returns a box of uniform density at its place. */
    private static MassProperties block(double mass, double... box) {
        double x = box[1] - box[0];
        double y = box[3] - box[2];
        double z = box[5] - box[4];
        double[] centre = {(box[0] + box[1]) / 2, (box[2] + box[3]) / 2, (box[4] + box[5]) / 2};
        return new MassProperties(mass, centre,
            new InertiaTensor(mass / 12 * (y * y + z * z), mass / 12 * (x * x + z * z), mass / 12 * (x * x + y * y)));
    }

    private static double volume(double... box) {
        return (box[1] - box[0]) * (box[3] - box[2]) * (box[5] - box[4]);
    }

    private static MassProperties of(Shape shape, double sx, double sy, double sz) throws Exception {
        shape.scale(sx, sy, sz);
        return Solids.of(shape, null).perKilogram();
    }

    private static void assertSame(MassProperties expected, MassProperties found, double tolerance) {
        assertEquals(expected.mass, found.mass, tolerance * expected.mass);
        assertArrayEquals(expected.centre(), found.centre(), tolerance);
        double most = Math.max(expected.inertia.xx, Math.max(expected.inertia.yy, expected.inertia.zz));
        for (int row = 0; row < 3; row++) {
            assertArrayEquals("row " + row, expected.inertia.toRows()[row], found.inertia.toRows()[row],
                tolerance * most);
        }
    }

    private static MassProperties kilogram(double y, double xx, double yy, double zz) {
        return new MassProperties(1, new double[] {0, y, 0}, new InertiaTensor(xx, yy, zz));
    }

    @Test
    public void shapesHaveTheirClosedForms() throws Exception {
        double a = 0.3 * 1.5;
        double h = 0.8 * 0.5;
        double c = 0.3 * 2;
        assertSame(block(1, -0.2, 0.2, -0.8, 0.8, -0.15, 0.15), of(new Box("box", 0.4, 0.6, 0.8), 1, 2, 0.5), EXACT);
        assertSame(kilogram(0, (3 * 0.09 + 0.64) / 12, 0.045, (3 * 0.09 + 0.64) / 12),
            of(new Cylinder("cylinder", 0.3, 0.8), 1, 1, 1), EXACT);
        assertSame(kilogram(-0.2, 3 / 80.0 * (4 * 0.09 + 0.64), 0.027, 3 / 80.0 * (4 * 0.09 + 0.64)),
            of(new Cone("cone", 0.3, 0.8), 1, 1, 1), EXACT);
        assertSame(kilogram(0, (1 + 4) * 0.16 / 5, (0.25 + 4) * 0.16 / 5, (0.25 + 1) * 0.16 / 5),
            of(new Sphere("ball", 0.4), 0.5, 1, 2), EXACT);
        assertSame(kilogram(0, c * c / 4 + h * h / 12, (a * a + c * c) / 4, a * a / 4 + h * h / 12),
            of(new Cylinder("elliptic cylinder", 0.3, 0.8), 1.5, 0.5, 2), SINGLE);
        assertSame(kilogram(-h / 4, 3 / 20.0 * (c * c + h * h / 4), 3 / 20.0 * (a * a + c * c),
            3 / 20.0 * (a * a + h * h / 4)),
            of(new Cone("elliptic cone", 0.3, 0.8), 1.5, 0.5, 2), SINGLE);
    }

    @Test
    public void aTurnedBoxModelHasProductsOfInertia() {
        Pose turned = Pose.ofDegrees(0.5, -0.3, 2, 20, 40, 60);
        box(turned, false, -0.2, 0.2, -0.3, 0.3, -0.4, 0.4);
        MassProperties expected = block(1, -0.2, 0.2, -0.3, 0.3, -0.4, 0.4).inParent(turned);
        MeshSolid solid = mesh(UNSCALED);
        assertEquals(0.4 * 0.6 * 0.8, solid.volume(), SINGLE);
        assertSame(expected, solid.perKilogram(), SINGLE);
        assertSame(expected, MassProperties.of(solid.convex()), SINGLE);
    }

    /** The tetrahedron between the origin and the ends of three legs along the axes, turned out of these axes. */
    @Test
    public void aTetrahedronTurnedOutOfItsAxes() {
        double a = 0.3;
        double b = 0.5;
        double c = 0.7;
        InertiaTensor own = new InertiaTensor(3 * (b * b + c * c) / 80, 3 * (a * a + c * c) / 80,
            3 * (a * a + b * b) / 80, a * b / 80, a * c / 80, b * c / 80);
        MassProperties expected = new MassProperties(1, new double[] {a / 4, b / 4, c / 4}, own);
        Random random = new Random(8);
        for (int i = 0; i < 20; i++) {
            Pose turned = Pose.ofDegrees(random.nextGaussian(), random.nextGaussian(), random.nextGaussian(),
                360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
            vertices.clear();
            for (double[] corner : new double[][] {{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c}}) {
                for (double value : turned.transform(corner[0], corner[1], corner[2])) {
                    vertices.add((float) value);
                }
            }
            indices.clear();
            indices.addAll(List.of(0, 2, 1, 0, 3, 2, 0, 1, 3, 1, 2, 3));
            MeshSolid solid = mesh(UNSCALED);
            assertEquals(a * b * c / 6, solid.volume(), SINGLE);
            assertSame(expected.inParent(turned), solid.perKilogram(), 2 * SINGLE);
            assertSame(expected.inParent(turned), MassProperties.of(solid.convex()), 2 * SINGLE);
        }
    }

    private static MassProperties l() {
        return MassProperties.sum(List.of(block(0.3 * 0.04, 0, 0.3, 0, 0.04, 0, 0.05),
            block(0.16 * 0.04, 0, 0.04, 0.04, 0.2, 0, 0.05)));
    }

    /** About its corner each leg of the L is a box off its centre. */
    @Test
    public void anLOfTwoBoxesHasTheTensorOfTheParallelAxisTheorem() {
        double m = 0.3 * 0.04;
        double n = 0.16 * 0.04;
        double x = (m * 0.15 + n * 0.02) / (m + n);
        double y = (m * 0.02 + n * 0.12) / (m + n);
        MassProperties l = l();
        assertArrayEquals(new double[] {x, y, 0.025}, l.centre(), EXACT);
        assertEquals(-m * (0.15 - x) * (0.02 - y) - n * (0.02 - x) * (0.12 - y), l.inertia.xy, EXACT);
        assertEquals(0, l.inertia.xz, EXACT);
        assertEquals(m * (0.3 * 0.3 + 0.04 * 0.04) / 12 + n * (0.04 * 0.04 + 0.16 * 0.16) / 12
            + m * (Math.pow(0.15 - x, 2) + Math.pow(0.02 - y, 2))
            + n * (Math.pow(0.02 - x, 2) + Math.pow(0.12 - y, 2)), l.inertia.zz, EXACT);
    }

    @Test
    public void aModelHasTheTensorOfWhatItsMeshEnclosesNotOfItsHull() {
        box(Pose.IDENTITY, false, 0, 0.3, 0, 0.04, 0, 0.05);
        box(Pose.IDENTITY, false, 0, 0.04, 0.04, 0.2, 0, 0.05);
        assertEquals((0.3 * 0.04 + 0.16 * 0.04) * 0.05, mesh(UNSCALED).volume(), SINGLE);
        assertSame(l().withMass(1), mesh(UNSCALED).perKilogram(), SINGLE);
    }

    @Test
    public void aScaledModelHasTheTensorOfItsSize() {
        box(Pose.IDENTITY, false, 0, 0.15, 0, 0.02, 0, 0.1);
        box(Pose.IDENTITY, false, 0, 0.02, 0.02, 0.1, 0, 0.1);
        assertSame(l().withMass(1), mesh(2, 2, 0.5).perKilogram(), SINGLE);
    }

    @Test
    public void aHollowBoxHasNoMassInItsCavity() {
        double[] outside = {-0.2, 0.2, -0.3, 0.3, -0.4, 0.4};
        double[] cavity = {-0.1, 0.19, -0.2, 0.2, -0.3, 0.1};
        box(Pose.IDENTITY, false, outside);
        box(Pose.IDENTITY, true, cavity);
        MassProperties expected = MassProperties.sum(List.of(block(volume(outside), outside),
            block(-volume(cavity), cavity)));
        assertEquals(volume(outside) - volume(cavity), mesh(UNSCALED).volume(), SINGLE);
        assertSame(expected.withMass(1), mesh(UNSCALED).perKilogram(), 2 * SINGLE);
    }

    @Test
    public void aMirroredPartThatIsInsideOutCounts() {
        box(Pose.IDENTITY, false, 0.1, 0.3, 0, 0.1, 0, 0.1);
        box(Pose.IDENTITY, true, -0.3, -0.1, 0, 0.1, 0, 0.1);
        MassProperties expected = MassProperties.sum(List.of(block(0.5, 0.1, 0.3, 0, 0.1, 0, 0.1),
            block(0.5, -0.3, -0.1, 0, 0.1, 0, 0.1)));
        assertSame(expected, mesh(UNSCALED).perKilogram(), SINGLE);
    }

    @Test
    public void anOpenMeshHasTheTensorOfItsHull() {
        box(Pose.IDENTITY, false, 0, 0.3, 0, 0.04, 0, 0.05);
        box(Pose.IDENTITY, false, 0, 0.04, 0.04, 0.2, 0, 0.05);
        indices.subList(0, 3).clear();
        MeshSolid solid = mesh(UNSCALED);
        assertEquals(solid.convex().volume(), solid.volume(), 0);
        assertSame(MassProperties.of(solid.convex()), solid.perKilogram(), 0);
    }

    /** The numbers are those of trimesh 5.2.0 for the convex hull; the trunk of the tree is open. */
    @Test
    public void theTreeHasTheTensorThatTrimeshComputes() throws Exception {
        Solid tree = Solids.of(new Model("tree", "models/Tree/Tree.mesh.xml", 1), Project.read(project.folder()),
            new ArrayList<>());
        InertiaTensor inertia = new InertiaTensor(0.89610398, 0.59253752, 0.88816983, -0.00314238, -0.01340033,
            0.00678872);
        assertEquals(9.970956572, tree.volume(), 1e-6);
        assertSame(new MassProperties(1, new double[] {0.0276237186, 2.38850552, -0.00238371203}, inertia),
            tree.perKilogram(), SINGLE);
    }

    /** Front and back of a bent sheet enclose nothing. */
    @Test
    public void aSheetWithTwoSidesHasTheTensorOfItsHull() {
        for (double value : new double[] {0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1, 1}) {
            vertices.add((float) value);
        }
        indices.addAll(List.of(0, 1, 2, 0, 2, 1, 1, 3, 2, 1, 2, 3));
        MeshSolid solid = mesh(UNSCALED);
        assertEquals(1 / 6.0, solid.volume(), SINGLE);
    }
}
