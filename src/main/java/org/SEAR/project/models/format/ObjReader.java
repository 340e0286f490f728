// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.jme3.asset.AssetInfo;
import com.jme3.asset.AssetKey;
import com.jme3.asset.AssetNotFoundException;
import com.jme3.material.Material;
import com.jme3.material.MaterialList;
import com.jme3.scene.Node;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.StringTokenizer;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.SEAR.files.FileLimits;
import org.SEAR.files.PrintableText;

/**
 * Reader of Wavefront models ("Object Files", Alias, 1995): positions, texture coordinates, normals, faces and
 * materials. A face without a known material is white. Lines and points have no surface. One use.
 */
public final class ObjReader {
    private static final byte[] MARK = {(byte) 0xef, (byte) 0xbb, (byte) 0xbf};
    /** Statements without effect on the surface. */
    private static final Set<String> IGNORED = Set.of("o", "g", "s", "mg", "l", "p", "vp", "lod", "bevel", "c_interp",
        "d_interp", "usemap",
        "maplib", "shadow_obj", "trace_obj");
    /** Statements that describe a surface without polygons, or one in another file. */
    private static final Set<String> SURFACES = Set.of("surf", "bzp", "bsp", "cdp", "call");
    /** Most unknown names in a warning. */
    private static final int LISTED = 5;
    private static final String DECIMALS = " numbers with decimal points";

    private final AssetInfo info;
    private final String name;
    private final byte[] bytes;
    private final Consumer<String> warnings;
    private int at;
    /** Line that {@link #next} returned last, and the one after it. */
    private int line;
    private int nextLine = 1;

    private final Numbers positions = new Numbers(3);
    private final Numbers places = new Numbers(2);
    private final Numbers normals = new Numbers(3);
    /** Corners of the current face. */
    private int[] ring = new int[16];
    private int[] ringPlaces = new int[16];
    private int[] ringNormals = new int[16];
    private final PolygonSplitter splitter;
    /** By the name of their material; empty for white. */
    private final Map<String, MeshPart> parts = new LinkedHashMap<>();
    private MeshPart part;
    private String material = "";
    private final Map<String, Material> materials = new LinkedHashMap<>();
    private boolean hasLibrary;
    private final Set<String> unknown = new TreeSet<>();
    private long vertices;
    private int strange;
    private String firstStrange;

    /** @param warnings receives each reason why the model is not shown as its file says */
    public ObjReader(AssetInfo info, byte[] bytes, Consumer<String> warnings) {
        this.info = info;
        this.name = info.getKey().getName();
        this.bytes = bytes;
        this.warnings = warnings;
        splitter = new PolygonSplitter(name, "the face in line ");
    }

    /** Growing list of numbers in groups. */
    private static final class Numbers {
        private final int size;
        private float[] values;
        private int count;

        Numbers(int size) {
            this.size = size;
            values = new float[64 * size];
        }

        int next() {
            if (size * (count + 1) > values.length) {
                values = Arrays.copyOf(values, 2 * values.length);
            }
            return size * count++;
        }
    }

    /**
     * Returns the model, a mesh for each material.
     *
     * @throws IOException that names the line, the value and the legal values
     */
    public Node read() throws IOException {
        at = bytes.length >= MARK.length && Arrays.equals(MARK, Arrays.copyOf(bytes, MARK.length)) ? MARK.length : 0;
        for (String text = next(); text != null; text = next()) {
            StringTokenizer words = new StringTokenizer(text);
            if (words.hasMoreTokens()) {
                statement(words.nextToken(), words, text);
            }
        }
        Node node = new Node(name);
        for (Map.Entry<String, MeshPart> each : parts.entrySet()) {
            SolidMesh mesh = each.getValue().mesh(positions.values, places.values, normals.values);
            node.attachChild(SolidMesh.geometry(each.getKey(), mesh.mesh(), materialOf(each.getKey())));
        }
        warn();
        return node;
    }

    private void warn() {
        if (!unknown.isEmpty()) {
            List<String> first = new ArrayList<>(unknown).subList(0, Math.min(LISTED, unknown.size()));
            warnings.accept("its .mtl has no material " + String.join(", ", first) + (unknown.size() > LISTED ? ", ..."
                : "") + "; these faces are white");
        }
        splitter.warn(warnings);
        if (strange > 0) {
            warnings.accept(strange + " lines are no statements of an .obj and left out, first line " + firstStrange);
        }
    }

    /** Returns a line with its continuations; null at the end. */
    private String next() throws IOException {
        line = nextLine;
        StringBuilder whole = null;
        while (at < bytes.length) {
            int end = at;
            while (end < bytes.length && bytes[end] != '\n' && bytes[end] != '\r') {
                end++;
            }
            FileLimits.range(name, "the number of characters of line " + line, end - at + (whole == null ? 0
                : whole.length()), 0,
                ModelLimits.MAX_LINE);
            boolean continued = end > at && bytes[end - 1] == '\\' && end < bytes.length;
            String text = new String(bytes, at, (continued ? end - 1 : end) - at, StandardCharsets.ISO_8859_1);
            at = end + (end + 1 < bytes.length && bytes[end] == '\r' && bytes[end + 1] == '\n' ? 2 : 1);
            nextLine++;
            if (!continued) {
                return whole == null ? text : whole.append(text).toString();
            }
            whole = (whole == null ? new StringBuilder() : whole).append(text).append(' ');
        }
        return whole == null ? null : whole.toString();
    }

