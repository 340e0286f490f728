// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.util.Locale;

/** Recognises a file format by its first bytes. */
final class FileKind {
    static final String TIFF = "a TIFF";
    static final String PICTURE = "a picture";
    static final String ZIP = "a zip";
    static final String GRID = "an ESRI ASCII grid";
    static final String UNKNOWN = "in no known format";

    private static final String[][] KINDS = {
        {"II*\0", TIFF}, {"MM\0*", TIFF}, {"II+\0", TIFF}, {"MM\0+", TIFF},
        {"\u0089PNG", PICTURE}, {"\u00ff\u00d8\u00ff", PICTURE}, {"GIF8", PICTURE}, {"BM", PICTURE},
        {"PK\u0003\u0004", ZIP},
        {"\0\0\0\fjP  ", "a JPEG 2000"}, {"\u00ff\u004f\u00ff\u0051", "a JPEG 2000"},
        {"\u0089HDF", "a NetCDF or HDF5"}, {"CDF\u0001", "a NetCDF"}, {"CDF\u0002", "a NetCDF"},
        {"CDF\u0005", "a NetCDF"},
        {"\u000e\u0003\u0013\u0001", "an HDF4"}, {"GRIB", "a GRIB"}, {"EHFA_HEADER_TAG", "an Erdas Imagine picture"},
        {"LASF", "a point cloud (LAS)"},
        {"Lerc2 ", "a LERC"}, {"DSAA", "a Surfer grid"}, {"DSBB", "a Surfer grid"}, {"DSRB", "a Surfer grid"},
        {"UHL1", "a DTED"},
        {"HDR", "a DTED"}, {"VOL1", "a DTED"}, {"SQLite format 3", "a GeoPackage or MBTiles"}, {"%PDF", "a PDF"},
        {"\u001f\u008b", "packed with gzip"}, {"7z\u00bc\u00af", "packed with 7z"}, {"Rar!", "packed with rar"},
        {"RIFF", "a WebP"},
        {"glTF", "a glTF model"}, {"<", "XML or HTML"}, {"{", "JSON"},
    };

    private FileKind() {
    }

    /**
     * Returns the format as used in messages.
     * @param head the first bytes as characters
     */
    static String of(String head) {
        if (head.trim().toLowerCase(Locale.ROOT).matches("(?s)(ncols|nrows|xll|yll|cellsize|nodata).*")) {
            return GRID;
        }
        for (String[] kind : KINDS) {
            if (head.startsWith(kind[0])) {
                return kind[1];
            }
        }
        return UNKNOWN;
    }
}
