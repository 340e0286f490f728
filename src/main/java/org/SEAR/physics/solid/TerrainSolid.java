// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.util.function.Predicate;
import org.SEAR.collision.ConvexHull;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.geometry.HeightSearch;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.raycast.BeamScene;

/** Terrain of an area, always fixed; rays and contacts use exactly the same triangles. */
public final class TerrainSolid extends Solid {
    private final HeightGrid heights;
    private final HeightSearch search;

    public TerrainSolid(HeightGrid heights) {
        super(half(heights.x(0), heights.x(heights.rows - 1)), half(heights.lowest(), heights.highest()),
            half(heights.z(0), heights.z(heights.columns - 1)), Pose.IDENTITY);
        this.heights = heights;
        search = new HeightSearch(heights);
    }

    /** @return null without heights */
    static TerrainSolid of(HeightGrid heights) {
        return heights == null ? null : new TerrainSolid(heights);
    }

    private static double half(float low, float high) {
        return Math.max(Math.abs(low), Math.abs(high));
    }

    @Override
    public int addTo(BeamScene scene, int owner) {
        return scene.addHeights(heights, owner);
    }

    /** Returns the bounding box; contacts use the triangles instead, see {@link #anyTriangle}. */
    @Override
    protected ConvexShape makeConvex() {
        double[][] corners = corners();
        double[] points = new double[3 * corners.length];
        for (int i = 0; i < points.length; i++) {
            points[i] = corners[i / 3][i % 3];
        }
        return ConvexHull.of(points);
    }

    @Override
    public TriangleSearch triangles() {
        return new HeightTriangles(heights);
    }

    /** Returns null: a terrain is drawn from its heights. */
    @Override
    public SurfaceMesh look() {
        return null;
    }

    /** Returns the corners of the bounding box. */
    @Override
    protected double[][] corners() {
        double[][] corners = new double[8][];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = new double[] {heights.x(i % 2 == 0 ? 0 : heights.rows - 1),
                i / 4 == 0 ? heights.lowest() : heights.highest(), heights.z(i / 2 % 2 == 0 ? 0 : heights.columns - 1)};
        }
        return corners;
    }

    @Override
    public boolean isMesh() {
        return true;
    }

    @Override
    public boolean anyTriangle(Aabb box, Predicate<double[]> test) {
        double[] corners = new double[9];
        return search.any(box.minX, box.minY, box.minZ, box.maxX, box.maxY, box.maxZ, at -> {
            for (int i = 0; i < corners.length; i++) {
                corners[i] = at[i];
            }
            return test.test(corners);
        });
    }

    @Override
    public double[] farthest(double dx, double dy, double dz) {
        return new double[] {heights.x(dx < 0 ? 0 : heights.rows - 1),
            dy < 0 ? heights.lowest() : heights.highest(), heights.z(dz < 0 ? 0 : heights.columns - 1)};
    }
}
