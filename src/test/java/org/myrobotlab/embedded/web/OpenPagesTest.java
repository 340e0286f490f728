// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.undertow.connector.ByteBufferPool;
import io.undertow.server.DefaultByteBufferPool;
import io.undertow.websockets.client.WebSocketClient;
import io.undertow.websockets.client.WebSocketClientNegotiation;
import io.undertow.websockets.core.WebSocketChannel;
import java.io.IOException;
import java.io.InputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.net.URI;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.SEAR.FreePort;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.xnio.OptionMap;
import org.xnio.Xnio;
import org.xnio.XnioWorker;

/**
 * A wait for pages to close lasts as long as one is open, continues through a reload, and ends with Enter at a
 * terminal.
 */
public class OpenPagesTest {
    private static final int PATIENCE_SECONDS = 60;
    private static final double FOR_EVER = 1e6;
    private static final double NO_GRACE = 0.001;

    private Thread waiting;

    /** Pages of other tests may close a moment later. */
    @Before
    public void nobodyLooks() {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (OpenPages.count() > 0) {
            assertTrue(OpenPages.count() + " pages of other tests are open", System.nanoTime() < end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
        }
    }

    @After
    public void allHaveGone() {
        while (OpenPages.count() > 0) {
            OpenPages.go();
        }
        if (waiting != null) {
            waiting.interrupt();
        }
    }

    private CompletableFuture<Void> stay(InputStream terminal, double grace) {
        CompletableFuture<Void> over = new CompletableFuture<>();
        waiting = new Thread(() -> {
            try {
                OpenPages.stay(terminal, grace);
                over.complete(null);
            } catch (InterruptedException e) {
                over.completeExceptionally(e);
            }
        });
        waiting.start();
        return over;
    }

    /** Waits until the thread is in this state; a thread that never reaches it fails the test. */
    private void waits(Thread.State how) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (waiting.getState() != how) {
            assertTrue(waiting.getState().toString(), waiting.isAlive() && System.nanoTime() < end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
        }
    }

    private static void ends(CompletableFuture<Void> over) throws Exception {
        over.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    }

    @Test
    public void withoutPagesItDoesNotWait() throws Exception {
        ends(stay(InputStream.nullInputStream(), FOR_EVER));
    }

    @Test
    public void aPageIsWaitedForThroughAReload() throws Exception {
        OpenPages.come();
        CompletableFuture<Void> over = stay(InputStream.nullInputStream(), FOR_EVER);
        waits(Thread.State.WAITING);
        OpenPages.go();
        waits(Thread.State.TIMED_WAITING);
        assertFalse("within the grace", over.isDone());
        OpenPages.come();
        waits(Thread.State.WAITING);
        assertFalse("it came back", over.isDone());
    }

    @Test
    public void itEndsWithTheLastPage() throws Exception {
        OpenPages.come();
        OpenPages.come();
        CompletableFuture<Void> over = stay(InputStream.nullInputStream(), NO_GRACE);
        waits(Thread.State.WAITING);
        OpenPages.go();
        waits(Thread.State.WAITING);
        assertEquals("one looks", 1, OpenPages.count());
        assertFalse(over.isDone());
        OpenPages.go();
        ends(over);
    }

    @Test
    public void aPageThatComesWhileTheServerStopsIsNotCounted() throws Exception {
        int port = FreePort.find();
        Hub hub = new Hub("hub");
        WebServer server = new WebServer(port, List.of(), hub);
        XnioWorker stopping = Xnio.getInstance(OpenPagesTest.class.getClassLoader()).createWorker(OptionMap.EMPTY);
        try (ByteBufferPool buffers = new DefaultByteBufferPool(false, 1024)) {
            WebSocketChannel page = WebSocketClient.connectionBuilder(
                stopping, buffers, URI.create("ws://127.0.0.1:" + port + "/api/messages"))
                .setClientNegotiation(new WebSocketClientNegotiation(List.of(), List.of()) {
                    @Override
                    public void beforeRequest(Map<String, List<String>> headers) {
                        headers.put("Origin", List.of("http://127.0.0.1:" + port));
                    }
                }).connect().get();
            long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
            while (OpenPages.count() == 0 && System.nanoTime() < deadline) {
                Thread.onSpinWait();    // the server counts its end a moment after the answer
            }
            stopping.shutdown();
            assertTrue(stopping.awaitTermination(PATIENCE_SECONDS, TimeUnit.SECONDS));
            int there = OpenPages.count();
            hub.connect(page, null);
            assertTrue(there + " and then " + OpenPages.count(), OpenPages.count() <= there);
        } finally {
            server.stop();
        }
    }

    @Test
    public void atATerminalEnterEndsItDespiteOpenPages() throws Exception {
        try (PipedOutputStream keys = new PipedOutputStream(); PipedInputStream terminal = new PipedInputStream(keys)) {
            OpenPages.come();
            CompletableFuture<Void> over = stay(terminal, FOR_EVER);
            waits(Thread.State.WAITING);
            assertFalse(over.isDone());
            type(keys, "\n");
            ends(over);
        }
    }

    @Test
    public void atATerminalAPageMayStillBeOpened() throws Exception {
        try (PipedOutputStream keys = new PipedOutputStream(); PipedInputStream terminal = new PipedInputStream(keys)) {
            CompletableFuture<Void> over = stay(terminal, NO_GRACE);
            waits(Thread.State.WAITING);
            assertFalse("nobody looks yet", over.isDone());
            type(keys, "x");
            OpenPages.come();
            waits(Thread.State.WAITING);
            assertFalse(over.isDone());
            OpenPages.go();
            ends(over);
        }
    }

    private static void type(PipedOutputStream keys, String text) throws IOException {
        keys.write(text.getBytes());
        keys.flush();
    }
}
