// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import org.junit.Rule;
import org.junit.Test;

/** Features of .dae files. */
public class ColladaFormatTest {
    private static final String HEAD = "<COLLADA version='1.4.1'><asset><unit meter='1'/><up_axis>Y_UP</up_axis>"
        + "</asset>";
    private static final String SOURCE = "<source id='%s'><float_array id='%s-a'>%s</float_array><technique_common>"
        + "<accessor source='#%s-a' count='%d' stride='%d'>%s</accessor></technique_common></source>";
    private static final String XYZ = "<param name='X'/><param name='Y'/><param name='Z'/>";
    /** Corners of the unit cube, and of a polygon in its base. */
    private static final String CORNERS = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1";
    private static final String[] SIDES = {"3 2 1 0", "4 5 6 7", "0 1 5 4", "1 2 6 5", "2 3 7 6", "3 0 4 7"};
    private static final String QUADS = "<polylist count='6' material='m'><input semantic='VERTEX' source='#v' "
        + "offset='0'/><vcount>4 4 4 4 4 4</vcount><p>" + String.join(" ", SIDES) + "</p></polylist>";
    private static final String PLAIN = "<node><instance_geometry url='#g'/></node>";
    private static final String BOUND = "<node><matrix>2 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry "
        + "url='#g'><bind_material><technique_common><instance_material symbol='m' target='#red'/></technique_common>"
        + "</bind_material></instance_geometry></node>";
    private static final String MATERIALS = "<library_images><image id='i'><init_from>a%20b.png</init_from></image>"
        + "</library_images><library_effects><effect id='e'><profile_COMMON><newparam sid='f'><surface type='2D'>"
        + "<init_from>i</init_from></surface></newparam><newparam sid='s'><sampler2D><source>f</source></sampler2D>"
        + "</newparam><technique sid='t'><lambert><diffuse><color>1 0 0 1</color></diffuse></lambert></technique>"
        + "</profile_COMMON></effect></library_effects><library_materials><material id='red'><instance_effect "
        + "url='#e'/></material></library_materials>";
    static final String PAINTED = model(HEAD + MATERIALS, QUADS, BOUND);

    @Rule
    public final FormatRule project = new FormatRule();

    private static String source(String id, String numbers, int size, String params) {
        return String.format(SOURCE, id, id, numbers, id, numbers.split(" ").length / size, size, params);
    }

    private static String model(String head, String primitives, String nodes) {
        return head + "<library_geometries><geometry id='g'><mesh>" + source("s", CORNERS, 3, XYZ)
            + "<vertices id='v'><input semantic='POSITION' source='#s'/></vertices>" + primitives
            + "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id='w'>" + nodes
            + "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#w'/></scene></COLLADA>";
    }

    private Measures load(String text) throws Exception {
        return project.with("m.dae", text).load("m.dae");
    }

    private void assertCube(String primitives) throws Exception {
        load(model(HEAD, primitives, PLAIN)).hasBox(0, 0, 0, 1, 1, 1).hasArea(6).hasVolume(1).hasTriangles(12);
    }

    @Test
    public void eachKindOfPolygonIsRead() throws Exception {
        String input = "<input semantic='VERTEX' source='#v' offset='0'/>";
        StringBuilder polygons = new StringBuilder();
        StringBuilder triangles = new StringBuilder();
        StringBuilder fans = new StringBuilder();
        StringBuilder strips = new StringBuilder();
        for (String side : SIDES) {
            String[] c = side.split(" ");
            polygons.append("<p>" + side + "</p>");
            triangles.append(String.join(" ", c[0], c[1], c[2], c[0], c[2], c[3], ""));
            fans.append("<p>" + side + "</p>");
            strips.append("<p>" + String.join(" ", c[0], c[1], c[3], c[2]) + "</p>");
        }
        assertCube(QUADS);
        assertCube("<polygons>" + input + polygons + "</polygons>");
        assertCube("<triangles>" + input + "<p>" + triangles + "</p></triangles>");
        assertCube("<trifans>" + input + fans + "</trifans><lines>" + input + "<p>0 1</p></lines>");
        assertCube("<tristrips>" + input + strips + "</tristrips>");
        String two = "<polylist count='6'><input semantic='VERTEX' source='#v' offset='1'/><input semantic='COLOR' "
            + "source='#c' offset='0'/><vcount>4 4 4 4 4 4</vcount><p>"
            + String.join(" ", SIDES).replaceAll("(\\d)", "9 $1") + "</p></polylist>";
        assertCube(two);
        assertCube("<polygons>" + input + polygons.toString().replaceFirst("<p>(.{7})</p>",
            "<ph><p>$1</p><h>0 1 2</h></ph>") + "</polygons>");
        assertEquals(List.of("model m.dae: the holes of 1 polygons are filled"), project.warnings);
    }

