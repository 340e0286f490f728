package org.SEAR.terrain;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;

/** Which maps are used, and which part of them: what an object Terrain says. Immutable, any thread. */
public final class TerrainArea {
    /** Paths below the assets, at least one. */
    final List<String> paths;
    /** Degrees of the centre and metres north-south and east-west; null: all of the maps. */
    final Area area;
    /** Metres of a map without a place on Earth; null: the map says them. */
    final Size size;

    private TerrainArea(List<String> paths, Area area, Size size) {
        this.paths = paths;
        this.area = area;
        this.size = size;
    }

    /**
     * All of one or several maps.
     *
     * @param path below the assets
     * @param tiles more of them, beside it
     */
    public static TerrainArea of(String path, List<String> tiles) {
        List<String> paths = new ArrayList<>();
        paths.add(path);
        paths.addAll(tiles);
        return new TerrainArea(Collections.unmodifiableList(paths), null, null);
    }

    /**
     * A part of them.
     *
     * @param latitude of the centre, degrees, + north
     * @param longitude of the centre, degrees, + east
     * @param northSouth metres, likewise eastWest
     */
    public TerrainArea around(double latitude, double longitude, double northSouth, double eastWest) {
        return new TerrainArea(paths, new Area(latitude, longitude, northSouth, eastWest), size);
    }

    /**
     * How large a map without a place on Earth is.
     *
     * @param northSouth metres, likewise eastWest
     * @param lowest metres of black, or of the lowest value; likewise highest
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
        return paths + (area == null ? "" : ", area " + area.latitude + " " + area.longitude + " " + area.northSouth + " x " + area.eastWest)
            + (size == null ? "" : ", size " + size.northSouth + " x " + size.eastWest + ", " + size.lowest + " to " + size.highest);
    }

    /** A rectangle about a place on Earth. */
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

    /** Metres. */
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
