package org.myrobotlab.service.sear.panel;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.geometry.HeightField;
import org.SEAR.terrain.relief.GroundPicture;
import org.SEAR.terrain.relief.Relief;

/**
 * The ground as panels draw it, for JSON: a shaded picture and a grid of heights, both coarse enough for one message, which panels get once for each
 * ground. Metres and degrees.
 *
 * <pre>
 * {"stamp": "..", "south": -1000, "north": 1000, "west": -1000, "east": 1000 (of the area, x and z in the world),
 *  "picture": "data:image/jpeg;base64,.." (the area, north up, at most 300 kB before base64),
 *  "rows": 300, "columns": 300, "lowest": -120.5, "highest": 310.25,
 *  "heights": ".." (base64 of 16 bits a post, low byte first, row by row from the south: 0 is the lowest, 65535 the highest),
 *  "altitude": 553.0 (of y = 0 above the geoid; null if the map has no place on Earth, likewise places),
 *  "places": [[36.48, -84.23], ..] (latitude and longitude of 33 x 33 points, row by row from the south, longitudes without a jump)}
 * </pre>
 */
final class TerrainJson {
    /** Bytes of the picture at most, before base64. */
    static final int PICTURE_BYTES = 300_000;
    /** Pixels of the picture's longer side at most. */
    static final int PICTURE_PIXELS = 1024;
    /** Posts of the grid on a side at most. */
    static final int MOST_POSTS = 300;
    /** Points on a side at which latitude and longitude are told: between them straight is right to a metre over 100 km. */
    static final int PLACES = 33;
    private static final int PER_POST = 3;
    private static final double SMALLER = 0.8;
    private static final double FULL = 65535;
    private static final double MILLIMETRES = 1e3;
    /** Parts of a degree that are told, about a centimetre. */
    private static final double PLACE = 1e7;

    private TerrainJson() {
    }

    /**
     * A ground for panels.
     *
     * @param origin null if it has no place on Earth
     * @param altitude metres of y = 0 above the geoid
     * @param detail metres between the map's own posts
     * @param colors null for colours by height
     */
    static Map<String, Object> of(HeightField field, GeoOrigin origin, double altitude, double detail,
            GroundPicture.Colors colors) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("south", field.x(0));
        map.put("north", field.x(field.rows - 1));
        map.put("west", field.z(0));
        map.put("east", field.z(field.columns - 1));
        map.put("picture", SmallPicture.address("jpeg", picture(field, detail, colors)));
        addHeights(map, field);
        map.put("altitude", origin == null ? null : WorldJson.rounded(altitude, MILLIMETRES));
        map.put("places", origin == null ? null : places(field, origin));
        return map;
    }

    private static byte[] picture(HeightField field, double detail, GroundPicture.Colors colors) {
        int longest = PICTURE_PIXELS;
        while (true) {
            byte[] bytes = encoded(GroundPicture.map(new Relief(field, longest, PER_POST, detail), colors));
            if (bytes.length <= PICTURE_BYTES) {
                return bytes;
            }
            longest *= SMALLER;
        }
    }

    private static byte[] encoded(GroundPicture picture) {
        BufferedImage image = new BufferedImage(picture.width, picture.height, BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < picture.height; row++) {
            image.setRGB(0, picture.height - 1 - row, picture.width, 1, picture.pixels, row * picture.width, picture.width);
        }
        return SmallPicture.jpeg(image);
    }

    private static void addHeights(Map<String, Object> map, HeightField field) {
        int rows = Math.min(MOST_POSTS, field.rows);
        int columns = Math.min(MOST_POSTS, field.columns);
        double[] heights = new double[rows * columns];
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < heights.length; i++) {
            heights[i] = field.height(between(field.x(0), field.x(field.rows - 1), i / columns, rows),
                between(field.z(0), field.z(field.columns - 1), i % columns, columns));
            low = Math.min(low, heights[i]);
            high = Math.max(high, heights[i]);
        }
        byte[] bytes = new byte[2 * heights.length];
        double scale = high > low ? FULL / (high - low) : 0;
        for (int i = 0; i < heights.length; i++) {
            int value = (int) Math.round((heights[i] - low) * scale);
            bytes[2 * i] = (byte) value;
            bytes[2 * i + 1] = (byte) (value >> 8);
        }
        map.put("rows", rows);
        map.put("columns", columns);
        map.put("lowest", low);
        map.put("highest", high);
        map.put("heights", Base64.getEncoder().encodeToString(bytes));
    }

    /** The place of one of count points from low to high, both ends exactly. */
    private static double between(double low, double high, int at, int count) {
        return at == count - 1 ? high : low + (high - low) * at / (count - 1);
    }

    private static List<double[]> places(HeightField field, GeoOrigin origin) {
        List<double[]> places = new ArrayList<>(PLACES * PLACES);
        for (int i = 0; i < PLACES * PLACES; i++) {
            GeoOrigin.GeoPoint place = origin.at(between(field.x(0), field.x(field.rows - 1), i / PLACES, PLACES), 0,
                between(field.z(0), field.z(field.columns - 1), i % PLACES, PLACES));
            double longitude = origin.getLongitude() + Math.IEEEremainder(place.longitude - origin.getLongitude(), 360);
            places.add(new double[] {WorldJson.rounded(place.latitude, PLACE), WorldJson.rounded(longitude, PLACE)});
        }
        return places;
    }
}
