// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.pictures;

import java.awt.image.IndexColorModel;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Palette for several pictures by Heckbert's median cut: the colour space is cut into boxes, always the box with most
 * pixels and greatest differences at its median. Immutable.
 */
final class GifColors {
    private static final int BITS = 5;
    private static final int CELLS = 1 << 3 * BITS;
    private static final int LEVELS = 1 << BITS;

    /** Number of pixels and sums of their red, green and blue, by cell. */
    private final long[][] sums = new long[CELLS][];
    private final byte[] indices = new byte[CELLS];
    private final IndexColorModel model;

    /**
     * @param pictures pixels as {@code 0xRRGGBB}
     * @param most number of colours; this index itself is the transparent colour
     */
    GifColors(List<int[]> pictures, int most) {
        for (int[] picture : pictures) {
            for (int pixel : picture) {
                count(pixel);
            }
        }
        List<List<Integer>> boxes = new ArrayList<>();
        List<Integer> all = new ArrayList<>();
        for (int cell = 0; cell < CELLS; cell++) {
            if (sums[cell] != null) {
                all.add(cell);
            }
        }
        boxes.add(all);
        boolean divisible = true;
        while (divisible && boxes.size() < most) {
            divisible = cut(boxes);
        }
        byte[][] colors = new byte[3][most + 1];
        for (int i = 0; i < boxes.size(); i++) {
            for (int cell : boxes.get(i)) {
                indices[cell] = (byte) i;
            }
            for (int k = 0; k < 3; k++) {
                colors[k][i] = (byte) mean(boxes.get(i), k);
            }
        }
        model = new IndexColorModel(8, most + 1, colors[0], colors[1], colors[2], most);
    }

    private static int cell(int pixel) {
        int drop = 8 - BITS;
        return (pixel >> 16 & 0xff) >> drop << 2 * BITS | (pixel >> 8 & 0xff) >> drop << BITS | (pixel & 0xff) >> drop;
    }

    private void count(int pixel) {
        int cell = cell(pixel);
        if (sums[cell] == null) {
            sums[cell] = new long[4];
        }
        sums[cell][0]++;
        for (int k = 0; k < 3; k++) {
            sums[cell][k + 1] += pixel >> 16 - 8 * k & 0xff;
        }
    }

    private long mean(List<Integer> box, int color) {
        long pixels = pixels(box);
        return pixels == 0 ? 0 : box.stream().mapToLong(cell -> sums[cell][color + 1]).sum() / pixels;
    }

    private long pixels(List<Integer> box) {
        return box.stream().mapToLong(cell -> sums[cell][0]).sum();
    }

    private static int level(int cell, int color) {
        return cell >> (2 - color) * BITS & LEVELS - 1;
    }

    private static int length(List<Integer> box, int color) {
        return box.stream().mapToInt(cell -> level(cell, color)).max().orElse(0) - box.stream()
            .mapToInt(cell -> level(cell, color)).min().orElse(0);
    }

    private static int longest(List<Integer> box) {
        int longest = 0;
        for (int color = 1; color < 3; color++) {
            longest = length(box, color) > length(box, longest) ? color : longest;
        }
        return longest;
    }

    /**
     * Cuts the most important box.
     * @return false if every box has a single colour
     */
    private boolean cut(List<List<Integer>> boxes) {
        List<Integer> box = boxes.stream().filter(one -> one.size() > 1)
            .max(Comparator.comparingDouble(one -> Math.sqrt(pixels(one)) * length(one, longest(one)))).orElse(null);
        if (box == null) {
            return false;
        }
        int color = longest(box);
        box.sort(Comparator.comparingInt(cell -> level(cell, color)));
        long half = pixels(box) / 2;
        int at = 0;
        for (long seen = 0; seen <= half && at < box.size() - 1; at++) {
            seen += sums[box.get(at)][0];
        }
        at = Math.max(1, at);
        boxes.remove(box);
        boxes.add(new ArrayList<>(box.subList(0, at)));
        boxes.add(new ArrayList<>(box.subList(at, box.size())));
        return true;
    }

    IndexColorModel model() {
        return model;
    }

    /** Returns the colour index of each pixel. */
    byte[] of(int[] pixels) {
        byte[] all = new byte[pixels.length];
        for (int i = 0; i < all.length; i++) {
            all[i] = indices[cell(pixels[i])];
        }
        return all;
    }
}
