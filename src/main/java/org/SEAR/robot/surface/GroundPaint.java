// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.surface;

import java.io.IOException;
import java.util.function.Consumer;
import org.SEAR.POJOs.Terrain;
import org.SEAR.files.Assets;
import org.SEAR.terrain.Ground;
import org.SEAR.terrain.TerrainColors;
import org.SEAR.terrain.relief.GroundPicture;

/** Picture of a terrain, without the shading of window and tab; outside the picture, the terrain's colour. */
final class GroundPaint implements SurfacePaint {
    private static final int RGB = 0xFFFFFF;
    private static final int OPAQUE = 255;

    private final Terrain terrain;
    private final Ground ground;
    private final Assets assets;
    private final Consumer<String> reported;
    private final int plain;
    private boolean known;
    private GroundPicture.Colors colors;

    /** @param told takes a warning if the picture can't be read, when a sensor first looks */
    GroundPaint(Terrain terrain, Ground ground, Assets assets, Consumer<String> told) {
        this.terrain = terrain;
        this.ground = ground;
        this.assets = assets;
        this.reported = told;
        this.plain = SurfaceColors.plain(terrain);
    }

    private void learn() {
        known = true;
        try {
            colors = TerrainColors.of(terrain, assets, ground);
        } catch (IOException e) {
            reported.accept("colour and line sensors can't read the terrain's picture: " + e.getMessage());
        }
    }

    @Override
    public int at(double[] point) {
        if (!known) {
            learn();
        }
        int color = colors == null ? 0 : colors.at(point[0], point[2]);
        return color >>> 24 == OPAQUE ? color & RGB : plain;
    }
}
