// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

import java.util.Arrays;
import org.SEAR.geometry.Rotation;
import org.SEAR.raycast.PictureBeams;

/**
 * Renders strips of pictures, one row of tiles each: beams find the surface of each pixel, beams to the sun find
 * shadows, and appearances give the colours. Holds the buffers of one thread; allocates nothing per strip.
 */
final class Painter {
    private static final int TILE = PictureBeams.TILE * PictureBeams.TILE;
    private static final double FULL = 255;

    private final PictureBeams beams;
    private final double near;
    private final double far;
    /** Distance between neighbouring pixels one metre ahead, metres. */
    private final double pitch;
    private final double[] depths;
    private final int[] shapes;
    private final int[] parts;
    private final float[] sunLight = Daylight.sun();
    private final float[] skyLight = Daylight.sky();
    private final double[] sun = Daylight.toSun();
    private final double[] axes = new double[9];
    private final double[] frame = new double[12];
    /** Rotation from the picture's frame to the shape's, and the camera and the sun in the shape's frame. */
    private final double[] turn = new double[9];
    private final double[] eye = new double[3];
    private final double[] sunThere = new double[3];
    private final SurfaceHit sky = new SurfaceHit();
    private final SurfaceHit[] spots = new SurfaceHit[TILE];
    private final Appearance[] skins = new Appearance[TILE];
    private final double[] towards = new double[TILE];
    private final double[] points = new double[3 * TILE];
    private final int[] own = new int[TILE];
    private final byte[] lit = new byte[TILE];
    private RenderJob sight;
    private Appearance[] all;
    private boolean[] casting;
    private int known;

    /** @param pitch distance between neighbouring pixels one metre ahead, metres */
    Painter(PictureBeams beams, double pitch, double near, double far) {
        this.beams = beams;
        this.pitch = pitch;
        this.near = near;
        this.far = far;
        int count = beams.width * PictureBeams.TILE;
        depths = new double[count];
        shapes = new int[count];
        parts = new int[count];
        Arrays.setAll(spots, i -> new SurfaceHit());
    }

    private void cast(RenderJob from, int strip, double start) {
        sight = from;
        int first = strip * beams.tilesAcross;
        sight.scene.castPicture(beams, sight.eye, start, far, sight.ignoredOwner, first, first + beams.tilesAcross,
            depths, shapes, parts);
    }

    private int pixels(int strip) {
        return (beams.bottom(strip * beams.tilesAcross) - strip * PictureBeams.TILE) * beams.width;
    }

    /** Renders depths along the axis, metres; infinite where nothing is between near and far. */
    void depths(RenderJob from, int strip, float[] picture) {
        cast(from, strip, 0);
        int base = strip * PictureBeams.TILE * beams.width;
        int count = pixels(strip);
        for (int i = 0; i < count; i++) {
            picture[base + i] = depths[i] < near ? Float.POSITIVE_INFINITY : (float) depths[i];
        }
    }

    /**
     * Renders temperatures, degrees Celsius.
     *
     * @param ofShapes appearance of each shape
     */
    void temperatures(RenderJob from, int strip, Appearance[] ofShapes, float[] picture) {
        cast(from, strip, near);
        int base = strip * PictureBeams.TILE * beams.width;
        int count = pixels(strip);
        for (int i = 0; i < count; i++) {
            picture[base + i] = (float) (shapes[i] < 0 ? Appearance.SKY_TEMPERATURE : ofShapes[shapes[i]].temperature);
        }
    }

    /**
     * Renders colours, 0xRRGGBB.
     *
     * @param ofShapes appearance of each shape
     * @param castingShapes whether each shape casts a shadow
     */
    void colors(RenderJob from, int strip, Appearance[] ofShapes, boolean[] castingShapes, int[] picture) {
        cast(from, strip, near);
        all = ofShapes;
        casting = castingShapes;
        Rotation.write(sight.eye.qx, sight.eye.qy, sight.eye.qz, sight.eye.qw, axes, 0);
        known = -1;
        int first = strip * beams.tilesAcross;
        for (int tile = first; tile < first + beams.tilesAcross; tile++) {
            tile(tile, strip * PictureBeams.TILE * beams.width, picture);
        }
    }

