// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.IOException;
import java.util.Locale;
import org.SEAR.files.Assets;
import org.SEAR.files.FileLimits;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.terrain.format.TiffPicture;
import org.SEAR.terrain.tiff.MapBytes;

/** Georeferenced aerial picture (GeoTIFF), resampled to a rectangle in the world's frame. Immutable, any thread. */
public final class AerialPicture {
    /** Maximum number of pixels per side. */
    public static final int MAX_SIDE = 4096;
    /** Maximum position error of a colour, pixels. */
    private static final double PIXELS = 0.25;

    /** Pixels from north to south. */
    public final int rows;
    /** Pixels from west to east. */
    public final int columns;
    /** Colours 0xAARRGGBB, row by row from the north, each from the west; 0 outside the picture. Read-only. */
    public final int[] colours;
    /** World x of the southern edge, metres. */
    public final double south;
    /** World x of the northern edge, metres. */
    public final double north;
    /** World z of the western edge, metres. */
    public final double west;
    /** World z of the eastern edge, metres. */
    public final double east;

    private AerialPicture(int rows, int columns, double[] rectangle) {
        this.rows = rows;
        this.columns = columns;
        this.colours = new int[rows * columns];
        this.south = rectangle[0];
        this.north = rectangle[1];
        this.west = rectangle[2];
        this.east = rectangle[3];
    }

    /** Returns whether a path has the ending of a format that supports georeferences. */
    public static boolean canSayItsPlace(String path) {
        String lower = path.toLowerCase(Locale.ROOT);
        return lower.endsWith(".tif") || lower.endsWith(".tiff");
    }

    /**
     * Loads the part of a picture that covers a rectangle.
     * @param path below the assets
     * @param origin of the world
     * @param rectangle in the world, metres: south and north (x), west and east (z)
     * @throws IOException that names the file, the error and what is legal; also if the picture does not overlap the
     *     rectangle
     */
    public static AerialPicture load(Assets assets, String path, GeoOrigin origin, double... rectangle)
        throws IOException {
        try (MapBytes bytes = MapBytes.open(assets, path); TiffPicture picture = TiffPicture.open(bytes)) {
            MapSystem system = MapSystem.at(path, picture.place.system, origin.getLatitude(), origin.getLongitude());
            double middle = picture.place.x(picture.columns / 2.0, picture.rows / 2.0);
            MapPlane plane = MapPlane.onEarth(origin, system, picture.place, middle);
            int[] part = part(picture, plane, rectangle);
            if (part == null) {
                double[] centre = system.toEarth(middle, picture.place.y(picture.columns / 2.0, picture.rows / 2.0));
                throw FileLimits.wrong(path, "the picture's place", place(centre[0], centre[1]),
                    "over the terrain, which is " + place(origin.getLatitude(), origin.getLongitude()));
            }
            int factor = (Math.max(part[2], part[3]) + MAX_SIDE - 1) / MAX_SIDE;
            int[] colours = picture.read(part[0], part[1], part[2], part[3], factor);
            AerialPicture made = new AerialPicture(side(part[2], factor), side(part[3], factor), rectangle);
            made.fill(plane, part, factor, colours);
            return made;
        }
    }

    private static String place(double latitude, double longitude) {
        return String.format(Locale.ROOT, "about latitude %.5f, longitude %.5f", latitude, longitude);
    }

    private static int side(int pixels, int factor) {
        return Math.max(2, Math.min(MAX_SIDE, (pixels + factor - 1) / factor));
    }

    /** Returns first row, first column, rows and columns of the picture under the rectangle, or null. */
    private static int[] part(TiffPicture picture, MapPlane plane, double[] rectangle) {
        double[] at = new double[2];
        double[] box = {Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        int points = 16;
        for (int i = 0; i <= points; i++) {
            for (int j = 0; j <= points; j++) {
                plane.at(rectangle[0] + (rectangle[1] - rectangle[0]) * i / points, rectangle[2]
                    + (rectangle[3] - rectangle[2]) * j / points, at);
                box[0] = Math.min(box[0], at[1]);
                box[1] = Math.min(box[1], at[0]);
                box[2] = Math.max(box[2], at[1]);
                box[3] = Math.max(box[3], at[0]);
            }
        }
        int row = (int) Math.max(0, Math.floor(box[0]) - 1);
        int column = (int) Math.max(0, Math.floor(box[1]) - 1);
        int rows = (int) Math.min(picture.rows, Math.ceil(box[2]) + 2) - row;
        int columns = (int) Math.min(picture.columns, Math.ceil(box[3]) + 2) - column;
        return rows > 0 && columns > 0 ? new int[] {row, column, rows, columns} : null;
    }

    private void fill(MapPlane plane, int[] part, int factor, int[] read) {
        FieldGrid grid = FieldGrid.pixels(rows, columns, south, west, (north - south) / rows, (east - west) / columns);
        double exactness = PlaneLattice.TOLERANCE / PIXELS / factor;
        PlaneLattice lattice = PlaneLattice.of(grid, plane, exactness, exactness);
        int width = (part[3] + factor - 1) / factor;
        int height = (part[2] + factor - 1) / factor;
        double[] at = new double[2 * columns];
        for (int r = 0; r < rows; r++) {
            lattice.places(rows - 1 - r, at);
            for (int c = 0; c < columns; c++) {
                double column = (at[2 * c] - part[1] + 0.5) / factor - 0.5;
                double row = (at[2 * c + 1] - part[0] + 0.5) / factor - 0.5;
                boolean inside = column > -0.5 && row > -0.5 && column < width - 0.5 && row < height - 0.5;
                colours[r * columns + c] = inside ? colour(read, width, height, column, row) : 0;
            }
        }
    }

    /** Interpolates bilinearly between four pixels. */
    private static int colour(int[] pixels, int width, int height, double column, double row) {
        int left = (int) Math.max(0, Math.floor(column));
        int top = (int) Math.max(0, Math.floor(row));
        int right = Math.min(left + 1, width - 1);
        int bottom = Math.min(top + 1, height - 1);
        double u = Math.max(0, column - left);
        double v = Math.max(0, row - top);
        int mixed = 0;
        for (int shift = 0; shift < 32; shift += 8) {
            double upper = (pixels[top * width + left] >>> shift & 0xff) * (1 - u)
                + (pixels[top * width + right] >>> shift & 0xff) * u;
            double lower = (pixels[bottom * width + left] >>> shift & 0xff) * (1 - u)
                + (pixels[bottom * width + right] >>> shift & 0xff) * u;
            mixed |= (int) Math.round(upper * (1 - v) + lower * v) << shift;
        }
        return mixed;
    }
}