    private void statement(String word, StringTokenizer words, String text) throws IOException {
        switch (word) {
            case "v":
                addNumbers(positions, 3, words, text, "v and three" + DECIMALS);
                break;
            case "vt":
                addNumbers(places, 1, words, text, "vt and one to three" + DECIMALS);
                break;
            case "vn":
                addNumbers(normals, 3, words, text, "vn and three" + DECIMALS);
                break;
            case "f":
            case "fo":
                face(words);
                break;
            case "usemtl":
                material = text.trim().substring(word.length()).trim();
                part = null;
                break;
            case "mtllib":
                library(text.trim().substring(word.length()).trim());
                break;
            default:
                if (SURFACES.contains(word)) {
                    throw FileLimits.wrong(name, "line " + line, text.trim(),
                        "polygons in this file: export the model as a mesh");
                }
                if (!word.startsWith("#") && !IGNORED.contains(word) && strange++ == 0) {
                    firstStrange = line + ": " + PrintableText.line(text.trim());
                }
        }
    }

    private void addNumbers(Numbers to, int least, StringTokenizer words, String text,
        String legal) throws IOException {
        FileLimits.range(name, "the number of " + text.trim().split("\\s", 2)[0] + " lines up to line " + line, to.count
            + 1L, 0,
            ModelLimits.MAX_TRIANGLES);
        int first = to.next();
        for (int i = 0; i < to.size; i++) {
            String word = words.hasMoreTokens() ? words.nextToken() : "";
            if (i < least || !word.isEmpty() && word.charAt(0) != '#') {
                to.values[first + i] = number(word, text, legal);
            }
        }
    }

    private float number(String word, String text, String legal) throws IOException {
        try {
            return Float.parseFloat(word);
        } catch (NumberFormatException e) {
            throw FileLimits.wrong(name, "line " + line, text.trim(), legal);
        }
    }

    private void face(StringTokenizer words) throws IOException {
        int corners = 0;
        while (words.hasMoreTokens()) {
            String word = words.nextToken();
            if (word.charAt(0) == '#') {
                break;
            }
            if (corners == ring.length) {
                ring = Arrays.copyOf(ring, 2 * corners);
                ringPlaces = Arrays.copyOf(ringPlaces, 2 * corners);
                ringNormals = Arrays.copyOf(ringNormals, 2 * corners);
            }
            corner(word, corners++);
        }
        if (corners < 3) {
            return;     // has no surface
        }
        addTriangles(splitter.split(positions.values, ring, corners, line), splitter.made());
    }

    private void addTriangles(int[] corners, int count) throws IOException {
        part = part == null ? parts.computeIfAbsent(material, key -> new MeshPart()) : part;
        FileLimits.range(name, "the number of materials up to line " + line, parts.size(), 0,
            ModelLimits.MAX_NODES - 1);
        for (int i = 0; i < count; i++) {
            vertices += part.add(ring[corners[i]], ringPlaces[corners[i]], ringNormals[corners[i]]) ? 1 : 0;
        }
        FileLimits.range(name, "the number of vertices up to line " + line, vertices, 0, ModelLimits.MAX_TRIANGLES);
    }

    /** Reads a corner: a position, which texture coordinates and a normal may follow, as 1/2/3 or 1//3. */
    private void corner(String word, int to) throws IOException {
        int slash = word.indexOf('/');
        int second = slash < 0 ? -1 : word.indexOf('/', slash + 1);
        String place = slash < 0 ? "" : word.substring(slash + 1, second < 0 ? word.length() : second);
        String normal = second < 0 ? "" : word.substring(second + 1);
        ring[to] = index(slash < 0 ? word : word.substring(0, slash), word, "v", positions.count);
        ringPlaces[to] = place.isEmpty() ? -1 : index(place, word, "vt", places.count);
        ringNormals[to] = normal.isEmpty() ? -1 : index(normal, word, "vn", normals.count);
        for (int axis = 0; axis < 3; axis++) {
            float value = positions.values[3 * ring[to] + axis];
            if (!(Math.abs(value) <= ModelLimits.MAX_COORDINATE)) {
                throw FileLimits.wrong(name, "a coordinate of v " + (ring[to] + 1) + " in the face in line " + line,
                    value,
                    "a finite number up to " + (int) ModelLimits.MAX_COORDINATE + " m from the model's origin");
            }
        }
    }

    private int index(String text, String word, String kind, int count) throws IOException {
        int value;
        try {
            value = Integer.parseInt(text);
        } catch (NumberFormatException e) {
            value = 0;
        }
        if (value == 0 || value > count || value < -count) {
            throw FileLimits.wrong(name, "a corner of the face in line " + line, word, count == 0
                ? "none, for there is no " + kind
                + " line before it" : "the number of a " + kind + " line before it, 1 to " + count);
        }
        return value > 0 ? value - 1 : count + value;
    }

    /** Reads the materials of a library beside the model; if it can't be read, the asset manager warns. */
    private void library(String given) {
        for (String file : given.split("(?i)(?<=\\.mtl)\\s+")) {
            if (!file.matches("(?is).*[^/\\\\]\\.mtl")) {
                warnings.accept("its materials \"" + PrintableText.line(file)
                    + "\" are left out: their file is no .mtl");
                continue;
            }
            String base = file.substring(Math.max(file.lastIndexOf('/'), file.lastIndexOf('\\')) + 1);
            try {
                MaterialList list = info.getManager().loadAsset(new AssetKey<MaterialList>(info.getKey().getFolder()
                    + base));
                list.forEach(materials::putIfAbsent);
                hasLibrary = true;
            } catch (AssetNotFoundException e) {
                continue;
            }
        }
    }

    private Material materialOf(String of) {
        Material known = materials.getOrDefault(of, materials.get(of.split("\\s", 2)[0]));
        if (known != null) {
            return known;
        }
        if (!of.isEmpty() && hasLibrary) {
            unknown.add(PrintableText.line(of));
        }
        return SolidMesh.white(info.getManager());
    }
}
