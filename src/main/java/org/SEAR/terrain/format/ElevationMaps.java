// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import org.SEAR.files.Assets;
import org.SEAR.files.FileLimits;
import org.SEAR.files.PrintableText;
import org.SEAR.terrain.tiff.MapBytes;

/** Opens elevation maps by content, not only by file ending. Any thread. */
public final class ElevationMaps {
    /** Supported file endings. */
    public static final List<String> ENDINGS = List.of(".hgt", ".hgt.zip", ".tif", ".tiff", ".asc", ".png", ".jpg",
        ".jpeg", ".gif", ".bmp");
    private static final String LEGAL = "SRTM (.hgt, .hgt.zip), GeoTIFF (.tif), ESRI ASCII grid (.asc) or a grey "
        + "picture (.png, .jpg, .bmp)";
    private static final int HEAD = 16;

    private ElevationMaps() {
    }

    /** Returns whether a path has the ending of an elevation map. */
    public static boolean isMap(String path) {
        String lower = path.toLowerCase(Locale.ROOT);
        return ENDINGS.stream().anyMatch(lower::endsWith);
    }

    /**
     * Opens a map.
     * @param path below the assets
     * @throws IOException that names the file, its format and the supported ones
     */
    public static ElevationMap open(Assets assets, String path) throws IOException {
        MapBytes bytes = MapBytes.open(assets, path);
        try {
            return open(assets, bytes);
        } catch (IOException | RuntimeException e) {
            bytes.close();
            throw e;
        }
    }

    /**
     * Checks a map's header, or the whole of a picture. Data after a header is checked when it is read.
     * @param path below the assets
     * @throws IOException that names the file, its format and the supported ones
     */
    public static void check(Assets assets, String path) throws IOException {
        try (MapBytes bytes = MapBytes.open(assets, path)) {
            if (isGrid(bytes)) {
                AsciiGrid.check(bytes);
                return;
            }
        }
        open(assets, path).close();
    }

    private static boolean isGrid(MapBytes bytes) throws IOException {
        String kind = kind(bytes);
        return kind.equals(FileKind.GRID) || kind.equals(FileKind.UNKNOWN) && bytes.getName().toLowerCase(Locale.ROOT)
            .endsWith(".asc");
    }

    private static String kind(MapBytes bytes) throws IOException {
        return FileKind.of(new String(bytes.read("the head", 0, (int) Math.min(HEAD, bytes.size())),
            StandardCharsets.ISO_8859_1));
    }

    private static ElevationMap open(Assets assets, MapBytes bytes) throws IOException {
        String lower = bytes.getName().toLowerCase(Locale.ROOT);
        String kind = kind(bytes);
        if (lower.endsWith(".hgt") && (SrtmTile.isTile(bytes.size()) || kind.equals(FileKind.UNKNOWN))
            || lower.endsWith(".zip") && kind.equals(FileKind.ZIP)) {
            return SrtmTile.open(bytes);
        }
        if (kind.equals(FileKind.TIFF)) {
            return GeoTiff.open(bytes);
        }
        if (kind.equals(FileKind.PICTURE)) {
            bytes.close();
            return GreyPicture.open(bytes.getName(), assets.readPicture(bytes.getName()));
        }
        if (isGrid(bytes)) {
            return AsciiGrid.open(bytes, systemBeside(assets, bytes.getName()));
        }
        throw FileLimits.wrong(bytes.getName(), "the file", kind.equals(FileKind.UNKNOWN) && lower.endsWith(".dem")
            ? "a USGS DEM" : kind, LEGAL + ": convert other elevation maps by " + translation(bytes.getName()));
    }

    /** Returns the command of GDAL that converts a map. */
    private static String translation(String path) {
        String name = PrintableText.line(path.substring(path.lastIndexOf('/') + 1));
        return "gdal_translate " + name + ' ' + (name.contains(".") ? name.substring(0, name.lastIndexOf('.')) : name)
            + "_converted.tif";
    }

    private static String systemBeside(Assets assets, String path) throws IOException {
        String beside = path.substring(0, Math.max(path.lastIndexOf('.'), 0)) + ".prj";
        if (!path.contains(".") || !assets.has(beside)) {
            return null;
        }
        try (MapBytes bytes = MapBytes.open(assets, beside)) {
            return EsriProjection.system(bytes);
        }
    }
}
