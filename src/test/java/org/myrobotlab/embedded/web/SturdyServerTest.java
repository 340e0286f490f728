// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Slow, greedy or broken programs of this computer don't keep others from pages and services. */
@Category(Slow.class)
public class SturdyServerTest {
    private static final String JSON = "Content-Type: application/json";
    private static final int PATIENCE_SECONDS = 120;
    private static final int MANY = 20;
    private static final int MEGABYTE = 1 << 20;
    private static final String DIGITS = "1".repeat(8 * MEGABYTE);
    private static final int FRAGMENT = 0x01;
    private static final int BYTES_FRAGMENT = 0x02;
    private static final int MORE = 0x00;
    private static final int TEXT = 0x81;
    private static final int LAST = 0x80;
    private static final int PONG = 0x8A;
    /** Limit of the server's connections. */
    private static final int MOST_CONNECTIONS = Connections.MOST;

    @Rule
    public final Server server = new Server(false);
    private final List<Socket> open = new ArrayList<>();

    @After
    public void close() throws IOException {
        for (Socket one : open) {
            one.close();
        }
    }

    private static String start(Socket socket) throws IOException {
        return new String(socket.getInputStream().readNBytes("HTTP/1.1 200".length()), StandardCharsets.US_ASCII);
    }

    @Test
    public void slowBodiesDoNotBlockOthers() throws Exception {
        for (int i = 0; i < MANY; i++) {
            open.add(server.begin("POST /api/service/talker/publishNumber", "[", JSON, "Content-Length: 3"));
            open.add(server.begin("POST /api/service/talker/publishNumber", "1\r\n[\r\n", JSON,
                "Transfer-Encoding: chunked"));
        }
        server.servesOthers();
        Socket slow = open.get(0);
        Server.send(slow, "7]");
        assertEquals("a slow call is carried out when it is whole", "HTTP/1.1 200", start(slow));
    }

    @Test
    public void longCallsDoNotBlockOthers() throws Exception {
        for (int i = 0; i < MANY; i++) {
            open.add(server.begin("POST /api/service/talker/await", "[]", JSON, "Content-Length: 2"));
        }
        server.talker().awaiting(MANY);
        server.servesOthers();
        server.talker().goOn();
        for (Socket one : open) {
            assertEquals("HTTP/1.1 200", start(one));
        }
    }

    @Test
    public void clientsThatNeverReadDoNotBlockOthers() throws Exception {
        for (int i = 0; i < MANY; i++) {
            open.add(server.begin("POST /api/service/talker/longText", "[" + 8 * MEGABYTE + "]", JSON,
                "Content-Length: 9"));
        }
        server.talker().awaiting(MANY);
        server.servesOthers();
    }

    @Test
    public void aPageThatNeverReadsIsClosed() throws Exception {
        Socket page = server.webSocket();
        open.add(page);
        CountDownLatch closed = new CountDownLatch(1);
        Thread caller = new Thread(() -> {
            try {
                while (true) {
                    page.getOutputStream().write(Server.frame(TEXT,
                        ("{\"id\":1,\"name\":\"talker\",\"method\":\"longText\",\"data\":[" + MEGABYTE + "]}")
                            .getBytes(StandardCharsets.UTF_8)));
                }
            } catch (IOException e) {
                closed.countDown();
            }
        }, "caller");
        caller.setDaemon(true);
        caller.start();
        assertTrue("the server has closed it", closed.await(60, TimeUnit.SECONDS));
        server.servesOthers();
    }

    /**
     * Sends fragments of an endless message.
     * @return megabytes that the server accepted
     */
    private int megabytesTaken(int first) throws IOException {
        byte[] part = new byte[MEGABYTE];
        Arrays.fill(part, (byte) ' ');
        Socket page = server.webSocket();
        open.add(page);
        int sent = 0;
        try {
            for (; sent < 64; sent++) {
                page.getOutputStream().write(Server.frame(sent == 0 ? first : MORE, part));
            }
        } catch (IOException e) {
            return sent;    // the server has closed it
        }
        return sent;
    }

    @Test
    public void unfinishedMessagesAreLimited() throws Exception {
        int texts = megabytesTaken(FRAGMENT);
        assertTrue(texts + " MB of text", texts > 0 && texts < 32);
        int bytes = megabytesTaken(BYTES_FRAGMENT);
        assertTrue(bytes + " MB of bytes", bytes < 32);
        server.servesOthers();
    }

    private static boolean isClosed(Socket page) throws IOException {
        try {
            return page.getInputStream().readAllBytes() != null;
        } catch (SocketException e) {
            return true;    // reset
        } catch (SocketTimeoutException e) {
            return false;
        }
    }

