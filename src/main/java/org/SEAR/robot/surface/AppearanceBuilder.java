// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.surface;

import java.io.IOException;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.function.Consumer;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Sphere;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Wheel;
import org.SEAR.camera.BallAppearance;
import org.SEAR.camera.BoxAppearance;
import org.SEAR.camera.Daylight;
import org.SEAR.camera.GroundAppearance;
import org.SEAR.camera.MeshAppearance;
import org.SEAR.camera.Paint;
import org.SEAR.camera.PlainAppearance;
import org.SEAR.camera.RoundAppearance;
import org.SEAR.camera.Appearance;
import org.SEAR.camera.Texture;
import org.SEAR.files.Assets;
import org.SEAR.physics.solid.BoxSolid;
import org.SEAR.physics.solid.Solid;
import org.SEAR.physics.solid.Solids;
import org.SEAR.project.models.ModelLoader;
import org.SEAR.project.models.ModelAppearance;
import org.SEAR.terrain.Ground;
import org.SEAR.terrain.TerrainColors;
import org.SEAR.terrain.relief.GroundPicture;
import org.SEAR.terrain.relief.Relief;

/**
 * Appearance of objects and robot parts to cameras: the same pictures, colours and picture mapping as in the window. It
 * is made when a camera first looks. SEAR warns once of an unreadable file and shows the object's colour. Simulation
 * thread.
 */
final class AppearanceBuilder {
    /** Colours of a wheel without its own colour or picture, and of its spokes. */
    private static final int TYRE = 0x212124;
    private static final int SPOKE = 0xbfc2c7;
    /** Pixels of the longer side of a terrain's picture, and pixels between two posts. */
    private static final int LONGEST = 1024;
    private static final int PER_POST = 3;

    private final Assets assets;
    private final Consumer<String> reported;
    private final Map<Solid, Shape> shapes = new IdentityHashMap<>();
    private final Map<Solid, Ground> grounds = new IdentityHashMap<>();
    private final Map<Solid, Appearance> known = new IdentityHashMap<>();
    private final Map<String, Paint> pictures = new HashMap<>();
    private final SurfacePictures files;

    AppearanceBuilder(Assets assets, SurfacePictures files, Consumer<String> told) {
        this.assets = assets;
        this.files = files;
        this.reported = told;
    }

    /** @param ground of a terrain; null for others */
    void add(Shape shape, Solid solid, Ground ground) {
        shapes.put(solid, shape);
        if (ground != null) {
            grounds.put(solid, ground);
        }
    }

    /** Returns the appearance, never null. */
    Appearance of(Solid solid) {
        return known.computeIfAbsent(solid, this::make);
    }

    private Appearance make(Solid solid) {
        Shape shape = shapes.get(solid);
        if (shape == null) {
            return new PlainAppearance(SurfaceColors.GREY, Shape.AMBIENT);
        }
        double temperature = shape.getTemperature() == null ? Shape.AMBIENT : shape.getTemperature();
        double[] half = {solid.halfX, solid.halfY, solid.halfZ};
        if (shape instanceof Wheel) {
            Paint tyre = shape.getImage() == null && !shape.hasColor() ? Paint.of(TYRE) : paint(shape);
            return new RoundAppearance(half, false, tyre, Paint.of(SPOKE), temperature);
        }
        if (shape instanceof Cylinder || shape instanceof Cone) {
            return new RoundAppearance(half, shape instanceof Cone, paint(shape), null, temperature);
        }
        if (shape instanceof Sphere) {
            return new BallAppearance(half, paint(shape), temperature);
        }
        if (shape instanceof Model) {
            return model((Model) shape, temperature);
        }
        if (shape instanceof Terrain) {
            return ground((Terrain) shape, grounds.get(solid), temperature);
        }
        return solid instanceof BoxSolid ? new BoxAppearance(Solids.look(solid, shape), half, paint(shape), temperature,
            !shape.isGround()) : new PlainAppearance(SurfaceColors.plain(shape), temperature);
    }

    /** Returns the picture or the colour of a shape. */
    private Paint paint(Shape shape) {
        Paint picture = shape.getPicture() == null ? null : pictures.computeIfAbsent(shape.getPicture(), this::read);
        return picture == null ? Paint.of(SurfaceColors.plain(shape)) : picture;
    }

    private Paint read(String path) {
        SurfacePicture picture = files.get(path);
        return picture == null ? null : Paint.of(picture.texture());
    }

    private Appearance model(Model model, double temperature) {
        double[] scale = {model.getScaleX(), model.getScaleY(), model.getScaleZ()};
        boolean own = model.getPicture() == null && !model.hasColor();
        try {
            ModelLoader loader = new ModelLoader(assets);
            ModelAppearance look = loader.look(model);
            Paint[] paints = look.materials.stream().map(AppearanceBuilder::paint).toArray(Paint[]::new);
            return new MeshAppearance(loader.triangles(model), scale, look.normals, look.places,
                own ? look.colors : null, own ? look.materialOf : null,
                own ? paints : new Paint[] {paint(model)}, temperature, !model.isTerrain());
        } catch (IOException e) {
            reported.accept("cameras see a model only in its colour: " + e.getMessage());
            return new PlainAppearance(SurfaceColors.plain(model), temperature);
        }
    }

    private static Paint paint(ModelAppearance.Surface surface) {
        return surface.width == 0 ? Paint.of(surface.pixels[0])
            : Paint.of(new Texture(surface.width, surface.height, surface.pixels, true));
    }

    private Appearance ground(Terrain terrain, Ground ground, double temperature) {
        GroundPicture.Colors colors = null;
        try {
            colors = TerrainColors.of(terrain, assets, ground);
        } catch (IOException e) {
            reported.accept("cameras can't read the terrain's picture: " + e.getMessage());
        }
        Relief relief = new Relief(ground.field, LONGEST, PER_POST, ground.spacing);
        return new GroundAppearance(ground.heights, GroundPicture.landscape(relief, Daylight.onLandscape(), colors),
            temperature);
    }
}
