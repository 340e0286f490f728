// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;

import io.undertow.Undertow;
import io.undertow.server.HttpServerExchange;
import java.io.IOException;
import java.net.Socket;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.SEAR.FreePort;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;

/** Hand-over of a request's body. */
public class RequestBodyTest {
    private static final int PATIENCE_SECONDS = 120;

    private final BlockingQueue<String> bodies = new LinkedBlockingQueue<>();
    private final BlockingQueue<List<String>> callers = new LinkedBlockingQueue<>();
    private Undertow server;
    private int port;

    @Before
    public void start() throws IOException {
        port = FreePort.find();
        server = Undertow.builder().addHttpListener(
            port, "127.0.0.1", exchange -> RequestBody.receive(exchange, this::take)).build();
        server.start();
    }

    @After
    public void stop() {
        server.stop();
    }

    private void take(HttpServerExchange exchange, String body) {
        bodies.add(body);
        callers.add(Arrays.stream(Thread.currentThread().getStackTrace()).map(StackTraceElement::getClassName)
            .collect(Collectors.toList()));
        exchange.endExchange();
    }

    /**
     * Otherwise an answer from another thread during the receiver's return can leave the connection asleep, and the
     * next request is never read.
     */
    @Test
    public void aBodyIsHandedOnWhenTheReceiverHasReturned() throws Exception {
        try (Socket socket = new Socket("127.0.0.1", port)) {
            for (String body : new String[] {"[1]", "[2]"}) {
                Server.send(socket, "POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 3\r\n\r\n");
                Server.send(socket, body);
                assertEquals(body, bodies.poll(PATIENCE_SECONDS, TimeUnit.SECONDS));
                List<String> caller = callers.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
                assertNotNull(caller);
                assertEquals(List.of(), caller.stream().filter(name -> name.contains("Receiver"))
                    .collect(Collectors.toList()));
                assertEquals("", Server.body(socket.getInputStream()));
            }
        }
    }
}
