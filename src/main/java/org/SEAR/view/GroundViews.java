// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.io.IOException;
import java.util.function.Consumer;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Terrain;
import org.SEAR.camera.Daylight;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.terrain.Ground;
import org.SEAR.terrain.TerrainColors;
import org.SEAR.terrain.relief.GroundPicture;
import org.SEAR.terrain.relief.Relief;
import org.SEAR.view.terrain.GroundMaterial;
import org.SEAR.view.terrain.TerrainView;

/** Creates the window's view of a project's terrain. Window thread only. */
final class GroundViews {
    /** Pixels of the longer side of the ground's picture: with a graphics card, and with software rendering. */
    private static final int FINE_PICTURE = 2048;
    private static final int PLAIN_PICTURE = 1024;
    private static final int PER_POST = 3;

    private GroundViews() {
    }

    /** Returns the view, or null without a terrain. Warns about an unreadable picture. */
    static TerrainView of(Project project, WindowApplication window, Consumer<String> warnings) {
        Ground ground;
        try {
            ground = project.getGround();
        } catch (ProjectException e) {
            warnings.accept("SEAR can't show the terrain: " + e.getMessage());
            return null;
        }
        if (ground == null) {
            return null;
        }
        boolean fine = !window.isSoftware();
        Relief relief = new Relief(ground.field, fine ? FINE_PICTURE : PLAIN_PICTURE, PER_POST, ground.spacing);
        GroundPicture picture = GroundPicture.landscape(relief, Daylight.onLandscape(),
            colors(project, ground, warnings));
        return new TerrainView(ground.heights, new GroundMaterial(window.getAssetManager(), ground.field, picture,
            fine), fine);
    }

    private static GroundPicture.Colors colors(Project project, Ground ground, Consumer<String> warnings) {
        for (SearObject object : project.getEnvironment()) {
            if (object instanceof Terrain) {
                try {
                    return TerrainColors.of((Terrain) object, project.getAssets(), ground);
                } catch (IOException e) {
                    warnings.accept("SEAR can't show the terrain's picture: " + e.getMessage());
                }
            }
        }
        return null;
    }
}
