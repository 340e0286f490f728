// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.ProjectRule;
import org.SEAR.record.Recorder;
import org.SEAR.record.RunRecord;
import org.SEAR.record.Series;
import org.SEAR.scene.ReadingTexts;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.SEAR.view.link.RunnerLink;
import org.example.OtherJar;
import org.example.ThermalGrid;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.sear.records.Records;

/** A thermal camera of 8 x 8 pixels from another jar, with a reading unknown to SEAR, works like SEAR's own sensors. */
public class OwnReadingTest {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int PIXELS = 64;
    private static final double AIR = 20;
    private static final double THINGS = 34;

    @Rule
    public final ProjectRule project = new ProjectRule();
    private final ClassLoader before = Thread.currentThread().getContextClassLoader();
    private URLClassLoader jar;
    private Simulation world;

    /** It looks ahead from 0.2 m above the ground at a box 0.2 m high and 1 m ahead. */
    @Before
    public void start() throws Exception {
        Path folder = project.newFolder("thermal").toPath();
        OtherJar.at(folder, "ThermalGridSensor$Type");
        jar = new URLClassLoader(new URL[] {folder.toUri().toURL()});
        Thread.currentThread().setContextClassLoader(jar);
        new Floor("floor", 20, 20);
        new Box("box", 2, 0.2, 0.2, 0).move(0, 0.1, 1.1);
        SEARrobot robot = Robots.create2("rover");
        ThermalGrid eye = new ThermalGrid("eye");
        eye.move(0, 0.2, 0);
        robot.addComponent(eye);
        Arduino board = new Arduino("uno");
        board.setPorts("/dev/board", "/dev/user");
        robot.addComponent(board);
        board.wire("A0", eye);
        world = Simulation.load(project.folder(), 1);
        steps(60);
    }

    @After
    public void end() throws Exception {
        Thread.currentThread().setContextClassLoader(before);
        world.close();
        jar.close();
    }

    private void steps(int count) {
        for (int i = 0; i < count; i++) {
            world.step();
        }
    }

    private String words() {
        return AIR + " to " + THINGS + " degC";
    }

    @Test
    public void aScriptGetsItsPixels() {
        double[] pixels = (double[]) world.read("eye").value();
        assertEquals(PIXELS, pixels.length);
        assertArrayEquals("above the horizon is the air", new double[PIXELS / 2],
            difference(Arrays.copyOf(pixels, PIXELS / 2), AIR), 0);
        assertEquals("below it the box", THINGS, pixels[PIXELS / 2 + 3], 0);
    }

    private static double[] difference(double[] values, double from) {
        return Arrays.stream(values).map(value -> value - from).toArray();
    }

    @Test
    public void theTabGetsItsTextNumbersAndPicture() throws Exception {
        JsonNode sensors = JSON.valueToTree(new WorldFeed().next(world, new WorldFeed.Message())).get("sensors");
        JsonNode eye = sensors.get(0);
        assertEquals("eye", eye.get("name").asText());
        assertEquals(words(), eye.get("words").asText());
        assertEquals("[20.0,34.0]", eye.get("numbers").toString());
        assertEquals("[\".coldest\",\".warmest\"]", eye.get("names").toString());
        assertEquals("degC", eye.get("unit").asText());
        assertEquals(PIXELS, eye.get("value").size());
        assertFalse(eye.has("ranges") || eye.has("hit"));
        String data = eye.get("picture").asText();
        BufferedImage picture = ImageIO.read(
            new ByteArrayInputStream(Base64.getDecoder().decode(data.substring("data:image/png;base64,".length()))));
        assertEquals(8, picture.getWidth());
        assertEquals(8, picture.getHeight());
        assertEquals("40 % red", 0x660099, picture.getRGB(3, 0) & 0xFFFFFF);
        assertEquals("54 % red", 0x8A0075, picture.getRGB(3, 4) & 0xFFFFFF);
    }

    @Test
    public void theWindowShowsItsText() {
        RunnerLink link = new RunnerLink(new SimulationRunner(world), () -> false);
        steps(10);
        assertEquals(words(), new ReadingTexts(link.project()).of(link.snapshot().readings).get("eye"));
        assertNull(link.snapshot().readings.get("eye").beams());
        link.close();
    }

    @Test
    public void aRecordStoresAndReturnsItsNumbersByName() throws Exception {
        Path file = project.folder().resolveSibling("eye.searlog");
        Recorder recorder = Recorder.begin(world, file, Recorder.LIMIT, said -> { });
        steps(4);
        recorder.end();
        RunRecord record = RunRecord.open(file);
        assertTrue(Series.names(record.getHeader()).containsAll(List.of("eye.coldest", "eye.warmest")));
        Series series = Series.of(record, List.of("eye.warmest", "eye.coldest"), 100);
        assertEquals(3, series.times.length);
        assertArrayEquals(new double[] {THINGS, THINGS, THINGS}, series.values[0], 0);
        assertArrayEquals(new double[] {AIR, AIR, AIR}, series.values[1], 0);
        assertEquals("13.0 to 14.0 degC", Records.wording(world).get("eye").apply(new double[] {13, 14}));
    }

    @Test
    public void aPinHasItsVoltage() {
        assertEquals(5 * (THINGS + 20) / 100, world.read("eye").volts(), 1e-12);
        String value = world.snapshot().robots.get(0).devices.stream().flatMap(device -> device.pins.stream())
            .filter(pin -> pin.wired.equals("eye (volts)")).findFirst().orElseThrow().value;
        assertEquals("2.70 V", value);
    }
}
