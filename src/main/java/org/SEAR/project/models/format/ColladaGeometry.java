// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.SEAR.files.FileLimits;

/**
 * Meshes of a COLLADA file: triangles, polygons, strips and fans of a {@code <mesh>}. Lines have no surface, holes of
 * polygons are filled. One file.
 */
final class ColladaGeometry {
    private static final Set<String> SURFACES = Set.of("triangles", "polylist", "polygons", "trifans", "tristrips");
    private static final Set<String> NO_SURFACES = Set.of("source", "vertices", "lines", "linestrips");
    /** Most indices of a corner. */
    private static final int MAX_OFFSET = 100;

    /** Most numbers of all sources, each array as often as a source names it. */
    private static final long MAX_NUMBERS = 12L * ModelLimits.MAX_TRIANGLES;

    /** Triangles of one material in the geometry's frame. */
    static final class Part {
        /** Symbol of the material; null for white. */
        final String material;
        final SolidMesh mesh;

        private Part(String material, SolidMesh mesh) {
            this.material = material;
            this.mesh = mesh;
        }
    }

    private final String file;
    private final Consumer<String> warnings;
    private final PolygonSplitter splitter;
    private final Map<ColladaElement, List<Part>> known = new HashMap<>();
    private final Map<ColladaElement, float[]> sources = new HashMap<>();
    private int holes;
    private long numbers;

    // of the primitive being read
    private float[] positions;
    private float[] places;
    private float[] normals;
    private int positionOffset;
    private int placeOffset;
    private int normalOffset;
    private int stride;
    private int[] ring = new int[16];

    ColladaGeometry(String file, Consumer<String> warnings) {
        this.file = file;
        this.warnings = warnings;
        splitter = new PolygonSplitter(file, "the polygon in line ");
    }

    /** Returns the parts of a geometry, in its own frame and unit. */
    List<Part> parts(ColladaElement geometry) throws IOException {
        if (!known.containsKey(geometry)) {
            known.put(geometry, read(geometry));
        }
        return known.get(geometry);
    }

    /** Warns of polygons that are not shown as the file says. */
    void warn() {
        splitter.warn(warnings);
        if (holes > 0) {
            warnings.accept("the holes of " + holes + " polygons are filled");
        }
    }

    private List<Part> read(ColladaElement geometry) throws IOException {
        ColladaElement mesh = geometry.child("mesh");
        List<Part> parts = new ArrayList<>();
        if (mesh == null) {
            warnings.accept("<geometry> in line " + geometry.line + " is left out, legal: a <mesh>");
            return parts;
        }
        for (ColladaElement each : mesh.children) {
            if (SURFACES.contains(each.name)) {
                parts.add(new Part(each.attribute("material"), primitive(each)));
            } else if (!NO_SURFACES.contains(each.name)) {
                warnings.accept("<" + each.name + "> in line " + each.line + " is left out, legal: triangles, "
                    + "polylist, polygons, trifans or tristrips");
            }
        }
        return parts;
    }

    private SolidMesh primitive(ColladaElement primitive) throws IOException {
        inputs(primitive);
        MeshPart part = new MeshPart();
        switch (primitive.name) {
            case "triangles":
                for (ColladaElement p : primitive.all("p")) {
                    int[] indices = p.indices();
                    int corners = corners(p, indices);
                    if (corners % 3 != 0) {
                        throw p.wrong("the number of corners", corners, "a multiple of 3");
                    }
                    for (int first = 0; first < corners; first += 3) {
                        polygon(part, p, indices, first, 3);
                    }
                }
                break;
            case "polylist":
                polylist(part, primitive);
                break;
            case "polygons":
                for (ColladaElement p : primitive.children) {
                    ColladaElement outline = p.name.equals("ph") ? p.child("p") : p.name.equals("p") ? p : null;
                    holes += p.name.equals("ph") ? 1 : 0;
                    if (outline != null) {
                        int[] indices = outline.indices();
                        polygon(part, outline, indices, 0, corners(outline, indices));
                    }
                }
                break;
            default:
                for (ColladaElement p : primitive.all("p")) {
                    strip(part, p, primitive.name.equals("trifans"));
                }
        }
        return part.mesh(positions, places == null ? new float[0] : places, normals == null ? new float[0] : normals);
    }

    private void polylist(MeshPart part, ColladaElement primitive) throws IOException {
        ColladaElement counts = primitive.child("vcount");
        ColladaElement p = primitive.child("p");
        if (counts == null || p == null) {
            return;     // an empty list
        }
        int[] indices = p.indices();
        int corners = corners(p, indices);
        int first = 0;
        for (int count : counts.indices()) {
            if (count > corners - first) {
                throw p.wrong("the number of corners", corners, "the sum of the vcount before it");
            }
            polygon(part, p, indices, first, count);
            first += count;
        }
        if (first != corners) {
            throw p.wrong("the number of corners", corners, first + ", the sum of the vcount before it");
        }
    }

