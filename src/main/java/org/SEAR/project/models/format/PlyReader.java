// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.jme3.asset.AssetInfo;
import com.jme3.asset.TextureKey;
import com.jme3.material.Material;
import com.jme3.scene.Node;
import java.io.IOException;
import java.util.Arrays;
import java.util.function.Consumer;
import org.SEAR.files.FileLimits;
import org.SEAR.project.models.format.PlyFile.Element;
import org.SEAR.project.models.format.PlyFile.Property;

/**
 * Reader of PLY models, text or binary (Turk, "The PLY Polygon File Format", Stanford, 1994): vertices with normals,
 * texture coordinates and colours, faces with colours, triangle strips. Other elements have no effect. One use.
 */
public final class PlyReader {
    private static final String[][] COLORS = {{"red", "diffuse_red", "r"}, {"green", "diffuse_green", "g"},
        {"blue", "diffuse_blue", "b"}, {"alpha", "diffuse_alpha", "a"}};
    private static final float FULL = 255;
    /** Most rows of an element without effect. */
    private static final long MAX_ROWS = 16L * ModelLimits.MAX_TRIANGLES;

    private final AssetInfo info;
    private final String name;
    private final byte[] bytes;
    private final Consumer<String> warnings;
    private final PolygonSplitter splitter;
    private PlyFile file;

    private float[] positions;
    private float[] normals;
    private float[] places;
    private float[] colors;
    private int[] indices = new int[3 * 64];
    private int count;
    /** Colour of each triangle, 0xAARRGGBB; null without colours of faces. */
    private int[] faceColors;
    private int[] ring = new int[16];

    /** @param warnings receives each reason why the model is not shown as its file says */
    public PlyReader(AssetInfo info, byte[] bytes, Consumer<String> warnings) {
        this.info = info;
        this.name = info.getKey().getName();
        this.bytes = bytes;
        this.warnings = warnings;
        splitter = new PolygonSplitter(name, "face ");
    }

    /**
     * Returns the model, one mesh.
     *
     * @throws IOException that names the line or the element, the value and the legal values
     */
    public Node read() throws IOException {
        file = new PlyFile(name, bytes);
        for (Element each : file.elements) {
            file.element = each.name;
            switch (each.name) {
                case "vertex":
                    vertices(each);
                    break;
                case "face":
                    faces(each);
                    break;
                case "tristrips":
                    strips(each);
                    break;
                default:
                    skip(each);
            }
        }
        splitter.warn(warnings);
        return node();
    }

    private Node node() {
        SolidMesh mesh = new SolidMesh(positions == null ? new float[0] : positions, Arrays.copyOf(indices, count));
        mesh.normals = normals;
        mesh.places = places;
        mesh.colors = colors;
        if (faceColors != null) {
            mesh = withFaceColors(mesh);
        }
        Material material = SolidMesh.white(info.getManager());
        if (mesh.colors != null) {
            material.setBoolean("UseVertexColor", true);
        }
        if (file.picture != null && mesh.places != null) {
            material.setTexture("DiffuseMap", info.getManager().loadTexture(new TextureKey(info.getKey().getFolder()
                + file.picture)));
        }
        Node node = new Node(name);
        node.attachChild(SolidMesh.geometry("faces", mesh.mesh(), material));
        return node;
    }

    /** Returns a mesh whose triangles share no vertices. */
    private SolidMesh withFaceColors(SolidMesh shared) {
        SolidMesh mesh = new SolidMesh(gathered(shared.positions, 3), new int[count]);
        mesh.normals = shared.normals == null ? null : gathered(shared.normals, 3);
        mesh.places = shared.places == null ? null : gathered(shared.places, 2);
        mesh.colors = new float[4 * count];
        for (int i = 0; i < count; i++) {
            mesh.indices[i] = i;
            for (int channel = 0; channel < 4; channel++) {
                mesh.colors[4 * i + channel] = (faceColors[i / 3] >>> 8 * channel & 0xff) / FULL;
            }
        }
        return mesh;
    }