    /** Each is legal by itself; all together exceed the limit. */
    @Test
    public void theOldestUnfinishedMessageMakesWayForOthers() throws Exception {
        byte[] part = new byte[RequestBody.LONGEST - MEGABYTE];
        Arrays.fill(part, (byte) ' ');
        for (int sum = 0; sum <= 2 * MessageRoom.MOST; sum += part.length) {
            Socket page = server.webSocket();
            open.add(page);
            page.getOutputStream().write(Server.frame(FRAGMENT, part));
        }
        Socket last = open.get(open.size() - 1);
        last.getOutputStream().write(Server.frame(LAST,
            "{\"id\":1,\"name\":\"talker\",\"method\":\"longText\",\"data\":[3]}".getBytes(StandardCharsets.UTF_8)));
        assertEquals("{\"id\":1,\"answer\":\"xxx\"}", Server.answer(last));
        assertTrue(isClosed(open.get(0)));
        server.servesOthers();
    }

    /** Each leaves less unread than one page may. */
    @Test
    public void pagesThatLeaveTooMuchUnreadTogetherAreClosed() throws Exception {
        byte[] call = Server.frame(TEXT, ("{\"id\":1,\"name\":\"talker\",\"method\":\"longText\",\"data\":["
            + 8 * MEGABYTE + "]}").getBytes(StandardCharsets.UTF_8));
        for (int i = 0; i < MANY; i++) {
            open.add(server.webSocket());
            open.get(i).getOutputStream().write(call);
        }
        server.talker().awaiting(MANY);
        for (Socket page : open) {
            page.getOutputStream().write(call);
        }
        server.talker().awaiting(MANY);
        server.servesOthers();
        int texts = 0;
        for (Socket page : open) {
            texts += isComplete(page) ? 1 : 0;
        }
        assertTrue(texts + " of " + MANY + " pages have got all", texts > 0 && texts < MANY);
    }

    private static boolean isComplete(Socket page) {
        try {
            return Server.answer(page).length() + Server.answer(page).length() > 16 * MEGABYTE;
        } catch (IOException e) {
            return false;
        }
    }

    @Test
    public void aMessageThatIsTooLongEndsItsOwnConnectionOnly() throws Exception {
        for (int i = 0; i < 3; i++) {
            Socket page = server.webSocket();
            open.add(page);
            try {
                page.getOutputStream().write(Server.frame(TEXT, new byte[17 * MEGABYTE]));
                page.getInputStream().readAllBytes();
            } catch (SocketException e) {
                // closed amid the message
                assertTrue(e.getMessage(), e.getMessage().contains("reset") || e.getMessage().contains("Broken pipe"));
            }
            server.servesOthers();
        }
    }

    /** RFC 6455, 5.2: the highest bit of a 64-bit length must be 0. */
    @Test
    public void aFrameOfNegativeLengthEndsItsConnection() throws Exception {
        byte[] frame = {(byte) TEXT, (byte) 0xFF, (byte) 0x80, 0, 0, 0, 0, 0, 0, 5, 1, 2, 3, 4, 'a', 'b', 'c'};
        for (int i = 0; i < 2 * MANY; i++) {    // more than the limit of pages
            try (Socket page = server.webSocket()) {
                page.getOutputStream().write(frame);
                page.getInputStream().readAllBytes();
            }
        }
        Socket page = server.webSocket();
        open.add(page);
        page.getOutputStream().write(Server.frame(TEXT, "{\"id\":1,\"name\":\"talker\",\"method\":\"getName\"}"
            .getBytes(StandardCharsets.UTF_8)));
        assertEquals("{\"id\":1,\"answer\":\"talker\"}", Server.answer(page));
    }

    @Test
    public void rejectedPagesTakeNoPlace() throws Exception {
        for (int i = 0; i < 2 * MOST_CONNECTIONS + MANY; i++) {
            open.add(server.webSocket());
        }
        server.servesOthers();
        assertEquals("closed after the reason", -1, lastByte(open.get(open.size() - 1)));
    }

    private static int lastByte(Socket socket) throws IOException {
        socket.getInputStream().readAllBytes();
        return socket.getInputStream().read();
    }

    @Test
    public void connectionsWithoutRequestAreClosedForOthers() throws Exception {
        for (int i = 0; i < 2 * MOST_CONNECTIONS + MANY; i++) {
            Socket idle = server.connect();
            open.add(idle);
            if (i % 2 == 0) {
                Server.send(idle, "GET / HTTP/1.1\r\nHost: localh");
            }
        }
        server.servesOthers();
        assertEquals("the one that came first is closed", -1, lastByte(open.get(0)));
    }

