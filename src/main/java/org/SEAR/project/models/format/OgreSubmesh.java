// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import org.SEAR.files.FileLimits;

/** Submesh of an OGRE mesh: triangles of one material. */
final class OgreSubmesh {
    private static final String LIST = "triangle_list";
    private static final String STRIP = "triangle_strip";
    private static final String FAN = "triangle_fan";
    private static final List<String> KINDS = List.of(LIST, STRIP, FAN, "point_list", "line_list", "line_strip");

    /** Name of the material; null for white. */
    final String material;
    /** Line of the file. */
    final int line;
    /** Own vertices; null for shared ones. */
    OgreVertices own;
    private final String kind;
    private final boolean sharing;
    private int[] corners = new int[48];
    private int count;
    private int faces;
    /** Number of faces that the file states; -1 for none. */
    private int stated = -1;

    OgreSubmesh(OgreAttributes given) throws IOException {
        material = given.text("material");
        line = given.line;
        kind = given.text("operationtype") == null ? LIST : given.text("operationtype");
        sharing = "true".equals(given.text("usesharedvertices"));
        if (!KINDS.contains(kind)) {
            throw given.wrong("operationtype", "one of " + String.join(", ", KINDS));
        }
    }

    /** Returns whether the submesh consists of triangles, not of points or lines. */
    boolean hasSurface() {
        return KINDS.indexOf(kind) <= KINDS.indexOf(FAN);
    }

    /** Takes the stated number of faces. */
    void state(OgreAttributes given) throws IOException {
        stated = given.text("count") == null ? -1 : given.whole("count", 3 * ModelLimits.MAX_TRIANGLES);
    }

    /**
     * Adds a face: three corners; one corner after the first face of a strip or fan.
     *
     * @return number of corners
     */
    int addFace(OgreAttributes given) throws IOException {
        if (!hasSurface()) {
            return 0;
        }
        int of = !kind.equals(LIST) && faces > 0 && given.text("v2") == null ? 1 : 3;
        faces++;
        for (int i = 1; i <= of; i++) {
            if (count == corners.length) {
                corners = Arrays.copyOf(corners, 2 * count);
            }
            corners[count++] = given.whole("v" + i, ModelLimits.MAX_TRIANGLES - 1);
        }
        return of;
    }

    /** Throws if the number of faces is not the stated one. */
    void end(String file) throws IOException {
        if (hasSurface() && stated >= 0) {
            FileLimits.range(file, "the number of faces of the submesh in line " + line, faces, stated, stated);
        }
    }

    /** Returns the submesh with its vertices. */
    SolidMesh mesh(String file, OgreVertices shared) throws IOException {
        OgreVertices vertices = own == null || sharing && shared != null ? shared : own;
        if (vertices == null) {
            throw FileLimits.wrong(file, "the geometry of the submesh in line " + line, "missing",
                "a geometry or a sharedgeometry");
        }
        for (int i = 0; i < count; i++) {
            if (corners[i] >= vertices.count) {
                throw FileLimits.wrong(file, "corner " + (i + 1) + " of the submesh in line " + line, corners[i],
                    vertices.count == 0
                    ? "none, for there are no vertices" : "0 to " + (vertices.count - 1));
            }
        }
        return vertices.mesh(triangles());
    }

    private int[] triangles() {
        if (kind.equals(LIST)) {
            return Arrays.copyOf(corners, count);
        }
        return kind.equals(FAN) ? SolidMesh.fan(corners, count) : SolidMesh.strip(corners, count);
    }
}
