// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.SEAR.files.FileLimits;
import org.SEAR.terrain.tiff.MapBytes;

/**
 * Coordinate system in a .prj beside a grid: well-known text of ESRI or OGC, or lines such as "Projection GEOGRAPHIC"
 * of older grids.
 */
final class EsriProjection {
    private static final int MOST = 1 << 16;
    private static final Pattern AUTHORITY =
        Pattern.compile("(?:AUTHORITY\\[\"EPSG\",\"?|ID\\[\"EPSG\",)(\\d{4,6})\"?\\]\\s*\\]\\s*$",
        Pattern.CASE_INSENSITIVE);
    private static final Pattern UTM = Pattern.compile("^\\s*PROJCS\\[\"(\\w+?)_UTM_Zone_(\\d{1,2})([NS])\"",
        Pattern.CASE_INSENSITIVE);
    private static final Pattern OLD_UTM = Pattern.compile("^\\s*Projection\\s+UTM\\s.*\\bZone\\s+(-?\\d{1,2})\\s.*",
        Pattern.CASE_INSENSITIVE | Pattern.DOTALL);

    private EsriProjection() {
    }

    /**
     * Returns the coordinate system.
     * @return EPSG:NUMBER, PROJ parameters, or EPSG:NUMBER of a geographic system and the projection on it
     * @throws IOException for an unsupported system
     */
    static String system(MapBytes file) throws IOException {
        FileLimits.range(file.getName(), "the file's size", file.size(), 1, MOST);
        String text = new String(file.read("the text", 0, (int) file.size()), StandardCharsets.UTF_8).trim();
        Matcher number = AUTHORITY.matcher(text);
        if (number.find()) {
            return "EPSG:" + number.group(1);
        }
        Matcher utm = UTM.matcher(text);
        if (utm.find() && zone(utm.group(1), utm.group(3)) > 0) {
            return "EPSG:" + (zone(utm.group(1), utm.group(3)) + Integer.parseInt(utm.group(2)));
        }
        Matcher old = OLD_UTM.matcher(text);
        if (old.matches()) {
            int zone = Integer.parseInt(old.group(1));
            return "EPSG:" + (zone < 0 ? 32700 - zone : 32600 + zone);
        }
        // other datums use the ellipsoid of WGS 84, too
        String datums = text.replaceAll("(?i)SPHEROID\\[\"[^\"]*\"", "");
        if (datums.matches("(?is)GEOGCS\\[.*(WGS_1984|WGS 84).*")
            || text.matches("(?is)Projection\\s+GEOGRAPHIC\\b.*")) {
            return Georeference.WGS84;
        }
        if (text.matches("(?is)GEOGCS\\[.*(D_North_American_1983|NAD83).*")) {
            return "EPSG:4269";
        }
        String own = EsriParameters.of(text);
        if (own != null) {
            return own;
        }
        String datum = text.matches("(?is)GEOGCS\\[.*") && EsriParameters.isInDegrees(text)
            ? DatumNames.system(text) : null;
        if (datum != null) {
            return datum;
        }
        throw FileLimits.wrong(file.getName(), "the coordinate system", text.replaceAll("\\s+", " "),
            "one with AUTHORITY[\"EPSG\",...], longitude and latitude, or a projection that docs/terrain.md lists on a "
                + "datum of the EPSG register: convert the map by gdalwarp -t_srs EPSG:4326 "
                + file.getName().replaceFirst(".*/", "").replaceFirst("(?i)\\.prj$", ".asc") + " wgs84.tif");
    }

    private static int zone(String datum, String side) {
        switch (datum.toUpperCase(Locale.ROOT)) {
            case "WGS_1984":
                return side.equalsIgnoreCase("N") ? 32600 : 32700;
            case "NAD_1983":
                return 26900;
            case "ETRS_1989":
                return 25800;
            default:
                return 0;
        }
    }
}
