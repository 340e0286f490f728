// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import org.SEAR.geometry.HeightTiles;

/**
 * Grid of a height field: rows from the south, columns from the west. Near the origin it contains the map's own posts,
 * which keeps ridges sharp. Immutable, any thread.
 */
final class FieldGrid {
    /**
     * Maximum number of posts of a field finer than the map. The triangles of such a field follow the map's bilinear
     * surface.
     */
    private static final double FINE = 6_000_000;
    private static final int MAX_BETWEEN = 8;
    private static final double MOST = 1e9;
    private static final double ROUNDING = 1e-6;

    final int rows;
    final int columns;
    final double lowX;
    final double lowZ;
    final double spacingX;
    final double spacingZ;

    private FieldGrid(int rows, int columns, double lowX, double lowZ, double spacingX, double spacingZ) {
        this.rows = rows;
        this.columns = columns;
        this.lowX = lowX;
        this.lowZ = lowZ;
        this.spacingX = spacingX;
        this.spacingZ = spacingZ;
    }

    /**
     * Returns the centres of pixels that fill a rectangle.
     * @param lowX its southern edge, metres; lowZ its western edge
     * @param spacingX pixel size, metres, likewise spacingZ
     */
    static FieldGrid pixels(int rows, int columns, double lowX, double lowZ, double spacingX, double spacingZ) {
        return new FieldGrid(rows, columns, lowX + spacingX / 2, lowZ + spacingZ / 2, spacingX, spacingZ);
    }

    /**
     * Returns the grid of an area centred at the origin.
     * @param size metres north-south and east-west
     * @param map spacing of the map's posts, metres, going north and going east
     * @param post position of one of the map's posts, metres north and east of the origin
     * @param whole whether the grid covers the whole area; otherwise it stays inside
     */
    static FieldGrid of(double[] size, double[] map, double[] post, boolean whole) {
        int between = MAX_BETWEEN + 1;
        Axis x;
        Axis z;
        do {
            between--;
            x = new Axis(size[0], map[0] / between, post[0], whole);
            z = new Axis(size[1], map[1] / between, post[1], whole);
        } while (between > 1 && x.posts() * z.posts() > FINE);
        return new FieldGrid((int) x.posts(), (int) z.posts(), x.low(), z.low(), x.spacing, z.spacing);
    }

    /** Returns the same grid, moved by less than a millimetre so that it can be cut into {@link HeightTiles}. */
    FieldGrid exact() {
        return new FieldGrid(rows, columns, HeightTiles.exact(lowX), HeightTiles.exact(lowZ),
            HeightTiles.exact(spacingX), HeightTiles.exact(spacingZ));
    }

    long posts() {
        return (long) rows * columns;
    }

    /** Returns the position of a row, metres north; also beyond the last one. */
    double x(int row) {
        return lowX + row * spacingX;
    }

    /** Returns the position of a column, metres east; also beyond the last one. */
    double z(int column) {
        return lowZ + column * spacingZ;
    }

    /** One direction of a grid. */
    private static final class Axis {
        private final double spacing;
        private final double post;
        private final double first;
        private final double last;

        Axis(double size, double spacing, double post, boolean whole) {
            this.spacing = spacing;
            this.post = post;
            double low = (-size / 2 - post) / spacing;
            double high = (size / 2 - post) / spacing;
            this.first = whole ? Math.floor(low + ROUNDING) : Math.ceil(low - ROUNDING);
            this.last = Math.max(first + 1, whole ? Math.ceil(high - ROUNDING) : Math.floor(high + ROUNDING));
        }

        double posts() {
            return Math.min(MOST, last - first + 1);
        }

        double low() {
            return post + first * spacing;
        }
    }
}
