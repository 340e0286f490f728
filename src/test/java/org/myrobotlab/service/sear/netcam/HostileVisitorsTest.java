// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.lang.ref.WeakReference;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.SEAR.Fuzz;
import org.SEAR.Slow;
import org.SEAR.sensors.CameraImage;
import org.junit.After;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Clients of a network camera that are forbidden, send garbage or read nothing don't affect the others. */
@Category(Slow.class)
public class HostileVisitorsTest {
    /** Timeout of a client without a byte read, milliseconds; long enough for the other clients on a busy machine. */
    private static final long PATIENCE = 4000;
    private static final int CLIENTS = 100;
    private static final int PICTURES = 5;
    private static final int SMALL = 2048;
    private static final int GARBAGE = 300;

    @Rule
    public final CameraWorld world = new CameraWorld();

    private NetworkCamera camera;

    private int open(String name) throws IOException {
        camera = NetworkCamera.open(name, DeviceProfile.PLAIN, 0, world.host, world.cameras, PATIENCE);
        return camera.getNumber();
    }

    @After
    public void close() {
        if (camera != null) {
            camera.close();
        }
    }

    private static String answer(int port, String request) throws IOException {
        try (Visitor visitor = new Visitor(port, 1 << 16)) {
            visitor.say(request);
            visitor.readHead();
            return visitor.status + " " + visitor.text();
        }
    }

    private static void assertStill(int port) throws IOException {
        try (Visitor visitor = Visitor.at(port, "/image.jpg")) {
            assertEquals(200, visitor.status);
            assertTrue(visitor.body().length > 100);
        }
    }

    @Test
    public void onlyProgramsAndPagesOfThisComputerHaveAccess() throws Exception {
        world.startPaused();
        int port = open("color");
        String get = "GET /image.jpg HTTP/1.1\r\n";
        String host = "Host: localhost:" + port + "\r\n";
        assertEquals("403 host [evil.example:" + port + "] is not allowed: call this server localhost",
            answer(port, get + "Host: evil.example:" + port + "\r\n\r\n"));
        assertEquals("403 host [localhost] is not allowed: call this server localhost",
            answer(port, get + "Host: localhost\r\n\r\n"));
        assertEquals("403 host [] is not allowed: call this server localhost", answer(port, get + "\r\n"));
        assertTrue(answer(port, get + host + "Host: evil.example\r\n\r\n").startsWith("403 host [localhost:"));
        assertEquals("403 pages of [http://evil.example] are not allowed",
            answer(port, get + host + "Origin: http://evil.example\r\n\r\n"));
        assertEquals("403 pages of [null] are not allowed", answer(port, get + host + "Origin: null\r\n\r\n"));
        assertEquals("405 method POST is not allowed, legal: GET",
            answer(port, "POST /image.jpg HTTP/1.1\r\n" + host + "Content-Length: 5\r\n\r\nhello"));
        for (String own : new String[] {"LOCALHOST:", "127.0.0.1:", "[::1]:"}) {
            try (Visitor visitor = new Visitor(port, SMALL)) {
                visitor.say("GET /image.jpg HTTP/1.0\r\nHOST:" + own + port + "\r\n\r\n");
                visitor.stopTalking();
                visitor.readHead();
                assertEquals(own, 200, visitor.status);
                visitor.body();
            }
        }
        for (NetworkInterface way : Collections.list(NetworkInterface.getNetworkInterfaces())) {
            for (InetAddress address : Collections.list(way.getInetAddresses())) {
                assertEquals(address.toString(), address.equals(InetAddress.getByName("127.0.0.1")),
                    opens(address, port));
            }
        }
    }

    private static boolean opens(InetAddress address, int port) {
        try (Socket socket = new Socket(address, port)) {
            return socket.isConnected();
        } catch (IOException e) {
            return false;
        }
    }

    @Test
    public void invalidRequestsAreAnsweredAndDropped() throws Exception {
        world.startPaused();
        int port = open("color");
        String end = "\r\nHost: localhost:" + port + "\r\n\r\n";
        for (String line : new String[] {"", "GET", "GET /image.jpg", "GET  /image.jpg HTTP/1.1",
            "GET /image.jpg HTTP/2.0", "PRI * HTTP/2.0",
            "GET /im\u00e4ge.jpg HTTP/1.1", "\u0016\u0003\u0001", "GET /image.jpg HTTP/1.1 "}) {
            assertEquals(line, "400 this is not an HTTP/1.1 request", answer(port, line + end));
        }
        assertEquals("400 a line of the request's head has no name", answer(port, "GET / HTTP/1.1\r\n: x" + end));
        for (String path : new String[] {"/../../etc/passwd", "/%2e%2e/image.jpg", "/image.jpg/", "//image.jpg",
            "/?action=stream"}) {
            String said = answer(port, "GET " + path + " HTTP/1.1" + end);
            assertTrue(said, path.startsWith("/?") ? said.startsWith("200 <!DOCTYPE")
                : said.startsWith("404 there is nothing at "));
        }
        for (String target : new String[] {"http://localhost:" + port + "/image.jpg", "HTTP://evil.example/image.jpg",
            "image.jpg", "*", "?action=stream", "localhost:" + port}) {
            assertEquals("400 address " + target + " is not allowed, legal: a path that begins with /",
                answer(port, "GET " + target + " HTTP/1.1" + end));
        }
        assertEquals("431 the request's head is longer than 8192 bytes",
            answer(port, "GET / HTTP/1.1\r\nX: " + "x".repeat(10_000)));
        Random random = new Random(Fuzz.SEED);
        for (int i = 0; i < GARBAGE; i++) {
            byte[] bytes = new byte[random.nextInt(200)];
            random.nextBytes(bytes);
            try (Socket socket = new Socket(InetAddress.getByName("127.0.0.1"), port)) {
                socket.getOutputStream().write(bytes);
                socket.setSoLinger(i % 2 == 0, 0);
            }
        }
        assertStill(port);
        CameraWorld.until("all are gone", () -> camera.getClients() == 0);
        assertEquals(List.of(), world.host.warnings);
    }

