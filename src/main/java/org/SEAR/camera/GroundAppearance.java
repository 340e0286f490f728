// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

import org.SEAR.geometry.HeightGrid;
import org.SEAR.terrain.relief.GroundGrain;
import org.SEAR.terrain.relief.GroundPicture;

/**
 * Appearance of a terrain: one picture over all of it that contains the light, a grain nearby, haze at a distance.
 * Immutable, any thread.
 */
public final class GroundAppearance extends Appearance {
    /** Distance at which haze replaces two thirds of the colour, metres; less in a smaller world. */
    private static final double CLEAR = 38_000;
    private static final double NEAREST_HAZE = 2500;
    private static final double OF_WORLD = 2.2;
    /** Height that halves the haze, metres. */
    private static final double THIN = 3000;
    private static final double[] AIR = {255 * 0.75, 255 * 0.82, 255 * 0.87};
    private static final double GRAIN = 0.8;
    /** Half of the distance over which the slope of the ground is measured, as a share of the post spacing. */
    private static final double SLOPE = 0.02;

    private final HeightGrid field;
    private final Texture picture;
    private final Texture grain;
    private final double sizeX;
    private final double sizeZ;
    private final double clear;

    /** @param picture covers all of the field */
    public GroundAppearance(HeightGrid field, GroundPicture picture, double temperature) {
        super(temperature, false);
        this.field = field;
        this.picture = new Texture(picture.width, picture.height, upsideDown(picture.pixels, picture.width), false);
        int side = GroundGrain.SIDE;
        int[] grey = new int[side * side];
        byte[] values = GroundGrain.grey();
        for (int i = 0; i < grey.length; i++) {
            grey[i] = (values[i] & 0xff) * 0x10101;
        }
        grain = new Texture(side, side, upsideDown(grey, side), true);
        sizeX = (field.rows - 1) * field.spacingX;
        sizeZ = (field.columns - 1) * field.spacingZ;
        clear = Math.max(NEAREST_HAZE, Math.min(CLEAR, OF_WORLD * Math.sqrt(sizeX * sizeX + sizeZ * sizeZ)));
    }

    private static int[] upsideDown(int[] pixels, int width) {
        int[] turned = new int[pixels.length];
        for (int at = 0; at < pixels.length; at += width) {
            System.arraycopy(pixels, at, turned, pixels.length - width - at, width);
        }
        return turned;
    }

    @Override
    boolean isLit() {
        return false;
    }

    @Override
    protected void normal(SurfaceHit s) {
        double stepX = SLOPE * field.spacingX;
        double stepZ = SLOPE * field.spacingZ;
        double north = (field.height(s.x + stepX, s.z) - field.height(s.x - stepX, s.z)) / (2 * stepX);
        double east = (field.height(s.x, s.z + stepZ) - field.height(s.x, s.z - stepZ)) / (2 * stepZ);
        if (Double.isFinite(north) && Double.isFinite(east)) {
            s.setNormal(-north, 1, -east);
        } else {
            s.setNormal(0, 1, 0);
        }
    }

    @Override
    protected void color(SurfaceHit s) {
        double close = Math.max(0, 1 - s.depth / GroundGrain.FAR);
        double rough = 1;
        if (close > 0) {
            double size = GroundGrain.REPEATED;
            grain.look(s.x / size, s.z / size, s.rightX / size, s.rightZ / size, s.downX / size, s.downZ / size, s);
            rough = 1 + close * close * GRAIN * (s.red / 255 - 0.5);
        }
        picture.look((s.z - field.lowZ) / sizeZ, (s.x - field.lowX) / sizeX, s.rightZ / sizeZ, s.rightX / sizeX,
            s.downZ / sizeZ, s.downX / sizeX, s);
        double down = -s.depth * s.dy;
        double far = s.depth * Math.sqrt(s.dx * s.dx + s.dy * s.dy + s.dz * s.dz);
        double haze = 1 - StrictMath.exp(-far / (clear * (1 + Math.max(0, down) / THIN)));
        s.red = hazy(s.red * rough, AIR[0], haze);
        s.green = hazy(s.green * rough, AIR[1], haze);
        s.blue = hazy(s.blue * rough, AIR[2], haze);
    }

    private static double hazy(double color, double air, double haze) {
        return color + (air - color) * haze;
    }
}
