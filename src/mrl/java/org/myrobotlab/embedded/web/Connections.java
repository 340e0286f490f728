// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import io.undertow.server.HttpHandler;
import io.undertow.server.HttpServerExchange;
import java.net.SocketAddress;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.xnio.ChannelListener;
import org.xnio.IoUtils;
import org.xnio.StreamConnection;
import org.xnio.XnioExecutor;

/**
 * Open connections. At the limit a new connection replaces the one that has been idle longest. If that one has just
 * arrived, the new connection may replace an older one whose request or answer is stuck. So a program that opens idle
 * connections, sends incomplete requests or does not read answers locks no one out. Any thread.
 */
final class Connections implements ChannelListener<StreamConnection> {
    /** Limit of open connections, exceeded only while more of them have a request. */
    static final int MOST = 256;
    /** Time from the head of a request to its end, s. */
    static final int TIMEOUT_SECONDS = 30;

    /** Time for which a new connection is expected to send a request, ns. */
    private static final long FRESH = TimeUnit.SECONDS.toNanos(1);

    private final ChannelListener<? super StreamConnection> next;
    /** Connections with a request, the oldest request first. */
    private final Map<SocketAddress, Open> busy = new LinkedHashMap<>();
    /** Connections without a request, the longest idle first. */
    private final Map<SocketAddress, Open> idle = new LinkedHashMap<>();

    /** @param next handles the connection */
    Connections(ChannelListener<? super StreamConnection> next) {
        this.next = next;
    }

    /** A connection and its request. */
    private static final class Open {
        private final StreamConnection connection;
        /** Null for an idle connection. */
        private final HttpServerExchange request;
        private final long since = System.nanoTime();

        Open(StreamConnection connection, HttpServerExchange request) {
            this.connection = connection;
            this.request = request;
        }

        boolean isFresh() {
            return System.nanoTime() - since < FRESH;
        }

        /** Returns whether a request or answer is incomplete; never for web sockets and running calls. */
        boolean isStuck() {
            return !request.isUpgrade() && (!request.isRequestComplete() || request.isResponseStarted());
        }
    }

    @Override
    public void handleEvent(StreamConnection connection) {
        StreamConnection closing = add(connection);
        IoUtils.safeClose(closing);
        next.handleEvent(connection);
    }

    /** Returns the connection to close; null if there is room. */
    private synchronized StreamConnection add(StreamConnection connection) {
        busy.values().removeIf(one -> !one.connection.isOpen());
        idle.values().removeIf(one -> !one.connection.isOpen());
        Open closing = busy.size() + idle.size() >= MOST ? takeOut() : null;
        idle.put(connection.getPeerAddress(), new Open(connection, null));
        return closing == null ? null : closing.connection;
    }

    /**
     * Accepting threads add connections at their own pace, so among connections of the same moment the last one added
     * need not be the newest.
     */
    private Open takeOut() {
        Open longest = idle.isEmpty() ? null : idle.values().iterator().next();
        if (longest == null || longest.isFresh()) {
            Open stuck = busy.values().stream().filter(Open::isStuck).findFirst().orElse(null);
            if (stuck != null && (longest == null || stuck.since - longest.since < 0)) {
                busy.values().remove(stuck);
                return stuck;
            }
        }
        idle.values().remove(longest);
        return longest;
    }

    /** Tracks which connections are busy by their requests; web sockets stay busy. */
    HttpHandler watching(HttpHandler handler) {
        return exchange -> {
            SocketAddress address = exchange.getConnection().getPeerAddress();
            begin(address, exchange);
            XnioExecutor.Key deadline = exchange.isRequestComplete() ? null
                : exchange.getIoThread().executeAfter(() -> closeUnfinished(exchange), TIMEOUT_SECONDS,
                    TimeUnit.SECONDS);
            exchange.addExchangeCompleteListener((done, after) -> {
                if (deadline != null) {
                    deadline.remove();
                }
                if (!done.isUpgrade()) {
                    end(address);
                }
                after.proceed();
            });
            handler.handleRequest(exchange);
        };
    }

    private static void closeUnfinished(HttpServerExchange request) {
        if (!request.isRequestComplete()) {
            IoUtils.safeClose(request.getConnection());
        }
    }

    /** Marks an idle connection as busy with a request. */
    synchronized void begin(SocketAddress address, HttpServerExchange request) {
        Open open = idle.remove(address);
        if (open != null) {
            busy.put(address, new Open(open.connection, request));
        }
    }

    private synchronized void end(SocketAddress address) {
        Open done = busy.remove(address);
        if (done != null) {
            idle.put(address, new Open(done.connection, null));
        }
    }
}
