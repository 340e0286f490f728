package org.SEAR.project.models;

import com.jme3.asset.AssetManager;
import com.jme3.asset.DesktopAssetManager;
import com.jme3.asset.ModelKey;
import com.jme3.asset.plugins.ClasspathLocator;
import com.jme3.asset.plugins.FileLocator;
import com.jme3.math.Vector3f;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial;
import com.jme3.scene.VertexBuffer;
import com.jme3.scene.mesh.IndexBuffer;
import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.SEAR.POJOs.Model;
import org.SEAR.geometry.Triangles;

/**
 * Loads models with jMonkeyEngine's loaders, without a display. The geometry that the physics and the beams get and the scene that a window shows
 * come from the same file and stand in the same frame. One thread at a time.
 */
public final class ModelLoader {
    /** The endings of the files that can be loaded. */
    public static final List<String> ENDINGS = List.of(".mesh.xml", ".j3o", ".obj", ".gltf", ".glb", ".blend");

    private final Assets assets;
    private final AssetManager manager;

    /** For the models of a project. */
    public ModelLoader(Assets assets) {
        this.assets = assets;
        this.manager = assetManager(assets);
    }

    /** Whether a path names a model by its ending. */
    public static boolean isModel(String path) {
        String lower = path.toLowerCase(Locale.ROOT);
        return ENDINGS.stream().anyMatch(lower::endsWith);
    }

    /** An asset manager that finds the project's assets, those that come with SEAR, and jMonkeyEngine's own; all model formats are registered. */
    public static AssetManager assetManager(Assets assets) {
        DesktopAssetManager manager = new DesktopAssetManager(ModelLoader.class.getResource("models.cfg"));
        prepare(manager, assets);
        return manager;
    }

    /** Lets an asset manager find the project's assets and those that come with SEAR, and load models without trusting them. */
    public static void prepare(AssetManager manager, Assets assets) {
        if (Files.isDirectory(assets.getFolder())) {
            manager.registerLocator(assets.getFolder().toString(), FileLocator.class);
        }
        manager.registerLocator(Assets.SHIPPED, ClasspathLocator.class);
        GuardedLoaders.register(manager);
    }

    /**
     * The scene of a model in its own frame, metres, before the object's scale and pose. A terrain is moved so that its centre is the origin.
     *
     * @throws IOException that names the object, the file and what is wrong with it
     */
    public Spatial spatial(Model model) throws IOException {
        Spatial loaded = load(model);
        if (!model.isTerrain()) {
            return loaded;
        }
        Node moved = new Node(model.getName());
        moved.attachChild(loaded);
        loaded.move(Terrain.toOrigin(collect(loaded)));
        return moved;
    }

    /**
     * The triangles of a model in its own frame, with the transforms of its nodes applied: metres, before the object's scale and pose. A terrain is
     * moved so that its centre is the origin.
     *
     * @throws IOException that names the object, the file and what is wrong with it
     */
    public Triangles triangles(Model model) throws IOException {
        Triangles triangles = collect(spatial(model));
        if (triangles.size() == 0) {
            throw new IOException(model + ": " + model.getPath() + " has no triangles");
        }
        return triangles;
    }

    private Spatial load(Model model) throws IOException {
        String path = Assets.normal(model.getPath());
        if (!isModel(path) || !assets.has(path)) {
            throw new IOException(model + ": path is \"" + model.getPath() + "\", legal: a file below assets that ends with one of "
                + String.join(", ", ENDINGS));
        }
        try {
            return manager.loadModel(new ModelKey(path)).clone();
        } catch (RuntimeException | OutOfMemoryError | StackOverflowError e) {
            throw new IOException(model + ": " + model.getPath() + " can't be loaded: " + reasons(e), e);
        }
    }

    private static String reasons(Throwable failure) {
        StringBuilder text = new StringBuilder(String.valueOf(failure.getMessage()));
        for (Throwable cause = failure.getCause(); cause != null; cause = cause.getCause()) {
            text.append(": ").append(cause.getMessage());
        }
        return text.toString();
    }

    static Triangles collect(Spatial scene) {
        List<Geometry> geometries = new ArrayList<>();
        scene.depthFirstTraversal(spatial -> {
            if (spatial instanceof Geometry && ((Geometry) spatial).getMesh().getTriangleCount() > 0
                && isSolid(((Geometry) spatial).getMesh())) {
                geometries.add((Geometry) spatial);
            }
        });
        int vertices = 0;
        int triangles = 0;
        for (Geometry geometry : geometries) {
            vertices += geometry.getMesh().getVertexCount();
            triangles += geometry.getMesh().getTriangleCount();
        }
        float[] positions = new float[vertices * 3];
        int[] indices = new int[triangles * 3];
        int vertex = 0;
        int index = 0;
        for (Geometry geometry : geometries) {
            index = addTriangles(geometry.getMesh(), vertex, indices, index);
            vertex = addVertices(geometry, positions, vertex);
        }
        return new Triangles(positions, indices);
    }

    private static boolean isSolid(Mesh mesh) {
        switch (mesh.getMode()) {
            case Triangles:
            case TriangleStrip:
            case TriangleFan:
                return mesh.getBuffer(VertexBuffer.Type.Position) != null;
            default:
                return false;
        }
    }

    private static int addTriangles(Mesh mesh, int firstVertex, int[] indices, int start) {
        IndexBuffer source = mesh.getIndicesAsList();
        int at = start;
        for (int i = 0; i < mesh.getTriangleCount() * 3; i++) {
            indices[at++] = firstVertex + source.get(i);
        }
        return at;
    }

    private static int addVertices(Geometry geometry, float[] positions, int firstVertex) {
        geometry.computeWorldMatrix();
        Vector3f point = new Vector3f();
        VertexBuffer buffer = geometry.getMesh().getBuffer(VertexBuffer.Type.Position);
        int count = geometry.getMesh().getVertexCount();
        for (int i = 0; i < count; i++) {
            for (int axis = 0; axis < 3; axis++) {
                point.set(axis, ((Number) buffer.getElementComponent(i, axis)).floatValue());
            }
            geometry.getWorldMatrix().mult(point, point);
            positions[(firstVertex + i) * 3] = point.x;
            positions[(firstVertex + i) * 3 + 1] = point.y;
            positions[(firstVertex + i) * 3 + 2] = point.z;
        }
        return firstVertex + count;
    }
}