    @Test
    public void incompleteRequestsAreClosedForOthers() throws Exception {
        String[] requests = {server.head("GET /", "Content-Length: 9"),
            server.head("GET /", "Host: elsewhere", "Content-Length: 9"),
            server.head("POST /api/service/talker/tick", JSON, "Content-Length: 9")};
        long start = System.nanoTime();
        for (int i = 0; i < 2 * MOST_CONNECTIONS + MANY; i++) {
            open.add(server.connect());
            Server.send(open.get(i), requests[i % requests.length] + "\r\n");
        }
        server.servesOthers();
        long seconds = TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - start);
        assertTrue(seconds + " s: they made way only when their time was over", seconds < Connections.TIMEOUT_SECONDS);
    }

    /** Undertow would print a stack trace for each. */
    @Test
    public void aTooLongChunkedBodyIsRejected() throws Exception {
        String piece = "1000001\r\n" + " ".repeat(0x1000001) + "\r\n";
        Socket socket = server.begin("POST /api/service/talker/half", piece, JSON, "Transfer-Encoding: chunked");
        open.add(socket);
        assertEquals("HTTP/1.1 413", start(socket));
        server.servesOthers();
    }

    @Test
    public void anOpenPageOutlastsConnectionsWithoutRequest() throws Exception {
        Socket page = server.webSocket();
        open.add(page);
        for (int i = 0; i < 2 * MOST_CONNECTIONS; i++) {
            open.add(server.connect());
        }
        server.servesOthers();
        page.getOutputStream().write(Server.frame(TEXT, "{\"id\":1,\"name\":\"talker\",\"method\":\"getName\"}"
            .getBytes(StandardCharsets.UTF_8)));
        assertEquals("{\"id\":1,\"answer\":\"talker\"}", Server.answer(page));
    }

    @Test
    public void controlFramesAndMissingEndsOfMessagesAreHandled() throws Exception {
        Socket page = server.webSocket();
        open.add(page);
        page.getOutputStream().write(Server.frame(FRAGMENT, "{\"id\":1,\"name\":\"talker\","
            .getBytes(StandardCharsets.UTF_8)));
        page.getOutputStream().write(Server.frame(PONG));
        page.getOutputStream().write(Server.frame(LAST, "\"method\":\"getName\"}".getBytes(StandardCharsets.UTF_8)));
        assertEquals("{\"id\":1,\"answer\":\"talker\"}", Server.answer(page));
        page.getOutputStream().write(Server.frame(FRAGMENT, new byte[MEGABYTE]));
        page.shutdownOutput();
        server.servesOthers();
    }

    @Test
    public void invalidCallsAreAnsweredAndThePageContinues() throws Exception {
        Socket page = server.webSocket();
        open.add(page);
        String nested = "[".repeat(60_000) + "]".repeat(60_000);
        String[][] cases = {{"null", "not JSON for Map: null"}, {"7", "not JSON for Map"},
            {nested, "nested more than 500 levels"},
            {"{\"a\":" + nested + "}", "nested more than 500 levels"},
            {"{\"id\":" + DIGITS + "}", "number of more than 1000 digits"}, {"{}", "name of a message is null"},
            {"{\"name\":7,\"method\":\"tick\"}", "name of a message is 7, legal: a string"},
            {"{\"subscribe\":\"talker\"}", "topic of a"},
            {"{\"name\":\"talker\",\"method\":\"tick\",\"data\":5}", "data of a message is not a list"}};
        for (String[] one : cases) {
            page.getOutputStream().write(Server.frame(TEXT, one[0].getBytes(StandardCharsets.UTF_8)));
            String answer = Server.answer(page);
            assertTrue(one[0].substring(0, Math.min(30, one[0].length())) + " " + answer, answer.contains("\"error\"")
                && answer.contains(one[1]));
        }
        assertEquals(404, server.status("POST /api/service/talker/half", "null", JSON));
        assertEquals(404, server.status("POST /api/service/talker/half", nested, JSON));
        assertEquals(404, server.status("POST /api/service/talker/half", "{\"a\":1}", JSON));
        assertEquals("a number that takes minutes to read", 404,
            server.status("POST /api/service/talker/half", "[" + DIGITS + "]", JSON));
        server.servesOthers();
    }

    @Test
    public void aCallOfMoreThanSixteenMegabytesIsRefused() throws Exception {
        Socket socket = server.begin("POST /api/service/talker/half", "", JSON, "Content-Length: " + 17 * MEGABYTE);
        open.add(socket);
        assertEquals("HTTP/1.1 413", start(socket));
        server.servesOthers();
    }

    /** The page closes during the long first message, before the server handles the second. */
    @Test
    public void aSubscriptionOfAClosingPageIsDropped() throws Exception {
        Socket page = server.webSocket();
        open.add(page);
        String slow = "{\"name\":\"talker\",\"method\":\"half\",\"data\":[[" + "[1],".repeat(MEGABYTE) + "0]]}";
        for (String message : new String[] {slow, "{\"subscribe\":\"talker\",\"topic\":\"publishNumber\"}",
            "{\"name\":\"talker\",\"method\":\"tick\"}"}) {
            page.getOutputStream().write(Server.frame(TEXT, message.getBytes(StandardCharsets.UTF_8)));
        }
        page.shutdownOutput();
        assertEquals("all was worked off", "tick", server.talker().heard.poll(PATIENCE_SECONDS, TimeUnit.SECONDS));
        assertNull("nobody has listened", server.talker().getNotifyList("publishNumber"));
    }
}
