// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.Rule;
import org.junit.Test;

/** Features of .obj files, by bounding box, area and volume. */
public class ObjFormatTest {
    private static final String CUBE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
    private static final String[] SIDES = {"f 4 3 2 1\n", "f 5 6 7 8\n", "f 1 2 6 5\n", "f 2 3 7 6\n", "f 3 4 8 7\n",
        "f 4 1 5 8\n"};

    @Rule
    public final FormatRule project = new FormatRule();

    private static String cube(String... before) {
        StringBuilder text = new StringBuilder(CUBE);
        for (int i = 0; i < SIDES.length; i++) {
            text.append(i < before.length ? before[i] : "").append(SIDES[i]);
        }
        return text.toString();
    }

    private void assertCube(String obj) throws Exception {
        project.with("m.obj", obj).load("m.obj").hasBox(0, 0, 0, 1, 1, 1).hasArea(6).hasVolume(1).hasTriangles(12);
    }

    @Test
    public void facesWithoutAKnownMaterialAreWhite() throws Exception {
        project.with("m.mtl", "newmtl red\nKd 1 0 0\n");
        assertCube("mtllib m.mtl\n" + cube("", "usemtl red\n", "usemtl missing\n", "usemtl\n", "usemtl red\n"));
        assertEquals(Arrays.asList("model m.obj: its .mtl has no material missing; these faces are white"),
            project.warnings);
        ModelAppearance look = project.look("m.obj");
        int red = 0;
        for (short material : look.materialOf) {
            int color = look.materials.get(material).pixels[0];
            assertTrue(Integer.toHexString(color), color == 0xff0000 || color == 0xffffff);
            red += color == 0xff0000 ? 1 : 0;
        }
        assertEquals(6, red);
    }

    @Test
    public void aUsemtlWithoutNameTakesNothingElse() throws Exception {
        project.with("m.obj", "usemtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\n").load("m.obj").hasBox(0, 0, 0, 1,
            1, 0).hasArea(0.5);
        assertCube(cube("usemtl\n", "usemtl \t\n", "g\n", "o\n"));
    }

    @Test
    public void materialsMayComeFromSeveralLibrariesWithSpacesInTheirNames() throws Exception {
        project.with("a.mtl", "newmtl dark red\nKd 0.5 0 0\n").with("b c.mtl", "newmtl blue\nKd 0 0 1\n");
        assertCube("mtllib a.mtl ./x/b c.mtl\n" + cube("usemtl dark red\n", "usemtl blue\n"));
        assertEquals(Arrays.asList(), project.warnings);
        assertEquals(2, project.look("m.obj").materials.size());
    }

    @Test
    public void aBrokenLibraryIsAWarning() throws Exception {
        project.with("m.mtl", "newmtl a\nKd red\n");
        assertCube("mtllib m.mtl\nmtllib nothing.mtl\nmtllib\n" + cube("usemtl a\n"));
        assertEquals(project.warnings.toString(), 3, project.warnings.size());
    }

    @Test
    public void anyLineEndsMarksContinuationsAndIndicesAreRead() throws Exception {
        assertCube("\ufeff" + cube().replace("\n", "\r\n"));
        assertCube(cube().replace("\n", "\r"));
        assertCube(cube().replace("f ", "f \\\n ").replace("v ", "v\t"));
        assertCube("vt 0 0\nvn 0 0 1\n" + cube().replaceAll("f (\\d) (\\d) (\\d) (\\d)",
            "f $1/1/1 $2//1 $3/1 $4/-1/-1 # a face"));
        assertCube(cube().replaceAll("(?m)^v (.*)$", "v $1 0.5 0.5 0.5 # grey"));
    }

    @Test
    public void linesAndPointsHaveNoSurfaceAndUnknownLinesAreAWarning() throws Exception {
        assertCube("l 1 2\n#f 1 2 3\n" + cube("l 1 2 3\np 1\nf 1 2\ns off\nvp 0.1\n", "face 1 2 3\nF 1 2 3\n"));
        assertEquals(Arrays.asList("model m.obj: 2 lines are no statements of an .obj and left out, first line 17: "
            + "face 1 2 3"), project.warnings);
        project.with("m.obj", cube("surf 0 1 0 1 1 2\n")).refuses("m.obj",
            "m.obj: line 9 is surf 0 1 0 1 1 2, legal: polygons in this file");
    }

    /** Adds a polygon to the text, turned and moved, beginning at a corner, in one of both orientations. */
    private static String polygon(double[] xy, int first, boolean reversed, double angle) {
        int corners = xy.length / 2;
        StringBuilder text = new StringBuilder();
        StringBuilder face = new StringBuilder("f");
        for (int i = 0; i < corners; i++) {
            double x = xy[2 * i] * Math.cos(angle) - xy[2 * i + 1] * Math.sin(angle) + 100;
            double z = xy[2 * i] * Math.sin(angle) + xy[2 * i + 1] * Math.cos(angle);
            text.append("v " + x + " " + (x * 0.5 - z) + " " + z + "\n");
            int corner = (reversed ? corners - i : i) + first;
            face.append(" " + (corner % corners + 1));
        }
        return text + "" + face + "\n";
    }

