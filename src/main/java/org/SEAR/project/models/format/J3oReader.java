// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.jme3.asset.AssetInfo;
import com.jme3.export.Savable;
import com.jme3.export.binary.BinaryImporter;
import com.jme3.material.Material;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.SEAR.files.FileLimits;

/** Reader of jMonkeyEngine's .j3o, after {@link J3oCheck}. */
public final class J3oReader {
    /** Logs a stack trace of each object that it leaves out. */
    private static final Logger LOG = Logger.getLogger(BinaryImporter.class.getName());
    private static final String WHOLE = "a scene as jMonkeyEngine 3.6 writes it: export the model again, or as .glb";

    static {
        LOG.setLevel(Level.OFF);
    }

    private J3oReader() {
    }

    /**
     * Returns the model; a part whose material can't be read is white.
     *
     * @throws IOException that names the object, the value and the legal values
     */
    public static Spatial read(AssetInfo info, byte[] bytes) throws IOException {
        String file = info.getKey().getName();
        new J3oCheck(file, bytes).check();
        BinaryImporter importer = new BinaryImporter();
        importer.setAssetManager(info.getManager());
        Savable read = importer.load(new ByteArrayInputStream(bytes));
        if (!(read instanceof Spatial)) {
            throw FileLimits.wrong(file, "the first object", read == null ? "unreadable, or one inside it is" : "a "
                + read.getClass().getName(), WHOLE);
        }
        Deque<Spatial> waiting = new ArrayDeque<>();
        waiting.add((Spatial) read);
        for (int nodes = 0; !waiting.isEmpty(); nodes++) {
            FileLimits.range(file, "the number of nodes", nodes + 1L, 1, ModelLimits.MAX_NODES);
            Spatial next = waiting.removeLast();
            if (next instanceof Node) {
                for (Spatial child : ((Node) next).getChildren()) {
                    if (child == null || child.getParent() != next) {
                        throw FileLimits.wrong(file, "a child of the node " + next.getName(),
                            "unreadable, or of two nodes", WHOLE);
                    }
                    waiting.add(child);
                }
            } else if (next instanceof Geometry && ((Geometry) next).getMaterial() == null) {
                next.setMaterial(new Material(info.getManager(), "Common/MatDefs/Light/Lighting.j3md"));
            }
        }
        return (Spatial) read;
    }
}
