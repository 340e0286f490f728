// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import org.SEAR.geometry.Triangles;
import org.junit.Rule;
import org.junit.Test;

/** Features of glTF 2.0 files, by bounding box, area and volume. */
public class GltfFormatTest {
    private static final double ROOT = Math.sqrt(2);
    private static final String TURNED = "\"rotation\":[0,0,0.3826834323650898,0.9238795325112867],\"mesh\":0";
    private static final String POSITIONS = "\"attributes\":{\"POSITION\":0}";

    @Rule
    public final FormatRule project = new FormatRule();

    private Measures load(GltfFile file) throws IOException {
        return project.with("m.gltf", file.bytes()).load("m.gltf");
    }

    private void assertRefused(GltfFile file, String message) throws IOException {
        project.with("m.gltf", file.bytes()).refuses("m.gltf", "m.gltf: " + message);
    }

    private void assertCube(GltfFile file) throws IOException {
        load(file).hasBox(0, 0, 0, 1, 1, 1).hasArea(6).hasVolume(1).hasTriangles(12);
    }

    @Test
    public void aCubeIsACube() throws Exception {
        assertCube(GltfFile.cube());
    }

    /** Its front, a square with sides of (sqrt 2, sqrt 1/2), becomes a rhombus. */
    @Test
    public void aChildTurnedInAScaledParentShears() throws Exception {
        GltfFile file = GltfFile.cube().node("\"scale\":[2,1,1],\"children\":[1]").node(TURNED);
        load(file).hasBox(-ROOT, 0, 0, ROOT, ROOT, 1).hasVolume(2).hasArea(2 * 2 + 4 * Math.sqrt(2.5)).hasTriangles(12);
    }

    @Test
    public void transformsOfAllParentsApply() throws Exception {
        GltfFile file = GltfFile.cube().node("\"translation\":[10,0,0],\"children\":[1]")
            .node("\"scale\":[1,3,1],\"children\":[2]")
            .node("\"rotation\":[0,0,0.7071067811865476,0.7071067811865476],\"translation\":[0,1,0],\"children\":[3]")
            .node("\"mesh\":0");
        load(file).hasBox(9, 3, 0, 10, 6, 1).hasVolume(3);
    }

    @Test
    public void aMatrixMayShear() throws Exception {
        GltfFile file = GltfFile.cube().node("\"mesh\":0,\"matrix\":[1,0,0,0, 2,1,0,0, 0,0,1,0, 5,6,7,1]");
        load(file).hasBox(5, 6, 7, 8, 7, 8).hasVolume(1).hasArea(4 + 2 * Math.sqrt(5));
    }

    /** The normals of a cube's sides are upright on the transformed triangles, and point outwards. */
    @Test
    public void normalsShearAndMirrorWithTheirTriangles() throws Exception {
        double[] at = new double[108];
        double[] normals = new double[108];
        Triangles cube = load(GltfFile.cube()).triangles;
        for (int i = 0; i < 36; i++) {
            int first = i / 3 * 3;
            double[][] p = new double[3][3];
            for (int k = 0; k < 9; k++) {
                p[k / 3][k % 3] = cube.vertices[3 * cube.indices[first + k / 3] + k % 3];
            }
            double[] n = Measures.cross(Measures.minus(p[1], p[0]), Measures.minus(p[2], p[0]));
            for (int axis = 0; axis < 3; axis++) {
                at[3 * i + axis] = p[i % 3][axis];
                normals[3 * i + axis] = n[axis];
            }
        }
        for (String matrix : new String[] {"1,0,0,0, 2,1,0,0, 0,0,1,0, 5,6,7,1", "1,0,0,0, 2,-1,0,0, 0,3,1,0, 5,6,7,1",
            "2,0,0,0, 0,3,0,0, 0,0,-4,0, 0,0,0,1"}) {
            GltfFile file = new GltfFile();
            file.primitive("\"attributes\":{\"POSITION\":" + file.floats(3, at) + ",\"NORMAL\":" + file.floats(3,
                normals) + "}");
            Measures made = load(file.node("\"mesh\":0,\"matrix\":[" + matrix + "]"));
            assertTrue(matrix + ": " + made.volume, made.volume > 0);
            float[] shown = project.look("m.gltf").normals;
            for (int t = 0; t < 36; t += 3) {
                double[][] p = new double[3][3];
                for (int k = 0; k < 9; k++) {
                    p[k / 3][k % 3] = made.triangles.vertices[3 * made.triangles.indices[t + k / 3] + k % 3];
                }
                double[] n = Measures.cross(Measures.minus(p[1], p[0]), Measures.minus(p[2], p[0]));
                int corner = 3 * made.triangles.indices[t];
                double[] given = {shown[corner], shown[corner + 1], shown[corner + 2]};
                assertEquals(matrix, 1, Measures.dot(n, given) / Math.sqrt(Measures.dot(n, n)), 1e-5);
            }
        }
    }

