// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.SEAR.Fuzz;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Programs send any requests and web socket messages, whole or cut off; after each the server answers others. */
@Category(Slow.class)
public class HostileExchangesFuzzTest {
    private static final int EXCHANGES = 10_000;
    /** Limit of answers later than a second on a busy machine; a blocked server would be late each time. */
    private static final int MOST_LATE = EXCHANGES / 100;
    private static final long SECOND = TimeUnit.SECONDS.toNanos(1);
    /** Connections that stay open, like those of hanging programs. */
    private static final int STALE = 50;
    private static final int MOST_FRAMES = 4;
    private static final int SHORT = 300;
    private static final int LONG = 70_000;
    private static final String[] METHODS = {"GET", "POST", "PUT", "get", "OPTIONS", "CONNECT", "\0", "G ET"};
    private static final String[] PATHS = {"/", "/api/service/talker/tick", "/api/messages", "/api/service", "//",
        "/..%2f..%2fetc/passwd", "/%00",
        "*", "http://localhost/", "/webjars/three.js/../", "/service/js/SEARGui.js"};
    private static final String[] HEADERS = {"Content-Type: application/json", "Content-Length: 3",
        "Content-Length: -1",
        "Content-Length: 99999999999", "Transfer-Encoding: chunked", "Expect: 100-continue", "Connection: Upgrade",
        "Upgrade: websocket",
        "Upgrade: h2c", "Sec-WebSocket-Version: 13", "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==", "Origin: null",
        "Host: evil.example", ": nothing", "Range: bytes=0-0,5-1", "Cookie: " + "c".repeat(9000)};

    @Rule
    public final Server server = new Server(false);
    private final Deque<Socket> stale = new ArrayDeque<>();

    @After
    public void close() throws IOException {
        for (Socket one : stale) {
            one.close();
        }
    }

    @Test
    public void theServerAnswersAfterEach() throws Exception {
        Random random = new Random(Fuzz.SEED);
        int late = 0;
        for (int i = 0; i < EXCHANGES; i++) {
            Socket socket = random.nextBoolean() ? frames(random) : request(random);
            long asked = System.nanoTime();
            assertEquals("exchange " + i, 200, server.status("GET /api/service/talker/getName", ""));
            late += System.nanoTime() - asked > SECOND ? 1 : 0;
            if (random.nextInt(3) > 0) {
                socket.close();
            } else {
                stale.add(socket);
            }
            if (stale.size() > STALE) {
                stale.remove().close();
            }
        }
        assertTrue(late + " answers took more than a second", late <= MOST_LATE);
    }

    private Socket frames(Random random) throws IOException {
        Socket page = server.webSocket();
        int frames = 1 + random.nextInt(MOST_FRAMES);
        for (int i = 0; i < frames; i++) {
            byte[] frame = Server.frame(random.nextInt(256), text(random));
            if (random.nextInt(4) == 0) {
                // its length or mask
                frame[1 + random.nextInt(Math.min(13, frame.length - 1))] = (byte) random.nextInt(256);
            }
            sendSome(page, frame, random);
        }
        return page;
    }

    private static byte[] text(Random random) {
        if (random.nextInt(3) == 0) {
            return "{\"id\":1,\"name\":\"talker\",\"method\":\"getName\"}".getBytes(StandardCharsets.UTF_8);
        }
        byte[] bytes = new byte[random.nextInt(random.nextInt(50) == 0 ? LONG : SHORT)];
        random.nextBytes(bytes);
        return bytes;
    }

    private Socket request(Random random) throws IOException {
        StringBuilder text = new StringBuilder(METHODS[random.nextInt(METHODS.length)]).append(' ')
            .append(PATHS[random.nextInt(PATHS.length)])
            .append(" HTTP/1.").append(random.nextInt(3)).append("\r\nHost: localhost:").append(server.port())
            .append("\r\n");
        for (int i = random.nextInt(HEADERS.length); i > 0; i--) {
            text.append(HEADERS[random.nextInt(HEADERS.length)]).append(random.nextInt(20) == 0 ? "\n" : "\r\n");
        }
        Socket socket = server.connect();
        sendSome(socket, text.append("\r\n[1]\r\n0\r\n\r\n").toString().getBytes(StandardCharsets.ISO_8859_1), random);
        return socket;
    }

    /** Sends all bytes or the beginning of them. The server may have closed the connection already. */
    private static void sendSome(Socket socket, byte[] bytes, Random random) {
        int length = random.nextInt(3) == 0 ? random.nextInt(bytes.length + 1) : bytes.length;
        try {
            socket.getOutputStream().write(bytes, 0, length);
            if (random.nextInt(10) == 0) {
                socket.shutdownOutput();
            }
        } catch (IOException e) {
            assertTrue("it was open: " + e, socket.isConnected());
        }
    }
}
