// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.StringReader;
import java.net.ServerSocket;
import java.net.URL;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import javax.imageio.ImageIO;
import org.SEAR.Slow;
import org.SEAR.camera.image.Jpeg;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.function.ThrowingRunnable;

/** A network camera for programs: addresses, files, streams, and stops and starts of simulations. */
@Category(Slow.class)
public class NetworkCameraTest {
    private static final int OK = 200;
    private static final int NOT_FOUND = 404;
    private static final int BUSY = 503;
    /** Mean error of JPEG, of 255. */
    private static final double LOSS = 4;

    @Rule
    public final CameraWorld world = new CameraWorld();

    private CameraExports exports;

    @Before
    public void make() {
        exports = new CameraExports(world.host, world.cameras);
    }

    @After
    public void close() {
        exports.close();
    }

    private static byte[] get(int port, String target, String type) throws IOException {
        try (Visitor visitor = Visitor.at(port, target)) {
            assertEquals(target, OK, visitor.status);
            assertEquals(target, type, visitor.headers.get("content-type"));
            return visitor.body();
        }
    }

    private static String refused(int port, String target, int status) throws IOException {
        try (Visitor visitor = Visitor.at(port, target)) {
            assertEquals(target, status, visitor.status);
            return visitor.text();
        }
    }

