// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

import org.SEAR.geometry.SurfaceMesh;

/** Appearance of a box: a picture on each of its six sides, placed as in the drawn mesh. Immutable, any thread. */
public final class BoxAppearance extends Appearance {
    private static final int SIDES = 6;

    private final double halfX;
    private final double halfY;
    private final double halfZ;
    private final Paint paint;
    private final PlaneMap[] sides = new PlaneMap[SIDES];

    /**
     * @param look drawn mesh, two triangles per side
     * @param half half extents along x, y and z, metres
     */
    public BoxAppearance(SurfaceMesh look, double[] half, Paint paint, double temperature, boolean casting) {
        super(temperature, casting);
        halfX = half[0];
        halfY = half[1];
        halfZ = half[2];
        this.paint = paint;
        float[] at = look.getPositions();
        float[] normals = look.getNormals();
        float[] places = look.getPictures();
        int[] indices = look.getIndices();
        double[] corners = new double[9];
        double[] ofCorners = new double[6];
        for (int first = 0; first < indices.length; first += 3) {
            for (int i = 0; i < 3; i++) {
                int vertex = indices[first + i];
                for (int axis = 0; axis < 3; axis++) {
                    corners[3 * i + axis] = at[3 * vertex + axis];
                }
                ofCorners[2 * i] = places[2 * vertex];
                ofCorners[2 * i + 1] = places[2 * vertex + 1];
            }
            int vertex = 3 * indices[first];
            sides[side(normals[vertex], normals[vertex + 1], normals[vertex + 2])] = new PlaneMap(corners, ofCorners);
        }
    }

    /** Returns the index of a side: two per axis, the negative side first. */
    private static int side(double nx, double ny, double nz) {
        int axis = Math.abs(nx) > 0.5 ? 0 : Math.abs(ny) > 0.5 ? 1 : 2;
        double sign = axis == 0 ? nx : axis == 1 ? ny : nz;
        return 2 * axis + (sign > 0 ? 1 : 0);
    }

    @Override
    protected void normal(SurfaceHit s) {
        double ex = Math.abs(s.x) - halfX;
        double ey = Math.abs(s.y) - halfY;
        double ez = Math.abs(s.z) - halfZ;
        s.nx = 0;
        s.ny = 0;
        s.nz = 0;
        if (ex >= ey && ex >= ez) {
            s.nx = Math.signum(s.x);
        } else if (ey >= ez) {
            s.ny = Math.signum(s.y);
        } else {
            s.nz = Math.signum(s.z);
        }
    }

    @Override
    protected void color(SurfaceHit spot) {
        sides[side(spot.nx, spot.ny, spot.nz)].look(paint, spot);
    }
}
