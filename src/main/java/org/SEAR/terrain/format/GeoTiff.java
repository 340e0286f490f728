// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.SEAR.files.FileLimits;
import org.SEAR.terrain.tiff.MapBytes;
import org.SEAR.terrain.tiff.TiffFile;
import org.SEAR.terrain.tiff.TiffImage;

/** TIFF with one value per pixel: an elevation if the file is georeferenced, otherwise a grey. */
final class GeoTiff extends ElevationMap {
    private static final int METADATA = 42112;
    private static final int NO_DATA = 42113;
    private static final int MAX_METADATA = 16 << 20;
    /** Length in metres of the units that GDAL and its users name. */
    private static final Map<String, Double> UNITS = Map.of("m", 1.0, "metre", 1.0, "meter", 1.0, "metres", 1.0,
        "meters", 1.0, "ft", 0.3048,
        "foot", 0.3048, "feet", 0.3048, "us-ft", 1200 / 3937.0, "us survey foot", 1200 / 3937.0);

    private final TiffImage image;
    /** Length of the values' unit in metres. */
    private final double metres;
    /** Elevation of the value 0, metres. */
    private final double zero;
    private final double noData;

    private GeoTiff(TiffImage image, Georeference place, double metres, double zero, double noData) {
        super(image.file.name, image.rows, image.columns, place, place != null || image.sampleFormat != 1 ? Double.NaN
            : Math.pow(2, 8 * image.sampleBytes) - 1);
        this.image = image;
        this.metres = metres;
        this.zero = zero;
        this.noData = noData;
    }

    static GeoTiff open(MapBytes bytes) throws IOException {
        TiffFile file = new TiffFile(bytes);
        TiffImage image = new TiffImage(file);
        if (image.samples != 1) {
            throw FileLimits.wrong(file.name, "SamplesPerPixel", image.samples,
                "1, the elevation (use setImage for colours)");
        }
        if (image.rows < 2 || image.columns < 2) {
            throw FileLimits.wrong(file.name, "the size", image.rows + " x " + image.columns, "at least 2 x 2 posts");
        }
        GeoKeys keys = new GeoKeys(file);
        double unit = unit(file, keys);
        return new GeoTiff(image, keys.place(), unit * metadata(file, "scale", 1), unit * metadata(file, "offset", 0),
            noData(file));
    }

    /**
     * Returns the unit's length in metres. As in GDAL, GDAL's own unit takes precedence over the coordinate system's.
     */
    private static double unit(TiffFile file, GeoKeys keys) throws IOException {
        String name = item(file, "unittype");
        if (name == null || name.isEmpty()) {
            return keys.metres();
        }
        Double metres = UNITS.get(name.toLowerCase(Locale.ROOT));
        if (metres == null) {
            String legal = "one of " + String.join(", ", new TreeSet<>(UNITS.keySet()));
            throw FileLimits.wrong(file.name, "GDAL's unit of heights", '"' + name + '"', legal);
        }
        return metres;
    }

    /** Returns the text of an item of GDAL's metadata, or null. */
    private static String item(TiffFile file, String role) throws IOException {
        String text = file.text(METADATA, "GDAL_METADATA", MAX_METADATA);
        Matcher item = Pattern.compile("<Item [^>]*role=\"" + role + "\"[^>]*>([^<]*)</Item>")
            .matcher(text == null ? "" : text);
        return item.find() ? item.group(1).trim() : null;
    }

    /** Returns a number of GDAL's metadata: scale or offset of the values. */
    private static double metadata(TiffFile file, String role, double without) throws IOException {
        String item = item(file, role);
        if (item == null) {
            return without;
        }
        try {
            return Double.parseDouble(item);
        } catch (NumberFormatException e) {
            throw FileLimits.wrong(file.name, "GDAL's " + role, '"' + item + '"', "a number");
        }
    }

    private static double noData(TiffFile file) throws IOException {
        String text = file.text(NO_DATA, "GDAL_NODATA", 256);
        if (text == null || text.trim().isEmpty()) {
            return Double.NaN;
        }
        try {
            return Double.parseDouble(text.trim().replaceFirst("(?i)^([-+]?)(nan)$", "NaN")
                .replaceFirst("(?i)^([-+]?)inf.*$", "$1Infinity"));
        } catch (NumberFormatException e) {
            throw FileLimits.wrong(file.name, "GDAL_NODATA", '"' + text + '"', "a number");
        }
    }

    @Override
    public float[] read(int row, int column, int height, int width) throws IOException {
        image.requireFew(row, column, height, width);
        float[] heights = new float[height * width];
        int from = row;
        while (from < row + height) {
            int down = from / image.blockRows;
            long end = Math.min((long) row + height, (down + 1L) * image.blockRows);
            int to = (int) Math.min(end, (long) from + image.rowsAtOnce());
            for (int across = column / image.blockColumns;
                across <= (column + width - 1) / image.blockColumns; across++) {
                int left = Math.max(column, across * image.blockColumns);
                int right = (int) Math.min((long) column + width, (across + 1L) * image.blockColumns);
                byte[] block = image.unpack(across, down, 0, from - down * image.blockRows, to - from);
                for (int r = from; r < to; r++) {
                    int at = (r - row) * width + left - column;
                    if (block == null) {
                        Arrays.fill(heights, at, at + right - left, Float.NaN);
                    } else {
                        values(block, (r - from) * image.blockColumns + left - across * image.blockColumns,
                            right - left, heights, at);
                    }
                }
            }
            from = to;
        }
        return heights;
    }

    @Override
    public String missing() {
        int missing = image.countMissing();
        return missing == 0 ? null : missing + " of its " + image.count() + " strips or tiles";
    }

    private void values(byte[] block, int first, int count, float[] into, int at) {
        ByteBuffer in = ByteBuffer.wrap(block).order(image.bigEndian ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
        boolean limited = Double.isNaN(white);
        for (int i = 0; i < count; i++) {
            double value = value(in, (first + i) * image.sampleBytes);
            double height = zero + value * metres;
            boolean none = value == noData || image.sampleFormat == 3 && image.sampleBytes == 4
                && (float) value == (float) noData;
            into[at + i] = none || limited && !(Math.abs(height) <= MapLimits.HIGHEST) ? Float.NaN : (float) height;
        }
    }

    private double value(ByteBuffer in, int at) {
        boolean signed = image.sampleFormat == 2;
        switch (image.sampleBytes) {
            case 1:
                return signed ? in.get(at) : in.get(at) & 0xff;
            case 2:
                return signed ? in.getShort(at) : Short.toUnsignedInt(in.getShort(at));
            case 4:
                return image.sampleFormat == 3 ? in.getFloat(at) : signed ? in.getInt(at)
                    : Integer.toUnsignedLong(in.getInt(at));
            default:
                return image.sampleFormat == 3 ? in.getDouble(at) : in.getLong(at);
        }
    }

    @Override
    public void close() throws IOException {
        image.file.bytes.close();
    }
}
