// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.surface;

import java.awt.image.BufferedImage;
import org.SEAR.camera.Texture;

/** Picture with look-up without allocation. Immutable, any thread. */
final class SurfacePicture {
    private static final int RGB = 0xFFFFFF;

    private final int width;
    private final int height;
    private final int[] pixels;

    SurfacePicture(BufferedImage image) {
        width = image.getWidth();
        height = image.getHeight();
        pixels = image.getRGB(0, 0, width, height, null, 0, width);
    }

    /** Returns the same picture, filtered for cameras. */
    Texture texture() {
        return new Texture(width, height, pixels, true);
    }

    /**
     * Returns the pixel at a position of the picture, which repeats in both directions.
     * @param u 0 at its left edge, 1 at its right one
     * @param v 0 at its lower edge, 1 at its upper one
     * @return 0xRRGGBB
     */
    int at(double u, double v) {
        int column = (int) Math.min(width - 1, (u - Math.floor(u)) * width);
        int row = (int) Math.min(height - 1, (1 - (v - Math.floor(v))) * height);
        return pixels[row * width + column] & RGB;
    }
}
