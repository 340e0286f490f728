// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.lang.ref.SoftReference;
import java.util.Locale;
import org.SEAR.POJOs.GroundHeights;
import org.SEAR.POJOs.Terrain;
import org.SEAR.files.Assets;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.grammar.Parameter;
import org.SEAR.terrain.Ground;

/**
 * Elevations of the current project's terrain. The last ground is soft-referenced, because scripts query it repeatedly.
 * Any thread.
 */
public final class TerrainHeights implements GroundHeights {
    private SoftReference<Ground> last = new SoftReference<>(null);

    @Override
    public double height(Terrain terrain, double latitude, double longitude) throws IOException {
        Ground ground = TerrainGround.load(terrain, new Assets(ProjectFolder.present().resolve(ProjectFolder.ASSETS)));
        keep(ground);
        if (ground.origin == null) {
            throw new IllegalArgumentException(terrain + " has no georeference, so it has no elevation by latitude and "
                + "longitude, legal: a map with georeference; sear.getGroundHeight(x, z) works for every map");
        }
        double height = ground.height(latitude, longitude);
        if (Double.isNaN(height)) {
            throw new IllegalArgumentException(terrain + " has no ground at latitude " + Parameter.format(latitude)
                + ", longitude " + Parameter.format(longitude) + ", legal: " + extent(ground));
        }
        return height;
    }

    private synchronized void keep(Ground ground) {
        if (last.get() != ground) {
            last = new SoftReference<>(ground);
        }
    }

    /** Returns the extent through the middle: {@code latitude 36.476 to 36.494, longitude -84.242 to -84.2197}. */
    private static String extent(Ground ground) {
        GeoOrigin.GeoPoint south = ground.origin.at(ground.field.lowX, 0, 0);
        GeoOrigin.GeoPoint north = ground.origin.at(ground.field.x(ground.field.rows - 1), 0, 0);
        GeoOrigin.GeoPoint west = ground.origin.at(0, 0, ground.field.lowZ);
        GeoOrigin.GeoPoint east = ground.origin.at(0, 0, ground.field.z(ground.field.columns - 1));
        return String.format(Locale.ROOT, "latitude %.4f to %.4f, longitude %.4f to %.4f", south.latitude,
            north.latitude, west.longitude, east.longitude);
    }
}
