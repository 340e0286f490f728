// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import com.jme3.bounding.BoundingBox;
import com.jme3.export.binary.BinaryExporter;
import com.jme3.math.Quaternion;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial;
import com.jme3.scene.shape.Box;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributeView;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.zip.GZIPOutputStream;
import org.SEAR.POJOs.Model;
import org.SEAR.geometry.Triangles;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** Every format, with files that the test makes: one triangle (0,0,0) (1,0,0) (0,2,0), moved by (1, 0, -3). */
public class ModelLoaderTest {
    private static final double[] MOVED = {1, 0, -3, 2, 0, -3, 1, 2, -3};

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Triangles load(Model model) throws Exception {
        return new ModelLoader(Project.read(project.folder()).getAssets()).triangles(model);
    }

    private static void assertTriangles(Triangles triangles, double[] expected) {
        double[] corners = new double[triangles.indices.length * 3];
        for (int i = 0; i < triangles.indices.length; i++) {
            for (int axis = 0; axis < 3; axis++) {
                corners[i * 3 + axis] = triangles.vertices[triangles.indices[i] * 3 + axis];
            }
        }
        assertArrayEquals(expected, corners, 1e-6);
    }

    private void put(String file, byte[] bytes) throws IOException {
        project.put(file, "");
        Files.write(project.folder().resolve(file), bytes);
    }

    /** Threads of a Python 3 process that runs Java inside have no class loader. */
    @Test
    public void aThreadWithoutClassLoaderFindsTheModelsThatComeWithSear() throws Exception {
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        Thread.currentThread().setContextClassLoader(null);
        try {
            assertTrue(load(new Model("plant", "models/Tree/Tree.mesh.xml")).size() > 0);
        } finally {
            Thread.currentThread().setContextClassLoader(before);
        }
    }

    /** A polygon splits into the expected number of triangles without overlap: the areas are equal. */
    private void assertWhole(String obj, int triangles, double area) throws Exception {
        project.put("assets/polygon.obj", obj);
        Triangles made = load(new Model("polygon", "polygon.obj"));
        assertEquals(triangles, made.size());
        double sum = 0;
        for (int i = 0; i < made.indices.length; i += 3) {
            float[] v = made.vertices;
            int a = 3 * made.indices[i];
            int b = 3 * made.indices[i + 1];
            int c = 3 * made.indices[i + 2];
            sum += ((v[b] - v[a]) * (v[c + 1] - v[a + 1]) - (v[b + 1] - v[a + 1]) * (v[c] - v[a])) / 2;
        }
        assertEquals(area, sum, 1e-6);
    }

    @Test
    public void anObjMayHaveCommentsBehindNumbersAndColoursOfCorners() throws Exception {
        assertWhole("v 0 0 0 1 0 0 # red\nv 1 0 0 1 0.5 0\nv 0 1 0 1 1 1\nvt 0 0 # a place\no a#b\nf 1/1 2/-1 "
            + "3/1 # a face\n", 1, 0.5);
    }

    @Test
    public void anObjMayHaveFacesOfManyCorners() throws Exception {
        StringBuilder disc = new StringBuilder();
        StringBuilder face = new StringBuilder("f");
        for (int i = 0; i < 32; i++) {
            disc.append("v ").append(Math.cos(Math.PI * i / 16)).append(' ').append(Math.sin(Math.PI * i / 16))
                .append(" 0\n");
            face.append(' ').append(i - 32);
        }
        assertWhole(disc.toString() + face + "\n", 30, 16 * Math.sin(Math.PI / 16));
        String corner = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n";
        assertWhole("\ufeff# an L\r\n" + corner + "f 1 2 3 \\\n 4 5 6\n", 4, 4);
        assertWhole(corner + "vt 0 0\nf 3/1 4/1 5/1 6/1 1/1 2/1\n", 4, 4);
    }

    @Test
    public void theTreeOfTheDissertationComesWithSear() throws Exception {
        Model tree = new Model("Tree1_name", "models/Tree/Tree.mesh.xml");
        ModelLoader loader = new ModelLoader(Project.read(project.folder()).getAssets());
        assertEquals(5 * 36 + 7 * 12 * 18, loader.triangles(tree).size());
        BoundingBox bounds = (BoundingBox) loader.spatial(tree).getWorldBound();
        assertEquals(4, bounds.getMax(null).y, 0.2);
        assertEquals(0, bounds.getMin(null).y, 0.01);
    }

    @Test
    public void everyFormatGivesItsTriangles() throws Exception {
        ModelFiles triangle = new ModelFiles(new float[] {0, 0, 0, 1, 0, 0, 0, 2, 0}, new int[] {0, 1, 2}, 1, 0, -3);
        for (String ending : ModelLoader.ENDINGS) {
            assertTriangles(load(new Model("m", "./" + triangle.put(project, ending))), MOVED);
        }
    }

