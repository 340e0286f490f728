package org.SEAR.raycast;

import java.util.Arrays;

/**
 * The beams of a picture: one for each pixel, all from one point, row by row from the top left. Neighbours go together in tiles, which are cast one
 * by one: what lies beside all beams of a tile is left out for all of them. Immutable, any thread.
 */
public final class PictureBeams {
    /** Pixels that a tile is wide and high; those at the right and lower edge are smaller. */
    public static final int TILE = 8;

    /** Of a tile's bounds: least and greatest place to the left, least and greatest place up. */
    static final int SIDES = 4;

    /** Pixels of a row, and rows. */
    public final int width;
    public final int height;
    /** Tiles of a row, and rows of tiles. */
    public final int tilesAcross;
    public final int tilesDown;

    final double[] left;
    final double[] up;
    final double[] bounds;

    /**
     * Beams through the points of the plane one metre ahead.
     *
     * @param width pixels of a row, 1 or more
     * @param left metres to the left of the axis of each pixel's point, row by row from the top left
     * @param up metres above the axis, likewise
     * @throws IllegalArgumentException if they make no rectangle
     */
    public PictureBeams(int width, double[] left, double[] up) {
        if (width < 1 || left.length == 0 || left.length % width != 0 || up.length != left.length) {
            throw new IllegalArgumentException("a picture of " + left.length + " and " + up.length + " beams in rows of " + width
                + ", legal: as many places to the left as up, one row or more of 1 or more");
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

    /** The first column of a tile. */
    public int first(int tile) {
        return tile % tilesAcross * TILE;
    }

    /** The column behind the last one of a tile. */
    public int end(int tile) {
        return Math.min(width, first(tile) + TILE);
    }

    /** The first row of a tile. */
    public int top(int tile) {
        return tile / tilesAcross * TILE;
    }

    /** The row below the last one of a tile. */
    public int bottom(int tile) {
        return Math.min(height, top(tile) + TILE);
    }

    /** Metres to the left of the axis, one metre ahead, of a pixel's beam. */
    public double left(int pixel) {
        return left[pixel];
    }

    /** Metres above the axis, one metre ahead, of a pixel's beam. */
    public double up(int pixel) {
        return up[pixel];
    }
}
