package org.SEAR.camera;

/**
 * Where a beam of a picture has met a surface, in the surface's own frame, and what it sees there. Mutable, so that nothing is made anew for a pixel;
 * belongs to one thread.
 */
public final class SurfaceHit {
    /** The place, metres. */
    public double x;
    public double y;
    public double z;
    /** The beam: how far ahead the place is, and what it goes for each metre ahead. */
    public double depth;
    public double dx;
    public double dy;
    public double dz;
    /** Where the place moves when the beam goes one pixel to the right, metres. */
    public double rightX;
    public double rightY;
    public double rightZ;
    /** Where it moves when the beam goes one pixel down, metres. */
    public double downX;
    public double downY;
    public double downZ;
    /** Number of a model's triangle, as its {@code Triangles} have it; -1 for others. */
    public int part;
    /** Outward normal of length 1. */
    public double nx;
    public double ny;
    public double nz;
    /** What is seen: 0 to 255 each, before the light. */
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
     * Reckons how the place moves from pixel to pixel, of a plane surface with the normal: by how much the beam's direction changes.
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