    private void tile(int tile, int base, int[] picture) {
        int count = 0;
        for (int row = beams.top(tile); row < beams.bottom(tile); row++) {
            for (int pixel = row * beams.width + beams.first(tile); pixel < row * beams.width
                + beams.end(tile); pixel++) {
                own[count] = shapes[pixel - base];
                lit[count] = 0;
                if (own[count] >= 0) {
                    spot(count, pixel, pixel - base);
                }
                count++;
            }
        }
        sight.scene.castShadows(sun, casting, points, own, lit, count);
        int i = 0;
        for (int row = beams.top(tile); row < beams.bottom(tile); row++) {
            for (int pixel = row * beams.width + beams.first(tile); pixel < row * beams.width
                + beams.end(tile); pixel++) {
                picture[pixel] = own[i] < 0 ? sky(pixel) : color(i);
                i++;
            }
        }
    }

    private int sky(int pixel) {
        double x = beams.left(pixel);
        double y = beams.up(pixel);
        SkyBackground.look(axes[0] * x + axes[1] * y + axes[2], axes[3] * x + axes[4] * y + axes[5], axes[6] * x
            + axes[7] * y + axes[8], sky);
        return rgb(sky.red, sky.green, sky.blue);
    }

    private void spot(int number, int pixel, int at) {
        int shape = own[number];
        if (shape != known) {
            intersect(shape);
        }
        SurfaceHit s = spots[number];
        Appearance skin = all[shape];
        skins[number] = skin;
        double x = beams.left(pixel);
        double y = beams.up(pixel);
        double t = depths[at];
        s.depth = t;
        s.dx = turn[0] * x + turn[1] * y + turn[2];
        s.dy = turn[3] * x + turn[4] * y + turn[5];
        s.dz = turn[6] * x + turn[7] * y + turn[8];
        s.x = eye[0] + t * s.dx;
        s.y = eye[1] + t * s.dy;
        s.z = eye[2] + t * s.dz;
        s.part = parts[at];
        skin.normal(s);
        s.spread(-pitch * turn[0], -pitch * turn[3], -pitch * turn[6], -pitch * turn[1], -pitch * turn[4],
            -pitch * turn[7]);
        skin.shade(s);
        towards[number] = s.nx * sunThere[0] + s.ny * sunThere[1] + s.nz * sunThere[2];
        lit[number] = (byte) (towards[number] > 0 ? 1 : 0);
        points[3 * number] = sight.eye.x + t * (axes[0] * x + axes[1] * y + axes[2]);
        points[3 * number + 1] = sight.eye.y + t * (axes[3] * x + axes[4] * y + axes[5]);
        points[3 * number + 2] = sight.eye.z + t * (axes[6] * x + axes[7] * y + axes[8]);
    }

    /** Transforms camera, axes and sun into the frame of a shape. */
    private void intersect(int shape) {
        known = shape;
        sight.scene.frame(shape, frame);
        double x = sight.eye.x - frame[9];
        double y = sight.eye.y - frame[10];
        double z = sight.eye.z - frame[11];
        for (int k = 0; k < 3; k++) {
            for (int axis = 0; axis < 3; axis++) {
                turn[3 * k + axis] = frame[k] * axes[axis] + frame[3 + k] * axes[3 + axis]
                    + frame[6 + k] * axes[6 + axis];
            }
            eye[k] = frame[k] * x + frame[3 + k] * y + frame[6 + k] * z;
            sunThere[k] = frame[k] * sun[0] + frame[3 + k] * sun[1] + frame[6 + k] * sun[2];
        }
    }

    private int color(int number) {
        SurfaceHit s = spots[number];
        Appearance skin = skins[number];
        skin.color(s);
        double sunny = Math.max(0, towards[number]);
        double left = towards[number] > 0 && lit[number] == 0 ? 1 - Daylight.SHADOW : 1;
        if (!skin.isLit()) {
            return rgb(left * s.red, left * s.green, left * s.blue);
        }
        return rgb(left * Math.min(FULL, s.red * (skyLight[0] + sunLight[0] * sunny)),
            left * Math.min(FULL, s.green * (skyLight[1] + sunLight[1] * sunny)),
            left * Math.min(FULL, s.blue * (skyLight[2] + sunLight[2] * sunny)));
    }

    private static int rgb(double red, double green, double blue) {
        return (int) (Math.min(FULL, red) + 0.5) << 16 | (int) (Math.min(FULL, green) + 0.5) << 8
            | (int) (Math.min(FULL, blue) + 0.5);
    }
}
