// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;

/** Maps and area that a Terrain object specifies. Immutable, any thread. */
public final class TerrainArea {
    /** Paths below the assets, at least one. */
    final List<String> paths;
    /** Rectangle on Earth; null for the whole maps. */
    final Area area;
    /** Size of a map without a georeference; null if the map defines it. */
    final Size size;

    private TerrainArea(List<String> paths, Area area, Size size) {
        this.paths = paths;
        this.area = area;
        this.size = size;
    }

    /**
     * Selects one or several whole maps.
     * @param path below the assets
     * @param tiles further maps
     */
    public static TerrainArea of(String path, List<String> tiles) {
        List<String> paths = new ArrayList<>();
        paths.add(path);
        paths.addAll(tiles);
        return new TerrainArea(Collections.unmodifiableList(paths), null, null);
    }

    /**
     * Selects a part of the maps.
     * @param latitude of the centre, degrees, + north
     * @param longitude of the centre, degrees, + east
     * @param northSouth metres, likewise eastWest
     */
    public TerrainArea around(double latitude, double longitude, double northSouth, double eastWest) {
        return new TerrainArea(paths, new Area(latitude, longitude, northSouth, eastWest), size);
    }

    /**
     * Sets the size of a map without a georeference.
     * @param northSouth metres, likewise eastWest
     * @param lowest elevation of black or of the minimum, metres; likewise highest
     */
    public TerrainArea sized(double northSouth, double eastWest, double lowest, double highest) {
        return new TerrainArea(paths, area, new Size(northSouth, eastWest, lowest, highest));
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof TerrainArea && toString().equals(other.toString());
    }

    @Override
    public int hashCode() {
        return Objects.hash(toString());
    }

    @Override
    public String toString() {
        return paths + (area == null ? "" : ", area " + area.latitude + " " + area.longitude + " " + area.northSouth
            + " x " + area.eastWest)
            + (size == null ? "" : ", size " + size.northSouth + " x " + size.eastWest + ", " + size.lowest + " to "
                + size.highest);
    }

    /** Rectangle centred at a position on Earth: degrees, and metres north-south and east-west. */
    static final class Area {
        final double latitude;
        final double longitude;
        final double northSouth;
        final double eastWest;

        Area(double latitude, double longitude, double northSouth, double eastWest) {
            this.latitude = latitude;
            this.longitude = longitude;
            this.northSouth = northSouth;
            this.eastWest = eastWest;
        }
    }

    /** Size of a map without a georeference, metres. */
    static final class Size {
        final double northSouth;
        final double eastWest;
        final double lowest;
        final double highest;

        Size(double northSouth, double eastWest, double lowest, double highest) {
            this.northSouth = northSouth;
            this.eastWest = eastWest;
            this.lowest = lowest;
            this.highest = highest;
        }
    }
}
