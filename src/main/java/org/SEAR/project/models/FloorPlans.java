// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Locale;
import java.util.function.IntPredicate;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.FloorPlan;
import org.SEAR.POJOs.Maze;
import org.SEAR.files.Assets;
import org.SEAR.files.FileLimits;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.WallGrid;

/** Walls of floor plans and mazes. Immutable; any thread. */
public final class FloorPlans {
    /** Most pixels of a floor plan, width times height. */
    private static final int MOST_PIXELS = 16_000_000;
    /** Weights of red, green and blue in the brightness, thousandths: ITU-R BT.601. */
    private static final int RED = 299;
    private static final int GREEN = 587;
    private static final int BLUE = 114;
    private static final int THOUSAND = 1000;
    private static final int WHITE = 255;

    /** Cells of the walls, around the origin. */
    public final WallGrid grid;
    /** Pose of the cells in the object's frame, at its height. */
    public final Pose pose;

    private FloorPlans(WallGrid grid, Pose pose) {
        this.grid = grid;
        this.pose = pose;
    }

    /**
     * Reads a floor plan.
     *
     * @throws IOException with the file, the problem and legal values
     */
    public static FloorPlans of(FloorPlan plan, Assets assets) throws IOException {
        if (!plan.isRosMap()) {
            int limit = (int) Math.ceil(WHITE * (1 - plan.getDarkness()));
            WallGrid grid = walls(grey(plan.getPath(), assets), plan.getPath(), plan.getMetresPerPixel(),
                grey -> grey >= 0 && grey < limit);
            return new FloorPlans(grid, Pose.IDENTITY);
        }
        RosMap map = RosMap.read(plan.getPath(), assets);
        WallGrid grid = walls(grey(map.image, assets), map.image, map.resolution, map::isWall);
        double[] size = grid.size();
        double cos = Math.cos(map.yaw);
        double sin = Math.sin(map.yaw);
        double east = map.originX + (cos * size[1] - sin * size[0]) / 2;
        double north = map.originY + (sin * size[1] + cos * size[0]) / 2;
        return new FloorPlans(grid, Pose.ofDegrees(north, 0, east, 0, Math.toDegrees(map.yaw), 0));
    }

    /** Returns the walls of a maze: posts, and walls between them, of the drawing's thickness. */
    public static FloorPlans of(Maze maze) {
        int rows = maze.getRows();
        int columns = maze.getColumns();
        WallGrid grid = new WallGrid(lines(rows, maze), lines(columns, maze));
        for (int row = 0; row <= rows; row++) {
            for (int column = 0; column <= columns; column++) {
                int i = 2 * (rows - row);
                int k = 2 * column;
                boolean above = column < columns && maze.hasWallAbove(row, column);
                boolean left = row < rows && maze.hasWallLeft(row, column);
                if (above) {
                    grid.fill(i, k);
                    grid.fill(i, k + 1);
                    grid.fill(i, k + 2);
                }
                if (left) {
                    grid.fill(i, k);
                    grid.fill(i - 1, k);
                    grid.fill(i - 2, k);
                }
            }
        }
        return new FloorPlans(grid, Pose.IDENTITY);
    }

    private static double[] lines(int cells, Maze maze) {
        double[] lines = new double[2 * cells + 2];
        for (int i = 0; i <= cells; i++) {
            double middle = (i - cells / 2.0) * maze.getCell();
            lines[2 * i] = middle - maze.getThickness() / 2;
            lines[2 * i + 1] = middle + maze.getThickness() / 2;
        }
        return lines;
    }

    private static WallGrid walls(int[][] grey, String file, double side, IntPredicate wall) throws IOException {
        int rows = grey.length;
        int columns = grey[0].length;
        WallGrid grid = new WallGrid(lines(rows, side), lines(columns, side));
        for (int row = 0; row < rows; row++) {
            for (int k = 0; k < columns; k++) {
                if (wall.test(grey[row][k])) {
                    grid.fill(rows - 1 - row, k);
                }
            }
        }
        if (grid.isEmpty()) {
            throw FileLimits.wrong(file, "the number of wall pixels", 0, "at least 1: none is dark enough");
        }
        return grid;
    }

    private static double[] lines(int cells, double side) {
        double[] lines = new double[cells + 1];
        for (int i = 0; i <= cells; i++) {
            lines[i] = (i - cells / 2.0) * side;
        }
        return lines;
    }

    /** Returns the brightness of the pixels by row, 0 to 255; -1 for a transparent pixel. */
    private static int[][] grey(String path, Assets assets) throws IOException {
        if (path.toLowerCase(Locale.ROOT).endsWith(".pgm")) {
            try (InputStream in = assets.open(path)) {
                return PgmPicture.read(in.readNBytes(FileLimits.MAX_PICTURE + 1), path, MOST_PIXELS);
            }
        }
        byte[] bytes = assets.readPicture(path);
        int[] size = assets.checkPicture(path);
        FileLimits.range(path, "the number of pixels", (long) size[0] * size[1], 1, MOST_PIXELS);
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(bytes));
        if (picture == null) {
            throw FileLimits.wrong(path, "the picture", "of an unknown kind", ".pgm, .png, .jpg, .gif or .bmp");
        }
        int[][] grey = new int[picture.getHeight()][picture.getWidth()];
        for (int row = 0; row < grey.length; row++) {
            picture.getRGB(0, row, grey[row].length, 1, grey[row], 0, grey[row].length);
            for (int k = 0; k < grey[row].length; k++) {
                int rgb = grey[row][k];
                int light = (RED * (rgb >> 16 & WHITE) + GREEN * (rgb >> 8 & WHITE) + BLUE * (rgb & WHITE)) / THOUSAND;
                grey[row][k] = rgb >>> 24 == 0 ? -1 : light;
            }
        }
        return grey;
    }
}
