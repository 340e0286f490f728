// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.SEAR.POJOs.Model;
import org.SEAR.Slow;
import org.SEAR.files.PictureSize;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.models.format.ModelLimits;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Each broken model and picture is a problem with the object's file, its field and the error, found before anything is
 * made from it.
 */
@Category(Slow.class)
public class BrokenModelsTest {
    private static final String INDICES = "\"indices\":1";

    @Rule
    public final ProjectRule project = new ProjectRule();

    private void asset(String name, byte[] bytes) throws IOException {
        Path file = project.folder().resolve("assets").resolve(name);
        Files.createDirectories(file.getParent());
        Files.write(file, bytes);
    }

    /** Returns the messages for a world with this one object. */
    private String problem(String object) throws Exception {
        project.put("environment/o.xml", object);
        try (Simulation made = Simulation.load(project.folder(), 1)) {
            made.step();
            return "a world at " + made.snapshot().time;
        } catch (ProjectException e) {
            assertEquals(e.getMessage(), 1, e.getProblems().size());
            return e.getMessage();
        }
    }

    private static String model(String file, int mass) {
        return "<Model><name>o</name><path>" + file + "</path><mass>" + mass + "</mass></Model>";
    }

    @Test
    public void eachModelIsRefusedWithItsMessage() throws Exception {
        BrokenModels broken = BrokenModels.models();
        assertTrue(broken.files.size() + " models", broken.files.size() >= 60);
        List<String> wrong = new ArrayList<>();
        for (Map.Entry<String, byte[]> file : broken.files.entrySet()) {
            asset(file.getKey(), file.getValue());
            for (int mass = 0; mass < 2; mass++) {
                String said = problem(model(file.getKey(), mass));
                boolean good = said.startsWith("environment/o.xml")
                    && said.contains("path is \"" + file.getKey() + "\"")
                    && said.contains(broken.messages.get(file.getKey()));
                if (!good) {
                    wrong.add(file.getKey() + ": " + said);
                }
            }
        }
        assertEquals(Collections.emptyList(), wrong);
    }

    @Test
    public void eachPictureIsRefusedWithItsMessage() throws Exception {
        BrokenModels broken = BrokenModels.pictures();
        List<String> wrong = new ArrayList<>();
        for (Map.Entry<String, byte[]> file : broken.files.entrySet()) {
            asset(file.getKey(), file.getValue());
            String said = problem("<Box><name>o</name><length>1</length><width>1</width><height>1</height><image>"
                + file.getKey() + "</image></Box>");
            if (!said.contains("image is \"" + file.getKey() + "\"")
                || !said.contains(broken.messages.get(file.getKey()))) {
                wrong.add(file.getKey() + ": " + said);
            }
        }
        assertEquals(Collections.emptyList(), wrong);
    }

    @Test
    public void aHugePictureOfAModelIsRefusedToo() throws Exception {
        asset("p.png", BrokenModels.png(30_000, 20_000));
        String obj = "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";
        asset("m.obj", obj.getBytes(StandardCharsets.UTF_8));
        asset("m.mtl", "newmtl a\nmap_Kd p.png\n".getBytes(StandardCharsets.UTF_8));
        String said = problem(model("m.obj", 0));
        assertTrue(said, said.contains("p.png: the picture's size is 30000 x 20000"));
    }

    @Test
    public void aPictureThatOnlyCantBeShownIsAWarning() throws Exception {
        asset("noise.png", new byte[100]);
        asset("cut.png", Arrays.copyOf(BrokenModels.png(2, 2), 20));
        for (String name : new String[] {"noise.png", "cut.png"}) {
            project.put("environment/o.xml",
                "<Box><name>o</name><length>1</length><width>1</width><height>1</height><image>"
                + name + "</image></Box>");
            String warnings = Project.read(project.folder()).getWarnings().toString();
            assertTrue(warnings, warnings.contains("the picture of Box \"o\" can't be shown (" + name));
        }
    }

