// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;
import org.myrobotlab.service.data.ImageData;
import org.myrobotlab.service.sear.SensorReading;

/** Camera data for scripts and other services. */
public class CameraCallsTest {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private SEAR sear;
    private Heard heard;

    @Before
    public void start() {
        new Floor("floor", 20, 20);
        Box red = new Box("red", 0.6, 0.2, 0.6, 0);
        red.setColor("red");
        red.setTemperature(50);
        red.move(0.3, 0.4, 2.1);
        SEARrobot robot = new SEARrobot("rover");
        robot.addComponent(new Dynamics("drive", 4, 0, 0.05, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.4, 0.4, 0.1, 4));
        for (String kind : new String[] {Camera.COLOR, Camera.DEPTH, Camera.INFRARED}) {
            Camera camera = new Camera(kind + " eye", 0, 0.3, 0);
            camera.setKind(kind);
            camera.setSize(WIDTH, HEIGHT);
            robot.addComponent(camera);
        }
        robot.addComponent(new org.SEAR.POJOs.Compass("compass"));
        sear = (SEAR) Runtime.start("testSear", "SEAR");
        heard = (Heard) Runtime.start("searStatus", "Heard");
        sear.startSimulation();
        sear.simSleep(1);
    }

    private static void refuses(String expected, ThrowingRunnable call) {
        assertEquals(expected, assertThrows(IllegalArgumentException.class, call).getMessage());
    }

    @Test
    public void picturesAreNumbersAFileAndBlobs() throws Exception {
        int[] pixels = sear.getPixels("color eye");
        assertEquals(WIDTH * HEIGHT, pixels.length);
        assertArrayEquals(pixels, (int[]) sear.getReading("color eye"));
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(sear.getImage("color eye")));
        assertEquals(pixels[20 * WIDTH + 20], image.getRGB(20, 20) & 0xffffff);
        List<double[]> blobs = sear.getBlobs("color eye", "red");
        assertEquals(1, blobs.size());
        assertTrue("it is to the left", blobs.get(0)[0] < WIDTH / 2.0 && blobs.get(0)[4] > 50);
        Path file = temporary.getRoot().toPath().resolve("pictures/eye.png");
        sear.saveImage("color eye", file.toString());
        assertArrayEquals(sear.getImage("color eye"), Files.readAllBytes(file));
    }

    @Test
    public void depthsTemperaturesAndPoints() {
        float[] depths = sear.getDepth("depth eye");
        assertEquals("the front of the box", 2, depths[20 * WIDTH + 25], 1e-3);
        float[] points = sear.getPointCloud("depth eye", true);
        int lowest = 0;
        for (int i = 1; i < points.length; i += 3) {
            lowest += Math.abs(points[i]) < 1e-4 ? 1 : 0;
        }
        assertTrue("many lie on the floor: " + lowest, lowest > 500);
        assertEquals(points.length, sear.getPointCloud("depth eye").length);
        float[] heat = sear.getTemperatures("infrared eye");
        assertEquals(50, heat[20 * WIDTH + 25], 1e-3);
        assertEquals("m", sear.getSensorUnit("depth eye"));
        assertEquals("in false colours red is near", 0xff0000, sear.getPixels("depth eye")[(HEIGHT - 1) * WIDTH]);
    }

    @Test
    public void queriesToTheWrongCameraAreAnswered() {
        refuses("sensor compass is a Compass, not a Camera, legal: color eye, depth eye, infrared eye",
            () -> sear.getImage("compass"));
        refuses("the name is missing (None), legal: color eye, depth eye, infrared eye", () -> sear.getPixels(null));
        refuses("camera color eye makes pictures of kind color, legal: setKind(\"depth\") before the start",
            () -> sear.getDepth("color eye"));
        refuses("the path is \"eye.gif\", legal: a file that ends with .png",
            () -> sear.saveImage("color eye", "eye.gif"));
        refuses("the colour is \"white\", legal: one with a hue, such as red, orange or #2060ff; white, grey and "
            + "black have none", () -> sear.getBlobs("color eye", "white"));
        assertTrue(assertThrows(IllegalArgumentException.class, () -> sear.getImage("eye")).getMessage()
            .startsWith("no sensor is called \"eye\", legal: color eye, "));
    }

    @Test
    public void picturesArePublishedAsMyRobotLabDoes() throws Exception {
        sear.addListener("publishImage", "searStatus", "onValue");
        sear.startPublishing("color eye", 10);
        sear.startPublishing("compass", 10);
        sear.simSleep(1);
        sear.stopPublishing("color eye");
        List<Object> values = heard.await(10);
        assertEquals("as many as asked for, and nothing of the compass", 10, values.size(), 1);
        ImageData image = (ImageData) values.get(0);
        assertEquals("color eye of testSear", image.name + " of " + image.source);
        String start = "data:image/png;base64,";
        assertTrue(image.src.startsWith(start));
        BufferedImage picture = ImageIO.read(
            new ByteArrayInputStream(Base64.getDecoder().decode(image.src.substring(start.length()))));
        assertEquals(WIDTH, picture.getWidth());
        sear.addListener("publishReading", "searStatus", "onValue");
        sear.startPublishing("depth eye", 10);
        sear.simSleep(0.5);
        assertTrue(heard.awaitValue(value -> value instanceof SensorReading
            && ((SensorReading) value).value instanceof float[]));
    }
}
