// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;

/**
 * The ground from an elevation map: SRTM, GeoTIFF, ESRI ASCII grid, or a picture whose grey level is the elevation. The
 * middle of its area is the world's origin, at height 0, and the reference of GPS and compass. It is fixed in place; a
 * project has at most one.
 */
@Described("the ground from an elevation map; the middle of its area is the world's origin; it can't be moved, turned "
    + "or scaled, and has no mass")
public class Terrain extends Shape {
    /** Largest extent of an area, metres: a position is at most half of it from the origin. */
    static final double LARGEST = 2 * FAR;
    /** Lowest legal elevation, metres. */
    static final double DEEPEST = -12000;
    /** Highest legal elevation, metres. */
    static final double HIGHEST = 100000;
    private static final int MAX_TILES = 63;

    @Param(doc = "elevation map below assets: .hgt, .hgt.zip, .tif, .tiff, .asc, or a grey picture .png, .jpg",
        text = TextRule.ASSET, required = true)
    private String path;
    @Param(doc = "another map beside or over the first", element = "tile", text = TextRule.ASSET,
        maxEntries = MAX_TILES)
    private List<String> tiles = new ArrayList<>();
    @Param(doc = "latitude of the middle of the used area, north positive; default the whole map", unit = "deg",
        min = -90, max = 90)
    private Double latitude;
    @Param(doc = "longitude of the middle of the used area, east positive", unit = "deg", min = -180, max = 180)
    private Double longitude;
    @Param(doc = "extent from north to south of the area, or of a map without one", unit = "m", min = 1, max = LARGEST)
    private Double northSouth;
    @Param(doc = "extent from east to west of the area, or of a map without one", unit = "m", min = 1, max = LARGEST)
    private Double eastWest;
    @Param(doc = "elevation of the map's lowest value, black in a picture; for a map without elevations", unit = "m",
        min = DEEPEST, max = HIGHEST)
    private Double lowest;
    @Param(doc = "elevation of the map's highest value, white in a picture", unit = "m", min = DEEPEST, max = HIGHEST)
    private Double highest;

    /** For reading from a file. */
    protected Terrain() {
    }

    /**
     * The whole map.
     *
     * @param path below assets
     */
    public Terrain(String name, String path) {
        super(name, 0);
        this.path = path;
        created(Terrain.class);
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        checkFixed(faults);
        boolean area = latitude != null || longitude != null;
        boolean size = lowest != null || highest != null;
        if (area && size) {
            faults.add("lowest", lowest, "none with latitude and longitude: an area has its own elevations");
        }
        boolean extent = northSouth != null || eastWest != null;
        boolean whole = northSouth != null && eastWest != null;
        if (area && (latitude == null || longitude == null || !whole)) {
            faults.add(latitude == null ? "longitude" : "latitude", latitude == null ? longitude : latitude,
                "all of latitude, longitude, northSouth and eastWest, or none of them");
        } else if (size && (lowest == null || highest == null || !whole)) {
            faults.add(lowest == null ? "highest" : "lowest", lowest == null ? highest : lowest,
                "all of northSouth, eastWest, lowest and highest, or none of them");
        } else if (extent && !area && !size) {
            faults.add(northSouth == null ? "eastWest" : "northSouth", northSouth == null ? eastWest : northSouth,
                "with latitude, longitude and both extents for an area, or with lowest, highest and both extents for "
                    + "a map's size");
        }
        if (lowest != null && highest != null && !(lowest < highest)) {
            faults.add("lowest", lowest, "below highest, " + Parameter.format(highest) + " m");
        }
    }

    private void checkFixed(Faults faults) {
        for (Parameter parameter : ParameterTable.of(Terrain.class).getParameters()) {
            String reason = whyFixed(parameter.getName());
            Object value = parameter.get(this);
            double usual = parameter.getName().startsWith("scale") ? 1 : 0;
            if (reason != null && value instanceof Double && (Double) value != usual) {
                faults.add(parameter.getName(), value, Parameter.format(usual) + ": " + reason);
            } else if (reason != null && value instanceof Boolean) {
                faults.add(parameter.getName(), value, "nothing: " + reason);
            }
        }
    }

    @Override
    String whyFixed(String parameter) {
        switch (parameter) {
            case "mass":
                return "a terrain is fixed";
            case "rx":
            case "ry":
            case "rz":
                return "north on a terrain is the world's x; turn robots and objects instead";
            case "scaleX":
            case "scaleY":
            case "scaleZ":
                return "a terrain has its true size; setSize(northSouth, eastWest, lowest, highest) sets it for a "
                    + "map without one";
            default:
                if (Shape.isLaunching(parameter)) {
                    return "a terrain is fixed";
                }
                return parameter.matches("[xyz]") || PlacedObject.isPlacing(parameter)
                    ? "the middle of a terrain's area is the world's origin;"
                    + " setArea(latitude, longitude, northSouth, eastWest) chooses another" : null;
        }
    }

    @Override
    public boolean isGround() {
        return true;
    }

