// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Chessboard;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.FloorPlan;
import org.SEAR.POJOs.Marker;
import org.SEAR.POJOs.Maze;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Picture;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Sphere;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Wall;
import org.SEAR.POJOs.Wheel;
import org.SEAR.collision.GjkDistance;
import org.SEAR.geometry.InertiaTensor;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.project.ProjectRule;
import org.SEAR.raycast.BeamScene;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** Each shape is the same body to contacts, beams, the window and the tab. */
public class SolidsTest {
    /** Largest relative deficit of the window's polygons on round shapes, and of the tab's outline. */
    private static final double COARSE = 0.03;
    private static final double EXACT = 1e-6;
    private static final Solids.Sources NO_MODELS = null;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private final List<Shape> shapes = new ArrayList<>();
    private final List<Solid> solids = new ArrayList<>();
    private final Random random = new Random(Long.getLong("sear.seed", 3));

    @Before
    public void make() throws Exception {
        add(new Box("box", 0.4, 0.6, 0.8), 1, 1, 1);
        add(new Box("scaled box", 0.4, 0.6, 0.8), 2, 1, 0.5);
        add(new Cylinder("cylinder", 0.3, 0.8), 1, 1, 1);
        add(new Cylinder("elliptic cylinder", 0.3, 0.8), 1, 2, 1.5);
        add(new Cone("cone", 0.3, 0.8), 1, 1, 1);
        add(new Cone("elliptic cone", 0.3, 0.8), 1.5, 0.5, 1);
        add(new Sphere("sphere", 0.4), 1, 1, 1);
        add(new Sphere("ellipsoid", 0.4), 0.5, 1, 2);
        add(new Floor("floor", 2, 3), 1, 1, 1);
        add(new Wheel("wheel", 0.3, 0.1), 1, 1, 1);
        add(new Marker("marker", "APRILTAG_36h11", 3, 0.8), 1, 1, 2);
        add(new Chessboard("chessboard", 8, 5, 0.1), 2, 1, 1);
        add(new Picture("picture", 0.7, 0.4), 1, 1, 30);
    }

    private void add(Shape shape, double sx, double sy, double sz) throws Exception {
        shape.scale(sx, sy, sz);
        shapes.add(shape);
        solids.add(Solids.of(shape, NO_MODELS));
    }

