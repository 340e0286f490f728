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
 * The connections that are open. One that comes when there are many takes the place of the one that has been without a request for the longest time.
 * Where that one has just come, the place may be that of a request or an answer that has been on its way for longer. So a program that opens
 * connections and asks nothing, that does not send what it says, or does not read what it asked for keeps nobody out. Any thread.
 */
final class Connections implements ChannelListener<StreamConnection> {
    /** Connections that stay open at the same time, unless more of them have a request. */
    static final int MOST = 256;
    /** From a request's head to its end. */
    static final int TIMEOUT_SECONDS = 30;

    /** One that has just come is about to ask. */
    private static final long FRESH = TimeUnit.SECONDS.toNanos(1);

    private final ChannelListener<? super StreamConnection> next;
    /** The one whose request is oldest comes first. */
    private final Map<SocketAddress, Open> busy = new LinkedHashMap<>();
    /** The one that has been idle longest comes first. */
    private final Map<SocketAddress, Open> idle = new LinkedHashMap<>();

    /** @param next what serves a connection */
    Connections(ChannelListener<? super StreamConnection> next) {
        this.next = next;
    }

    /** A connection and its request. */
    private static final class Open {
        private final StreamConnection connection;
        /** Null for one that is idle. */
        private final HttpServerExchange request;
        private final long since = System.nanoTime();

        Open(StreamConnection connection, HttpServerExchange request) {
            this.connection = connection;
            this.request = request;
        }

        boolean isFresh() {
            return System.nanoTime() - since < FRESH;
        }

        /** Neither a web socket nor a call that runs. */
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

    /** Answers the connection that must go; null if none has to. */
    private synchronized StreamConnection add(StreamConnection connection) {
        busy.values().removeIf(one -> !one.connection.isOpen());
        idle.values().removeIf(one -> !one.connection.isOpen());
        Open closing = busy.size() + idle.size() >= MOST ? takeOut() : null;
        idle.put(connection.getPeerAddress(), new Open(connection, null));
        return closing == null ? null : closing.connection;
    }

    /** Threads add what they have accepted each at its own pace: among those that came within a moment, the newest is not the one that came last. */
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

    /** Knows by the requests which connections are busy: those that become web sockets stay so. */
    HttpHandler watching(HttpHandler handler) {
        return exchange -> {
            SocketAddress address = exchange.getConnection().getPeerAddress();
            begin(address, exchange);
            XnioExecutor.Key deadline = exchange.isRequestComplete() ? null
                : exchange.getIoThread().executeAfter(() -> closeUnfinished(exchange), TIMEOUT_SECONDS, TimeUnit.SECONDS);
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

    /** What was idle has a request now. */
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