    @Test
    public void aStillIsTheLastPictureWithTheSameBytesEachTime() throws Exception {
        world.startPaused();
        int port = exports.plain("color", 0);
        int[] pixels = world.cameras.pixels("color");
        byte[] still = get(port, "/image.jpg", "image/jpeg");
        assertArrayEquals(Jpeg.ofColors(CameraWorld.WIDTH, pixels), still);
        assertArrayEquals(still, get(port, "/image.jpg?t=17", "image/jpeg"));
        assertArrayEquals(world.cameras.png("color"), get(port, "/image.png", "image/png"));
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(still));
        assertEquals(CameraWorld.HEIGHT, image.getHeight());
        double off = 0;
        for (int i = 0; i < pixels.length; i++) {
            int rgb = image.getRGB(i % CameraWorld.WIDTH, i / CameraWorld.WIDTH);
            for (int shift = 0; shift <= 16; shift += 8) {
                off += Math.abs((rgb >> shift & 255) - (pixels[i] >> shift & 255)) / 3.0 / pixels.length;
            }
        }
        assertTrue("it is " + off + " off", off < LOSS);
    }

    @Test
    public void depthsAndTemperaturesAreFilesOf16Bit() throws Exception {
        world.startPaused();
        int depth = exports.plain("depth", 0);
        byte[] file = get(depth, "/depth.png", "image/png");
        assertArrayEquals(world.cameras.png("depth"), file);
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(file));
        int[] grey = image.getRaster().getPixels(0, 0, CameraWorld.WIDTH, CameraWorld.HEIGHT, (int[]) null);
        float[] metres = world.cameras.depths("depth");
        for (int i = 0; i < grey.length; i++) {
            assertEquals(Float.isInfinite(metres[i]) ? 0 : Math.round(metres[i] * 1000.0), grey[i], 0);
        }
        int infrared = exports.plain("infrared", 0);
        assertArrayEquals(world.cameras.png("infrared"), get(infrared, "/temperature.png", "image/png"));
        assertEquals("camera infrared makes pictures of kind infrared, legal: /stream.mjpg, /image.jpg, /image.png, "
            + "/temperature.png, /", refused(infrared, "/depth.png", NOT_FOUND));
        assertArrayEquals("false colours", new int[] {CameraWorld.WIDTH, CameraWorld.HEIGHT},
            size(get(depth, "/image.jpg", "image/jpeg")));
        try (Visitor visitor = Visitor.at(infrared, "/stream.mjpg")) {
            assertArrayEquals(new int[] {CameraWorld.WIDTH, CameraWorld.HEIGHT}, size(visitor.part().file));
        }
    }

    private static int[] size(byte[] file) throws IOException {
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(file));
        return new int[] {image.getWidth(), image.getHeight()};
    }

    /** If a busy machine makes no new picture for a second, the last one is sent again. */
    @Test
    public void aStreamHasThePicturesThatAreDue() throws Exception {
        world.start();
        int port = exports.plain("color", 0);
        try (Visitor visitor = Visitor.at(port, "/stream.mjpg")) {
            assertEquals(OK, visitor.status);
            assertEquals("multipart/x-mixed-replace;boundary=picture", visitor.headers.get("content-type"));
            Visitor.Part before = visitor.part();
            Visitor.Part part = before;
            for (int news = 0; news < 8; news += part.time > before.time ? 1 : 0, before = part) {
                part = visitor.part();
                assertEquals("image/jpeg", part.type);
                double tenths = part.time * 10;
                assertEquals("by the camera's rate: " + part.time, Math.rint(tenths), tenths, 1e-4);
                assertTrue(part.time + " after " + before.time, part.time >= before.time);
                assertArrayEquals(new int[] {CameraWorld.WIDTH, CameraWorld.HEIGHT}, size(part.file));
                if (part.time == before.time) {
                    assertArrayEquals("sent again", before.file, part.file);
                }
            }
        }
    }

    @Test
    public void aStreamOfAPausedWorldContinues() throws Exception {
        world.startPaused();
        int port = exports.plain("color", 0);
        try (Visitor visitor = Visitor.at(port, "/stream.mjpg")) {
            byte[] first = visitor.part().file;
            assertArrayEquals("it stands still", first, visitor.part().file);
            assertArrayEquals(first, get(port, "/image.jpg", "image/jpeg"));
        }
    }

    @Test
    public void programsForAnEsp32CamFindIt() throws Exception {
        world.startPaused();
        int port = exports.like("color", 0, "esp32-cam");
        byte[] still = get(port, "/capture", "image/jpeg");
        assertArrayEquals(still, get(port, "/capture?_cb=1700000000", "image/jpeg"));
        try (Visitor visitor = Visitor.at(port + 1, "/stream")) {
            assertEquals("multipart/x-mixed-replace;boundary=123456789000000000000987654321",
                visitor.headers.get("content-type"));
            assertArrayEquals(still, visitor.part().file);
        }
        assertArrayEquals(still, get(port, "/image.jpg", "image/jpeg"));
        assertEquals("there is nothing at /stream, legal: /stream.mjpg, /image.jpg, /image.png, /depth.png, "
            + "/temperature.png, /", refused(port, "/stream", NOT_FOUND));
        assertEquals(Map.of("color", List.of("network camera (ESP32-CAM) http://localhost:" + (port + 1) + "/stream")),
            exports.list());
    }

    @Test
    public void programsForMjpgStreamerFindIt() throws Exception {
        world.startPaused();
        int port = exports.like("color", 0, "OctoPi");
        byte[] still = get(port, "/?action=snapshot", "image/jpeg");
        assertArrayEquals(still, get(port, "/webcam/?action=snapshot&n=1", "image/jpeg"));
        try (Visitor visitor = Visitor.at(port, "/?action=stream")) {
            assertEquals("multipart/x-mixed-replace;boundary=boundarydonotcross", visitor.headers.get("content-type"));
            assertArrayEquals(still, visitor.part().file);
        }
        assertTrue("a page", new String(get(port, "/", "text/html; charset=utf-8"))
            .contains("<img src=\"/stream.mjpg\""));
    }

    /**
     * Everything up to a JPEG file's first two bytes is a header with the length, as MyRobotLab's OpenCV service reads
     * it.
     */
    @Test
    public void aProgramThatSearchesJpegFilesFindsThem() throws Exception {
        world.startPaused();
        int port = exports.plain("color", 0);
        byte[] still = get(port, "/image.jpg", "image/jpeg");
        try (DataInputStream in = new DataInputStream(new URL("http://localhost:" + port + "/stream.mjpg")
            .openStream())) {
            for (int i = 0; i < 2; i++) {
                StringBuilder head = new StringBuilder();
                while (head.indexOf("\u00ff\u00d8") < 0) {
                    head.append((char) in.readUnsignedByte());
                }
                Properties fields = new Properties();
                fields.load(new StringReader(head.substring(0, head.length() - 2)));
                byte[] file = new byte[Integer.parseInt(fields.getProperty("Content-Length"))];
                file[0] = (byte) 0xff;
                file[1] = (byte) 0xd8;
                in.readFully(file, 2, file.length - 2);
                assertArrayEquals(still, file);
            }
        }
    }

    @Test
    public void anExportOutlivesSimulations() throws Exception {
        int port = exports.plain("color", 0);
        exports.begin();
        assertEquals("no simulation with a camera color runs: startSimulation() first",
            refused(port, "/image.jpg", BUSY));
        try (Visitor visitor = Visitor.at(port, "/stream.mjpg")) {
            world.start();
            exports.begin();
            visitor.part();
            world.control.stop();
            assertEquals("no simulation with a camera color runs: startSimulation() first",
                refused(port, "/image.jpg", BUSY));
            world.start();
            double time = Double.POSITIVE_INFINITY;
            while (time > 1) {
                time = visitor.part().time;
            }
            get(port, "/image.jpg", "image/jpeg");
            assertEquals(port, exports.plain("color", 0));
            exports.end("color");
            visitor.rest();
        }
        assertThrows(IOException.class, () -> Visitor.at(port, "/image.jpg"));
        assertEquals(Map.of(), exports.list());
        assertEquals(List.of(), world.host.warnings);
    }

    private static void refuses(String expected, ThrowingRunnable call) {
        assertEquals(expected, assertThrows(IllegalArgumentException.class, call).getMessage());
    }

    @Test
    public void errorsAreReported() throws Exception {
        int early = exports.plain("eye", 0);
        world.startPaused();
        exports.begin();
        assertEquals(1, world.host.warnings.size());
        String warning = world.host.warnings.get(0);
        assertTrue(warning, warning.startsWith("the export of camera eye does not work: no sensor is called"));
        assertEquals("no simulation with a camera eye runs: startSimulation() first",
            refused(early, "/image.jpg", BUSY));
        refuses("the name is missing (None), legal: color, depth, fast, infrared", () -> exports.plain(null, 0));
        refuses("TCP port is 65536, legal: 0 (any free one) to 65535", () -> exports.plain("color", 65536));
        refuses("TCP port is 65535, legal: 0 (any free one) to 65534", () -> exports.like("color", 65535, "ESP32-CAM"));
        refuses("the product is \"GoPro\", legal: ESP32-CAM, OctoPi", () -> exports.like("color", 0, "GoPro"));
        refuses("camera \"color\" is not exported, legal: eye", () -> exports.end("color"));
        try (ServerSocket taken = new ServerSocket(0, 1, java.net.InetAddress.getByName("127.0.0.1"))) {
            String message = assertThrows(IOException.class, () -> exports.plain("color", taken.getLocalPort()))
                .getMessage();
            assertTrue(message, message.startsWith("TCP port " + taken.getLocalPort()
                + " for camera color can't be opened: "));
        }
        assertFalse(exports.list().containsKey("color"));
    }
}
