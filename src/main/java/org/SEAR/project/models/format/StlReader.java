// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import com.jme3.asset.AssetInfo;
import com.jme3.scene.Node;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import java.util.function.Consumer;
import org.SEAR.files.FileLimits;

/**
 * Reader of STL models, binary or text (3D Systems, "StereoLithography Interface Specification", 1989). Equal points
 * share a vertex; normals are those of the triangles. One use.
 */
public final class StlReader {
    /** Header of a binary file with its number of facets, bytes. */
    private static final int HEAD = 84;
    /** A facet of a binary file: normal and three points of three floats each, and two bytes. */
    private static final int FACET = 50;
    private static final int NORMAL = 12;
    private static final int NUMBERS = 9;
    private static final String SOLID = "solid";

    private final AssetInfo info;
    private final String name;
    private final byte[] bytes;
    private final Consumer<String> warnings;
    private final PointTable points = new PointTable();
    private int[] indices = new int[3 * 64];
    private int count;
    private int at;
    private int line = 1;

    /** @param warnings receives each reason why the model is not shown as its file says */
    public StlReader(AssetInfo info, byte[] bytes, Consumer<String> warnings) {
        this.info = info;
        this.name = info.getKey().getName();
        this.bytes = bytes;
        this.warnings = warnings;
    }

    /** Points by their coordinates: a hash table with open addressing. */
    private static final class PointTable {
        private float[] values = new float[3 * 64];
        private int count;
        /** Point plus 1 of each place; 0 for a free one. The length is a power of two. */
        private int[] table = new int[256];

        int add(float x, float y, float z) {
            int place = start(x, y, z);
            for (; table[place] != 0; place = place + 1 & table.length - 1) {
                int known = 3 * (table[place] - 1);
                if (values[known] == x && values[known + 1] == y && values[known + 2] == z) {
                    return table[place] - 1;
                }
            }
            if (3 * count == values.length) {
                values = Arrays.copyOf(values, 2 * values.length);
            }
            values[3 * count] = x;
            values[3 * count + 1] = y;
            values[3 * count + 2] = z;
            table[place] = ++count;
            if (2 * count > table.length) {
                grow();
            }
            return count - 1;
        }

        /** Returns the first place to search; adding 0 makes -0 equal to 0. */
        private int start(float x, float y, float z) {
            long mixed = (Float.floatToIntBits(x + 0f) * 0x9e3779b97f4a7c15L + Float.floatToIntBits(y + 0f))
                * 0x9e3779b97f4a7c15L + Float.floatToIntBits(z + 0f);
            mixed = (mixed ^ mixed >>> 30) * 0xbf58476d1ce4e5b9L;
            mixed = (mixed ^ mixed >>> 27) * 0x94d049bb133111ebL;
            return (int) (mixed ^ mixed >>> 31) & table.length - 1;
        }

        private void grow() {
            table = new int[2 * table.length];
            for (int i = 0; i < count; i++) {
                int place = start(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
                while (table[place] != 0) {
                    place = place + 1 & table.length - 1;
                }
                table[place] = i + 1;
            }
        }
    }

    /**
     * Returns the model, one white mesh.
     *
     * @throws IOException that names the facet or the line, the value and the legal values
     */
    public Node read() throws IOException {
        ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        long facets = bytes.length < HEAD ? -1 : Integer.toUnsignedLong(in.getInt(HEAD - 4));
        if (bytes.length != HEAD + FACET * facets && isText()) {
            text();
        } else {
            binary(in, facets);
        }
        SolidMesh mesh = new SolidMesh(Arrays.copyOf(points.values, 3 * points.count), Arrays.copyOf(indices, count));
        Node node = new Node(name);
        node.attachChild(SolidMesh.geometry("solid", mesh.mesh(), SolidMesh.white(info.getManager())));
        return node;
    }

    /** Returns whether the file starts like text: binary files may start with the same word. */
    private boolean isText() {
        String start = new String(bytes, 0, Math.min(bytes.length, 10 * HEAD), StandardCharsets.ISO_8859_1);
        return start.trim().toLowerCase(Locale.ROOT).startsWith(SOLID) && start.indexOf('\0') < 0;
    }

