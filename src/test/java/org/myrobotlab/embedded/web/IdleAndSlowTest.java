// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.SEAR.HowMany;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Many idle, slow or half-closed connections at the same time: after each kind the server answers others. */
@Category(Slow.class)
public class IdleAndSlowTest {
    private static final int MANY = 20;
    private static final int IDLE = 500;
    /** More bytes than systems buffer for a connection without a reader. */
    private static final int LENGTH = 8 << 20;
    private static final int BITE = 1000;
    private static final int TEXT = 0x81;
    private static final int FRAGMENT = 0x01;
    private static final int LAST = 0x80;
    private static final int CLOSE = 0x88;
    private static final int PING = 0x89;
    private static final int PONG = 0x8A;
    private static final String CALL = "{\"id\":1,\"name\":\"talker\",\"method\":\"getName\"}";
    private static final String ANSWER = "{\"id\":1,\"answer\":\"talker\"}";

    @Rule
    public final Server server = new Server(false);
    private final List<Socket> open = new ArrayList<>();

    @After
    public void close() throws IOException {
        for (Socket one : open) {
            one.close();
        }
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private Socket page() throws IOException {
        Socket page = server.webSocket();
        open.add(page);
        return page;
    }

    @Test
    public void connectionsOfOneProgramThatAreIdleAfterTheirRequests() throws Exception {
        for (int i = 0; i < IDLE; i++) {
            Socket one = server.begin("GET /api/service/talker/getName", "");
            open.add(one);
            assertEquals("HTTP/1.1 200", new String(one.getInputStream().readNBytes("HTTP/1.1 200".length()),
                StandardCharsets.US_ASCII));
        }
        server.servesOthers();
    }

    /** Several programs open connections at the same time, and a page of each continues to work. */
    @Test
    public void idleConnectionsOfSeveralProgramsAtTheSameTime() throws Exception {
        List<Socket> pages = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            pages.add(page());
        }
        List<Thread> programs = new ArrayList<>();
        List<IOException> failures = new ArrayList<>();
        for (int i = 0; i < pages.size(); i++) {
            Thread program = new Thread(() -> idle(IDLE / pages.size(), failures), "program " + i);
            program.start();
            programs.add(program);
        }
        for (Thread program : programs) {
            program.join();
        }
        assertEquals(List.of(), failures);
        server.servesOthers();
        for (Socket page : pages) {
            page.getOutputStream().write(Server.frame(TEXT, bytes(CALL)));
            assertEquals(ANSWER, Server.answer(page));
        }
    }

    private void idle(int count, List<IOException> failures) {
        for (int i = 0; i < count; i++) {
            try {
                Socket idle = server.connect();
                synchronized (open) {
                    open.add(idle);
                }
            } catch (IOException e) {
                synchronized (failures) {
                    failures.add(e);
                }
            }
        }
    }

    @Test
    public void pagesThatReadSlowlyGetAllOfIt() throws Exception {
        List<Socket> pages = new ArrayList<>();
        for (int i = 0; i < MANY; i++) {
            Socket page = page();
            page.getOutputStream().write(Server.frame(
                TEXT, bytes(CALL.replace("getName\"", "longText\",\"data\":[" + LENGTH + "]"))));
            pages.add(page);
        }
        server.talker().awaiting(MANY);
        Socket slow = pages.get(0);
        InputStream bites = new InputStream() {
            private int read;

            @Override
            public int read() throws IOException {
                return slow.getInputStream().read();
            }

            @Override
            public int read(byte[] into, int from, int length) throws IOException {
                if (++read % BITE == 0) {
                    askOthers();
                }
                return slow.getInputStream().read(into, from, Math.min(length, BITE));
            }
        };
        server.servesOthers();
        String text = Server.nextText(bites);
        while (text.startsWith("{\"services\":")) {
            text = Server.nextText(bites);
        }
        assertEquals("{\"id\":1,\"answer\":\"\"}".length() + LENGTH, text.length());
        server.servesOthers();
    }

    private void askOthers() throws IOException {
        assertEquals(200, server.status("GET /api/service/talker/getName", ""));
    }

    @Test
    public void controlFramesAmidAMessageAreAnswered() throws Exception {
        Socket page = page();
        page.getOutputStream().write(Server.frame(TEXT, bytes(CALL)));
        assertEquals(ANSWER, Server.answer(page));
        page.getOutputStream().write(Server.frame(FRAGMENT, bytes(CALL.substring(0, 9))));
        page.getOutputStream().write(Server.frame(PING, bytes("hello")));
        assertEquals("hello", new String(Server.nextFrame(page.getInputStream(), PONG), StandardCharsets.UTF_8));
        page.getOutputStream().write(Server.frame(LAST, bytes(CALL.substring(9))));
        assertEquals(ANSWER, Server.answer(page));
        page.getOutputStream().write(Server.frame(FRAGMENT, bytes(CALL)));
        page.getOutputStream().write(Server.frame(CLOSE, (byte) 3, (byte) 0xE8));
        Server.nextFrame(page.getInputStream(), CLOSE);
        server.servesOthers();
    }

    @Test
    public void halfClosedConnections() throws Exception {
        for (int i = 0; i < IDLE; i++) {
            Socket one = i % 3 == 0 ? page() : i % 3 == 1 ? server.connect()
                : server.begin("POST /api/service/talker/tick", "[", "Content-Length: 2",
                "Content-Type: application/json");
            open.add(one);
            if (i % 2 == 0) {
                one.getOutputStream().write(Server.frame(FRAGMENT, bytes(CALL)));
            }
            one.shutdownOutput();
        }
        server.servesOthers();
    }

    /**
     * Programs send head and body separately and reuse the connection. An answer from another thread while the
     * connection's own thread is still in the receiver must not leave the connection asleep.
     */
    @Test
    public void bodiesThatComeAfterTheirHeads() throws Exception {
        int calls = HowMany.of("sear.calls", 40_000);
        List<IOException> failures = Collections.synchronizedList(new ArrayList<>());
        List<Thread> programs = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            Random pauses = new Random(i);
            Thread program = new Thread(() -> askInParts(calls, pauses, failures), "program " + i);
            program.start();
            programs.add(program);
        }
        for (Thread program : programs) {
            program.join();
        }
        assertEquals(List.of(), failures);
    }

    private void askInParts(int calls, Random pauses, List<IOException> failures) {
        try (Socket one = server.connect()) {
            one.setTcpNoDelay(true);
            for (int i = 0; i < calls; i++) {
                Server.send(one, server.head("POST /api/service/talker/getName", "Content-Type: application/json",
                    "Content-Length: 2") + "\r\n");
                spin(pauses.nextInt(100_000));
                Server.send(one, "[");
                spin(pauses.nextInt(100_000));
                Server.send(one, "]");
                assertEquals("\"talker\"", Server.body(one.getInputStream()).trim());
            }
        } catch (IOException e) {
            failures.add(e);
        }
    }

    private static void spin(int nanos) {
        long end = System.nanoTime() + nanos;
        while (System.nanoTime() < end) {
            Thread.onSpinWait();
        }
    }
}
