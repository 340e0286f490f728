// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Sphere;
import org.SEAR.Slow;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Looks of shapes that panels receive match the shapes. */
@Category(Slow.class)
public class LookTableTest {
    private static final int CORNERS = 3;

    @Rule
    public final ProjectRule project = new ProjectRule();
    private final LookTable looks = new LookTable();

    private List<WorldState.Thing> world() throws Exception {
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            return new WorldJson(looks).whole(world, new WorldState()).objects;
        }
    }

    private static double[] points(Map<String, Object> part) {
        ByteBuffer bytes = ByteBuffer.wrap(Base64.getDecoder().decode((String) part.get("positions")))
            .order(ByteOrder.LITTLE_ENDIAN);
        double[] low = (double[]) part.get("low");
        double[] high = (double[]) part.get("high");
        double[] points = new double[bytes.remaining() / Short.BYTES];
        for (int i = 0; i < points.length; i++) {
            points[i] = low[i % CORNERS] + (bytes.getShort() & 0xffff) * (high[i % CORNERS] - low[i % CORNERS]) / 65535;
        }
        return points;
    }

    /** A page may send any JSON. */
    @SuppressWarnings({"unchecked", "rawtypes"})
    @Test
    public void invalidListsOfKeysAreRejected() {
        assertEquals("the keys of looks are null, legal: a list of texts",
            assertThrows(IllegalArgumentException.class, () -> looks.of(null)).getMessage());
        for (Object one : new Object[] {null, 1}) {
            List wanted = Arrays.asList("a", one);
            assertEquals("the keys of looks are [a, " + one + "], legal: a list of texts",
                assertThrows(IllegalArgumentException.class, () -> looks.of(wanted)).getMessage());
        }
    }

    @Test
    public void aBoxHasTwelveTrianglesOnItsSides() throws Exception {
        new Box("box", 0.4, 0.6, 0.8, 0).move(1, 2, 3);
        Map<String, Object> part = looks.of(List.of(world().get(0).look + "/0")).get(0);
        double[] points = points(part);
        assertEquals(36, part.get("vertices"));
        assertEquals(36 * CORNERS, points.length);
        byte[] normals = Base64.getDecoder().decode((String) part.get("normals"));
        double[] half = {(Double) ((double[]) part.get("high"))[0], ((double[]) part.get("high"))[1],
            ((double[]) part.get("high"))[2]};
        assertEquals(0.4 * 0.6 * 0.8 / 8, half[0] * half[1] * half[2], 1e-6);
        for (int i = 0; i < points.length; i += CORNERS) {
            for (int axis = 0; axis < CORNERS; axis++) {
                assertEquals(half[axis], Math.abs(points[i + axis]), 1e-4);
                assertTrue("a normal along an axis", Math.abs(normals[i + axis]) == 127 || normals[i + axis] == 0);
            }
        }
    }

    @Test
    public void shapesThatLookAlikeShareALook() throws Exception {
        new Box("a", 1, 1, 1).move(0, 0.5, 0);
        new Box("b", 1, 1, 1).move(3, 0.5, 0);
        new Box("c", 1, 1, 1.001).move(6, 0.5, 0);
        List<WorldState.Thing> objects = world();
        assertEquals(objects.get(0).look, objects.get(1).look);
        assertNotEquals(objects.get(0).look, objects.get(2).look);
    }

    @Test
    public void aLargeLookIsSentInParts() throws Exception {
        StringBuilder file = new StringBuilder();
        int rows = 110;
        for (int i = 0; i < rows * rows; i++) {
            file.append("v ").append(i / rows).append(' ').append(i * 7919 % 13 / 13.0).append(' ').append(i % rows)
                .append('\n');
        }
        for (int i = 0; i < rows * (rows - 1); i++) {
            if (i % rows < rows - 1) {
                file.append("f ").append(i + 1).append(' ').append(i + 2).append(' ').append(i + rows + 1).append('\n');
                file.append("f ").append(i + 2).append(' ').append(i + rows + 2).append(' ').append(i + rows + 1)
                    .append('\n');
            }
        }
        Files.createDirectories(project.folder().resolve("assets"));
        Files.writeString(project.folder().resolve("assets/hills.obj"), file);
        new Model("hills", "hills.obj");
        String id = world().get(0).look;
        int triangles = 2 * (rows - 1) * (rows - 1);
        int parts = (triangles + LookTable.PART - 1) / LookTable.PART;
        assertTrue(parts > 2);
        int vertices = 0;
        for (int i = 0; i < parts; i++) {
            Map<String, Object> part = looks.of(List.of(id + "/" + i)).get(0);
            assertEquals(parts, part.get("parts"));
            vertices += (Integer) part.get("vertices");
        }
        assertEquals(CORNERS * triangles, vertices);
        List<String> all = new ArrayList<>();
        for (int i = 0; i < parts; i++) {
            all.add(id + "/" + i);
        }
        List<Map<String, Object>> answer = looks.of(all);
        assertEquals("as many as fit into a message", 1, answer.size());
        assertTrue(answer.stream().mapToInt(part -> part.toString().length()).sum() < 1 << 20);
    }

    @Test
    public void aPictureOfNoiseWithHolesFitsIntoAMessage() throws Exception {
        BufferedImage noise = new BufferedImage(600, 600, BufferedImage.TYPE_INT_ARGB);
        Random random = new Random(5);
        for (int i = 0; i < noise.getWidth() * noise.getHeight(); i++) {
            noise.setRGB(i % noise.getWidth(), i / noise.getWidth(), random.nextInt());
        }
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ImageIO.write(noise, "png", file);
        String address = SmallPicture.of(file.toByteArray(), "noise.png");
        assertTrue(address.startsWith("data:image/png;base64,"));
        assertTrue("characters: " + address.length(), address.length() <= 400_000);
    }

    @Test
    public void picturesAreSmallAndOnlyThoseOfTheWorld() throws Exception {
        Files.createDirectories(project.folder().resolve("assets"));
        ImageIO.write(new BufferedImage(3000, 1500, BufferedImage.TYPE_INT_RGB), "png", project.folder()
            .resolve("assets/large.png").toFile());
        Files.writeString(project.folder().resolve("assets/secret.txt"), "secret");
        Floor floor = new Floor("floor", 10, 10);
        floor.setImage("large.png");
        new Sphere("ball", 1);
        List<WorldState.Thing> objects = world();
        assertEquals(Optional.of("large.png"), objects.get(1).picture);
        assertEquals(Optional.empty(), objects.get(0).picture);
        Map<String, Object> sent = looks.of(List.of("picture large.png")).get(0);
        String data = (String) sent.get("data");
        assertTrue(data.startsWith("data:image/jpeg;base64,"));
        BufferedImage small = ImageIO.read(
            new ByteArrayInputStream(Base64.getDecoder().decode(data.substring(data.indexOf(',') + 1))));
        assertEquals(512, small.getWidth());
        assertEquals(256, small.getHeight());
        assertEquals(List.of(), looks.of(
            List.of("picture secret.txt", "picture ../robot/x.xml", "nothing", "/", "nothing/0",
            objects.get(0).look + "/1", objects.get(0).look + "/-1", objects.get(0).look + "/99999", "picture ")));
    }
}
