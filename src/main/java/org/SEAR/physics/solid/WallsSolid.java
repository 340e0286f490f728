// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.io.IOException;
import org.SEAR.POJOs.FloorPlan;
import org.SEAR.POJOs.Maze;
import org.SEAR.POJOs.Walls;
import org.SEAR.collision.ConvexBox;
import org.SEAR.collision.ConvexShape;
import org.SEAR.files.Assets;
import org.SEAR.files.FileLimits;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Triangles;
import org.SEAR.geometry.WallGrid;
import org.SEAR.project.models.FloorPlans;

/** Fixed vertical walls of a floor plan or a maze, as a mesh whose bottom is at the object's height. */
final class WallsSolid extends MeshSolid {
    /** Most areas of a drawing from above; a finer one is drawn coarser. */
    private static final int MOST_AREAS = 2500;

    private final WallGrid grid;
    private final Triangles surface;
    private final double[] scale;
    private final double area;

    private WallsSolid(WallGrid grid, Triangles surface, double[] scale, Pose offset) {
        super(surface, scale, offset);
        this.grid = grid;
        this.surface = surface;
        this.scale = scale;
        area = grid.area();
    }

    static WallsSolid of(FloorPlan plan, Assets assets) throws IOException {
        return of(plan, FloorPlans.of(plan, assets), plan.getPath());
    }

    static WallsSolid of(Maze maze) throws IOException {
        return of(maze, FloorPlans.of(maze), maze.toString());
    }

    private static WallsSolid of(Walls walls, FloorPlans plan, String file) throws IOException {
        Triangles surface = plan.grid.surface(walls.getHeight() / 2);
        if (surface == null || surface.size() == 0) {
            throw FileLimits.wrong(file, "the number of wall faces", surface == null ? "more than " + WallGrid.MOST : 0,
                "1 to " + WallGrid.MOST + ": a picture without grain");
        }
        double[] scale = {walls.getScaleX(), walls.getScaleY(), walls.getScaleZ()};
        Pose at = plan.pose;
        return new WallsSolid(plan.grid, surface, scale, new Pose(at.x * scale[0], walls.getHeight() / 2 * scale[1],
            at.z * scale[2], at.qx, at.qy, at.qz, at.qw));
    }

    @Override
    public TriangleSearch triangles() {
        return new WallTriangles(surface, scale);
    }

    @Override
    public double[][][] areas() {
        double[][] tops = grid.tops(MOST_AREAS);
        double[][][] areas = new double[tops.length][4][];
        for (int i = 0; i < tops.length; i++) {
            for (int n = 0; n < areas[i].length; n++) {
                areas[i][n] = offset.transform(tops[i][n == 1 || n == 2 ? 1 : 0] * scale[0], halfY,
                    tops[i][n < 2 ? 2 : 3] * scale[2]);
            }
        }
        return areas;
    }

    @Override
    protected ConvexShape makeConvex() {
        return new ConvexBox(halfX, halfY, halfZ);
    }

    @Override
    public double volume() {
        return area * scale[0] * scale[2] * 2 * halfY;
    }

    @Override
    public double thickness() {
        return Math.min(2 * halfY, grid.thickness() * Math.min(scale[0], scale[2]));
    }

    @Override
    public boolean encloses(double x, double y, double z) {
        return Math.abs(y) < halfY && grid.contains(x / scale[0], z / scale[2]);
    }
}
