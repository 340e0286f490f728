// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.ColorSensor;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LineSensor;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.SurfaceSensor;
import org.SEAR.POJOs.Terrain;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** Line and colour sensors see what the window shows. */
public class SurfaceSensorsTest {
    private static final int RED = 0xFF0000;
    private static final int GREEN = 0x00FF00;
    private static final int BLUE = 0x0000FF;
    private static final int WHITE = 0xFFFFFF;
    private static final int BLACK = 0;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private String picture(String name, int width, int... pixels) throws Exception {
        BufferedImage image = new BufferedImage(width, pixels.length / width, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < pixels.length; i++) {
            image.setRGB(i % width, i / width, pixels[i]);
        }
        Path file = project.folder().resolve("assets").resolve(name);
        Files.createDirectories(file.getParent());
        ImageIO.write(image, "png", file.toFile());
        return name;
    }

    /** Makes a plate on the ground, its middle 0.05 m above the ground. */
    private static void plate(SensorObject... sensors) {
        SEARrobot robot = new SEARrobot("plate");
        robot.addComponent(new Dynamics("dynamics", 4, 0, 0.05, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.8, 0.8, 0.1, 4));
        for (SensorObject sensor : sensors) {
            if (sensor instanceof SurfaceSensor && ((SurfaceSensor) sensor).getRange() < 0.1) {
                ((SurfaceSensor) sensor).setRange(0.1);
            }
            robot.addComponent(sensor);
        }
    }

    private Simulation settled() throws Exception {
        Simulation world = Simulation.load(project.folder(), 1);
        for (int i = 0; i < 60; i++) {
            world.step();
        }
        return world;
    }

    private static void assertColor(String what, int expected, Object reading) {
        ColorReading color = (ColorReading) reading;
        assertEquals(what + " red", expected >> 16, color.getRed(), 1e-6);
        assertEquals(what + " green", expected >> 8 & 0xFF, color.getGreen(), 1e-6);
        assertEquals(what + " blue", expected & 0xFF, color.getBlue(), 1e-6);
    }

    @Test
    public void aPictureLiesOnAFloorAsTheWindowShowsIt() throws Exception {
        new Floor("floor", 2, 2, picture("four.png", 2, RED, GREEN, BLUE, WHITE));
        plate(new ColorSensor("red", -0.3, 0, 0.3), new ColorSensor("green", -0.3, 0, -0.3),
            new ColorSensor("blue", 0.3, 0, 0.3), new ColorSensor("white", 0.3, 0, -0.3));
        try (Simulation world = settled()) {
            assertColor("upper left", RED, world.read("red"));
            assertColor("upper right", GREEN, world.read("green"));
            assertColor("lower left", BLUE, world.read("blue"));
            assertColor("lower right", WHITE, world.read("white"));
        }
    }

    @Test
    public void aPictureTurnsWithItsFloor() throws Exception {
        Floor floor = new Floor("floor", 2, 2, picture("four.png", 2, RED, GREEN, BLUE, WHITE));
        floor.rotate(0, 180, 0);
        plate(new ColorSensor("white", -0.3, 0, 0.3), new ColorSensor("red", 0.3, 0, -0.3));
        try (Simulation world = settled()) {
            assertColor("turned", WHITE, world.read("white"));
            assertColor("turned", RED, world.read("red"));
        }
    }

    @Test
    public void aPictureOfItsTrueSizeIsRepeated() throws Exception {
        Floor floor = new Floor("floor", 2, 2, picture("two.png", 2, RED, GREEN));
        floor.setImageSize(0.4);
        plate(new ColorSensor("a", 0.1, 0, 0), new ColorSensor("b", 0.3, 0, 0), new ColorSensor("c", -0.1, 0, 0),
            new ColorSensor("d", -0.3, 0, 0));
        try (Simulation world = settled()) {
            assertColor("0 to 0.2 m", RED, world.read("a"));
            assertColor("0.2 to 0.4 m", GREEN, world.read("b"));
            assertColor("-0.2 to 0 m", GREEN, world.read("c"));
            assertColor("-0.4 to -0.2 m", RED, world.read("d"));
        }
    }