    private double[] direction() {
        double[] d = new double[3];
        double length = 0;
        while (length < 0.1 || length > 1) {
            for (int axis = 0; axis < 3; axis++) {
                d[axis] = 2 * random.nextDouble() - 1;
            }
            length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        }
        return new double[] {d[0] / length, d[1] / length, d[2] / length};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    @Test
    public void everyShapeIsTestedHere() {
        Set<Class<?>> tested = new HashSet<>();
        shapes.forEach(shape -> tested.add(shape.getClass()));
        tested.add(Model.class);
        tested.add(Terrain.class);
        tested.addAll(List.of(Maze.class, FloorPlan.class, Wall.class));    // by WallsTest
        assertEquals(tested, new HashSet<>(new Solids().types()));
    }

    @Test
    public void halfSizesAreThoseOfTheCollidingBody() {
        for (int i = 0; i < solids.size(); i++) {
            Solid solid = solids.get(i);
            String name = shapes.get(i).getName();
            assertEquals(name, solid.halfX, solid.farthest(1, 0, 0)[0], EXACT);
            assertEquals(name, solid.halfY, solid.farthest(0, -1, 0)[1] * -1, EXACT);
            assertEquals(name, solid.halfZ, solid.farthest(0, 0, 1)[2], EXACT);
        }
    }

    /**
     * The triangles face outward, no corner lies outside the colliding body, and they fill it. Volume, centre of mass
     * and moments of inertia agree.
     */
    @Test
    public void theWindowShowsTheCollidingBody() {
        for (int i = 0; i < solids.size(); i++) {
            String name = shapes.get(i).getName();
            Solid solid = solids.get(i);
            SurfaceMesh look = solid.look();
            float[] at = look.getPositions();
            for (int k = 0; k < 200; k++) {
                double[] d = direction();
                double reach = dot(d, solid.farthest(d[0], d[1], d[2]));
                for (int corner = 0; corner < at.length; corner += 3) {
                    assertTrue(name, d[0] * at[corner] + d[1] * at[corner + 1] + d[2] * at[corner + 2] <= reach + 1e-3);
                }
            }
            double[] moments = moments(look);
            assertEquals(name, 1, moments[0] / solid.volume(), COARSE);
            assertEquals(name, solid.perKilogram().centre()[1], moments[2] / moments[0], 1e-2);
            InertiaTensor tensor = solid.perKilogram().inertia;
            double[] inertia = {tensor.xx, tensor.yy, tensor.zz};
            double[] squares = {moments[4], moments[5] - moments[2] * moments[2] / moments[0], moments[6]};
            for (int axis = 0; axis < 3; axis++) {
                double expected = (squares[(axis + 1) % 3] + squares[(axis + 2) % 3]) / moments[0];
                assertEquals(name + ", axis " + axis, 1, inertia[axis] / expected, 2 * COARSE);
            }
        }
    }

    /**
     * Returns volume and the integrals of x, y, z and their squares over the enclosed space, summed over tetrahedra to
     * the origin.
     */
    private static double[] moments(SurfaceMesh look) {
        float[] at = look.getPositions();
        int[] corners = look.getIndices();
        double[] sum = new double[7];
        for (int i = 0; i < corners.length; i += 3) {
            int a = 3 * corners[i];
            int b = 3 * corners[i + 1];
            int c = 3 * corners[i + 2];
            double part = ((double) at[a] * ((double) at[b + 1] * at[c + 2] - (double) at[b + 2] * at[c + 1])
                + (double) at[a + 1] * ((double) at[b + 2] * at[c] - (double) at[b] * at[c + 2])
                + (double) at[a + 2] * ((double) at[b] * at[c + 1] - (double) at[b + 1] * at[c])) / 6;
            sum[0] += part;
            for (int axis = 0; axis < 3; axis++) {
                double total = (double) at[a + axis] + at[b + axis] + at[c + axis];
                double squares = (double) at[a + axis] * at[a + axis] + (double) at[b + axis] * at[b + axis]
                    + (double) at[c + axis] * at[c + axis];
                sum[1 + axis] += part * total / 4;
                sum[4 + axis] += part * (total * total + squares) / 20;
            }
        }
        return sum;
    }

    /** Just beyond the end of a beam to the centre is inside; just before it is outside. */
    @Test
    public void beamsHitTheCollidingBody() {
        for (int i = 0; i < solids.size(); i++) {
            Solid solid = solids.get(i);
            BeamScene scene = new BeamScene();
            solid.addTo(scene, BeamScene.WORLD);
            scene.commit();
            for (int k = 0; k < 100; k++) {
                double[] d = direction();
                double t = scene.cast(-10 * d[0], -10 * d[1], -10 * d[2], d[0], d[1], d[2], 20, BeamScene.WORLD, null);
                String what = shapes.get(i).getName() + " along " + d[0] + " " + d[1] + " " + d[2];
                assertTrue(what + " at " + t, t < 10);
                assertTrue(what, isInside(solid, d, t - 10 + 1e-3));
                assertTrue(what, !isInside(solid, d, t - 10 - 1e-3));
            }
        }
    }

    /** Returns whether a point of the beam is inside, by its distance from the colliding body. */
    private static boolean isInside(Solid solid, double[] d, double t) {
        double[] p = {t * d[0], t * d[1], t * d[2]};
        GjkDistance gjk = new GjkDistance();
        return gjk.measure((dx, dy, dz, into) -> solid.convex().support(dx, dy, dz, into), (dx, dy, dz, into) ->
            System.arraycopy(p, 0, into, 0, 3),
            0);
    }

    @Test
    public void theTabsOutlineReachesAsFarAsTheCollidingBody() {
        for (int i = 0; i < solids.size(); i++) {
            Solid solid = solids.get(i);
            for (int k = 0; k < 100; k++) {
                double[] d = direction();
                double[] inside = solid.offset.rotateBack(d[0], d[1], d[2]);
                double[] farthest = solid.farthest(inside[0], inside[1], inside[2]);
                double reach = dot(d, solid.offset.transform(farthest[0], farthest[1], farthest[2]));
                double drawn = Double.NEGATIVE_INFINITY;
                for (double[] point : solid.outline()) {
                    drawn = Math.max(drawn, dot(d, point));
                }
                String name = shapes.get(i).getName();
                assertTrue(name + ": " + drawn + " of " + reach, drawn <= reach + 1e-3
                    && drawn >= reach - COARSE * solid.convex().radius());
            }
        }
    }

    @Test
    public void aFloorsTopIsAtItsOriginAndAWheelsAxleAlongX() throws Exception {
        assertEquals(0, highest(solids.get(8)), EXACT);
        assertEquals(0.3, highest(solids.get(9)), EXACT);
        assertEquals(Pose.IDENTITY, solids.get(0).offset);
    }

    private static double highest(Solid solid) {
        double most = Double.NEGATIVE_INFINITY;
        for (double[] point : solid.outline()) {
            most = Math.max(most, point[1]);
        }
        return most;
    }
}
