// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Terrain;
import org.SEAR.files.Assets;
import org.SEAR.geometry.HeightField;
import org.SEAR.terrain.relief.GroundPicture;

/**
 * Colours that a Terrain object specifies: its picture, north up over the whole area, or its one colour. Any thread.
 */
public final class TerrainColors {
    private static final int OPAQUE = 0xff000000;

    private TerrainColors() {
    }

    /**
     * Returns the ground's colours.
     * @return null for colours by elevation and slope
     * @throws IOException that names the picture, the error and what is legal
     */
    public static GroundPicture.Colors of(Terrain terrain, Assets assets, Ground ground) throws IOException {
        String path = terrain.getImage();
        if (path != null) {
            return AerialPicture.canSayItsPlace(path) && ground.origin != null ? placed(path, assets, ground)
                : filling(picture(path, assets), ground.field);
        }
        if (!terrain.hasColor()) {
            return null;
        }
        int color = OPAQUE | Integer.parseInt(terrain.getColor().substring(1), 16);
        return (x, z) -> color;
    }

    /**
     * Checks a TIFF picture by reading it. Other pictures are checked when the project is loaded.
     * @throws IOException that names the picture, the error and what is legal
     */
    public static void check(Terrain terrain, Assets assets, Ground ground) throws IOException {
        String path = terrain.getImage();
        if (path != null && AerialPicture.canSayItsPlace(path) && assets.has(path)) {
            of(terrain, assets, ground);
        }
    }

    /** Returns the colours of a georeferenced picture. */
    private static GroundPicture.Colors placed(String path, Assets assets, Ground ground) throws IOException {
        HeightField field = ground.field;
        AerialPicture picture = AerialPicture.load(assets, path, ground.origin, field.x(0),
            field.x(field.rows - 1), field.z(0), field.z(field.columns - 1));
        double perX = picture.rows / (picture.north - picture.south);
        double perZ = picture.columns / (picture.east - picture.west);
        return (x, z) -> {
            int row = Math.max(0, Math.min(picture.rows - 1, (int) ((picture.north - x) * perX)));
            int column = Math.max(0, Math.min(picture.columns - 1, (int) ((z - picture.west) * perZ)));
            return picture.colours[row * picture.columns + column];
        };
    }

    private static BufferedImage picture(String path, Assets assets) throws IOException {
        assets.checkPicture(path);
        try (InputStream in = assets.open(path)) {
            BufferedImage image = ImageIO.read(in);
            if (image == null) {
                throw new IOException(path + ": SEAR can't read the picture, legal: .png, .jpg, .gif or .bmp");
            }
            return image;
        }
    }

    /** Returns the colours of a picture that covers a whole field. */
    static GroundPicture.Colors filling(BufferedImage image, HeightField field) {
        int width = image.getWidth();
        int height = image.getHeight();
        int[] pixels = image.getRGB(0, 0, width, height, null, 0, width);
        double perX = height / ((field.rows - 1) * field.spacingX);
        double perZ = width / ((field.columns - 1) * field.spacingZ);
        return (x, z) -> at(pixels, width, (z - field.lowZ) * perZ - 0.5, height - (x - field.lowX) * perX - 0.5);
    }

    /** Interpolates between the centres of four pixels. */
    private static int at(int[] pixels, int width, double across, double down) {
        int left = (int) Math.floor(across);
        int top = (int) Math.floor(down);
        double u = across - left;
        double v = down - top;
        int northWest = pixel(pixels, width, left, top);
        int northEast = pixel(pixels, width, left + 1, top);
        int southWest = pixel(pixels, width, left, top + 1);
        int southEast = pixel(pixels, width, left + 1, top + 1);
        int mixed = 0;
        for (int shift = 24; shift >= 0; shift -= 8) {
            double above = (northWest >>> shift & 0xff) * (1 - u) + (northEast >>> shift & 0xff) * u;
            double below = (southWest >>> shift & 0xff) * (1 - u) + (southEast >>> shift & 0xff) * u;
            mixed |= (int) Math.round(above * (1 - v) + below * v) << shift;
        }
        return mixed >>> 24 > 127 ? mixed : 0;
    }

    private static int pixel(int[] pixels, int width, int x, int y) {
        return pixels[Math.max(0, Math.min(pixels.length / width - 1, y)) * width
            + Math.max(0, Math.min(width - 1, x))];
    }
}
