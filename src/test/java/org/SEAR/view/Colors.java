// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.Arrays;

/** Colours of pictures with tolerance. */
final class Colors {
    private static final int AROUND = 2;
    private static final int FAR = 15;

    private Colors() {
    }

    /**
     * Returns the median, channel by channel, of the 5 by 5 pixels around a pixel, which ignores one or two lines
     * across it.
     */
    static Color around(BufferedImage picture, int x, int y) {
        int[] red = new int[(2 * AROUND + 1) * (2 * AROUND + 1)];
        int[] green = red.clone();
        int[] blue = red.clone();
        int count = 0;
        for (int dx = -AROUND; dx <= AROUND; dx++) {
            for (int dy = -AROUND; dy <= AROUND; dy++) {
                Color color = new Color(picture.getRGB(clamp(x + dx, picture.getWidth()),
                    clamp(y + dy, picture.getHeight())));
                red[count] = color.getRed();
                green[count] = color.getGreen();
                blue[count++] = color.getBlue();
            }
        }
        return new Color(middle(red), middle(green), middle(blue));
    }

    /** Returns the mean colour of the 31 by 31 pixels around a pixel. */
    static Color mean(BufferedImage picture, int x, int y) {
        long red = 0;
        long green = 0;
        long blue = 0;
        int count = 0;
        for (int dx = -FAR; dx <= FAR; dx++) {
            for (int dy = -FAR; dy <= FAR; dy++) {
                Color color = new Color(picture.getRGB(clamp(x + dx, picture.getWidth()),
                    clamp(y + dy, picture.getHeight())));
                red += color.getRed();
                green += color.getGreen();
                blue += color.getBlue();
                count++;
            }
        }
        return new Color((int) (red / count), (int) (green / count), (int) (blue / count));
    }

    private static int clamp(int at, int size) {
        return Math.max(0, Math.min(size - 1, at));
    }

    private static int middle(int[] values) {
        Arrays.sort(values);
        return values[values.length / 2];
    }
}
