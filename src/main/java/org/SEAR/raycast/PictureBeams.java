// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import java.util.Arrays;

/**
 * The rays of a picture: one per pixel, all from one point, row by row from the top left. Neighbouring pixels form
 * tiles, which are cast one by one: whatever is outside a tile's frustum is skipped for all its rays. Immutable, any
 * thread.
 */
public final class PictureBeams {
    /** Width and height of a tile, pixels. Tiles at the right and lower edge may be smaller. */
    public static final int TILE = 8;

    /** Numbers per tile bound: minimum and maximum to the left, minimum and maximum up. */
    static final int SIDES = 4;

    /** Width and height of the picture, pixels. */
    public final int width;
    public final int height;
    /** Number of tiles per row, and of rows of tiles. */
    public final int tilesAcross;
    public final int tilesDown;

    final double[] left;
    final double[] up;
    final double[] bounds;

    /**
     * Creates rays through points in the plane one metre ahead.
     * @param width pixels per row, 1 or more
     * @param left distance of each pixel's point to the left of the axis, metres, row by row from the top left
     * @param up distance above the axis, metres, likewise
     * @throws IllegalArgumentException if the points form no rectangle
     */
    public PictureBeams(int width, double[] left, double[] up) {
        if (width < 1 || left.length == 0 || left.length % width != 0 || up.length != left.length) {
            throw new IllegalArgumentException("picture of " + left.length + " left and " + up.length
                + " up coordinates in rows of " + width + ", legal: equal numbers, one or more full rows of 1 or more");
        }
        this.width = width;
        this.height = left.length / width;
        this.left = left.clone();
        this.up = up.clone();
        tilesAcross = (width + TILE - 1) / TILE;
        tilesDown = (height + TILE - 1) / TILE;
        bounds = new double[SIDES * tilesAcross * tilesDown];
        for (int tile = 0; tile < tilesAcross * tilesDown; tile++) {
            enclose(tile);
        }
    }

    private void enclose(int tile) {
        int at = SIDES * tile;
        Arrays.fill(bounds, at, at + SIDES, Double.NEGATIVE_INFINITY);
        for (int row = top(tile); row < bottom(tile); row++) {
            for (int i = row * width + first(tile); i < row * width + end(tile); i++) {
                bounds[at] = Math.max(bounds[at], -left[i]);
                bounds[at + 1] = Math.max(bounds[at + 1], left[i]);
                bounds[at + 2] = Math.max(bounds[at + 2], -up[i]);
                bounds[at + 3] = Math.max(bounds[at + 3], up[i]);
            }
        }
        bounds[at] = -bounds[at];
        bounds[at + 2] = -bounds[at + 2];
    }

    /** Returns the first column of a tile. */
    public int first(int tile) {
        return tile % tilesAcross * TILE;
    }

    /** Returns the column after the last one of a tile. */
    public int end(int tile) {
        return Math.min(width, first(tile) + TILE);
    }

    /** Returns the first row of a tile. */
    public int top(int tile) {
        return tile / tilesAcross * TILE;
    }

    /** Returns the row after the last one of a tile. */
    public int bottom(int tile) {
        return Math.min(height, top(tile) + TILE);
    }

    /** Returns how far to the left of the axis a pixel's ray is at one metre ahead, metres. */
    public double left(int pixel) {
        return left[pixel];
    }

    /** Returns how far above the axis a pixel's ray is at one metre ahead, metres. */
    public double up(int pixel) {
        return up[pixel];
    }
}
