// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.python3;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;

/** Which connections the gateway admits, and when it closes the others. */
public class TokenGateTest {
    private static final String TOKEN = "0123456789abcdef";
    private static final int PATIENCE_MILLIS = (int) TimeUnit.MINUTES.toMillis(2);

    private final BlockingQueue<Socket> admitted = new LinkedBlockingQueue<>();
    private final List<Socket> clients = new ArrayList<>();
    private TokenGate gate;

    @Before
    public void open() throws IOException {
        gate = TokenGate.open(0, TOKEN, admitted::add);
    }

    @After
    public void close() throws IOException {
        gate.close();
        for (Socket client : clients) {
            client.close();
        }
    }

    private Socket client(String sends) throws IOException {
        Socket client = new Socket("127.0.0.1", gate.getPort());
        clients.add(client);
        client.setSoTimeout(PATIENCE_MILLIS);
        client.setTcpNoDelay(true);
        client.getOutputStream().write(sends.getBytes(StandardCharsets.US_ASCII));
        return client;
    }

    private static String answer(Socket client, int length) throws IOException {
        return new String(client.getInputStream().readNBytes(length), StandardCharsets.US_ASCII);
    }

    @Test
    public void theTokenAdmitsAndNoLaterByteIsRead() throws Exception {
        Socket client = client("A\n" + TOKEN + "\nfirst call");
        assertEquals("!yv\n", answer(client, 4));
        Socket socket = admitted.poll(2, TimeUnit.MINUTES);
        assertTrue(socket.getChannel().isBlocking());
        assertEquals("first call", answer(socket, "first call".length()));
    }

    @Test
    public void theTokenMayArriveByteByByte() throws Exception {
        Socket client = client("");
        for (char one : ("A\n" + TOKEN + "\n").toCharArray()) {
            client.getOutputStream().write(one);
        }
        assertEquals("!yv\n", answer(client, 4));
    }

    @Test
    public void otherGreetingsAreRefused() throws Exception {
        for (String greeting : new String[] {"A\n\n", "A\nshort\n", "a\n" + TOKEN + "\n", "A\r" + TOKEN + "\n",
            "A\n" + TOKEN.toUpperCase() + "\n", "\n\n", "\nA\n", "A\n" + TOKEN + " "}) {
            Socket client = client(greeting);
            assertEquals(greeting, "!x\n", answer(client, 100));
        }
        assertTrue(admitted.isEmpty());
    }

    @Test
    public void aClientThatSendsNoTokenIsClosedAtTheDeadline() throws Exception {
        long began = System.nanoTime();
        assertEquals("", answer(client("A\n"), 1));
        assertTrue(System.nanoTime() - began > TimeUnit.SECONDS.toNanos(TokenGate.DEADLINE_SECONDS));
    }

    @Test
    public void theOldestMakesWayForOneMore() throws Exception {
        for (int i = 0; i < TokenGate.MAX_PENDING; i++) {
            client("A");
        }
        Socket last = client("A\n" + TOKEN + "\n");
        assertEquals("!yv\n", answer(last, 4));
        assertEquals("", answer(clients.get(0), 1));
    }

    @Test
    public void closingClosesWaitingClients() throws Exception {
        Socket client = client("A");
        gate.close();
        assertTrue(ended(client));
    }

    private static boolean ended(Socket client) {
        try {
            return client.getInputStream().read() < 0;
        } catch (IOException e) {
            return true;
        }
    }
}