    private static double area(double[] xy) {
        double sum = 0;
        for (int i = 0; i < xy.length; i += 2) {
            int next = (i + 2) % xy.length;
            sum += (xy[i] * xy[next + 1] - xy[next] * xy[i + 1]) / 2;
        }
        return Math.abs(sum);
    }

    /** Triangles cover a polygon exactly if the sum of their areas is the polygon's. */
    private void assertFilled(double[] xy, int first, boolean reversed, double angle) throws Exception {
        Measures made = project.with("m.obj", polygon(xy, first, reversed, angle)).load("m.obj");
        String what = Arrays.toString(xy) + " from " + first + (reversed ? ", reversed" : "") + ", turned by " + angle;
        assertEquals(what, area(xy) * Math.sqrt(1 + 0.25 + 1), made.area, 1e-4 * area(xy));
        assertTrue(what, project.warnings.isEmpty());
    }

    @Test
    public void concavePolygonsAreFilledExactly() throws Exception {
        double[][] all = {
            {0, 0, 2, 1, 0, 2, 1, 1},                                                       // dart
            {0, 0, 3, 0, 3, 1, 1, 1, 1, 3, 0, 3},                                           // L
            {0, 0, 5, 0, 5, 5, 0, 5, 0, 3, 4, 3, 4, 2, 0, 2},                               // C
            {0, 0, 1, 0, 2, 0, 3, 0, 3, 3, 2, 1, 1, 1, 0, 3},                               // with corners on an edge
            {0, 0, 4, 0, 4, 4, 0, 4, 0, 0, 1, 1, 1, 3, 3, 3, 3, 1, 1, 1},          // a square hole, by a bridge
            {0, 0, 0, 0, 2, 1, 2, 1, 0, 2, 1, 1, 1, 1},                                     // corners twice
            {0, 0, 2, 1, 5, 2.5, 2, 1, 0, 2, 1, 1}};                                        // a spike
        for (double[] xy : all) {
            for (int first = 0; first < xy.length / 2; first++) {
                assertFilled(xy, first, first % 2 == 1, 0.3 * first);
            }
        }
    }

    @Test
    public void randomPolygonsAreFilledExactly() throws Exception {
        Random random = new Random(1);
        for (int i = 0; i < 60; i++) {
            int corners = 4 + random.nextInt(40);
            double[] xy = new double[2 * corners];
            for (int c = 0; c < corners; c++) {
                double radius = 0.2 + random.nextDouble() * 5;
                xy[2 * c] = radius * Math.cos(2 * Math.PI * c / corners);
                xy[2 * c + 1] = radius * Math.sin(2 * Math.PI * c / corners);
            }
            assertFilled(xy, random.nextInt(corners), random.nextBoolean(), random.nextDouble() * 6);
        }
        double[] comb = new double[2 * 402];
        for (int c = 0; c < 400; c++) {
            comb[2 * c] = c;
            comb[2 * c + 1] = c % 2 == 0 ? 1 : 20;
        }
        comb[800] = 399;
        comb[803] = 0;
        assertFilled(comb, 7, false, 1);
    }

    @Test
    public void aFaceWhoseEdgesCrossIsAWarning() throws Exception {
        project.with("m.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 2 3 0\nf 1 2 3 4\n").load("m.obj").hasTriangles(2);
        assertEquals(Arrays.asList("model m.obj: the edges of 1 faces cross, first those of the face in "
            + "line 5; their surface may be wrong"), project.warnings);
        StringBuilder pentagram = new StringBuilder();
        for (int i = 0; i < 5; i++) {
            pentagram.append("v " + Math.cos(Math.PI * 0.8 * i) + " " + Math.sin(Math.PI * 0.8 * i) + " 0\n");
        }
        project.with("m.obj", pentagram + "f 1 2 3 4 5\n").load("m.obj");
        assertEquals(project.warnings.toString(), 1, project.warnings.size());
    }

    @Test
    public void errorsNameTheLineAndTheValue() throws Exception {
        project.with("m.obj", CUBE + "f 1 2 \\\n 3\nf 1 2 x\n").refuses("m.obj",
            "a corner of the face in line 11 is x, legal: the number of a v line");
        project.with("m.obj", "v 1 2\n").refuses("m.obj",
            "m.obj: line 1 is v 1 2, legal: v and three numbers with decimal points");
        project.with("m.obj", "v 1 2 \u001b[31m\n").refuses("m.obj", "m.obj: line 1 is v 1 2 ?[31m, legal: ");
        project.with("m.obj", CUBE + "vt x\n").refuses("m.obj", "line 9 is vt x, legal: vt and one to three numbers");
        project.with("m.obj", "v " + " ".repeat(5 << 20) + "\n").refuses("m.obj",
            "the number of characters of line 1 is 5242882, legal: 0 to 4194304");
    }
}
