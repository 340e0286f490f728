// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.Rule;
import org.junit.Test;

/** Features of .stl files. */
public class StlFormatTest {
    private static final String FACET = "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n"
        + "      vertex 1 0 0\n      vertex 0 1e0 -0.0\n    endloop\n  endfacet\n";
    static final String TEXT = "solid a part\n" + FACET + "endsolid a part\n";

    private static final float[] CUBE = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
    private static final int[] SIDES = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7,
        2, 7, 6, 3, 0, 4, 3, 4, 7};
    static final ModelFiles SOLID = new ModelFiles(CUBE, SIDES, 0, 0, 0);

    @Rule
    public final FormatRule project = new FormatRule();

    @Test
    public void cornersAtOnePlaceShareAVertex() throws Exception {
        Measures cube = project.with("m.stl", SOLID.bytes(".stl")).load("m.stl").hasBox(0, 0, 0, 1, 1, 1).hasArea(6)
            .hasVolume(1).hasTriangles(12);
        assertEquals(8, cube.triangles.vertices.length / 3);
        assertEquals(List.of(), project.warnings);
    }

    @Test
    public void textMayHaveSeveralSolidsInAnyCase() throws Exception {
        String upper = TEXT.toUpperCase(java.util.Locale.ROOT).replace("-0.0", "2").replace("\n", "\r\n");
        project.with("m.stl", TEXT + upper).load("m.stl").hasBox(0, 0, 0, 1, 1, 2).hasTriangles(2);
        project.with("m.stl", TEXT.replace("0 0 1\n", "nan nan -nan(ind)\n")).load("m.stl").hasArea(0.5);
    }

    @Test
    public void aBinaryFileMayStartLikeText() throws Exception {
        byte[] bytes = SOLID.bytes(".stl");
        System.arraycopy("solid exported".getBytes(StandardCharsets.UTF_8), 0, bytes, 0, 14);
        project.with("m.stl", bytes).load("m.stl").hasVolume(1);
        project.with("m.stl", Arrays.copyOf(bytes, bytes.length + 9)).load("m.stl").hasVolume(1);
        assertEquals(List.of("model m.stl: 9 bytes after its 12 facets are left out"), project.warnings);
    }

    @Test
    public void errorsNameThePlaceAndTheValue() throws Exception {
        byte[] bytes = SOLID.bytes(".stl");
        project.with("m.stl", Arrays.copyOf(bytes, 600)).refuses("m.stl",
            "the file's size is 600 bytes, legal: 684 bytes for the 12 facets in its head: it is cut off, or no STL");
        project.with("m.stl", new byte[50]).refuses("m.stl", "the file's size is 50, legal: 84 to ");
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putFloat(84 + 50 + 12, Float.NaN);
        project.with("m.stl", bytes).refuses("m.stl", "a coordinate of facet 2 is NaN, legal: a finite number up to");
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(80, -1);
        project.with("m.stl", bytes).refuses("m.stl", "the number of facets is 4294967295, legal: 0 to 4000000");
        project.with("m.stl", TEXT.replace("endloop", "vertex 1 1 1 endloop")).refuses("m.stl",
            "the word in line 7 is vertex, legal: endloop");
        project.with("m.stl", TEXT.replace("1e0", "1,0")).refuses("m.stl",
            "a coordinate in line 6 is 1,0, legal: a number with a decimal point");
        project.with("m.stl", "solid a\n" + FACET).refuses("m.stl",
            "the word in line 9 is missing, at the end of the file, legal: endsolid");
        project.with("m.stl", "solid a\nendsolid a\n").refuses("m.stl", "the number of triangles is 0: it has no");
    }

    @Test
    public void aPartInMillimetresIsReportedWithItsScale() throws Exception {
        project.with("m.stl", TEXT.replace("1 0 0\n", "120 0 0\n")).load("m.stl");
        assertEquals(List.of("model m.stl: it is 120 m large. Its file has no unit, and lengths are metres: if it was "
            + "drawn in millimetres, it is 0.120 m, call scale(0.001, 0.001, 0.001)"), project.warnings);
        project.with("m.stl", TEXT.replace("1 0 0\n", "1e-4 0 0\n").replace("1e0", "2e-4")).load("m.stl");
        assertTrue(project.warnings.toString(), project.warnings.get(0).contains("it is 0.000200 m large")
            && project.warnings.get(0).contains("it is 0.200 m, call scale(1000.0, 1000.0, 1000.0)"));
        project.with("m.stl", TEXT.replace("1 0 0\n", "20 0 0\n")).load("m.stl");
        assertEquals(List.of(), project.warnings);
    }
}
