// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.surface;

import java.util.IdentityHashMap;
import java.util.Map;
import java.util.function.Consumer;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.camera.Appearance;
import org.SEAR.files.Assets;
import org.SEAR.physics.solid.Solid;
import org.SEAR.terrain.Ground;

/**
 * Colour of objects and robot parts at a point of their surface: of their picture, as in the window, otherwise their
 * own. Ignores a model's own textures: it has the colour of its object. Allocates nothing once a picture is read.
 * Simulation thread.
 */
public final class SurfaceColors {
    /** Colour of a solid without an object: the body of a robot without parts. */
    static final int GREY = 0x999999;
    private static final int HEX = 16;

    private final Assets assets;
    private final Consumer<String> reported;
    private final Map<Solid, SurfacePaint> paints = new IdentityHashMap<>();
    private final SurfacePictures pictures;
    private final AppearanceBuilder skins;

    /** @param told takes warnings of pictures that can't be read, when a sensor first looks */
    public SurfaceColors(Assets assets, Consumer<String> told) {
        this.assets = assets;
        this.reported = told;
        pictures = new SurfacePictures(assets, told);
        skins = new AppearanceBuilder(assets, pictures, told);
    }

    /** Adds an object of the environment, or a part or wheel of a robot. */
    public void add(Shape shape, Solid solid) {
        paints.put(solid, new ShapePaint(shape, solid, pictures::get));
        skins.add(shape, solid, null);
    }

    public void addTerrain(Terrain terrain, Solid solid, Ground ground) {
        paints.put(solid, new GroundPaint(terrain, ground, assets, reported));
        skins.add(terrain, solid, ground);
    }

    /**
     * Returns the colour at a point of a surface.
     * @param point {x, y, z} in the solid's frame, metres
     * @return 0xRRGGBB
     */
    public int at(Solid solid, double[] point) {
        SurfacePaint paint = paints.get(solid);
        return paint == null ? GREY : paint.at(point);
    }

    /** Returns the appearance to cameras, made at its first use; never null. */
    public Appearance skin(Solid solid) {
        return skins.of(solid);
    }

    static int plain(Shape shape) {
        return Integer.parseInt(shape.getColor().substring(1), HEX);
    }
}
