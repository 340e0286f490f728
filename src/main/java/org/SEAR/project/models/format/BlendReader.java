// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.jme3.asset.AssetInfo;
import com.jme3.math.Matrix4f;
import com.jme3.math.Transform;
import com.jme3.math.Vector3f;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial;
import com.jme3.scene.VertexBuffer.Type;
import com.jme3.scene.plugins.blender.BlenderContext;
import com.jme3.scene.plugins.blender.BlenderContext.LoadedDataType;
import com.jme3.scene.plugins.blender.BlenderLoader;
import com.jme3.scene.plugins.blender.file.BlenderFileException;
import com.jme3.scene.plugins.blender.file.FileBlockHeader;
import com.jme3.scene.plugins.blender.file.FileBlockHeader.BlockCode;
import com.jme3.scene.plugins.blender.file.Pointer;
import com.jme3.scene.plugins.blender.file.Structure;
import com.jme3.scene.plugins.blender.meshes.MeshHelper;
import com.jme3.scene.plugins.blender.modifiers.ModifierHelper;
import com.jme3.scene.plugins.blender.objects.ObjectHelper;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.SEAR.files.FileLimits;
import org.SEAR.files.PrintableText;

/**
 * Reader of Blender files without links to other files, which could lie anywhere on the disk. Vertices get the exact
 * matrix of their object, which may shear; jMonkeyEngine's nodes can't. One use.
 */
public final class BlendReader extends BlenderLoader {
    /** Structure with the path of another file; jMonkeyEngine does not know its block code. */
    private static final String LIBRARY = "Library";
    /** Types of objects with a surface that jMonkeyEngine's loader does not read, and their names. */
    private static final Map<Integer, String> LEFT_OUT = Map.of(4, "text", 5, "metaball");
    private static final List<String> LISTS = List.of("modifiers", "defbase", "constraints", "base");
    /** Largest relative deviation of a node's matrix from its object's: rounding. */
    private static final float ROUNDING = 1e-5f;

    private final AssetInfo info;
    private final String file;
    private final Consumer<String> warnings;
    private BlenderContext context;

    /** @param warnings receives each reason why the model is not shown as its file says */
    public BlendReader(AssetInfo info, Consumer<String> warnings) {
        this.info = info;
        this.file = info.getKey().getName();
        this.warnings = warnings;
    }

    /**
     * Returns the model.
     *
     * @param bytes content of the file, unpacked
     * @throws IOException that names the block, the value and the legal values
     */
    public Spatial read(byte[] bytes) throws IOException {
        new BlendCheck(file, bytes).check();
        Spatial model = load(new AssetInfo(info.getManager(), info.getKey()) {
            @Override
            public InputStream openStream() {
                return new ByteArrayInputStream(bytes);
            }
        });
        try {
            correct(model);
        } catch (BlenderFileException e) {
            throw FileLimits.wrong(file, "an object's matrix", "damaged", "four rows of four numbers", e);
        }
        return model;
    }

    @Override
    protected BlenderContext setup(AssetInfo given) throws BlenderFileException {
        context = super.setup(given);
        given.getManager().unregisterLocator(given.getKey().getName(), LinkedContentLocator.class);
        String version = String.valueOf(context.getBlenderVersion());
        context.putHelper(MeshHelper.class, new BlendMeshes(version, context));
        context.putHelper(ModifierHelper.class, new BlendModifiers(version, context, file, warnings));
        for (FileBlockHeader block : blocks(BlockCode.BLOCK_UNKN)) {
            Structure data = block.getStructure(context);
            if (data != null && LIBRARY.equals(data.getType())) {
                throw new BlenderFileException("links", FileLimits.wrong(file, "its content",
                    "with links to other files",
                    "everything local: in Blender use File, Append instead of Link, or export .glb"));
            }
        }
        for (FileBlockHeader block : blocks(BlockCode.BLOCK_OB00)) {
            Structure object = block.getStructure(context);
            checkLists(object);
            int type = ((Number) object.getFieldValue("type")).intValue();
            if (LEFT_OUT.containsKey(type)) {
                warnings.accept("the " + LEFT_OUT.get(type) + " object " + PrintableText.line(object.getName())
                    + " is left out: convert it to a mesh in Blender");
            }
        }
        for (FileBlockHeader block : blocks(BlockCode.BLOCK_SC00)) {
            checkLists(block.getStructure(context));
        }
        return context;
    }