    @Test
    public void aLineIsDarkAndItsEdgeHalf() throws Exception {
        new Floor("floor", 2, 2, picture("line.png", 1, WHITE, BLACK));
        plate(new LineSensor("light", -0.01, 0, 0), new LineSensor("dark", 0.01, 0, 0), new LineSensor("edge"));
        try (Simulation world = settled()) {
            assertEquals(100, (Double) world.read("light").value(), 1e-6);
            assertEquals(0, (Double) world.read("dark").value(), 1e-9);
            assertEquals(50, (Double) world.read("edge").value(), 1e-6);
            assertEquals("%", world.getUnit("edge"));
        }
    }

    @Test
    public void aSpotMixesLight() throws Exception {
        new Floor("floor", 2, 2, picture("stripes.png", 1, WHITE, BLACK));
        ColorSensor wide = new ColorSensor("wide");
        wide.setSpot(0.2);
        plate(wide);
        try (Simulation world = settled()) {
            ColorReading mean = (ColorReading) world.read("wide");
            assertEquals("half the light is 188 in a picture", 188, mean.getRed(), 0.5);
            assertEquals(mean.getRed(), mean.getBlue(), 1e-9);
        }
    }

    @Test
    public void plainObjectsHaveTheirColourAndEmptySpaceIsDark() throws Exception {
        new Floor("floor", 9, 9).setColor("#204060");
        Box crate = new Box("crate", 1, 1, 1, 0);
        crate.setColor("red");
        crate.move(0, 0.5, 2);
        Cylinder post = new Cylinder("post", 0.5, 1, 0);
        post.setColor("#102030");
        post.move(2, 0.5, 0);
        ColorSensor ahead = new ColorSensor("ahead", 0, 0, 0, 0, 0, 0);
        ahead.setRange(2);
        ColorSensor left = new ColorSensor("left", 0, 0, 0, 0, 90, 0);
        left.setRange(2);
        ColorSensor right = new ColorSensor("right", 0, 0, 0, 0, -90, 0);
        right.setRange(2);
        plate(new ColorSensor("below"), ahead, left, right);
        try (Simulation world = settled()) {
            assertColor("below", 0x204060, world.read("below"));
            assertColor("ahead", RED, world.read("ahead"));
            assertColor("left", 0x102030, world.read("left"));
            assertColor("right", BLACK, world.read("right"));
        }
    }

    /** The picture over a terrain fills its area, north up: its upper edge at +x, its right edge at +z. */
    @Test
    public void thePictureOverATerrainIsSeen() throws Exception {
        int[] heights = new int[64];
        Arrays.fill(heights, 0x808080);
        Terrain terrain = new Terrain("land", picture("flat.png", 8, heights));
        terrain.setSize(2, 2, -1, 1.008);
        terrain.setImage(picture("four.png", 2, RED, GREEN, BLUE, WHITE));
        plate(new ColorSensor("north west", 0.3, 0, -0.3), new ColorSensor("north east", 0.3, 0, 0.3),
            new ColorSensor("south west", -0.3, 0, -0.3), new ColorSensor("south east", -0.3, 0, 0.3));
        try (Simulation world = settled()) {
            assertColor("north west", RED, mostly(world.read("north west")));
            assertColor("north east", GREEN, mostly(world.read("north east")));
            assertColor("south west", BLUE, mostly(world.read("south west")));
            assertColor("south east", WHITE, mostly(world.read("south east")));
            assertEquals(List.of(), world.snapshot().warnings.stream().filter(text -> text.contains("picture"))
                .collect(Collectors.toList()));
        }
    }

    /** Returns the dominant colour of a mixture from the centres of four pixels. */
    private static ColorReading mostly(Object reading) {
        ColorReading color = (ColorReading) reading;
        return new ColorReading(Math.round(color.getRed() / 255) * 255, Math.round(color.getGreen() / 255) * 255,
            Math.round(color.getBlue() / 255) * 255);
    }

    @Test
    public void aTerrainOfOneColourHasIt() throws Exception {
        int[] heights = new int[64];
        Arrays.fill(heights, 0x808080);
        Terrain terrain = new Terrain("land", picture("flat.png", 8, heights));
        terrain.setSize(2, 2, -1, 1.008);
        terrain.setColor("#204060");
        plate(new ColorSensor("below"));
        try (Simulation world = settled()) {
            assertColor("below", 0x204060, world.read("below"));
        }
    }

