// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Collections;
import org.SEAR.files.Assets;
import org.junit.Test;

/**
 * Real elevations in three formats and two coordinate systems, compared with GDAL's values: USGS, SRTM, the Jacksboro
 * fault.
 */
public class JacksboroTest {
    private static final Path FOLDER = Paths.get(System.getProperty("sear.root", "."),
        "src/test/resources/org/SEAR/terrain");
    private static final Assets ASSETS = new Assets(FOLDER);

    private static TerrainArea all(String path) {
        return TerrainArea.of(path, Collections.emptyList());
    }

    private static JsonNode probes() throws IOException {
        return new ObjectMapper().readTree(FOLDER.resolve("probes.json").toFile());
    }

    private static int probesOf(Ground ground, String elevation) throws IOException {
        int seen = 0;
        for (JsonNode probe : probes().get("probes")) {
            double height = ground.height(probe.get("latitude").asDouble(), probe.get("longitude").asDouble());
            if (!Double.isNaN(height)) {
                assertEquals(probe.toString(), probe.get(elevation).asDouble(), height, 0.05);
                double[] at = ground.origin.to(probe.get("latitude").asDouble(), probe.get("longitude").asDouble());
                assertEquals(probe.toString(), probe.get(elevation).asDouble(), ground.altitude
                    + ground.field.height(at[0], at[1]), 0.5);
                seen++;
            }
        }
        return seen;
    }

    @Test
    public void allProbesOfTheGeographicMap() throws IOException {
        Ground ground = TerrainLoader.load(all("terrain/jacksboro.tif"), ASSETS);
        assertEquals(24, probesOf(ground, "elevation_wgs84_grid"));
        assertEquals(Collections.emptyList(), ground.warnings);
    }

    @Test
    public void allProbesOfTheProjectedMap() throws IOException {
        Ground ground = TerrainLoader.load(all("jacksboro-utm16n.tif"), ASSETS);
        assertEquals(24, probesOf(ground, "elevation_utm_grid"));
    }

    @Test
    public void theProbesThatTheAsciiGridCovers() throws IOException {
        Ground ground = TerrainLoader.load(all("jacksboro-part.asc"), ASSETS);
        assertEquals(3, probesOf(ground, "elevation_wgs84_grid"));
    }

    @Test
    public void theSummitIsAsHighAsItIs() throws IOException {
        JsonNode summit = probes().get("summit");
        double latitude = summit.get("latitude").asDouble();
        double longitude = summit.get("longitude").asDouble();
        Ground ground = TerrainLoader.load(
            all("terrain/jacksboro.tif").around(latitude, longitude, 2000, 2000), ASSETS);
        assertEquals(1076, ground.altitude, 1);
        assertEquals(0, ground.field.height(0, 0), 1e-6);
        assertEquals(1076, ground.height(latitude, longitude), 1);
        assertEquals(latitude, ground.origin.getLatitude(), 0);
    }
}
