package org.myrobotlab.service.sear.panel;

import java.io.IOException;
import java.lang.ref.WeakReference;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.SurfaceMesh;
import org.SEAR.project.models.Assets;
import org.SEAR.simulator.Simulation;

/**
 * What shapes look like, for the panels' view in space. A world tells of each shape the number of its look, which shapes that look alike share, and
 * the path of its picture; a panel asks for those that it has not got yet, large looks in parts.
 *
 * <pre>
 * {"key": "6f1e../0", "parts": 1, "vertices": 36 (three a triangle), "low": [x, y, z], "high": [x, y, z] (of the whole look, metres),
 *  "positions": ".." (base64 of 16 bits a coordinate, low byte first: 0 is low, 65535 high),
 *  "normals": ".." (base64 of 8 bits a coordinate, 127 is 1), "pictures": ".." (base64 of two floats a vertex, low byte first)}
 * {"key": "picture textures/grass.png", "data": "data:image/jpeg;base64,..", "problem": null}
 * </pre>
 *
 * <p>It knows the shapes of the last world that it was given, and no others. Any thread.
 */
final class Looks {
    /** Triangles of a part. */
    static final int PART = 8000;
    /** Triangles of the finest look that is told; finer ones are drawn as the box around them. */
    static final int MOST_TRIANGLES = 400_000;
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
     * Puts into a shape's map how it looks.
     *
     * @param inWorld that was begun
     */
    synchronized void add(Map<String, Object> map, Shape shape, Simulation inWorld) {
        map.put("look", known.computeIfAbsent(shape, one -> learn(inWorld.getSurface(one))));
        String picture = shape.getPicture();
        map.put("picture", picture);
        if (picture != null) {
            pictures.put(PICTURE + picture, picture);
        }
    }

    private String learn(SurfaceMesh surface) {
        if (surface == null || surface.getIndices().length > CORNERS * MOST_TRIANGLES) {
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
            Map<String, Object> one = pictures.containsKey(key) ? picture(key) : look(key);
            if (!one.isEmpty()) {
                found.add(one);
                size += one.values().stream().mapToInt(value -> value instanceof String ? ((String) value).length() : 0).sum();
            }
        }
        return found;
    }

    private Map<String, Object> picture(String key) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("key", key);
        try {
            map.put("data", SmallPicture.of(assets.readPicture(pictures.get(key)), pictures.get(key)));
        } catch (IOException e) {
            map.put("data", null);
            map.put("problem", e.getMessage());
        }
        return map;
    }

    private Map<String, Object> look(String key) {
        int slash = key.lastIndexOf('/');
        SurfaceMesh surface = slash < 0 ? null : looks.get(key.substring(0, slash));
        int part = surface == null || !key.substring(slash + 1).matches("\\d{1,4}") ? -1 : Integer.parseInt(key.substring(slash + 1));
        int parts = surface == null ? 0 : (surface.getIndices().length + CORNERS * PART - 1) / (CORNERS * PART);
        return part < 0 || part >= parts ? Collections.emptyMap() : look(key, surface, part, parts);
    }

    private static Map<String, Object> look(String key, SurfaceMesh surface, int part, int parts) {
        float[] positions = surface.getPositions();
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int i = 0; i < positions.length; i++) {
            low[i % CORNERS] = Math.min(low[i % CORNERS], positions[i]);
            high[i % CORNERS] = Math.max(high[i % CORNERS], positions[i]);
        }
        int[] indices = surface.getIndices();
        int first = CORNERS * PART * part;
        int count = Math.min(indices.length - first, CORNERS * PART);
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("key", key);
        map.put("parts", parts);
        map.put("vertices", count);
        map.put("low", low);
        map.put("high", high);
        addVertices(map, surface, first, count);
        return map;
    }

    private static void addVertices(Map<String, Object> map, SurfaceMesh surface, int first, int count) {
        int[] indices = surface.getIndices();
        float[] positions = surface.getPositions();
        float[] normals = surface.getNormals();
        float[] places = surface.getPictures();
        double[] low = (double[]) map.get("low");
        double[] high = (double[]) map.get("high");
        ByteBuffer at = ByteBuffer.allocate(CORNERS * Short.BYTES * count).order(ByteOrder.LITTLE_ENDIAN);
        ByteBuffer outward = ByteBuffer.allocate(CORNERS * count);
        ByteBuffer picture = ByteBuffer.allocate(2 * Float.BYTES * count).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = first; i < first + count; i++) {
            for (int axis = 0; axis < CORNERS; axis++) {
                double size = high[axis] - low[axis];
                at.putShort((short) Math.round(size > 0 ? (positions[CORNERS * indices[i] + axis] - low[axis]) / size * FULL : 0));
                outward.put((byte) Math.round(normals[CORNERS * indices[i] + axis] * UNIT));
            }
            picture.putFloat(places[2 * indices[i]]).putFloat(places[2 * indices[i] + 1]);
        }
        map.put("positions", Base64.getEncoder().encodeToString(at.array()));
        map.put("normals", Base64.getEncoder().encodeToString(outward.array()));
        map.put("pictures", Base64.getEncoder().encodeToString(picture.array()));
    }
}
