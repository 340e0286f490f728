// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.io.IOException;
import java.lang.ref.WeakReference;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.files.Assets;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.simulator.Simulation;

/**
 * Meshes and pictures of shapes for the panels' 3D view. A world lists for each shape the key of its look, which
 * identical shapes share, and the path of its picture. A panel requests those it lacks, large looks in parts.
 *
 * <p>Contains only shapes of the last world. Any thread.
 */
final class LookTable {
    /** Triangles per part. */
    static final int PART = 8000;
    /** Most triangles of a look; panels draw the bounding box of finer ones. */
    static final int MAX_TRIANGLES = 400_000;
    /** Approximate limit of an answer, characters; MyRobotLab accepts messages up to 1 MiB. */
    private static final int ENOUGH = 400_000;
    private static final String PICTURE = "picture ";
    private static final int CORNERS = 3;
    private static final int BYTES_OF_A_VERTEX = 32;
    private static final double FULL = 65535;
    private static final int UNIT = 127;

    private final Map<String, SurfaceMesh> looks = new HashMap<>();
    private final Map<String, String> pictures = new HashMap<>();
    private Map<Shape, String> known = new IdentityHashMap<>();
    private WeakReference<Simulation> world = new WeakReference<>(null);
    private Assets assets;

    /** Starts a world; forgets the shapes of another one. */
    synchronized void begin(Simulation newWorld) {
        if (newWorld != world.get()) {
            world = new WeakReference<>(newWorld);
            assets = newWorld.getProject().getAssets();
            looks.clear();
            pictures.clear();
            known = new IdentityHashMap<>();
        }
    }

    /**
     * Adds the look of an object with a surface.
     *
     * @param inWorld the world passed to {@link #begin}
     */
    synchronized void add(WorldState.Thing thing, SearObject object, Simulation inWorld) {
        if (!(object instanceof Shape)) {
            return;
        }
        Shape shape = (Shape) object;
        thing.look = known.computeIfAbsent(shape, one -> learn(inWorld.getSurface(one)));
        thing.picture = Optional.ofNullable(shape.getPicture());
        thing.picture.ifPresent(picture -> pictures.put(PICTURE + picture, picture));
    }

    private String learn(SurfaceMesh surface) {
        if (surface == null || surface.getIndices().length > CORNERS * MAX_TRIANGLES) {
            return "";
        }
        float[] positions = surface.getPositions();
        ByteBuffer all = ByteBuffer.allocate(BYTES_OF_A_VERTEX * positions.length / CORNERS
            + Integer.BYTES * surface.getIndices().length);
        all.asFloatBuffer().put(positions).put(surface.getNormals()).put(surface.getPictures());
        all.position(BYTES_OF_A_VERTEX * positions.length / CORNERS);
        all.asIntBuffer().put(surface.getIndices());
        String id = UUID.nameUUIDFromBytes(all.array()).toString();
        looks.put(id, surface);
        return id;
    }

    /**
     * Returns requested looks and pictures, as many as fit into a message but at least one.
     *
     * @param wanted keys; unknown ones get no answer
     * @throws IllegalArgumentException unless the keys are texts, as foreign pages may send anything
     */
    synchronized List<Map<String, Object>> of(List<String> wanted) {
        if (wanted == null || !((List<?>) wanted).stream().allMatch(String.class::isInstance)) {
            throw new IllegalArgumentException("the keys of looks are " + wanted + ", legal: a list of texts");
        }
        List<Map<String, Object>> found = new ArrayList<>();
        int size = 0;
        for (String key : wanted) {
            if (size > ENOUGH) {
                break;
            }
            JsonForm one = pictures.containsKey(key) ? new PictureForm(key, pictures.get(key), assets) : part(key);
            if (one != null) {
                Map<String, Object> map = one.map();
                found.add(map);
                size += map.values().stream().mapToInt(value -> value instanceof String ? ((String) value)
                    .length() : 0).sum();
            }
        }
        return found;
    }

    /** Returns a part; null if the key is unknown. */
    private Part part(String key) {
        int slash = key.lastIndexOf('/');
        SurfaceMesh surface = slash < 0 ? null : looks.get(key.substring(0, slash));
        int part = surface == null || !key.substring(slash + 1).matches("\\d{1,4}") ? -1
            : Integer.parseInt(key.substring(slash + 1));
        int parts = surface == null ? 0 : (surface.getIndices().length + CORNERS * PART - 1) / (CORNERS * PART);
        return part < 0 || part >= parts ? null : new Part(key, surface, part, parts);
    }

    /** A picture of a project. */
    private static final class PictureForm extends JsonForm {
        /** For example {@code picture textures/grass.png}. */
        final String key;
        /** {@code data:image/jpeg;base64,..}; empty if the picture can't be read. */
        final Optional<String> data;
        /** The reason why the picture can't be read. */
        final String problem;

        PictureForm(String key, String path, Assets assets) {
            this.key = key;
            String address = null;
            String why = null;
            try {
                address = SmallPicture.of(assets.readPicture(path), path);
            } catch (IOException e) {
                why = e.getMessage();
            }
            data = Optional.ofNullable(address);
            problem = why;
        }
    }

    /** A look, or a part of a large one. */
    private static final class Part extends JsonForm {
        /** For example {@code 6f1e../0}: the look and the number of its part. */
        final String key;
        final int parts;
        /** Number of vertices, three per triangle. */
        final int vertices;
        /** Lowest corner of the look's bounding box, {x, y, z}, metres; 0 in the positions. */
        final double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        /** Highest corner; 65535 in the positions. */
        final double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        /** Base64 of 16 bits per coordinate, low byte first. */
        final String positions;
        /** Base64 of 8 bits per coordinate, 127 means 1. */
        final String normals;
        /** Texture coordinates, 0 to 1: base64 of two floats per vertex, low byte first. */
        final String pictures;

        Part(String key, SurfaceMesh surface, int part, int parts) {
            this.key = key;
            this.parts = parts;
            int first = CORNERS * PART * part;
            int[] corners = surface.getIndices();    // these calls return copies: one call each
            float[] all = surface.getPositions();
            float[] directions = surface.getNormals();
            float[] places = surface.getPictures();
            vertices = Math.min(corners.length - first, CORNERS * PART);
            for (int i = 0; i < all.length; i++) {
                low[i % CORNERS] = Math.min(low[i % CORNERS], all[i]);
                high[i % CORNERS] = Math.max(high[i % CORNERS], all[i]);
            }
            ByteBuffer at = ByteBuffer.allocate(CORNERS * Short.BYTES * vertices).order(ByteOrder.LITTLE_ENDIAN);
            ByteBuffer outward = ByteBuffer.allocate(CORNERS * vertices);
            ByteBuffer picture = ByteBuffer.allocate(2 * Float.BYTES * vertices).order(ByteOrder.LITTLE_ENDIAN);
            for (int i = first; i < first + vertices; i++) {
                int vertex = corners[i];
                for (int axis = 0; axis < CORNERS; axis++) {
                    double size = high[axis] - low[axis];
                    at.putShort((short) Math.round(
                        size > 0 ? (all[CORNERS * vertex + axis] - low[axis]) / size * FULL : 0));
                    outward.put((byte) Math.round(directions[CORNERS * vertex + axis] * UNIT));
                }
                picture.putFloat(places[2 * vertex]).putFloat(places[2 * vertex + 1]);
            }
            positions = Base64.getEncoder().encodeToString(at.array());
            normals = Base64.getEncoder().encodeToString(outward.array());
            pictures = Base64.getEncoder().encodeToString(picture.array());
        }
    }
}