    private List<FileBlockHeader> blocks(BlockCode code) {
        List<FileBlockHeader> blocks = context.getFileBlocks(code);
        return blocks == null ? List.of() : blocks;
    }

    /** Throws for a list without end, which jMonkeyEngine's loader would follow forever. */
    private void checkLists(Structure of) throws BlenderFileException {
        for (String name : LISTS) {
            Object list = of.getFieldValue(name);
            Pointer next = list instanceof Structure ? (Pointer) ((Structure) list).getFieldValue("first") : null;
            long last = next == null ? 0 : ((Pointer) ((Structure) list).getFieldValue("last")).getOldMemoryAddress();
            long at = 0;
            for (int count = 0; at != last; count++) {
                if (count > ModelLimits.MAX_NODES || next.isNull()) {
                    throw new BlenderFileException("list", FileLimits.wrong(file, "the list " + name + " of "
                        + of.getName(), "longer than its end", "at most " + ModelLimits.MAX_NODES + " entries"));
                }
                at = next.getOldMemoryAddress();
                next = (Pointer) next.fetchData().get(0).getFlatFieldValue("next");
            }
        }
    }

    @Override
    protected void clear(AssetInfo given) {
        // setup has already removed the locator of linked files
    }

    /** Applies the matrices of objects to their vertices where the nodes' transforms differ. */
    private void correct(Spatial model) throws BlenderFileException {
        ObjectHelper objects = context.getHelper(ObjectHelper.class);
        Map<Spatial, Matrix4f> exact = new HashMap<>();
        for (FileBlockHeader block : blocks(BlockCode.BLOCK_OB00)) {
            Structure object = block.getStructure(context);
            Object node = context.getLoadedFeature(object.getOldMemoryAddress(), LoadedDataType.FEATURE);
            if (node instanceof Node) {
                exact.put((Node) node, objects.getMatrix(object, "obmat", context.getBlenderKey().isFixUpAxis()));
            }
        }
        List<Geometry> found = new ArrayList<>();
        model.depthFirstTraversal(spatial -> {
            if (spatial instanceof Geometry && exact.containsKey(spatial.getParent())) {
                found.add((Geometry) spatial);
            }
        });
        for (Geometry geometry : found) {
            Matrix4f right = exact.get(geometry.getParent()).mult(matrix(geometry.getLocalTransform()));
            Matrix4f shown = matrix(geometry.getWorldTransform());
            if (differ(right, shown)) {
                Mesh mesh = geometry.getMesh().deepClone();
                apply(right, mesh.getFloatBuffer(Type.Position));
                mesh.clearBuffer(Type.Normal);          // the triangles are shown flat
                mesh.updateBound();
                geometry.setMesh(mesh);
                geometry.setLocalTransform(new Transform());
                ((Node) model).attachChild(geometry);
            }
        }
    }

    private static Matrix4f matrix(Transform transform) {
        return transform.toTransformMatrix();
    }

    private static boolean differ(Matrix4f a, Matrix4f b) {
        float size = 0;
        float most = 0;
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                size = Math.max(size, Math.abs(a.get(row, column)));
                most = Math.max(most, Math.abs(a.get(row, column) - b.get(row, column)));
            }
        }
        return most > ROUNDING * size;
    }

    private static void apply(Matrix4f matrix, FloatBuffer positions) {
        Vector3f point = new Vector3f();
        for (int i = 0; i + 2 < positions.limit(); i += 3) {
            matrix.mult(point.set(positions.get(i), positions.get(i + 1), positions.get(i + 2)), point);
            positions.put(i, point.x).put(i + 1, point.y).put(i + 2, point.z);
        }
    }
}