    /** Parts of another robot: a plain one, one with a picture, one that a servo turns away, and a wheel. */
    @Test
    public void partsOfOtherRobotsAreSeenWhereTheyAre() throws Exception {
        new Floor("floor", 9, 9).setColor("black");
        ColorSensor ahead = new ColorSensor("ahead", 0, 0.3, 0, 0, 0, 0);
        ahead.setRange(3);
        ColorSensor picture = new ColorSensor("picture", 0.3, 0.3, 0, 0, 0, 0);
        picture.setRange(3);
        ColorSensor turned = new ColorSensor("turned", -0.3, 0.3, 0, 0, 0, 0);
        turned.setRange(3);
        plate(ahead, picture, turned);
        SEARrobot other = new SEARrobot("other");
        other.addComponent(new Dynamics("other dynamics", 4, 0, 0.05, 1, 0, 0, 0));
        Box base = new Box("base", 0.8, 0.4, 0.1, 4);
        base.setColor("blue");
        Box plain = new Box("plain", 0.2, 0.1, 0.6, 0);
        plain.setColor("#204060");
        plain.move(0, 0.3, 0);
        Box poster = new Box("poster", 0.2, 0.1, 0.6, 0, picture("two.png", 2, RED, RED));
        poster.move(0.3, 0.3, 0);
        Box flag = new Box("flag", 0.2, 0.1, 0.2, 0);
        flag.setColor("green");
        flag.move(-0.3, 0.3, 0);
        Servo mast = new Servo("mast", -0.3, 0.3, -0.05);
        mast.setRange(-180, 180);
        Box back = new Box("back", 0.2, 0.1, 0.2, 0);
        back.setColor("red");
        back.move(-0.3, 0.3, -0.2);
        mast.mount(flag);
        mast.mount(back);
        for (SearObject part : List.of(base, plain, poster, flag, back, mast)) {
            other.addComponent(part);
        }
        try (Simulation world = settled()) {
            assertColor("plain", 0x204060, world.read("ahead"));
            assertColor("picture", RED, world.read("picture"));
            assertColor("before it turns", RED, world.read("turned"));
            world.getServo("mast").setAngle(180);
            for (int i = 0; i < 60; i++) {
                world.step();
            }
            assertColor("after it has turned", 0x008000, world.read("turned"));
        }
    }

    @Test
    public void objectsBeyondTheRangeAreDark() throws Exception {
        new Floor("floor", 9, 9).setColor("white");
        LineSensor near = new LineSensor("near");
        near.setRange(0.06);
        LineSensor far = new LineSensor("far");
        far.setRange(0.04);
        SEARrobot robot = new SEARrobot("plate");
        robot.addComponent(new Dynamics("dynamics", 4, 0, 0.05, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.8, 0.8, 0.1, 4));
        robot.addComponent(near);
        robot.addComponent(far);
        try (Simulation world = settled()) {
            assertEquals(100, (Double) world.read("near").value(), 1e-6);
            assertEquals(0, (Double) world.read("far").value(), 0);
        }
    }

    @Test
    public void errorsStayInTheRange() throws Exception {
        new Floor("floor", 9, 9).setColor("white");
        LineSensor line = new LineSensor("line");
        Noise noise = new Noise();
        noise.setWhite(30);
        noise.setDropout(0.2);
        line.setNoise(noise);
        plate(line);
        try (Simulation world = settled()) {
            double[] readings = new double[300];
            for (int i = 0; i < readings.length; i++) {
                world.step();
                readings[i] = (Double) world.read("line").value();
            }
            assertTrue(Arrays.stream(readings).allMatch(reading -> Double.isNaN(reading) || reading >= 0
                && reading <= 100));
            assertTrue(Arrays.stream(readings).anyMatch(Double::isNaN));
            assertTrue(Arrays.stream(readings).anyMatch(reading -> reading < 90));
        }
    }

    @Test
    public void lightAndPicturesAreInversesOfEachOther() {
        for (int value : List.of(0, 1, 10, 11, 128, 254, 255)) {
            assertEquals(value, LightSpot.picture(LightSpot.linear(value)), 1e-3);
        }
        assertEquals("half the numbers are a fifth of the light", 0.2158, LightSpot.linear(128), 1e-3);
    }
}
