// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import org.SEAR.POJOs.Wall;
import org.SEAR.collision.ConvexBox;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.WallLine;

/** Fixed vertical walls along a line, as a mesh whose bottom is at the object's height. */
final class WallLineSolid extends MeshSolid {
    private final WallLine line;
    private final double[] scale;
    private final double thickness;

    private WallLineSolid(WallLine line, Wall wall, double[] scale) {
        super(line.surface(wall.getHeight() / 2), scale,
            Pose.ofDegrees(0, wall.getHeight() / 2 * scale[1], 0, 0, 0, 0));
        this.line = line;
        this.scale = scale;
        thickness = wall.getThickness();
    }

    static WallLineSolid of(Wall wall) {
        double[][] corners = wall.getCorners().stream().map(corner -> new double[] {corner.getX(), corner.getZ()})
            .toArray(double[][]::new);
        return new WallLineSolid(new WallLine(corners, wall.getThickness()), wall,
            new double[] {wall.getScaleX(), wall.getScaleY(), wall.getScaleZ()});
    }

    @Override
    public double[][][] areas() {
        double[][][] areas = line.areas();
        for (int i = 0; i < areas.length; i++) {
            double[][] corners = new double[areas[i].length][];
            for (int n = 0; n < corners.length; n++) {
                corners[n] = offset.transform(areas[i][n][0] * scale[0], halfY, areas[i][n][1] * scale[2]);
            }
            areas[i] = corners;
        }
        return areas;
    }

    @Override
    protected ConvexShape makeConvex() {
        return new ConvexBox(halfX, halfY, halfZ);
    }

    @Override
    public double volume() {
        return line.area() * scale[0] * scale[2] * 2 * halfY;
    }

    @Override
    public double thickness() {
        return Math.min(2 * halfY, thickness * Math.min(scale[0], scale[2]));
    }

    @Override
    public boolean encloses(double x, double y, double z) {
        return Math.abs(y) < halfY && line.contains(x / scale[0], z / scale[2]);
    }
}
