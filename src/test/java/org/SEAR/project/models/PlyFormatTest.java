// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.Rule;
import org.junit.Test;

/** Features of .ply files. */
public class PlyFormatTest {
    /** A square with a colour for each corner, and an element without effect. */
    static final String PAINTED = "ply\nformat ascii 1.0\ncomment by hand\nobj_info none\nelement vertex 4\n"
        + "property float x\nproperty float y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
        + "property uchar blue\nelement edge 1\nproperty int vertex1\nproperty list uchar float weights\n"
        + "element face 1\nproperty list uchar uint vertex_index\nend_header\n"
        + "0 0 0 255 0 0\n2 0 0 255 0 0\n2 2 0 0 0 255\n0 2 0 0 0 255\n7 2 0.5 0.5\n4 0 1 2 3\n";

    @Rule
    public final FormatRule project = new FormatRule();

    @Test
    public void textHasTheColoursOfItsVertices() throws Exception {
        project.with("m.ply", PAINTED).load("m.ply").hasBox(0, 0, 0, 2, 2, 0).hasArea(4).hasTriangles(2);
        assertArrayEquals(new float[] {1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1}, project.look("m.ply").colors, 0);
        assertEquals(List.of(), project.warnings);
        project.with("m.ply", PAINTED.replace("\n", "\r\n")).load("m.ply").hasArea(4);
        project.with("m.ply", PAINTED.replace("uchar red", "uchar r0")).load("m.ply").hasArea(4);
        assertNull(project.look("m.ply").colors);
    }

    @Test
    public void facesWithColoursShareNoVertices() throws Exception {
        String faces = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            + "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
            + "property uchar blue\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0 51 255\n";
        project.with("m.ply", faces).load("m.ply").hasArea(1);
        float[] colors = project.look("m.ply").colors;
        assertEquals(18, colors.length);
        assertArrayEquals(new float[] {1, 0, 0, 0, 0.2f, 1}, new float[] {colors[6], colors[7], colors[8], colors[9],
            colors[10], colors[11]}, 1e-6f);
    }

    @Test
    public void bothByteOrdersAreRead() throws Exception {
        byte[] big = StlFormatTest.SOLID.bytes(".ply");
        project.with("m.ply", big).load("m.ply").hasBox(0, 0, 0, 1, 1, 1).hasVolume(1).hasTriangles(12);
        String head = new String(big, StandardCharsets.ISO_8859_1).split("end_header\n")[0] + "end_header\n";
        ByteBuffer from = ByteBuffer.wrap(big);
        from.position(head.length());
        byte[] start = head.replace("big", "little").getBytes(StandardCharsets.ISO_8859_1);
        ByteBuffer to = ByteBuffer.allocate(big.length + 3).order(ByteOrder.LITTLE_ENDIAN).put(start);
        for (int i = 0; i < 24; i++) {
            to.putFloat(from.getFloat());
        }
        for (int i = 0; i < 12; i++) {
            to.put(from.get()).putInt(from.getInt()).putInt(from.getInt()).putInt(from.getInt());
        }
        project.with("m.ply", to.array()).load("m.ply").hasVolume(1);
    }

    @Test
    public void polygonsAndStripsAreRead() throws Exception {
        String text = PAINTED.replace("element vertex 4", "element vertex 6").replace("7 2 0.5 0.5\n",
            "1 1 0 9 9 9\n0 4 0 9 9 9\n7 2 0.5 0.5\n");
        project.with("m.ply", text.replace("4 0 1 2 3\n", "5 0 1 4 2 3\n")).load("m.ply").hasArea(3).hasTriangles(3);
        String strips = text.replace("element face", "element tristrips").replace("uchar uint", "int int");
        project.with("m.ply", strips.replace("4 0 1 2 3\n", "8 0 1 3 2 -1 3 2 5\n")).load("m.ply").hasArea(6)
            .hasVolume(0).hasTriangles(3);
    }

    @Test
    public void aPictureOfACommentIsShown() throws Exception {
        String text = PAINTED.replace("comment by hand", "comment TextureFile missing picture.png").replace(
            "property uchar red\nproperty uchar green\n", "property float s\nproperty float t\n");
        project.with("m.ply", text).load("m.ply");
        assertEquals(List.of("model m.ply: its picture missing picture.png can't be shown: there is no such file in "
            + "assets"), project.warnings);
    }

    @Test
    public void errorsNameThePlaceAndTheValue() throws Exception {
        project.with("m.ply", PAINTED.replace("ascii", "utf8")).refuses("m.ply",
            "line 2 of the head is format utf8 1.0, legal: format ascii, binary_little_endian or binary_big_endian");
        project.with("m.ply", "point cloud").refuses("m.ply", "line 1 of the head is missing, legal: ply");
        project.with("m.ply", PAINTED.replace("float x", "real x")).refuses("m.ply",
            "line 6 of the head is property real x, legal: property, a type and a name");
        project.with("m.ply", PAINTED.replace("float x", "float w")).refuses("m.ply",
            "property x of element vertex is missing, legal: a number");
        project.with("m.ply", PAINTED.replace("vertex 4", "vertex 3999999")).refuses("m.ply",
            "the number of rows of element vertex is 3999999, legal: those that the file has: it is cut off");
        project.with("m.ply", PAINTED.replace("vertex 4", "vertex 4000001")).refuses("m.ply",
            "the number of vertices is 4000001, legal: 0 to 4000000");
        project.with("m.ply", PAINTED.replace("4 0 1 2 3", "4 0 1 2 4")).refuses("m.ply",
            "a corner of face 1 is 4, legal: 0 to 3");
        project.with("m.ply", PAINTED.replace("4 0 1 2 3", "4 0 1 2")).refuses("m.ply", "face 1 is missing, legal: ");
        project.with("m.ply", PAINTED.replace("2 2 0 0", "2 two 0 0")).refuses("m.ply",
            "a number of vertex 3 in line 20 is two, legal: a number with a decimal point");
        byte[] big = StlFormatTest.SOLID.bytes(".ply");
        project.with("m.ply", Arrays.copyOf(big, big.length - 5)).refuses("m.ply", "face 12 is missing, legal: all ");
    }
}