    @Test
    public void oneOfAHundredClientsReadsNothing() throws Exception {
        world.start();
        int port = open("fast");
        ExecutorService readers = Executors.newCachedThreadPool();
        try (Visitor dull = new Visitor(port, SMALL)) {
            dull.say("GET /stream.mjpg HTTP/1.1\r\nHost: localhost:" + port + "\r\n\r\n");
            List<Visitor> others = new ArrayList<>();
            List<Future<Double>> ends = new ArrayList<>();
            for (int i = 1; i < CLIENTS; i++) {
                others.add(Visitor.at(port, "/stream.mjpg"));
            }
            CameraWorld.until("all are there", () -> camera.getClients() == CLIENTS);
            double began = world.control.session().time();
            AtomicBoolean dropped = new AtomicBoolean();
            for (Visitor other : others) {
                ends.add(readers.submit(() -> {
                    double time = other.part().time;
                    for (int after = 0; after < PICTURES; after += dropped.get() ? 1 : 0) {
                        double next = other.part().time;
                        assertTrue(next + " after " + time, next >= time);
                        time = next;
                    }
                    return time;
                }));
            }
            CameraWorld.until("the one is dropped, and nobody else", () -> camera.getClients() == CLIENTS - 1);
            dropped.set(true);
            for (Future<Double> end : ends) {
                assertTrue("the simulation has gone on", end.get(PATIENCE, TimeUnit.SECONDS) > began);
            }
            assertEquals(CLIENTS - 1, camera.getClients());
            for (Visitor other : others) {
                other.close();
            }
        } finally {
            readers.shutdownNow();
        }
        CameraWorld.until("all have left", () -> camera.getClients() == 0);
        assertTrue(world.control.isRunning());
    }

    @Test
    public void clientsBeyondTheLimitAreRejectedWithTheCause() throws Exception {
        world.startPaused();
        int port = open("color");
        List<Visitor> visitors = new ArrayList<>();
        for (int i = 0; i < PictureServer.MAX_CLIENTS; i++) {
            visitors.add(Visitor.at(port, "/stream.mjpg"));
        }
        try (Visitor late = Visitor.at(port, "/stream.mjpg")) {
            assertEquals(503, late.status);
            assertEquals("128 programs are connected, the most that the camera serves", late.text());
        }
        for (Visitor visitor : visitors) {
            visitor.close();
        }
        CameraWorld.until("all have left", () -> camera.getClients() == 0);
        assertStill(port);
    }

    /** Each of ten clients that read nothing holds at most one picture. */
    @Test
    public void unreadPicturesAreNotStored() throws Exception {
        world.startPaused();
        CameraImage image = world.cameras.look("fast");
        PictureServer server = PictureServer.open("fast", DeviceProfile.PLAIN, 0, new Demand(),
            TimeUnit.HOURS.toMillis(1));
        Thread thread = new Thread(server::serve);
        thread.start();
        List<Visitor> dull = new ArrayList<>();
        List<WeakReference<byte[]>> files = new ArrayList<>();
        try {
            for (int i = 0; i < 10; i++) {
                dull.add(new Visitor(server.getNumber(), SMALL));
                dull.get(i).say("GET /stream.mjpg HTTP/1.1\r\nHost: localhost:" + server.getNumber() + "\r\n\r\n");
            }
            CameraWorld.until("all are there", () -> server.getClients() == dull.size());
            for (int i = 0; i < 500; i++) {
                EncodedFrame shot = new EncodedFrame(image);
                files.add(new WeakReference<>(shot.file(Form.STREAM)));
                server.publish(shot);
            }
            CameraWorld.until("they are gone", () -> {
                System.gc();
                return files.stream().filter(file -> file.get() != null).count() <= dull.size() + 2;
            });
            assertEquals(dull.size(), server.getClients());
        } finally {
            server.close();
            thread.join();
            for (Visitor visitor : dull) {
                visitor.close();
            }
        }
    }
}
