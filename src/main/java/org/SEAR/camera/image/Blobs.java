// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera.image;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Connected regions of a picture with the hue of a colour, like those that colour-tracking cameras such as Pixy report.
 * Pixels connect at sides, not at corners. Hue hardly depends on brightness, so a region includes an object's shaded
 * side.
 */
public final class Blobs {
    /** Maximum hue difference of a pixel, degrees. */
    private static final double HUE = 15;
    /** Saturation (0 to 1) and brightness (0 to 255) below which a pixel has no reliable hue. */
    private static final double MIN_SATURATION = 0.3;
    private static final int DARKEST = 25;
    private static final double CIRCLE = 360;
    private static final double SIXTH = 60;

    private Blobs() {
    }

    /** Connected region. Immutable. */
    public static final class Blob {
        /** Centre of the bounding box, pixels from the centre of the top left pixel. */
        public final double x;
        public final double y;
        /** Size of the bounding box, pixels. */
        public final int width;
        public final int height;
        /** Number of pixels. */
        public final int area;

        Blob(int left, int top, int right, int bottom, int area) {
            x = (left + right) / 2.0;
            y = (top + bottom) / 2.0;
            width = right - left + 1;
            height = bottom - top + 1;
            this.area = area;
        }
    }

    /** Returns whether a colour, 0xRRGGBB, has a hue to search for: neither grey nor nearly black. */
    public static boolean hasHue(int rgb) {
        return hue(rgb) >= 0;
    }

    /**
     * Returns the regions with the hue of a colour, the largest first.
     * @param pixels 0xRRGGBB each, row by row from the top left
     * @param least minimum area of a region, pixels
     */
    public static List<Blob> find(int width, int[] pixels, int color, int least) {
        double wanted = hue(color);
        boolean[] open = new boolean[pixels.length];
        for (int i = 0; i < pixels.length; i++) {
            double hue = hue(pixels[i]);
            double off = Math.abs(hue - wanted);
            open[i] = hue >= 0 && Math.min(off, CIRCLE - off) <= HUE;
        }
        List<Blob> blobs = new ArrayList<>();
        int[] waiting = new int[pixels.length];
        for (int i = 0; i < pixels.length; i++) {
            if (open[i]) {
                Blob blob = piece(width, open, i, waiting);
                if (blob.area >= least) {
                    blobs.add(blob);
                }
            }
        }
        blobs.sort(Comparator.comparingInt((Blob blob) -> -blob.area).thenComparingDouble(blob -> blob.y)
            .thenComparingDouble(blob -> blob.x));
        return blobs;
    }

    private static Blob piece(int width, boolean[] open, int start, int[] waiting) {
        int left = width;
        int right = 0;
        int top = Integer.MAX_VALUE;
        int bottom = 0;
        int area = 0;
        int count = 1;
        waiting[0] = start;
        open[start] = false;
        while (count > 0) {
            int at = waiting[--count];
            int column = at % width;
            left = Math.min(left, column);
            right = Math.max(right, column);
            top = Math.min(top, at / width);
            bottom = Math.max(bottom, at / width);
            area++;
            count = column > 0 ? take(open, at - 1, waiting, count) : count;
            count = column < width - 1 ? take(open, at + 1, waiting, count) : count;
            count = take(open, at - width, waiting, count);
            count = take(open, at + width, waiting, count);
        }
        return new Blob(left, top, right, bottom, area);
    }

    private static int take(boolean[] open, int at, int[] waiting, int count) {
        if (at < 0 || at >= open.length || !open[at]) {
            return count;
        }
        open[at] = false;
        waiting[count] = at;
        return count + 1;
    }

    /** Returns the hue in degrees from red over green to blue; -1 for grey or dark colours. */
    private static double hue(int rgb) {
        int red = rgb >> 16 & 0xff;
        int green = rgb >> 8 & 0xff;
        int blue = rgb & 0xff;
        int most = Math.max(red, Math.max(green, blue));
        int range = most - Math.min(red, Math.min(green, blue));
        if (most < DARKEST || range < MIN_SATURATION * most) {
            return -1;
        }
        double turn = most == red ? (double) (green - blue) / range : most == green ? 2 + (double) (blue - red) / range
            : 4 + (double) (red - green) / range;
        return SIXTH * (turn < 0 ? turn + 6 : turn);
    }
}