    private void binary(ByteBuffer in, long facets) throws IOException {
        FileLimits.range(name, "the file's size", bytes.length, HEAD, ModelLimits.MAX_FILE);
        FileLimits.range(name, "the number of facets", facets, 0, ModelLimits.MAX_TRIANGLES);
        long whole = HEAD + FACET * facets;
        if (bytes.length < whole) {
            throw FileLimits.wrong(name, "the file's size", bytes.length + " bytes", whole + " bytes for the " + facets
                + " facets in its head: it is cut off, or no STL");
        }
        if (bytes.length > whole) {
            warnings.accept(bytes.length - whole + " bytes after its " + facets + " facets are left out");
        }
        for (int i = 0; i < facets; i++) {
            in.position(HEAD + FACET * i + NORMAL);
            for (int corner = 0; corner < 3; corner++) {
                add(in.getFloat(), in.getFloat(), in.getFloat(), "facet ", i + 1);
            }
        }
    }

    private void add(float x, float y, float z, String kind, int number) throws IOException {
        for (int axis = 0; axis < 3; axis++) {
            float value = axis == 0 ? x : axis == 1 ? y : z;
            if (!(Math.abs(value) <= ModelLimits.MAX_COORDINATE)) {
                throw FileLimits.wrong(name, "a coordinate of " + kind + number, value, "a finite number up to "
                    + (int) ModelLimits.MAX_COORDINATE + " m from the model's origin");
            }
        }
        if (count == indices.length) {
            indices = Arrays.copyOf(indices, 2 * count);
        }
        indices[count++] = points.add(x, y, z);
        FileLimits.range(name, "the number of vertices up to " + kind + number, points.count, 0,
            ModelLimits.MAX_TRIANGLES);
        FileLimits.range(name, "the number of triangles up to " + kind + number, count / 3, 0,
            ModelLimits.MAX_TRIANGLES);
    }

    private void text() throws IOException {
        for (String word = word(); !word.isEmpty(); word = word()) {
            require(word, SOLID);
            skipLine();
            word = word();
            while (word.equals("facet")) {
                facet();
                word = word();
            }
            require(word, "endsolid");
            skipLine();
        }
    }

    private void facet() throws IOException {
        require(word(), "normal");
        for (int i = 0; i < 3; i++) {
            word();         // the triangle has its own normal
        }
        require(word(), "outer");
        require(word(), "loop");
        float[] xyz = new float[NUMBERS];
        for (int i = 0; i < NUMBERS; i++) {
            if (i % 3 == 0) {
                require(word(), "vertex");
            }
            xyz[i] = number();
        }
        for (int i = 0; i < NUMBERS; i += 3) {
            add(xyz[i], xyz[i + 1], xyz[i + 2], "line ", line);
        }
        require(word(), "endloop");
        require(word(), "endfacet");
    }

    private void require(String word, String legal) throws IOException {
        if (!word.equals(legal)) {
            throw FileLimits.wrong(name, "the word in line " + line, word.isEmpty() ? "missing, at the end of the file"
                : word, legal);
        }
    }

    private float number() throws IOException {
        String word = word();
        try {
            return Float.parseFloat(word);
        } catch (NumberFormatException e) {
            throw FileLimits.wrong(name, "a coordinate in line " + line, word, "a number with a decimal point");
        }
    }

    /** Returns the next word in lower case; an empty one at the end. */
    private String word() throws IOException {
        while (at < bytes.length && bytes[at] >= 0 && bytes[at] <= ' ') {
            line += bytes[at++] == '\n' ? 1 : 0;
        }
        int start = at;
        while (at < bytes.length && (bytes[at] < 0 || bytes[at] > ' ')) {
            at++;
        }
        FileLimits.range(name, "the number of characters of a word in line " + line, at - start, 0,
            ModelLimits.MAX_LINE);
        return new String(bytes, start, at - start, StandardCharsets.ISO_8859_1).toLowerCase(Locale.ROOT);
    }

    private void skipLine() {
        while (at < bytes.length && bytes[at] != '\n' && bytes[at] != '\r') {
            at++;
        }
    }
}
