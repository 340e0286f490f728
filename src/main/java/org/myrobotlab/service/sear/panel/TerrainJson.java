// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import org.SEAR.camera.image.Jpeg;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.geometry.HeightField;
import org.SEAR.terrain.relief.GroundPicture;
import org.SEAR.terrain.relief.Relief;

/**
 * The ground for panels as JSON: a shaded picture and an elevation grid, coarse enough for one message. Panels request
 * each ground once. Metres and degrees.
 */
final class TerrainJson extends JsonForm {
    /** Most bytes of the picture, before base64. */
    static final int PICTURE_BYTES = 300_000;
    /** Most pixels of the picture's longer side. */
    static final int PICTURE_PIXELS = 1024;
    /** Most grid posts per side. */
    static final int MAX_POSTS = 300;
    /**
     * Points per side with latitude and longitude. Linear interpolation between them is accurate to a metre over 100
     * km.
     */
    static final int PLACES = 33;
    private static final int PER_POST = 3;
    private static final double SMALLER = 0.8;
    private static final double FULL = 65535;
    private static final double MILLIMETRES = 1e3;
    /** Reported parts per degree, about a centimetre. */
    private static final double PLACE = 1e7;

    /** Identifies the ground for panels, see {@link TerrainMap}. */
    final String stamp;
    /** Limits of the area in the world's x. */
    final float south;
    final float north;
    /** Limits of the area in the world's z. */
    final float west;
    final float east;
    /** Picture of the area, north up: {@code data:image/jpeg;base64,..}. */
    final String picture;
    final int rows;
    final int columns;
    final double lowest;
    final double highest;
    /**
     * Base64 of 16 bits per post, low byte first, row by row from the south: 0 is the lowest, 65535 the highest
     * elevation.
     */
    final String heights;
    /** Height of y = 0 above the geoid; empty if the map is not georeferenced. */
    final Optional<Double> altitude;
    /**
     * {latitude, longitude} of {@value #PLACES} x {@value #PLACES} points, row by row from the south, longitudes
     * without a jump; empty without georeference.
     */
    final Optional<List<double[]>> places;

    /**
     * Creates a ground for panels.
     *
     * @param origin null without georeference
     * @param altitude height of y = 0 above the geoid, metres
     * @param detail spacing of the map's own posts, metres
     * @param colors null for colours by elevation
     */
    TerrainJson(String stamp, HeightField field, GeoOrigin origin, double altitude, double detail,
        GroundPicture.Colors colors) {
        this.stamp = stamp;
        south = field.x(0);
        north = field.x(field.rows - 1);
        west = field.z(0);
        east = field.z(field.columns - 1);
        picture = SmallPicture.address("jpeg", picture(field, detail, colors));
        rows = Math.min(MAX_POSTS, field.rows);
        columns = Math.min(MAX_POSTS, field.columns);
        double[] posts = new double[rows * columns];
        for (int i = 0; i < posts.length; i++) {
            posts[i] = field.height(between(south, north, i / columns, rows),
                between(west, east, i % columns, columns));
        }
        lowest = Arrays.stream(posts).min().orElseThrow();
        highest = Arrays.stream(posts).max().orElseThrow();
        heights = encoded(posts, lowest, highest);
        this.altitude = Optional.ofNullable(origin).map(place -> JsonNumbers.rounded(altitude, MILLIMETRES));
        places = Optional.ofNullable(origin).map(place -> places(field, place));
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
            image.setRGB(0, picture.height - 1 - row, picture.width, 1, picture.pixels, row * picture.width,
                picture.width);
        }
        return Jpeg.of(image);
    }

    private static String encoded(double[] posts, double low, double high) {
        byte[] bytes = new byte[2 * posts.length];
        double scale = high > low ? FULL / (high - low) : 0;
        for (int i = 0; i < posts.length; i++) {
            int value = (int) Math.round((posts[i] - low) * scale);
            bytes[2 * i] = (byte) value;
            bytes[2 * i + 1] = (byte) (value >> 8);
        }
        return Base64.getEncoder().encodeToString(bytes);
    }

    /** Returns one of count points from low to high; exact at both ends. */
    private static double between(double low, double high, int at, int count) {
        return at == count - 1 ? high : low + (high - low) * at / (count - 1);
    }

    private static List<double[]> places(HeightField field, GeoOrigin origin) {
        List<double[]> places = new ArrayList<>(PLACES * PLACES);
        for (int i = 0; i < PLACES * PLACES; i++) {
            GeoOrigin.GeoPoint place = origin.at(between(field.x(0), field.x(field.rows - 1), i / PLACES, PLACES), 0,
                between(field.z(0), field.z(field.columns - 1), i % PLACES, PLACES));
            double longitude = origin.getLongitude() + Math.IEEEremainder(place.longitude - origin.getLongitude(), 360);
            places.add(new double[] {JsonNumbers.rounded(place.latitude, PLACE),
                JsonNumbers.rounded(longitude, PLACE)});
        }
        return places;
    }
}