    @Test
    public void unitsAxesAndNodesPlaceTheGeometry() throws Exception {
        load(model(HEAD.replace("'1'", "'0.01'"), QUADS, PLAIN)).hasBox(0, 0, 0, 0.01, 0.01, 0.01);
        String up = "<node><translate>0 0 5</translate><scale>1 1 2</scale><instance_geometry url='#g'/></node>";
        load(model(HEAD, QUADS, up)).hasBox(0, 0, 5, 1, 1, 7).hasVolume(2);
        load(model(HEAD.replace("Y_UP", "Z_UP"), QUADS, up)).hasBox(0, 5, -1, 1, 7, 0).hasVolume(2);
        load(model(HEAD.replace("Y_UP", "X_UP"), QUADS, up)).hasBox(-1, 0, 5, 0, 1, 7).hasVolume(2);
        String nested = "<node><rotate>0 0 2 90</rotate><node><translate>3 0 0</translate><scale>-1 1 1</scale>"
            + "<instance_geometry url='#g'/></node></node>";
        load(model(HEAD, QUADS, nested)).hasBox(-1, 2, 0, 0, 3, 1).hasVolume(1);
        String twice = "</visual_scene></library_visual_scenes><library_nodes><node id='n'><instance_geometry "
            + "url='#g'/></node></library_nodes><library_visual_scenes><visual_scene id='w'><node><instance_node "
            + "url='#n'/></node><node><translate>4 0 0</translate><instance_node url='#n'/></node>";
        load(model(HEAD, QUADS, "</visual_scene></library_visual_scenes><library_visual_scenes><visual_scene id='u'>"
            + twice).replaceFirst("id='w'", "id='first'")).hasBox(0, 0, 0, 5, 1, 1).hasVolume(2);
    }

    @Test
    public void aSkinnedMeshIsInItsBindPose() throws Exception {
        String skin = "<library_controllers><controller id='c'><skin source='#g'><bind_shape_matrix>1 0 0 0 0 1 0 0 0 "
            + "0 3 0 0 0 0 1</bind_shape_matrix></skin></controller></library_controllers>";
        load(model(HEAD + skin, QUADS, "<node><instance_controller url='#c'/></node>")).hasBox(0, 0, 0, 1, 1, 3);
        assertTrue(project.warnings.toString(), project.warnings.contains("model m.dae: 1 skinned meshes are in their "
            + "bind pose"));
    }

    @Test
    public void materialsHaveTheirColourOrPicture() throws Exception {
        load(PAINTED).hasBox(5, 0, 0, 7, 1, 1).hasVolume(2);
        assertEquals(List.of(), project.warnings);
        assertEquals(0xff0000, project.look("m.dae").materials.get(0).pixels[0]);
        project.with("a b.png", BrokenModels.png(2, 2));
        String textured = PAINTED.replace("<color>1 0 0 1</color>", "<texture texture='s' texcoord='UV'/>");
        load(textured);
        assertEquals(List.of(), project.warnings);
        assertEquals(2, project.look("m.dae").materials.get(0).width);
        load(textured.replace("a%20b.png", "file:///C:/pictures/a%20b.png"));
        assertEquals(2, project.look("m.dae").materials.get(0).width);
        load(textured.replace("a%20b.png", "../../elsewhere.png"));
        assertEquals(1, project.warnings.size());
        load(textured.replace("texture='s'", "texture='none'"));
        assertTrue(project.warnings.toString(), project.warnings.get(0).contains("the picture of <texture> in line 1"));
        load(model(HEAD, QUADS, PLAIN));
        assertEquals(List.of("model m.dae: it binds no material to m; these surfaces are white"), project.warnings);
    }

    @Test
    public void errorsNameTheLineAndTheValue() throws Exception {
        refuses(PAINTED.replace("6 7 0", "6 8 0"), "an index of <p> in line 1 is 8, legal: 0 to 7");
        refuses(PAINTED.replace("<vcount>4 ", "<vcount>5 "), "the number of corners of <p> in line 1 is 24, legal: ");
        refuses(PAINTED.replace("<p>3 ", "<p>-3 "), "number 1 of <p> in line 1 is -3, legal: a whole number that is");
        refuses(PAINTED.replace("url='#g'", "url='other.dae#g'"),
            "url of <instance_geometry> in line 1 is other.dae#g, legal: # and the id of a <geometry> of this file");
        refuses(PAINTED.replace("meter='1'", "meter='0'"), "meter of <unit> in line 1 is 0, legal: a number above 0");
        refuses(PAINTED.replace("Y_UP", "W_UP"), "the text of <up_axis> in line 1 is W_UP, legal: X_UP, Y_UP or Z_UP");
        refuses(PAINTED.replace("matrix>2", "matrix>NaN"), "a number of <matrix> in line 1 is NaN, legal: a finite");
        refuses(PAINTED.replace("0 0 0 1</matrix>", "0 0 1 1</matrix>"), "the fourth row of <matrix> in line 1 is ");
        refuses(PAINTED.replace("count='8'", "count='9'"), "count of <accessor> in line 1 is 9, legal: rows that");
        refuses(PAINTED.replace("matrix>", "skew>"), "the transform of <skew> in line 1 is skew, legal: matrix, ");
        refuses("<COLLADA>", "no XML, legal: the XML of a COLLADA model");
        refuses("<mesh/>", "the root element is <mesh>, legal: <COLLADA>");
        refuses("<!DOCTYPE a [<!ENTITY b SYSTEM 'file:///etc/passwd'>]>" + PAINTED, "the text is with a document type");
        refuses(PAINTED.replace("<instance_geometry", "<instance_node url='#n'/><instance_geometry").replace("<node>",
            "<node id='n'>"), "the nesting of <node> in line 1 is without end or too deep, legal: at most 100 deep");
        String doubling = "<node id='n0'><instance_geometry url='#g'/></node>";
        for (int i = 1; i < 30; i++) {
            doubling += "<node id='n" + i + "'><instance_node url='#n" + (i - 1) + "'/><instance_node url='#n" + (i - 1)
                + "'/></node>";
        }
        refuses(model(HEAD, QUADS, doubling), "the number of nodes, each as often as it is used, is 10000, legal: ");
    }

    private void refuses(String text, String part) throws Exception {
        project.with("m.dae", text).refuses("m.dae", part);
    }
}
