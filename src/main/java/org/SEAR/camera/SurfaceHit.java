// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

/**
 * Point where a beam of a picture hits a surface, in the surface's frame, with the surface's colour there. Mutable, to
 * avoid allocation per pixel; belongs to one thread.
 */
public final class SurfaceHit {
    /** Position, metres. */
    public double x;
    public double y;
    public double z;
    /** Depth along the camera's axis, metres, and the beam's displacement per metre of depth. */
    public double depth;
    public double dx;
    public double dy;
    public double dz;
    /** Displacement of the position when the beam moves one pixel to the right, metres. */
    public double rightX;
    public double rightY;
    public double rightZ;
    /** Displacement of the position when the beam moves one pixel down, metres. */
    public double downX;
    public double downY;
    public double downZ;
    /** Index of the triangle of a model, as in {@code Triangles}; -1 for other shapes. */
    public int part;
    /** Outward unit normal. */
    public double nx;
    public double ny;
    public double nz;
    /** Colour before lighting, 0 to 255 each. */
    public double red;
    public double green;
    public double blue;

    /** Takes a colour, 0xRRGGBB. */
    public void setColor(int rgb) {
        red = rgb >> 16 & 0xff;
        green = rgb >> 8 & 0xff;
        blue = rgb & 0xff;
    }

    /** Takes a normal of any length but 0. */
    public void setNormal(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        nx = x / length;
        ny = y / length;
        nz = z / length;
    }

    /**
     * Reckons how the place moves from pixel to pixel, of a plane surface with the normal: by how much the beam's
     * direction changes.
     *
     * @param ax of the direction for a pixel to the right, likewise ay and az
     * @param bx of the direction for a pixel down, likewise by and bz
     */
    void spread(double ax, double ay, double az, double bx, double by, double bz) {
        double along = nx * dx + ny * dy + nz * dz;
        double right = along == 0 ? 0 : (nx * ax + ny * ay + nz * az) / along;
        double down = along == 0 ? 0 : (nx * bx + ny * by + nz * bz) / along;
        rightX = depth * (ax - right * dx);
        rightY = depth * (ay - right * dy);
        rightZ = depth * (az - right * dz);
        downX = depth * (bx - down * dx);
        downY = depth * (by - down * dy);
        downZ = depth * (bz - down * dz);
    }
}
