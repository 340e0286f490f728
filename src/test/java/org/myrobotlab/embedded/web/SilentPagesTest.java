// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.SEAR.FreePort;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Pages whose computer has vanished, for example a closed laptop, don't block others for ever. */
@Category(Slow.class)
public class SilentPagesTest {
    private static final int MOST_PAGES = 32;
    private static final int TEXT = 0x81;
    private static final int CLOSE = 0x88;
    private static final int PING = 0x89;
    private static final int PONG = 0x8A;

    private final AtomicLong now = new AtomicLong();
    private final List<Socket> pages = new ArrayList<>();
    private Server server;
    private WebServer running;

    @Before
    public void start() throws IOException {
        int port = FreePort.find();
        running = new WebServer(port, List.of(), new Hub("hub", now::get));
        server = Server.at(port);
        for (int i = 0; i < MOST_PAGES; i++) {
            pages.add(server.webSocket());
            assertTrue(Server.nextText(pages.get(i).getInputStream()).startsWith("{\"services\":"));
        }
    }

    @After
    public void stop() throws IOException {
        for (Socket page : pages) {
            page.close();
        }
        running.stop();
    }

    private void pass(int seconds) {
        now.addAndGet(TimeUnit.SECONDS.toNanos(seconds));
    }

    /** Answers a ping as an open page does; the error of its call shows that the server has received it. */
    private static void answer(Socket page) throws IOException {
        page.getOutputStream().write(Server.frame(PONG));
        page.getOutputStream().write(Server.frame(TEXT, "{\"id\":1,\"name\":\"nobody\",\"method\":\"x\"}"
            .getBytes(StandardCharsets.UTF_8)));
        assertTrue(Server.answer(page).contains("there is no service nobody"));
    }

    private void isRefused() throws IOException {
        try (Socket page = server.webSocket()) {
            Server.nextFrame(page.getInputStream(), CLOSE);
        }
    }

    @Test
    public void theLongestSilentPageIsClosedFirst() throws Exception {
        pass(59);
        isRefused();
        pass(2);
        Socket silent = pages.remove(5);
        for (Socket page : pages) {
            answer(page);
        }
        Socket next = server.webSocket();
        pages.add(next);
        assertTrue(Server.nextText(next.getInputStream()).startsWith("{\"services\":"));
        silent.getInputStream().readAllBytes();     // ends, because the server closed it
        silent.close();
        isRefused();
        answer(pages.get(0));
    }

    @Test
    public void pagesArePinged() throws Exception {
        assertEquals(0, Server.nextFrame(pages.get(0).getInputStream(), PING).length);
    }
}