    @Override
    String whyNoComponent() {
        return " is the terrain, which can't be a component";
    }

    public String getPath() {
        return path;
    }

    /** Returns the paths of all maps below assets: the first map, then the tiles. */
    public List<String> getPaths() {
        List<String> all = new ArrayList<>();
        all.add(path);
        all.addAll(tiles);
        return all;
    }

    /**
     * Adds a map beside or over the first. Where maps overlap, the earlier one counts.
     *
     * @param tile path below assets
     */
    public void addTile(String tile) {
        String checkedTile = checked("tile", tile);
        if (checkedTile == null || getPaths().contains(checkedTile) || tiles.size() >= MAX_TILES) {
            throw new IllegalArgumentException(label() + ": tile is " + ParameterTable.quote(tile)
                + ", legal: another map than its "
                + getPaths().size() + " so far, at most " + MAX_TILES + " besides the first");
        }
        tiles.add(checkedTile);
        changed();
    }

    /**
     * Selects a part of the map, whose middle becomes the world's origin.
     *
     * @param newLatitude of the middle, degrees, north positive
     * @param newLongitude of the middle, degrees, east positive
     * @param newNorthSouth extent from north to south, metres
     * @param newEastWest extent from east to west, metres
     */
    public void setArea(double newLatitude, double newLongitude, double newNorthSouth, double newEastWest) {
        double checkedLatitude = checked("latitude", newLatitude);
        double checkedLongitude = checked("longitude", newLongitude);
        double checkedNorthSouth = checked("northSouth", newNorthSouth);
        double checkedEastWest = checked("eastWest", newEastWest);
        if (lowest != null) {
            throw new IllegalArgumentException(label() + ": setSize was called for a map without georeference, which "
                + "has no area by latitude and longitude, legal: setArea or setSize");
        }
        latitude = checkedLatitude;
        longitude = checkedLongitude;
        northSouth = checkedNorthSouth;
        eastWest = checkedEastWest;
        changed();
    }

    /**
     * Sets the size of a map without georeference, such as a picture.
     *
     * @param newNorthSouth extent from north to south, metres
     * @param newEastWest extent from east to west, metres
     * @param newLowest elevation of the lowest value (black), metres
     * @param newHighest elevation of the highest value (white), metres
     */
    public void setSize(double newNorthSouth, double newEastWest, double newLowest, double newHighest) {
        double checkedNorthSouth = checked("northSouth", newNorthSouth);
        double checkedEastWest = checked("eastWest", newEastWest);
        double checkedLowest = checked("lowest", newLowest);
        double checkedHighest = checked("highest", newHighest);
        if (!(checkedLowest < checkedHighest)) {
            throw new IllegalArgumentException(label() + ": lowest is " + Parameter.format(checkedLowest)
                + ", legal: below highest, " + Parameter.format(checkedHighest) + " m");
        }
        if (latitude != null) {
            throw new IllegalArgumentException(label() + ": setArea was called for a map with georeference, which has "
                + "its own size, legal: setArea or setSize");
        }
        northSouth = checkedNorthSouth;
        eastWest = checkedEastWest;
        lowest = checkedLowest;
        highest = checkedHighest;
        changed();
    }

    /**
     * Returns the elevation at a geographic position, whether a simulation runs or not.
     *
     * @param atLatitude degrees, north positive
     * @param atLongitude degrees, east positive
     * @return metres above the geoid (about mean sea level)
     * @throws IllegalArgumentException if the position is outside of the area, or the map has no georeference
     * @throws UncheckedIOException if the map can't be read
     */
    public double getHeight(double atLatitude, double atLongitude) {
        try {
            return Heights.ALL.height(this, atLatitude, atLongitude);
        } catch (IOException e) {
            throw new UncheckedIOException(label() + ": " + e.getMessage(), e);
        }
    }

    /** Loaded on the first elevation query. */
    private static final class Heights {
        static final GroundHeights ALL = ServiceLoader.load(GroundHeights.class, GroundHeights.class.getClassLoader())
            .findFirst()
            .orElseThrow(() -> new IllegalStateException("no org.SEAR.POJOs.GroundHeights on the class path: sear.jar "
                + "is incomplete"));
    }

    /** Returns whether {@link #setArea} has selected a part of the map. */
    public boolean hasArea() {
        return latitude != null;
    }

    /** Returns whether {@link #setSize} has set the size of the map. */
    public boolean hasSize() {
        return lowest != null;
    }

    public Double getLatitude() {
        return latitude;
    }

    public Double getLongitude() {
        return longitude;
    }

    /** Returns the extent from north to south, metres; null for the whole of a map with its own extent. */
    public Double getNorthSouth() {
        return northSouth;
    }

    /** Returns the extent from east to west, metres; null for the whole of a map with its own extent. */
    public Double getEastWest() {
        return eastWest;
    }

    public Double getLowest() {
        return lowest;
    }

    public Double getHighest() {
        return highest;
    }

    @Override
    protected String defaultColor() {
        return "#6b8e23";
    }
}
