// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

import org.SEAR.geometry.Triangles;

/** Appearance of a model: the materials that its file gives each triangle. Immutable, any thread. */
public final class MeshAppearance extends Appearance {
    private final Triangles mesh;
    private final double[] scale;
    private final float[] normals;
    private final float[] places;
    private final float[] colors;
    private final short[] paintOf;
    private final Paint[] paints;

    /**
     * @param scale along x, y and z
     * @param normals x, y and z of each vertex; null for flat triangles
     * @param places texture coordinates u and v of each vertex; null without pictures
     * @param colors red, green and blue of each vertex, 0 to 1, which multiply the paint; null for none
     * @param paintOf number of each triangle's paint; null for the first
     */
    public MeshAppearance(Triangles mesh, double[] scale, float[] normals, float[] places, float[] colors,
        short[] paintOf, Paint[] paints, double temperature, boolean casting) {
        super(temperature, casting);
        this.mesh = mesh;
        this.scale = scale.clone();
        this.normals = normals;
        this.places = places;
        this.colors = colors;
        this.paintOf = paintOf;
        this.paints = paints.clone();
    }

    private double at(int vertex, int axis) {
        return mesh.vertices[3 * vertex + axis] * scale[axis];
    }

    @Override
    protected void normal(SurfaceHit s) {
        int a = mesh.indices[3 * s.part];
        int b = mesh.indices[3 * s.part + 1];
        int c = mesh.indices[3 * s.part + 2];
        double ex = at(b, 0) - at(a, 0);
        double ey = at(b, 1) - at(a, 1);
        double ez = at(b, 2) - at(a, 2);
        double fx = at(c, 0) - at(a, 0);
        double fy = at(c, 1) - at(a, 1);
        double fz = at(c, 2) - at(a, 2);
        double nx = ey * fz - ez * fy;
        double ny = ez * fx - ex * fz;
        double nz = ex * fy - ey * fx;
        if (nx != 0 || ny != 0 || nz != 0) {
            s.setNormal(nx, ny, nz);
        } else {
            s.setNormal(-s.dx, -s.dy, -s.dz);
        }
    }

    /**
     * Interpolates the vertex normals, so that light is smooth across edges; the triangle's own normal is for pictures.
     */
    @Override
    void shade(SurfaceHit s) {
        if (normals == null) {
            return;
        }
        int first = 3 * s.part;
        double b = share(first, 1, 2, s.x, s.y, s.z);
        double c = share(first, 2, 1, s.x, s.y, s.z);
        double a = 1 - b - c;
        double nx = mixed(normals, 3, 0, first, a, b, c) / scale[0];
        double ny = mixed(normals, 3, 1, first, a, b, c) / scale[1];
        double nz = mixed(normals, 3, 2, first, a, b, c) / scale[2];
        if (nx * nx + ny * ny + nz * nz > 0) {
            s.setNormal(nx, ny, nz);
        }
    }

    /** Returns the barycentric weight of a triangle's corner at a point of its plane. */
    private double share(int first, int corner, int other, double x, double y, double z) {
        int a = mesh.indices[first];
        int b = mesh.indices[first + corner];
        int c = mesh.indices[first + other];
        double bb = 0;
        double bc = 0;
        double cc = 0;
        double pb = 0;
        double pc = 0;
        for (int axis = 0; axis < 3; axis++) {
            double e = at(b, axis) - at(a, axis);
            double f = at(c, axis) - at(a, axis);
            double p = (axis == 0 ? x : axis == 1 ? y : z) - at(a, axis);
            bb += e * e;
            bc += e * f;
            cc += f * f;
            pb += p * e;
            pc += p * f;
        }
        double area = bb * cc - bc * bc;
        return area > 0 ? (cc * pb - bc * pc) / area : 0;
    }

    private double mixed(float[] values, int size, int number, int first, double a, double b, double c) {
        return a * values[size * mesh.indices[first] + number] + b * values[size * mesh.indices[first + 1] + number]
            + c * values[size * mesh.indices[first + 2] + number];
    }

    private double place(int number, int first, double x, double y, double z) {
        double b = share(first, 1, 2, x, y, z);
        double c = share(first, 2, 1, x, y, z);
        return mixed(places, 2, number, first, 1 - b - c, b, c);
    }

    @Override
    protected void color(SurfaceHit s) {
        paint(s);
        if (colors != null) {
            int first = 3 * s.part;
            double b = share(first, 1, 2, s.x, s.y, s.z);
            double c = share(first, 2, 1, s.x, s.y, s.z);
            double a = 1 - b - c;
            s.red *= mixed(colors, 3, 0, first, a, b, c);
            s.green *= mixed(colors, 3, 1, first, a, b, c);
            s.blue *= mixed(colors, 3, 2, first, a, b, c);
        }
    }

    private void paint(SurfaceHit s) {
        Paint paint = paints[paintOf == null ? 0 : paintOf[s.part]];
        if (places == null || paint.isPlain()) {
            paint.look(0, 0, 0, 0, 0, 0, s);
            return;
        }
        int first = 3 * s.part;
        double u = place(0, first, s.x, s.y, s.z);
        double v = place(1, first, s.x, s.y, s.z);
        paint.look(u, v, place(0, first, s.x + s.rightX, s.y + s.rightY, s.z + s.rightZ) - u,
            place(1, first, s.x + s.rightX, s.y + s.rightY, s.z + s.rightZ) - v,
            place(0, first, s.x + s.downX, s.y + s.downY, s.z + s.downZ) - u,
            place(1, first, s.x + s.downX, s.y + s.downY, s.z + s.downZ) - v, s);
    }
}