    @Test
    public void aMirroredNodeKeepsItsOutside() throws Exception {
        load(GltfFile.cube().node("\"mesh\":0,\"scale\":[-2,1,1]")).hasBox(-2, 0, 0, 0, 1, 1).hasVolume(2);
        load(GltfFile.cube().node("\"children\":[1],\"scale\":[-2,1,-1]").node("\"mesh\":0")).hasBox(-2, 0, -1, 0, 1,
            0).hasVolume(2);
    }

    @Test
    public void aMatrixThatIsNotAffineOrNotAloneIsRefused() throws Exception {
        assertRefused(GltfFile.cube().node("\"mesh\":0,\"matrix\":[1,0,0,0.5, 0,1,0,0, 0,0,1,0, 0,0,0,1]"),
            "nodes[0].matrix is [1.0, 0.0, 0.0, 0.5, ");
        assertRefused(GltfFile.cube().node("\"mesh\":0,\"matrix\":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2]"),
            "nodes[0].matrix is [");
        assertRefused(GltfFile.cube().node("\"mesh\":0,\"scale\":[1,1,2],\"matrix\":[1,0,0,0, 0,1,0,0, 0,0,1,0, "
            + "0,0,0,1]"),
            "nodes[0] is with a matrix and a translation, rotation or scale, legal: one of both");
        assertRefused(GltfFile.cube().node("\"mesh\":0,\"rotation\":[0,0,0,0]"),
            "nodes[0].rotation is [0.0, 0.0, 0.0, 0.0], legal: a quaternion");
        load(GltfFile.cube().node("\"mesh\":0,\"rotation\":[0,0,2,2]")).hasBox(-1, 0, 0, 0, 1, 1).hasVolume(1);
    }

    @Test
    public void stripsFansAndListsAreTriangles() throws Exception {
        GltfFile strip = new GltfFile();
        strip.floats(3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0);
        Measures made = load(strip.primitive(POSITIONS + ",\"mode\":5")).hasTriangles(3).hasArea(1.5).hasBox(0, 0, 0, 1,
            2, 0);
        assertUpwards(made);
        GltfFile fan = new GltfFile();
        fan.floats(3, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 0, 0);
        fan.indices(5121, 0, 1, 2, 3, 4);
        assertUpwards(load(fan.primitive(POSITIONS + ",\"indices\":1,\"mode\":6")).hasTriangles(3).hasArea(1.5));
        GltfFile plain = new GltfFile();
        plain.floats(3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 7, 7, 7);
        load(plain.primitive(POSITIONS + ",\"mode\":4")).hasTriangles(1).hasArea(0.5);
        GltfFile lines = GltfFile.cube();
        for (int mode = 0; mode < 4; mode++) {
            lines.primitive(POSITIONS + ",\"mode\":" + mode);
        }
        load(lines.primitive(POSITIONS + ",\"indices\":1")).hasTriangles(12);
        assertRefused(GltfFile.cube().primitive(POSITIONS + ",\"mode\":7"),
            "meshes[0].primitives[0].mode is 7, legal: a whole number from 0 to 6");
    }

    private static void assertUpwards(Measures made) {
        Triangles t = made.triangles;
        for (int i = 0; i < t.indices.length; i += 3) {
            int a = 3 * t.indices[i];
            int b = 3 * t.indices[i + 1];
            int c = 3 * t.indices[i + 2];
            assertTrue((t.vertices[b] - t.vertices[a]) * (t.vertices[c + 1] - t.vertices[a + 1])
                - (t.vertices[b + 1] - t.vertices[a + 1]) * (t.vertices[c] - t.vertices[a]) > 0);
        }
    }