    private float[] gathered(float[] values, int size) {
        float[] all = new float[size * count];
        for (int i = 0; i < count; i++) {
            System.arraycopy(values, size * indices[i], all, size * i, size);
        }
        return all;
    }

    private void vertices(Element vertex) throws IOException {
        FileLimits.range(name, "the number of vertices", vertex.count, 0, ModelLimits.MAX_TRIANGLES);
        if (positions != null) {
            throw FileLimits.wrong(name, "element vertex", "there twice", "one element of that name");
        }
        int total = (int) vertex.count;
        file.requireBytes(vertex);
        int[] place = {single(vertex, "x"), single(vertex, "y"), single(vertex, "z")};
        int[] normal = {vertex.index("nx"), vertex.index("ny"), vertex.index("nz")};
        int[] picture = {vertex.index("u", "s", "texture_u"), vertex.index("v", "t", "texture_v")};
        int[] color = colorsOf(vertex);
        positions = new float[3 * total];
        normals = room(normal, total);
        places = room(picture, total);
        colors = color == null ? null : new float[4 * total];
        double[] values = new double[vertex.properties.size()];
        for (file.row = 0; file.row < total; file.row++) {
            row(vertex, values);
            int i = (int) file.row;
            file.endRow();
            gather(values, place, positions, i);
            gather(values, normal, normals, i);
            gather(values, picture, places, i);
            for (int channel = 0; color != null && channel < 4; channel++) {
                colors[4 * i + channel] = channel(vertex, values, color[channel]) / FULL;
            }
        }
    }

    private int single(Element of, String property) throws IOException {
        int index = of.index(property);
        if (index < 0 || of.properties.get(index).counter != null) {
            throw FileLimits.wrong(name, "property " + property + " of element " + of.name, "missing", "a number");
        }
        return index;
    }

    private static float[] room(int[] properties, int total) {
        return Arrays.stream(properties).allMatch(index -> index >= 0) ? new float[properties.length * total] : null;
    }

    private static void gather(double[] values, int[] properties, float[] to, int row) {
        for (int i = 0; to != null && i < properties.length; i++) {
            to[properties.length * row + i] = (float) values[properties[i]];
        }
    }

    /** Returns the properties red, green, blue and, unless it is -1, alpha; null without a colour. */
    private static int[] colorsOf(Element of) {
        int[] indices = new int[COLORS.length];
        for (int i = 0; i < COLORS.length; i++) {
            indices[i] = of.index(COLORS[i]);
            if (indices[i] < 0 && i < 3) {
                return null;
            }
        }
        return indices;
    }

    /** Returns a part of a colour, 0 to 255. */
    private static float channel(Element of, double[] values, int property) {
        if (property < 0) {
            return FULL;
        }
        double value = values[property] * (of.properties.get(property).type.real ? FULL : 1);
        return (float) Math.max(0, Math.min(FULL, value));
    }

    private void faces(Element face) throws IOException {
        FileLimits.range(name, "the number of faces", face.count, 0, ModelLimits.MAX_TRIANGLES);
        int list = list(face);
        int[] color = colorsOf(face);
        double[] values = new double[face.properties.size()];
        for (file.row = 0; file.row < face.count; file.row++) {
            int corners = 0;
            for (int i = 0; i < values.length; i++) {
                if (i == list) {
                    corners = corners(face.properties.get(i), 0);
                } else {
                    values[i] = value(face.properties.get(i));
                }
            }
            file.endRow();
            int first = count;
            if (corners >= 3) {
                int[] triangles = splitter.split(positions, ring, corners, file.row + 1);
                for (int i = 0; i < splitter.made(); i++) {
                    add(ring[triangles[i]]);
                }
            }
            if (color != null) {
                paint(first / 3, argb(face, values, color));
            }
        }
    }

    private static int argb(Element face, double[] values, int[] color) {
        int argb = 0;
        for (int i = 0; i < COLORS.length; i++) {
            argb |= Math.round(channel(face, values, color[i])) << 8 * i;
        }
        return argb;
    }

