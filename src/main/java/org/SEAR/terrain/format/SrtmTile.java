// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipInputStream;
import org.SEAR.files.FileLimits;
import org.SEAR.terrain.tiff.MapBytes;

/**
 * SRTM tile, or a tile in its format: one degree by one degree, signed 16-bit big-endian metres above the geoid, north
 * row first, no header. The name gives the south-west corner. The outermost rows and columns are on the degree lines.
 */
final class SrtmTile extends ElevationMap {
    private static final short NO_DATA = -32768;
    private static final int[] SIDES = {1201, 3601};
    private static final Pattern NAME = Pattern.compile("([NS])(\\d\\d)([EW])(\\d{3})([^/]*)\\.hgt(\\.zip)?",
        Pattern.CASE_INSENSITIVE);
    private static final int MAX_ENTRIES = 16;

    private final MapBytes bytes;

    private SrtmTile(MapBytes bytes, int side, Georeference place) {
        super(bytes.getName(), side, side, place, Double.NaN);
        this.bytes = bytes;
    }

    /** Returns whether a file has the size of a tile. */
    static boolean isTile(long size) {
        return Arrays.stream(SIDES).anyMatch(side -> size == 2L * side * side);
    }

    /** Opens a plain or zipped tile. */
    static SrtmTile open(MapBytes file) throws IOException {
        MapBytes bytes = file.getName().toLowerCase(Locale.ROOT).endsWith(".zip") ? unpacked(file) : file;
        if (!isTile(bytes.size())) {
            throw FileLimits.wrong(file.getName(), "the tile's size", bytes.size() + " bytes",
                "2884802 (1201 x 1201 posts, 3 arc seconds) or 25934402 (3601 x 3601, 1 arc second)");
        }
        int side = (int) Math.round(Math.sqrt(bytes.size() / 2.0));
        return new SrtmTile(bytes, side, place(file.getName(), side));
    }

    private static Georeference place(String path, int side) throws IOException {
        String file = path.substring(path.lastIndexOf('/') + 1);
        Matcher name = NAME.matcher(file);
        if (!name.matches()) {
            throw FileLimits.wrong(path, "the file's name", file, "the tile's south-west corner, such as N36W085.hgt");
        }
        int latitude = Integer.parseInt(name.group(2)) * (name.group(1).equalsIgnoreCase("N") ? 1 : -1);
        int longitude = Integer.parseInt(name.group(4)) * (name.group(3).equalsIgnoreCase("E") ? 1 : -1);
        FileLimits.range(path, "the latitude in the file's name", latitude, -90, 89);
        FileLimits.range(path, "the longitude in the file's name", longitude, -180, 179);
        double step = 1.0 / (side - 1);
        return new Georeference(Georeference.WGS84, longitude, latitude + 1, step, 0, 0, -step);
    }

    private static MapBytes unpacked(MapBytes file) throws IOException {
        FileLimits.range(file.getName(), "the file's size", file.size(), 1, MapBytes.MAX_UNPACKED);
        byte[] packed = file.read("the file", 0, (int) file.size());
        file.close();
        try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(packed))) {
            ZipEntry entry = zip.getNextEntry();
            for (int i = 0; entry != null && i < MAX_ENTRIES; i++) {
                if (entry.getName().toLowerCase(Locale.ROOT).endsWith(".hgt")) {
                    byte[] tile = zip.readNBytes(2 * 3601 * 3601 + 1);
                    if (tile.length > 2 * 3601 * 3601) {
                        throw FileLimits.wrong(file.getName(), "the size of " + entry.getName() + " in it",
                            "more than " + 2 * 3601 * 3601 + " bytes", "2884802 or 25934402");
                    }
                    return MapBytes.of(file.getName(), tile);
                }
                entry = null;
                if (i + 1 < MAX_ENTRIES) {
                    entry = nextOf(zip, file.getName());
                }
            }
        } catch (ZipException | EOFException | IllegalArgumentException e) {
            throw new IOException(file.getName() + ": the zip is broken (" + e.getMessage()
                + "), legal: a whole zip with a .hgt inside", e);
        }
        throw FileLimits.wrong(file.getName(), "the zip's content", "no .hgt among the first " + MAX_ENTRIES + " files",
            "a zip with a .hgt inside");
    }

    /** Returns the next entry; limits how many bytes are skipped. */
    private static ZipEntry nextOf(ZipInputStream zip, String name) throws IOException {
        long left = MapBytes.MAX_UNPACKED;
        byte[] some = new byte[1 << 16];
        for (int count = zip.read(some); count >= 0; count = zip.read(some)) {
            left -= count;
            if (left < 0) {
                throw FileLimits.wrong(name, "a file in the zip", "more than " + MapBytes.MAX_UNPACKED + " bytes",
                    "a zip with a .hgt inside");
            }
        }
        return zip.getNextEntry();
    }

    @Override
    public float[] read(int row, int column, int height, int width) throws IOException {
        float[] heights = new float[height * width];
        byte[] line = new byte[2 * width];
        for (int r = 0; r < height; r++) {
            bytes.read("row " + (row + r), 2L * ((long) (row + r) * columns + column), line, line.length);
            for (int c = 0; c < width; c++) {
                short value = (short) (line[2 * c] << 8 | line[2 * c + 1] & 0xff);
                heights[r * width + c] = value == NO_DATA ? Float.NaN : value;
            }
        }
        return heights;
    }

    @Override
    public void close() throws IOException {
        bytes.close();
    }
}