    @Test
    public void aBlenderFileMayBePackedAndHasPolygonsOfManyCorners() throws Exception {
        float[] house = {0, 0, 0, 2, 0, 0, 2, 0, 2, 1, 0, 3, 0, 0, 2};
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
            out.write(BlendFile.mesh(house, new int[][] {{0, 1, 2, 3, 4}}, new float[] {0, 5, 0}));
        }
        put("assets/house.blend", packed.toByteArray());
        Triangles triangles = load(new Model("m", "house.blend"));
        assertEquals(3, triangles.size());
        double area = 0;
        for (int i = 0; i < triangles.indices.length; i += 3) {
            area += area(triangles, i);
        }
        assertEquals(5, area, 1e-5);
    }

    /** Returns the area of a triangle in the plane z = -5. */
    private static double area(Triangles triangles, int first) {
        double[] x = new double[3];
        double[] y = new double[3];
        for (int i = 0; i < 3; i++) {
            int vertex = triangles.indices[first + i] * 3;
            x[i] = triangles.vertices[vertex];
            y[i] = triangles.vertices[vertex + 1];
            assertEquals(-5, triangles.vertices[vertex + 2], 1e-6);
        }
        return ((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])) / 2;
    }

    @Test
    public void j3oWithNodesThatMoveTurnAndScale() throws Exception {
        Node root = new Node("root");
        Geometry box = new Geometry("box", new Box(0.5f, 0.5f, 0.5f));
        root.attachChild(box);
        root.setLocalTranslation(1, 2, 3);
        root.setLocalRotation(new Quaternion().fromAngles(0, (float) Math.PI / 2, 0));
        box.setLocalScale(2, 1, 4);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        BinaryExporter.getInstance().save(root, out);
        put("assets/b.j3o", out.toByteArray());
        Triangles triangles = load(new Model("m", "b.j3o"));
        assertEquals(12, triangles.size());
        double[] low = {9, 9, 9};
        double[] high = {-9, -9, -9};
        for (int i = 0; i < triangles.vertices.length; i++) {
            low[i % 3] = Math.min(low[i % 3], triangles.vertices[i]);
            high[i % 3] = Math.max(high[i % 3], triangles.vertices[i]);
        }
        assertArrayEquals(new double[] {-1, 1.5, 2}, low, 1e-5);
        assertArrayEquals(new double[] {3, 2.5, 4}, high, 1e-5);
    }

    @Test
    public void aTerrainsCentreIsTheOrigin() throws Exception {
        project.put("assets/hill.obj", "v 10 5 10\nv 30 5 10\nv 30 9 30\nv 10 9 30\nf 1 4 3\nf 1 3 2\n");
        Model terrain = new Model("hill", "hill.obj");
        terrain.setTerrain(true);
        assertTriangles(load(terrain), new double[] {-10, -2, -10, -10, 2, 10, 10, 2, 10, -10, -2, -10, 10, 2, 10,
            10, -2, -10});
        Spatial shown = new ModelLoader(Project.read(project.folder()).getAssets()).spatial(terrain);
        assertEquals(0, shown.getWorldBound().getCenter().length(), 1e-5);
    }

    private void assertRefused(String file, String message) throws Exception {
        try {
            load(new Model("m", file));
            fail(file + " was loaded");
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().contains(message) && e.getMessage().contains("Model \"m\""));
        }
    }

    @Test
    public void hostileAndBrokenModelsAreRefused() throws Exception {
        project.put("assets/evil.mesh.xml", "<?xml version=\"1.0\"?><!DOCTYPE mesh [<!ENTITY x SYSTEM "
            + "\"file:///etc/passwd\">]><mesh>&x;</mesh>");
        assertRefused("evil.mesh.xml", "document type");
        project.put("assets/broken.mesh.xml", "<mesh><submeshes>");
        assertRefused("broken.mesh.xml", "can't be loaded");
        project.put("assets/empty.obj", "# nothing\n");
        assertRefused("empty.obj", "no triangles");
        project.put("assets/noise.j3o", "JME3\u0001\u0002\u0003");
        assertRefused("noise.j3o", "can't be loaded");
        project.put("assets/cut.gltf", "{\"asset\":");
        assertRefused("cut.gltf", "can't be loaded");
        project.put("assets/cut.glb", "glTF\u0002");
        assertRefused("cut.glb", "can't be loaded");
        project.put("assets/noise.blend", "BLENDER-v279REND");
        assertRefused("noise.blend", "can't be loaded");
    }

    @Test
    public void aBlenderFileThatLinksToAnotherIsRefusedAndTheOtherNotRead() throws Exception {
        float[] corners = {0, 0, 0, 2, 0, 0, 2, 0, 2};
        byte[] other = BlendFile.mesh(corners, new int[][] {{0, 1, 2}}, new float[3]);
        Path outside = project.getRoot().toPath().resolve("other.blend");
        Files.write(outside, other);
        put("assets/inside.blend", other);
        for (String path : new String[] {outside.toString(), "//../../other.blend", "//inside.blend",
            "/nowhere.blend"}) {
            put("assets/linked.blend", BlendFile.linked(path));
            FileTime before = lastRead(outside);
            assertRefused("linked.blend",
                "linked.blend: its content is with links to other files, legal: everything local");
            assertEquals(before, Files.readAttributes(outside, BasicFileAttributes.class).lastAccessTime());
        }
        Model model = new Model("linked model", "linked.blend");
        try {
            Simulation.load(project.folder(), 1).close();
            fail("was loaded");
        } catch (ProjectException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("linked model.xml")
                && e.getMessage().contains("with links to other files"));
        }
        assertEquals("linked.blend", model.getPath());
    }

    /**
     * Returns the last access time after setting it far back, because systems with lazy access times then record the
     * next read.
     */
    private static FileTime lastRead(Path file) throws IOException {
        Files.getFileAttributeView(file, BasicFileAttributeView.class).setTimes(null, FileTime.fromMillis(0), null);
        return Files.readAttributes(file, BasicFileAttributes.class).lastAccessTime();
    }

    @Test
    public void aJ3oMayNameClassesOfScenesOnly() throws Exception {
        Node root = new Node("root");
        root.attachChild(new Geometry("box", new Box(1, 1, 1)));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        BinaryExporter.getInstance().save(root, out);
        String text = new String(out.toByteArray(), StandardCharsets.ISO_8859_1);
        String gadget = text.replace("com.jme3.scene.Node", "java.util.Properties".substring(0, 19));
        put("assets/gadget.j3o", gadget.getBytes(StandardCharsets.ISO_8859_1));
        assertRefused("gadget.j3o", "java.util.Propertie");
    }
}