    /** Sets the colour of the triangles from one to the last. */
    private void paint(int from, int argb) {
        if (faceColors == null) {
            faceColors = new int[Math.max(64, count / 3)];
            Arrays.fill(faceColors, -1);
        }
        if (count / 3 > faceColors.length) {
            faceColors = Arrays.copyOf(faceColors, Math.max(count / 3, 2 * faceColors.length));
        }
        Arrays.fill(faceColors, from, count / 3, argb);
    }

    private int list(Element of) throws IOException {
        if (positions == null) {
            throw FileLimits.wrong(name, "element " + of.name, "before the vertices", "element vertex before it");
        }
        int list = of.index("vertex_indices", "vertex_index");
        if (list < 0 || of.properties.get(list).counter == null || of.properties.get(list).type.real) {
            throw FileLimits.wrong(name, "property vertex_indices of element " + of.name, "missing",
                "a list of whole numbers");
        }
        return list;
    }

    /** Reads a list of vertices into the ring, and returns their number. */
    private int corners(Property of, int least) throws IOException {
        long corners = (long) file.number(of.counter);
        FileLimits.range(name, "the number of corners of " + file.where(), corners, 0, 3L * ModelLimits.MAX_TRIANGLES);
        int total = positions.length / 3;
        for (int i = 0; i < corners; i++) {
            if (i == ring.length) {
                ring = Arrays.copyOf(ring, 2 * i);
            }
            double index = file.number(of.type);
            if (!(index >= least && index < total)) {
                throw FileLimits.wrong(name, "a corner of " + file.where(), (long) index,
                    total == 0 ? "none, for there are no vertices" : least + " to " + (total - 1));
            }
            ring[i] = (int) index;
        }
        return (int) corners;
    }

    private void add(int vertex) {
        if (count == indices.length) {
            indices = Arrays.copyOf(indices, 2 * count);
        }
        indices[count++] = vertex;
    }

    /** Reads strips of triangles, which -1 separates. */
    private void strips(Element of) throws IOException {
        FileLimits.range(name, "the number of tristrips", of.count, 0, ModelLimits.MAX_TRIANGLES);
        int list = list(of);
        for (file.row = 0; file.row < of.count; file.row++) {
            for (int i = 0; i < of.properties.size(); i++) {
                if (i == list) {
                    int first = count / 3;
                    strip(corners(of.properties.get(i), -1));
                    if (faceColors != null) {
                        paint(first, -1);
                    }
                } else {
                    value(of.properties.get(i));
                }
            }
            file.endRow();
        }
    }

    private void strip(int corners) throws IOException {
        int first = 0;
        for (int i = 0; i <= corners; i++) {
            if (i == corners || ring[i] < 0) {
                int[] triangles = SolidMesh.strip(Arrays.copyOfRange(ring, first, i), i - first);
                FileLimits.range(name, "the number of triangles up to " + file.where(), (count + triangles.length) / 3,
                    0, ModelLimits.MAX_TRIANGLES);
                for (int corner : triangles) {
                    add(corner);
                }
                first = i + 1;
            }
        }
    }

    private void skip(Element of) throws IOException {
        FileLimits.range(name, "the number of rows of element " + of.name, of.count, 0, MAX_ROWS);
        double[] values = new double[of.properties.size()];
        for (file.row = 0; file.row < of.count && values.length > 0; file.row++) {
            row(of, values);
            file.endRow();
        }
    }

    private void row(Element of, double[] values) throws IOException {
        for (int i = 0; i < values.length; i++) {
            values[i] = value(of.properties.get(i));
        }
    }

    /** Returns a number; reads a list without keeping it. */
    private double value(Property property) throws IOException {
        if (property.counter == null) {
            return file.number(property.type);
        }
        long entries = (long) file.number(property.counter);
        FileLimits.range(name, "the number of entries of " + property.name + " of " + file.where(), entries, 0,
            bytes.length);
        for (long i = 0; i < entries; i++) {
            file.number(property.type);
        }
        return 0;
    }
}