    private int corners(ColladaElement p, int[] indices) throws IOException {
        if (indices.length % stride != 0) {
            throw p.wrong("the number of indices", indices.length, "a multiple of " + stride
                + ", the number of offsets of the inputs");
        }
        return indices.length / stride;
    }

    private void polygon(MeshPart part, ColladaElement p, int[] indices, int first, int count) throws IOException {
        if (count < 3) {
            return;
        }
        if (ring.length < count) {
            ring = new int[2 * count];
        }
        for (int i = 0; i < count; i++) {
            ring[i] = index(p, indices[(first + i) * stride + positionOffset], positions, 3);
        }
        int[] triangles = splitter.split(positions, ring, count, p.line);
        for (int i = 0; i < splitter.made(); i++) {
            corner(part, p, indices, first + triangles[i]);
        }
    }

    private void strip(MeshPart part, ColladaElement p, boolean fan) throws IOException {
        int[] indices = p.indices();
        int[] corners = new int[corners(p, indices)];
        Arrays.setAll(corners, i -> i);
        int[] all = fan ? SolidMesh.fan(corners, corners.length) : SolidMesh.strip(corners, corners.length);
        splitter.count(all.length / 3, p.line);
        for (int corner : all) {
            corner(part, p, indices, corner);
        }
    }

    private void corner(MeshPart part, ColladaElement p, int[] indices, int corner) throws IOException {
        int at = corner * stride;
        part.add(index(p, indices[at + positionOffset], positions, 3),
            places == null ? -1 : index(p, indices[at + placeOffset], places, 2),
            normals == null ? -1 : index(p, indices[at + normalOffset], normals, 3));
    }

    private static int index(ColladaElement p, int index, float[] values, int size) throws IOException {
        if (index >= values.length / size) {
            throw p.wrong("an index", index, values.length == 0 ? "none, for the source is empty"
                : "0 to " + (values.length / size - 1));
        }
        return index;
    }

    private void inputs(ColladaElement primitive) throws IOException {
        positions = null;
        places = null;
        normals = null;
        stride = 1;
        for (ColladaElement input : primitive.all("input")) {
            int offset = input.whole("offset", -1, MAX_OFFSET);
            stride = Math.max(stride, offset + 1);
            if ("VERTEX".equals(input.attribute("semantic"))) {
                for (ColladaElement own : input.reference("source", "vertices").all("input")) {
                    use(own, offset);
                }
            } else {
                use(input, offset);
            }
        }
        if (positions == null) {
            throw primitive.wrong("the VERTEX input with a POSITION", null, "both");
        }
    }

    private void use(ColladaElement input, int offset) throws IOException {
        switch (String.valueOf(input.attribute("semantic"))) {
            case "POSITION":
                positions = source(input, 3);
                positionOffset = offset;
                break;
            case "NORMAL":
                normals = source(input, 3);
                normalOffset = offset;
                break;
            case "TEXCOORD":
                if (places == null) {
                    places = source(input, 2);
                    placeOffset = offset;
                }
                break;
            default:        // has no effect on the surface
        }
    }

    /** Returns the first numbers of each row of a source. */
    private float[] source(ColladaElement input, int size) throws IOException {
        ColladaElement source = input.reference("source", "source");
        ColladaElement accessor = source.child("technique_common", "accessor");
        if (accessor == null) {
            throw source.wrong("the accessor", null, "an <accessor> in its <technique_common>");
        }
        if (!sources.containsKey(accessor)) {
            sources.put(accessor, read(accessor, size));
        }
        return sources.get(accessor);
    }

    private float[] read(ColladaElement accessor, int size) throws IOException {
        float[] values = accessor.reference("source", "float_array").floats();
        numbers += values.length;
        FileLimits.range(file, "the number of numbers of all sources", numbers, 0, MAX_NUMBERS);
        int count = accessor.whole("count", -1, ModelLimits.MAX_TRIANGLES);
        int stride = accessor.whole("stride", 1, MAX_OFFSET);
        int offset = accessor.whole("offset", 0, values.length);
        int[] at = new int[size];
        int found = 0;
        int column = 0;
        for (ColladaElement param : accessor.all("param")) {
            if (param.attribute("name") != null && found < size) {
                at[found++] = column;
            }
            column++;
        }
        for (int i = 0; i < size && found < size; i++) {
            at[i] = i;      // params without names
        }
        if (at[size - 1] >= stride) {
            throw accessor.wrong("stride", stride, "at least " + (at[size - 1] + 1));
        }
        if (count > 0 && offset + (count - 1L) * stride + at[size - 1] >= values.length) {
            throw accessor.wrong("count", count, "rows that the array of " + values.length + " numbers has");
        }
        float[] all = new float[size * count];
        for (int i = 0; i < all.length; i++) {
            all[i] = values[offset + i / size * stride + at[i % size]];
        }
        return all;
    }
}