    /** Models are often passed on without their pictures. */
    @Test
    public void aModelWithoutItsPicturesIsPlainAndAWarning() throws Exception {
        asset("noise.png", new byte[100]);
        asset("cut.png", Arrays.copyOf(BrokenModels.png(2, 2), 20));
        asset("other.tiff", new byte[100]);
        ModelFiles solid = new ModelFiles(new float[] {0, 0, 0, 1, 0, 0, 0, 2, 0}, new int[] {0, 1, 2}, 0, 0, 0);
        String gltf = new String(solid.bytes(".gltf"), StandardCharsets.UTF_8)
            .replace(INDICES, "\"material\":0," + INDICES);
        for (String name : new String[] {"missing.png", "noise.png", "cut.png", "other.tiff", "../../elsewhere.png",
            "C:\\\\pictures\\\\a.png"}) {
            asset("m.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
                .getBytes(StandardCharsets.UTF_8));
            asset("m.mtl", ("newmtl a\nmap_Kd " + name.replace("\\\\", "\\") + "\n").getBytes(StandardCharsets.UTF_8));
            asset("m.gltf", gltf.replace("\"asset\"",
                "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],"
                + "\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"" + name + "\"}],\"asset\"")
                    .getBytes(StandardCharsets.UTF_8));
            for (String file : new String[] {"m.obj", "m.gltf"}) {
                assertOneWarning(file, "model " + file + ": its picture ", name.replace("\\\\", "\\")
                    .replace("../", ""), " can't be shown: ");
            }
        }
        for (String texture : new String[] {"{}", "{\"extensions\":{\"EXT_texture_webp\":{\"source\":0}}}"}) {
            String rest = "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],"
                + "\"textures\":[" + texture + "],\"images\":[{\"uri\":\"a.webp\"}],\"asset\"";
            asset("m.gltf", gltf.replace("\"asset\"", rest).getBytes(StandardCharsets.UTF_8));
            asset("m.glb", glb(solid.bytes(".glb"), json -> json.replace(INDICES, "\"material\":0," + INDICES)
                .replace("\"asset\"", rest)));
            for (String file : new String[] {"m.gltf", "m.glb"}) {
                assertOneWarning(file, "model " + file + ": its picture textures[0] without a source can't be shown: ");
            }
        }
        asset("m.mtl", "newmtl a\nKd red\n".getBytes(StandardCharsets.UTF_8));
        assertOneWarning("m.obj", "its materials m.mtl are left out: a line lacks a number");
        Files.delete(project.folder().resolve("assets/m.mtl"));
        assertOneWarning("m.obj", "its materials m.mtl are left out: there is no such file in assets");
    }

    /** Returns a .glb with changed JSON. */
    private static byte[] glb(byte[] whole, UnaryOperator<String> change) {
        ByteBuffer in = ByteBuffer.wrap(whole).order(ByteOrder.LITTLE_ENDIAN);
        int data = 20 + in.getInt(12);
        byte[] json = change.apply(new String(whole, 20, data - 20, StandardCharsets.UTF_8))
            .getBytes(StandardCharsets.UTF_8);
        int size = 20 + json.length + whole.length - data;
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN).put(whole, 0, 8).putInt(size)
            .putInt(json.length).put(whole, 16, 4).put(json).put(whole, data, whole.length - data).array();
    }

    /** Two objects of one model cause one warning, which the window also shows. */
    private void assertOneWarning(String file, String... words) throws Exception {
        project.put("environment/o.xml", model(file, 0));
        project.put("environment/p.xml", model(file, 0).replace("<name>o", "<x>5</x><name>p"));
        try (Simulation made = Simulation.load(project.folder(), 1)) {
            List<String> warnings = made.snapshot().warnings;
            assertEquals(warnings.toString(), 1, warnings.size());
            for (String word : words) {
                assertTrue(warnings.toString(), warnings.get(0).contains(word));
            }
            new ModelLoader(Project.read(project.folder()).getAssets())
                .look((Model) Project.read(project.folder()).getEnvironment().get(0));
        }
    }

    @Test
    public void allUnloadableModelsAreReportedTogether() throws Exception {
        asset("a.obj", "v 0 0\n".getBytes(StandardCharsets.UTF_8));
        asset("b.glb", "no glb, for it has other bytes".getBytes(StandardCharsets.UTF_8));
        project.put("environment/a.xml", model("a.obj", 0).replace("<name>o", "<name>a"));
        project.put("environment/b.xml", model("b.glb", 1).replace("<name>o", "<name>b"));
        try (Simulation made = Simulation.load(project.folder(), 1)) {
            fail("a world at " + made.snapshot().time);
        } catch (ProjectException e) {
            assertEquals(e.getMessage(), 2, e.getProblems().size());
            assertTrue(e.getMessage(), e.getMessage().contains("environment/a.xml: path is \"a.obj\""));
            assertTrue(e.getMessage(), e.getMessage().contains("b.glb: the head is"));
        }
    }

    @Test
    public void onlyThePixelsOfAPngAreUnpacked() throws Exception {
        byte[] png = BrokenModels.png(2, 2);
        byte[] text = "\0\0\0\4zTXtboom\0\0\0\0".getBytes(StandardCharsets.ISO_8859_1);
        byte[] with = new byte[png.length + text.length];
        System.arraycopy(png, 0, with, 0, 33);
        System.arraycopy(text, 0, with, 33, text.length);
        System.arraycopy(png, 33, with, 33 + text.length, png.length - 33);
        assertArrayEquals(png, PictureSize.checked(with, "p.png"));
    }

    @Test
    public void aModelThatIsTooLargeIsNotEvenOpened() throws Exception {
        asset("large.obj", new byte[0]);
        try (RandomAccessFile file = new RandomAccessFile(project.folder().resolve("assets/large.obj")
            .toFile(), "rw")) {
            file.setLength(ModelLimits.MAX_FILE + 1);
        }
        String said = problem(model("large.obj", 0));
        if (!said.contains("large.obj has 268435457 bytes, legal: at most 268435456")) {
            fail(said);
        }
    }
}