    @Test
    public void indicesOfAllTypesAndSeveralPrimitivesAreRead() throws Exception {
        for (int type : new int[] {5121, 5123, 5125}) {
            GltfFile file = GltfFile.cube();
            int lower = file.indices(type, 0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4);
            int upper = file.indices(type, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7);
            assertCube(file.primitive(POSITIONS + ",\"indices\":" + lower).primitive(POSITIONS + ",\"indices\":"
                + upper));
        }
        GltfFile file = GltfFile.cube();
        int indices = file.indices(5126, 0, 1, 2);
        assertRefused(file.primitive(POSITIONS + ",\"indices\":" + indices),
            "the componentType of meshes[0].primitives[0].indices is 5126");
    }

    @Test
    public void interleavedSparseAndQuantizedPositionsAreRead() throws Exception {
        GltfFile file = new GltfFile();
        int at = file.interleaved(5, 1, 9, 0, 0, 0, 9, 9, 1, 0, 0, 9, 9, 0, 1, 0, 9);
        load(file.primitive("\"attributes\":{\"POSITION\":" + at + "}")).hasBox(0, 0, 0, 1, 1, 0).hasArea(0.5);
        file = GltfFile.cube();
        String sparse = "\"sparse\":{\"count\":2,\"indices\":{\"bufferView\":" + file.view(5121, 0, 4)
            + ",\"componentType\":5121},\"values\":{\"bufferView\":" + file.view(5126, -1, 0, 0, -1, 0, 1) + "}}";
        at = file.accessor("\"bufferView\":0,\"componentType\":5126,\"count\":8,\"type\":\"VEC3\"," + sparse);
        load(file.primitive("\"attributes\":{\"POSITION\":" + at + "},\"indices\":1")).hasBox(-1, 0, 0, 1, 1,
            1).hasVolume(1.5);
        file = GltfFile.cube();
        String wrong = "\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":" + file.view(5121, 8)
            + ",\"componentType\":5121},\"values\":{\"bufferView\":" + file.view(5126, -1, 0, 0) + "}}";
        at = file.accessor("\"bufferView\":0,\"componentType\":5126,\"count\":8,\"type\":\"VEC3\"," + wrong);
        assertRefused(file.primitive("\"attributes\":{\"POSITION\":" + at + "}"),
            "an index of a sparse accessor is 8, legal: 0 to 7");
        file = new GltfFile();
        file.numbers(5122, 3, ",\"normalized\":true", 0, 0, 0, 32767, 0, 0, 0, -32768, 0);
        file.with(",\"extensionsRequired\":[\"KHR_mesh_quantization\"]");
        load(file.primitive(POSITIONS)).hasBox(0, -1, 0, 1, 0, 0);
        file = new GltfFile();
        file.numbers(5121, 3, "", 0, 0, 0, 200, 0, 0, 0, 100, 0);
        load(file.primitive(POSITIONS).node("\"mesh\":0,\"scale\":[0.01,0.01,0.01]")).hasBox(0, 0, 0, 2, 1, 0);
    }

    @Test
    public void morphTargetsHaveTheirDefaultWeights() throws Exception {
        for (int where = 0; where < 3; where++) {
            GltfFile file = GltfFile.cube();
            int up = file.floats(3, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 2, 0);
            int wide = file.floats(3, 0, 0, 0, 4, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 0, 4, 0, 0, 0, 0, 0);
            file.primitive(POSITIONS + ",\"indices\":1,\"targets\":[{\"POSITION\":" + up + "},{\"POSITION\":" + wide
                + "}]");
            file.mesh(where == 0 ? "" : ",\"weights\":[0.5,0.25]").node("\"mesh\":0" + (where == 2
                ? ",\"weights\":[0,1]" : ""));
            double[][] size = {{1, 1}, {2, 2}, {5, 1}};
            load(file).hasBox(0, 0, 0, size[where][0], size[where][1], 1).hasVolume(size[where][0] * size[where][1]);
        }
        GltfFile file = GltfFile.cube().mesh(",\"weights\":[0.5]");
        assertRefused(file.primitive(POSITIONS + ",\"indices\":1,\"targets\":[{\"POSITION\":0},{\"POSITION\":0}]"),
            "the number of weights of the morph targets of meshes[0].primitives[0] is 1, legal: 2 to 2");
    }

