// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import java.io.IOException;
import java.util.Arrays;
import org.SEAR.files.FileLimits;

/** Vertices of an OGRE mesh: of one submesh, or shared by several. */
final class OgreVertices {
    private static final int START = 64;

    /** Number of vertices that the file states. */
    final int count;
    private final String what;
    private int vertex = -1;
    private boolean hasPlace;
    private int positionCount;
    private float[] positions = new float[START];
    private float[] normals;
    private float[] places;
    private float[] colors;

    OgreVertices(OgreAttributes given) throws IOException {
        count = given.whole(given.text("vertexcount") == null ? "count" : "vertexcount", ModelLimits.MAX_TRIANGLES);
        what = "the number of vertices of <" + given.element + "> in line " + given.line;
    }

    /** Starts a list of properties of the same vertices. */
    void startBuffer() {
        vertex = -1;
    }

    /** Adds a property of the current vertex, or goes to the next one. */
    void add(String element, OgreAttributes given) throws IOException {
        if (element.equals("vertex")) {
            given.require(++vertex < count, "once for each of the " + count + " stated vertices");
            hasPlace = false;
            return;
        }
        given.require(vertex >= 0, "in a vertex");
        switch (element) {
            case "position":
                positions = put(positions, 3, given, "x", "y", "z");
                positionCount++;
                break;
            case "normal":
                normals = put(normals, 3, given, "x", "y", "z");
                break;
            case "texcoord":
                places = hasPlace ? places : put(places, 2, given, "u", given.text("v") == null ? "u" : "v");
                hasPlace = true;
                break;
            default:
                color(given);
        }
    }

    private float[] room(float[] values, int size) {
        float[] room = values == null ? new float[START] : values;
        return size * (vertex + 1) > room.length ? Arrays.copyOf(room, Math.max(2 * room.length, size * (vertex + 1)))
            : room;
    }

    private float[] put(float[] values, int size, OgreAttributes given, String... names) throws IOException {
        float[] room = room(values, size);
        for (int i = 0; i < size; i++) {
            room[size * vertex + i] = given.number(names[i]);
        }
        return room;
    }

    private void color(OgreAttributes given) throws IOException {
        String[] numbers = String.valueOf(given.text("value")).trim().split("\\s+");
        colors = room(colors, 4);
        try {
            for (int i = 0; i < 4; i++) {
                colors[4 * vertex + i] = i == 3 && numbers.length == 3 ? 1 : Float.parseFloat(i < numbers.length
                    ? numbers[i] : "");
            }
        } catch (NumberFormatException e) {
            throw given.wrong("value", "three or four numbers from 0 to 1");
        }
    }

    /** Throws if a stated vertex has no position. */
    void end(String file) throws IOException {
        FileLimits.range(file, what + ", by their positions,", positionCount, count, count);
    }

    /** Returns the triangles of these vertices as a mesh. */
    SolidMesh mesh(int[] triangles) {
        SolidMesh mesh = new SolidMesh(Arrays.copyOf(positions, 3 * count), triangles);
        mesh.normals = normals == null ? null : Arrays.copyOf(normals, 3 * count);
        mesh.places = places == null ? null : Arrays.copyOf(places, 2 * count);
        mesh.colors = colors == null ? null : Arrays.copyOf(colors, 4 * count);
        return mesh;
    }
}
