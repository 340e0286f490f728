// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import com.jme3.asset.AssetManager;
import com.jme3.asset.ModelKey;
import com.jme3.asset.plugins.ClasspathLocator;
import com.jme3.asset.plugins.FileLocator;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial;
import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import org.SEAR.POJOs.Model;
import org.SEAR.files.Assets;
import org.SEAR.files.FileLimits;
import org.SEAR.files.InvalidFile;
import org.SEAR.files.LongWork;
import org.SEAR.geometry.Triangles;
import org.SEAR.project.models.format.ModelLimits;

/**
 * Loads models with jMonkeyEngine's loaders, without a display. The geometry for physics and beams and the scene for a
 * window come from the same file and have the same frame. One thread at a time.
 */
public final class ModelLoader {
    /** Endings of the supported files. */
    public static final List<String> ENDINGS = List.of(".mesh.xml", ".j3o", ".obj", ".gltf", ".glb", ".stl",
        ".ply", ".dae", ".blend");
    /** Says how to use a file of another format. */
    public static final String CONVERT = "; convert other formats with Blender or MeshLab, STEP and other CAD files "
        + "with FreeCAD";

    private static final String BLENDER = "a whole file of Blender 2.49 to 2.79: export it as .glb";

    private final Assets assets;
    private final ModelAssets manager;
    private final boolean pixels;
    private final Consumer<String> warnings;

    /** Creates a loader for the models of a project, with their pictures. */
    public ModelLoader(Assets assets) {
        this(assets, true, unheard -> { });
    }

    private ModelLoader(Assets assets, boolean pixels, Consumer<String> warnings) {
        this.assets = assets;
        this.pixels = pixels;
        this.warnings = warnings;
        this.manager = new ModelAssets(ModelLoader.class.getResource("models.cfg"));
        prepare(manager, assets, pixels);
    }

    /**
     * Creates a loader for triangles only, which checks pictures but does not unpack them.
     *
     * @param warnings receives messages about parts that can't be shown
     */
    public static ModelLoader withoutPictures(Assets assets, Consumer<String> warnings) {
        return new ModelLoader(assets, false, warnings);
    }

    /** Returns the assets that models are loaded from. */
    public Assets getAssets() {
        return assets;
    }

    /** Returns whether the path has the ending of a model. */
    public static boolean isModel(String path) {
        String lower = path.toLowerCase(Locale.ROOT);
        return ENDINGS.stream().anyMatch(lower::endsWith);
    }

    /**
     * Prepares an asset manager: it finds the project's assets and those that come with SEAR, and loads models without
     * trusting them.
     */
    public static void prepare(AssetManager manager, Assets assets) {
        prepare(manager, assets, true);
    }

    private static void prepare(AssetManager manager, Assets assets, boolean pixels) {
        if (Files.isDirectory(assets.getFolder())) {
            manager.registerLocator(assets.getFolder().toString(), FileLocator.class);
        }
        manager.registerLocator(Assets.SHIPPED, ClasspathLocator.class);
        manager.registerLocator("", MadePictureLocator.class);
        GuardedLoaders.register(manager, pixels);
    }

    /**
     * Returns the scene of a model in its own frame, metres, before the object's scale and pose. The centre of a
     * terrain is moved to the origin.
     *
     * @throws IOException that names the object, the file and the problem
     */
    public Spatial spatial(Model model) throws IOException {
        Spatial loaded = load(model);
        if (!model.isTerrain()) {
            return loaded;
        }
        Node moved = new Node(model.getName());
        moved.attachChild(loaded);
        loaded.move(TerrainCentre.toOrigin(collect(loaded, model)));
        return moved;
    }

    /**
     * Returns the triangles of a model in its own frame with the transforms of its nodes applied, metres, before the
     * object's scale and pose. The centre of a terrain is moved to the origin. A loader without pictures caches the
     * triangles.
     *
     * @throws IOException that names the object, the file and the problem
     */
    public Triangles triangles(Model model) throws IOException {
        if (pixels) {
            return read(model).triangles;
        }
        requireFile(model);
        String key = KnownModels.key(model, assets);
        KnownModels models = KnownModels.of(assets);
        KnownModels.Known known = models.get(key);
        if (known == null) {
            known = read(model);
            models.put(key, known);
        }
        known.leftOut.forEach(text -> warnings.accept("model " + model.getPath() + ": " + text));
        String scale = ModelScale.warning(model, known.triangles);
        if (scale != null) {
            warnings.accept("model " + model.getPath() + ": " + scale);
        }
        return known.triangles;
    }

    private KnownModels.Known read(Model model) throws IOException {
        manager.takeLeftOut();
        Triangles triangles = collect(spatial(model), model);
        if (triangles.size() == 0) {
            throw new IOException(model + ": " + FileLimits.wrong(model.getPath(), "the number of triangles",
                "0: it has no triangles", "1 to " + ModelLimits.MAX_TRIANGLES).getMessage());
        }
        return new KnownModels.Known(triangles, manager.takeLeftOut());
    }

    /**
     * Returns the appearance of the model's triangles; for a loader with pictures.
     *
     * @throws IOException that names the object, the file and the problem
     */
    public ModelAppearance look(Model model) throws IOException {
        Spatial scene = spatial(model);
        return onEngineThread(model, () ->
            ModelAppearance.of(SceneTriangles.solids(scene, model + ": " + model.getPath())));
    }

    private Spatial load(Model model) throws IOException {
        String path = requireFile(model);
        return onEngineThread(model, () -> manager.loadModel(new ModelKey(path)).clone());
    }

    private String requireFile(Model model) throws IOException {
        String path = Assets.normal(model.getPath());
        if (!isModel(path) || !assets.has(path)) {
            throw new IOException(model + ": path is \"" + model.getPath() + "\", legal: a file below assets that ends "
                + "with one of " + String.join(", ", ENDINGS) + CONVERT);
        }
        long size = assets.size(path);
        if (size > ModelLimits.MAX_FILE) {
            throw new IOException(model + ": " + model.getPath() + " has " + size + " bytes, legal: at most "
                + ModelLimits.MAX_FILE);
        }
        return path;
    }

    /** Returns the reason why a model can't be loaded: of this program, otherwise none of a library's own words. */
    private static IOException failure(Model model, Throwable e) {
        String reason = null;
        for (Throwable cause = e; cause != null && reason == null; cause = cause.getCause()) {
            reason = cause instanceof InvalidFile ? cause.getMessage() : null;
        }
        String path = model.getPath();
        String legal = path.toLowerCase(Locale.ROOT).endsWith(".blend") ? BLENDER : "a smaller or undamaged model";
        InvalidFile other = e instanceof Error
            ? FileLimits.wrong(path, "its need for memory or nesting", "too large", legal)
            : FileLimits.wrong(path, "its content", "damaged, or of an unknown kind", legal);
        String text = reason == null ? other.getMessage() : reason;
        return new IOException(model + ": " + path + " can't be loaded: " + text, e);
    }

    private static Triangles collect(Spatial scene, Model model) throws IOException {
        return onEngineThread(model, () -> SceneTriangles.of(scene, model + ": " + model.getPath()));
    }

    private static <T> T onEngineThread(Model model, Callable<T> work) throws IOException {
        try {
            return EngineThread.call(work, new LongWork("model " + model.getName() + ": reading " + model.getPath()));
        } catch (ExecutionException e) {
            throw failure(model, e.getCause());
        }
    }
}