    @Test
    public void aSkinMovesItsMeshAndTheNodeDoesNot() throws Exception {
        GltfFile file = GltfFile.cube();
        int joints = file.numbers(5121, 4, "", 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
            1, 0, 0, 0, 1, 0, 0, 0);
        double[] ones = new double[32];
        for (int i = 0; i < 32; i += 4) {
            ones[i] = 1;
        }
        int weights = file.floats(4, ones);
        int bind = file.floats(16, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0,
            0, -1, 0, 1);
        file.primitive("\"attributes\":{\"POSITION\":0,\"JOINTS_0\":" + joints + ",\"WEIGHTS_0\":" + weights
            + "},\"indices\":1");
        file.node("\"mesh\":0,\"skin\":0,\"translation\":[100,100,100]")
            .node("\"translation\":[5,0,0],\"children\":[2]").node("\"translation\":[0,3,0]");
        file.roots("0,1").with(",\"skins\":[{\"joints\":[1,2],\"inverseBindMatrices\":" + bind + "}]");
        load(file).hasBox(5, 0, 0, 6, 3, 1).hasVolume(3);
        file.with(",\"skins\":[{\"joints\":[1],\"inverseBindMatrices\":" + bind + "}]");
        assertRefused(file, "meshes[0].primitives[0].attributes.JOINTS_0[8], an index of the file, is 1, legal: 0 "
            + "to 0");
    }

    @Test
    public void onlyTheSceneThatTheFileNamesIsRead() throws Exception {
        GltfFile file = GltfFile.cube().node("\"mesh\":0").node("\"mesh\":0,\"translation\":[7,0,0]")
            .roots("[{\"nodes\":[0]},{\"nodes\":[1]}]");
        load(file).hasBox(0, 0, 0, 1, 1, 1);
        load(file.with(",\"scene\":1")).hasBox(7, 0, 0, 8, 1, 1);
        assertRefused(GltfFile.cube().roots("[]"), "scenes is missing, legal: a list with the scene of the model");
    }

    @Test
    public void numbersThatAreNotWholeOrNoNumbersAreRefused() throws Exception {
        assertRefused(GltfFile.cube().node("\"mesh\":0.5"), "nodes[0].mesh is 0.5, legal: 0 to 0");
        assertRefused(GltfFile.cube().node("\"mesh\":\"0\""), "nodes[0].mesh is \"0\", legal: 0 to 0");
        assertRefused(GltfFile.cube().primitive(POSITIONS + ",\"mode\":4.5"),
            "meshes[0].primitives[0].mode is 4.5, legal: a whole number");
        for (String[] change : new String[][] {{"\"count\":8", "\"count\":7.5",
            "accessors[0].count is 7.5, legal: a whole number"},
            {"\"count\":8", "\"count\":\"8\"", "accessors[0].count is \"8\", legal: a finite number"},
            {"\"byteOffset\":96", "\"byteOffset\":96.5",
            "bufferViews[1].byteOffset is 96.5, legal: a whole number from 0 to 168"},
            {"5123", "5123.5", "accessors[1].componentType is 5123.5, legal: a whole number"},
            {"\"version\":\"2.0\"", "\"version\":\"1.0\"", "asset.version is 1.0, legal: 2.0"},
            {"\"version\":\"2.0\"", "\"version\":\"2.0\",\"minVersion\":\"2.1\"",
            "asset.version is 2.0, and at least 2.1, legal: 2.0"}}) {
            project.with("m.gltf", GltfFile.cube().text().replace(change[0], change[1])).refuses("m.gltf", "m.gltf: "
                + change[2]);
        }
        assertRefused(GltfFile.cube().with(",\"materials\":[5]"), "materials[0] is 5, legal: a JSON object");
        GltfFile colored = GltfFile.cube()
            .with(",\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1]}}]");
        assertRefused(colored.primitive(POSITIONS + ",\"material\":0"), "materials[0] is {\"pbrMetallicRoughness\"");
        project.with("m.gltf", "{\"asset\":\n{,").refuses("m.gltf",
            "m.gltf: the text before line 2, column 2, is no JSON");
        project.with("m.gltf", GltfFile.cube().text().replace("base64,AAAA", "base64,A?AA")).refuses("m.gltf",
            "buffers[0].uri is data:");
    }
}
