// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.IOException;
import org.SEAR.files.Assets;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.terrain.format.GeoTiffWriter;
import org.SEAR.terrain.format.Georeference;
import org.SEAR.terrain.format.MapLimits;

/** Cuts the used part out of maps, so that a shared project needs no more. Any thread. */
public final class MapCut {
    /** Extent of the map beyond its outermost posts, cells. */
    private static final double HALF_CELL = 0.5;
    /** Rows and columns kept around the area. */
    private static final int RIM = 3;

    private MapCut() {
    }

    /**
     * Returns the used part of the maps with a rim, as one GeoTIFF that produces the same ground.
     * @param area with a part of maps
     * @return null if the area uses the whole maps or exceeds the memory, or if the coordinate system has no EPSG
     *     number
     * @throws IOException that names the map and the error
     */
    public static byte[] of(TerrainArea area, Assets assets) throws IOException {
        if (area.area == null) {
            return null;
        }
        try (Mosaic mosaic = Mosaic.open(assets, area.paths)) {
            return GeoTiffWriter.canWrite(mosaic.place) ? cut(mosaic, area) : null;
        }
    }

    private static byte[] cut(Mosaic mosaic, TerrainArea wanted) throws IOException {
        TerrainArea.Area area = wanted.area;
        MapSystem system = MapSystem.at(mosaic.first().name, mosaic.place.system, area.latitude, area.longitude);
        double middle = mosaic.place.x((mosaic.columns - 1) / 2.0, (mosaic.rows - 1) / 2.0);
        MapPlane plane = MapPlane.onEarth(new GeoOrigin(area.latitude, 0, area.longitude), system,
            mosaic.place, middle);
        double[] box = new MapExtent(mosaic, plane).box(area.northSouth, area.eastWest, HALF_CELL);
        if (box == null) {
            throw MapExtent.beyond(mosaic, system, area);
        }
        int left = (int) Math.max(0, Math.floor(box[0]) - RIM);
        int top = (int) Math.max(0, Math.floor(box[1]) - RIM);
        int right = (int) Math.min(mosaic.columns - 1.0, Math.ceil(box[2]) + RIM);
        int bottom = (int) Math.min(mosaic.rows - 1.0, Math.ceil(box[3]) + RIM);
        if ((bottom - top + 1L) * (right - left + 1) > MapLimits.MAX_POSTS) {
            return null;
        }
        MapRaster raster = mosaic.read(top, left, bottom - top + 1, right - left + 1);
        Georeference place = mosaic.place.from(left, top);
        return GeoTiffWriter.bytes(place, system.geographic, raster.rows, raster.columns, raster.heights);
    }
}
