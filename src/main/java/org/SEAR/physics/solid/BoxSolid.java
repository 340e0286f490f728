// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import org.SEAR.POJOs.Board;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.collision.ConvexBox;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.raycast.BeamScene;

/** Box, floor, or plate with a picture on its front only. */
public final class BoxSolid extends Solid {
    /** Per side: the normal, the direction of the picture's right edge, and the direction of its upper edge. */
    private static final int[][] SIDES = {{0, 0, -1, -1, 0, 0, 0, 1, 0}, {1, 0, 0, 0, 0, -1, 0, 1, 0},
        {0, 0, 1, 1, 0, 0, 0, 1, 0},
        {-1, 0, 0, 0, 0, 1, 0, 1, 0}, {0, 1, 0, 0, 0, -1, -1, 0, 0}, {0, -1, 0, 0, 0, -1, 1, 0, 0}};

    /** Picture coordinate of the corner whose colour covers the other sides of a plate. */
    private static final double CORNER = 1e-3;

    private final boolean plate;

    /** @param halfX half extent along x, metres, likewise halfY and halfZ */
    public BoxSolid(double halfX, double halfY, double halfZ, Pose offset) {
        this(halfX, halfY, halfZ, offset, false);
    }

    private BoxSolid(double halfX, double halfY, double halfZ, Pose offset, boolean plate) {
        super(halfX, halfY, halfZ, offset);
        this.plate = plate;
    }

    static BoxSolid of(Board board) {
        double half = board.getThickness() / 2 * board.getScaleZ();
        return new BoxSolid(board.getBoardWidth() / 2 * board.getScaleX(),
            board.getBoardHeight() / 2 * board.getScaleY(), half,
            new Pose(0, 0, half, 0, 0, 0, 1), true);
    }

    static BoxSolid of(Box box) {
        return new BoxSolid(box.getLength() / 2 * box.getScaleX(), box.getHeight() / 2 * box.getScaleY(),
            box.getWidth() / 2 * box.getScaleZ(),
            Pose.IDENTITY);
    }

    static BoxSolid of(Floor floor) {
        double half = Floor.THICKNESS / 2 * floor.getScaleY();
        return new BoxSolid(floor.getLength() / 2 * floor.getScaleX(), half, floor.getWidth() / 2 * floor.getScaleZ(),
            new Pose(0, -half, 0, 0, 0, 0, 1));
    }

    @Override
    public int addTo(BeamScene scene, int owner) {
        return scene.addBox(halfX, halfY, halfZ, owner);
    }

    @Override
    protected ConvexShape makeConvex() {
        return new ConvexBox(halfX, halfY, halfZ);
    }

    @Override
    protected double[][] corners() {
        double[][] corners = new double[8][];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = new double[] {(i & 1) == 0 ? -halfX : halfX, (i & 2) == 0 ? -halfY : halfY, (i & 4) == 0
                ? -halfZ : halfZ};
        }
        return corners;
    }

    @Override
    public SurfaceMesh look() {
        SurfaceMesh mesh = new SurfaceMesh();
        for (int[] side : SIDES) {
            vertex(mesh, side, 0, 0);
            vertex(mesh, side, 1, 0);
            int upperRight = vertex(mesh, side, 1, 1);
            int upperLeft = vertex(mesh, side, 0, 1);
            mesh.triangle(upperRight - 2, upperRight - 1, upperRight);
            mesh.triangle(upperRight - 2, upperRight, upperLeft);
        }
        return mesh;
    }

    private int vertex(SurfaceMesh mesh, int[] side, int u, int v) {
        int right = 2 * u - 1;
        int up = 2 * v - 1;
        boolean plain = plate && side != SIDES[0];
        return mesh.vertex((side[0] + right * side[3] + up * side[6]) * halfX,
            (side[1] + right * side[4] + up * side[7]) * halfY,
            (side[2] + right * side[5] + up * side[8]) * halfZ, side[0], side[1], side[2], plain ? CORNER : u, plain
                ? CORNER : v);
    }
}
