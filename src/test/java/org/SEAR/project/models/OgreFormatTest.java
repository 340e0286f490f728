// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.util.Arrays;
import org.junit.Rule;
import org.junit.Test;

/** Features of OGRE's mesh.xml files, by bounding box, area and volume. */
public class OgreFormatTest {
    private static final int[] CUBE = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7,
        2, 7, 6, 3, 0, 4, 3, 4, 7};
    private static final double[] CORNERS = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};

    @Rule
    public final FormatRule project = new FormatRule();

    private static String buffer(double... corners) {
        StringBuilder text = new StringBuilder("<vertexbuffer positions=\"true\">\n");
        for (int i = 0; i < corners.length; i += 3) {
            text.append("<vertex><position x=\"" + corners[i] + "\" y=\"" + corners[i + 1] + "\" z=\"" + corners[i + 2]
                + "\"/></vertex>\n");
        }
        return text + "</vertexbuffer>";
    }

    private static String geometry(String element, double... corners) {
        return "<" + element + " vertexcount=\"" + corners.length / 3 + "\">" + buffer(corners) + "</" + element + ">";
    }

    private static String faces(int... corners) {
        StringBuilder text = new StringBuilder("<faces count=\"" + corners.length / 3 + "\">");
        for (int i = 0; i < corners.length; i += 3) {
            text.append("<face v1=\"" + corners[i] + "\" v2=\"" + corners[i + 1] + "\" v3=\"" + corners[i + 2]
                + "\"/>");
        }
        return text + "</faces>";
    }

    private static String submesh(String attributes, String content) {
        return "<submesh " + attributes + ">" + content + "</submesh>";
    }

    private Measures load(String inside) throws IOException {
        return project.with("m.mesh.xml", "<?xml version=\"1.0\"?>\n<mesh>" + inside + "</mesh>").load("m.mesh.xml");
    }

    private void assertRefused(String inside, String message) throws IOException {
        project.with("m.mesh.xml", "<mesh>\n" + inside + "</mesh>").refuses("m.mesh.xml", "m.mesh.xml: " + message);
    }

    private void assertCube(String inside) throws IOException {
        load(inside).hasBox(0, 0, 0, 1, 1, 1).hasArea(6).hasVolume(1).hasTriangles(12);
    }

    @Test
    public void ownAndSharedVerticesAreRead() throws Exception {
        assertCube("<submeshes>" + submesh("", faces(CUBE) + geometry("geometry", CORNERS)) + "</submeshes>");
        String halves = submesh("usesharedvertices=\"true\"", faces(Arrays.copyOf(CUBE, 18)))
            + submesh("material=\"x\" usesharedvertices=\"true\"", faces(Arrays.copyOfRange(CUBE, 18, 36)));
        assertCube(geometry("sharedgeometry", CORNERS) + "<submeshes>" + halves + "</submeshes>");
        assertCube("<submeshes>" + halves + "</submeshes>" + geometry("sharedgeometry", CORNERS));
        assertCube(geometry("sharedgeometry", 0, 0, 0, 9, 9, 9, 9, 0, 0) + "<submeshes>"
            + submesh("usesharedvertices=\"false\"", faces(CUBE) + geometry("geometry", CORNERS)) + "</submeshes>");
    }

    @Test
    public void verticesMayHaveSeveralBuffersAndOtherProperties() throws Exception {
        StringBuilder others = new StringBuilder("<vertexbuffer normals=\"true\" texture_coords=\"2\" "
            + "colours_diffuse=\"true\">");
        for (int i = 0; i < 8; i++) {
            others.append("<vertex><normal x=\"0\" y=\"0\" z=\"1\"/><colour_diffuse value=\"1 0 0 1\"/><texcoord "
                + "u=\"0.5\" v=\"1\"/><texcoord u=\"0\"/><tangent x=\"1\"/></vertex>");
        }
        String rest = "<skeletonlink name=\"none\"/><levelofdetail><lodfacelist><faces count=\"1\"><face "
            + "v1=\"9\"/></faces></lodfacelist></levelofdetail>"
            + "<submeshnames><submesh name=\"a\" index=\"0\"/></submeshnames>";
        assertCube("<submeshes>" + submesh("", faces(CUBE) + "<geometry vertexcount=\"8\">" + buffer(CORNERS) + others
            + "</vertexbuffer></geometry>"
            + "<boneassignments><vertexboneassignment vertexindex=\"0\"/></boneassignments>") + "</submeshes>" + rest);
        assertEquals(0.5, project.look("m.mesh.xml").places[0], 0);
    }

    @Test
    public void stripsFansAndLines() throws Exception {
        String strip = "<faces count=\"3\"><face v1=\"0\" v2=\"1\" v3=\"2\"/><face v1=\"3\"/><face v1=\"4\"/></faces>";
        double[] corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
        load("<submeshes>" + submesh("operationtype=\"triangle_strip\"", strip + geometry("geometry", corners))
            + "</submeshes>")
            .hasTriangles(3).hasArea(1.5).hasBox(0, 0, 0, 1, 2, 0);
        double[] round = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 0, 0};
        load("<submeshes>" + submesh("operationtype=\"triangle_fan\"", strip + geometry("geometry", round))
            + "</submeshes>")
            .hasTriangles(3).hasArea(1.5).hasBox(-1, 0, 0, 1, 1, 0);
        assertCube("<submeshes>" + submesh("operationtype=\"line_list\"",
            "<faces count=\"9\"><face v1=\"0\" v2=\"1\"/></faces>"
            + geometry("geometry", 9, 9, 9)) + submesh("operationtype=\"triangle_list\"", faces(CUBE)
            + geometry("geometry", CORNERS)) + "</submeshes>");
        assertRefused(submesh("operationtype=\"quads\"", ""),
            "operationtype of <submesh> in line 2 is quads, legal: one of triangle_list, ");
    }

    /** jMonkeyEngine's reader keeps 16 bits. */
    @Test
    public void largeIndicesNeedNoFlag() throws Exception {
        double[] many = new double[3 * 70_000];
        many[3 * 69_999] = 1;
        many[3 * 69_998 + 1] = 1;
        load(submesh("use32bitindexes=\"false\"", faces(0, 69_999, 69_998) + geometry("geometry", many))).hasBox(0, 0,
            0, 1, 1, 0).hasArea(0.5);
    }

    @Test
    public void errorsNameTheLineTheElementAndTheValue() throws Exception {
        String cube = faces(CUBE) + "\n" + geometry("geometry", CORNERS);
        assertRefused(submesh("", cube.replace("count=\"12\"", "count=\"13\"")),
            "the number of faces of the submesh in line 2 is 12, legal: 13 to 13");
        assertRefused(submesh("", cube.replace("vertexcount=\"8\"", "vertexcount=\"9\"")),
            "the number of vertices of <geometry> in line 3, by their positions, is 8, legal: 9 to 9");
        assertRefused(submesh("", cube.replace("vertexcount=\"8\"", "vertexcount=\"7\"")),
            "<vertex> in line 11 is at a wrong place, legal: once for each");
        assertRefused(submesh("", cube.replace("x=\"1.0\"", "x=\"1,0\"")),
            "x of <position> in line 5 is 1,0, legal: a number with a decimal point");
        assertRefused(submesh("", cube.replace("v2=\"2\"", "v2=\"-2\"")),
            "v2 of <face> in line 2 is -2, legal: a whole number from 0 to 3999999");
        assertRefused(submesh("", cube.replace("v2=\"2\"", "v2=\"8\"")),
            "corner 2 of the submesh in line 2 is 8, legal: 0 to 7");
        assertRefused(submesh("", faces(CUBE)), "the geometry of the submesh in line 2 is missing");
        assertRefused(geometry("geometry", CORNERS), "<geometry> in line 2 is at a wrong place, legal: in a submesh");
        project.with("m.mesh.xml", "<mesh>\n<submesh</mesh>").refuses("m.mesh.xml",
            "m.mesh.xml: the text before line 2, column 9, is no XML");
        project.with("m.mesh.xml", "<html/>").refuses("m.mesh.xml",
            "m.mesh.xml: <mesh> is missing, legal: the XML of an OGRE mesh");
    }

    @Test
    public void aMaterialThatIsMissingOrBrokenIsAWarning() throws Exception {
        String cube = submesh("material=\"red\"", faces(CUBE) + geometry("geometry", CORNERS));
        project.with("m.material", "material blue\n{\n technique\n {\n  pass\n  {\n  }\n }\n}\n");
        assertCube(cube);
        assertEquals(Arrays.asList("model m.mesh.xml: its .material has no red; these submeshes are white"),
            project.warnings);
        project.with("m.material", "material red\n{\n technique\n {\n  pass\n  {\n   diffuse red\n  }\n }\n}\n");
        assertCube(cube);
        assertEquals(project.warnings.toString(), 1, project.warnings.size());
    }
}
