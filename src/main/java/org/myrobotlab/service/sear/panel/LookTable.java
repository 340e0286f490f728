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
import org.SEAR.POJOs.Shape;
import org.SEAR.files.Assets;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.simulator.Simulation;

/**
 * What shapes look like, for the panels' view in space. A world tells of each shape the number of its look, which shapes that look alike share, and
 * the path of its picture; a panel asks for those that it has not got yet, large looks in parts.
 *
 * <p>It knows the shapes of the last world that it was given, and no others. Any thread.
 */
final class LookTable {
    /** Triangles of a part. */
    static final int PART = 8000;
    /** Triangles of the finest look that is told; finer ones are drawn as the box around them. */
    static final int MAX_TRIANGLES = 400_000;
    /** Characters of an answer, more or less: MyRobotLab takes messages up to 1 MiB. */
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

    /** Forgets the shapes of another world than this. */
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
     * Says of a shape how it looks.
     *
     * @param inWorld that was begun
     */
    synchronized void add(WorldState.Thing thing, Shape shape, Simulation inWorld) {
        thing.look = known.computeIfAbsent(shape, one -> learn(inWorld.getSurface(one)));
        thing.picture = Optional.ofNullable(shape.getPicture());
        thing.picture.ifPresent(picture -> pictures.put(PICTURE + picture, picture));
    }

    private String learn(SurfaceMesh surface) {
        if (surface == null || surface.getIndices().length > CORNERS * MAX_TRIANGLES) {
            return "";
        }
        float[] positions = surface.getPositions();
        ByteBuffer all = ByteBuffer.allocate(BYTES_OF_A_VERTEX * positions.length / CORNERS + Integer.BYTES * surface.getIndices().length);
        all.asFloatBuffer().put(positions).put(surface.getNormals()).put(surface.getPictures());
        all.position(BYTES_OF_A_VERTEX * positions.length / CORNERS);
        all.asIntBuffer().put(surface.getIndices());
        String id = UUID.nameUUIDFromBytes(all.array()).toString();
        looks.put(id, surface);
        return id;
    }

    /**
     * The looks and pictures that a panel wants, as many as fit into a message, at least one if there is one.
     *
     * @param wanted keys; those that nothing is known of get no answer
     * @throws IllegalArgumentException if they aren't, as a page of somebody else's may send
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
                size += map.values().stream().mapToInt(value -> value instanceof String ? ((String) value).length() : 0).sum();
            }
        }
        return found;
    }

    /** Null for none. */
    private Part part(String key) {
        int slash = key.lastIndexOf('/');
        SurfaceMesh surface = slash < 0 ? null : looks.get(key.substring(0, slash));
        int part = surface == null || !key.substring(slash + 1).matches("\\d{1,4}") ? -1 : Integer.parseInt(key.substring(slash + 1));
        int parts = surface == null ? 0 : (surface.getIndices().length + CORNERS * PART - 1) / (CORNERS * PART);
        return part < 0 || part >= parts ? null : new Part(key, surface, part, parts);
    }

    /** A picture of a project. */
    private static final class PictureForm extends JsonForm {
        /** {@code picture textures/grass.png}. */
        final String key;
        /** {@code data:image/jpeg;base64,..}; none if it can't be read. */
        final Optional<String> data;
        /** Why it can't. */
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
        /** {@code 6f1e../0}: the look, and which part of it. */
        final String key;
        final int parts;
        /** Three a triangle. */
        final int vertices;
        /** The corner of the box around the whole look, {x, y, z}, metres; 0 in the positions. */
        final double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        /** The opposite corner; 65535 in the positions. */
        final double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        /** Base64 of 16 bits a coordinate, low byte first. */
        final String positions;
        /** Base64 of 8 bits a coordinate, 127 is 1. */
        final String normals;
        /** Where in the picture, 0 to 1: base64 of two floats a vertex, low byte first. */
        final String pictures;

        Part(String key, SurfaceMesh surface, int part, int parts) {
            this.key = key;
            this.parts = parts;
            int first = CORNERS * PART * part;
            int[] corners = surface.getIndices();    // copies, all of them: asked for once
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
                    at.putShort((short) Math.round(size > 0 ? (all[CORNERS * vertex + axis] - low[axis]) / size * FULL : 0));
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
