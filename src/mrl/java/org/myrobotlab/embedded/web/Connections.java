package org.myrobotlab.embedded.web;

import io.undertow.server.HttpHandler;
import java.net.SocketAddress;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import org.xnio.ChannelListener;
import org.xnio.IoUtils;
import org.xnio.StreamConnection;

/**
 * The connections that are open. One that comes when there are many takes the place of the one that has been without a request for the longest time:
 * a program that opens connections and asks nothing keeps nobody out. Any thread.
 */
final class Connections implements ChannelListener<StreamConnection> {
    /** Connections that stay open at the same time, unless more of them have a request. */
    static final int MOST = 256;

    private final ChannelListener<? super StreamConnection> next;
    private final Map<SocketAddress, StreamConnection> busy = new HashMap<>();
    /** The one that has been idle longest comes first. */
    private final Map<SocketAddress, StreamConnection> idle = new LinkedHashMap<>();

    /** @param next what serves a connection */
    Connections(ChannelListener<? super StreamConnection> next) {
        this.next = next;
    }

    @Override
    public void handleEvent(StreamConnection connection) {
        StreamConnection closing = add(connection);
        IoUtils.safeClose(closing);
        next.handleEvent(connection);
    }

    /** Answers the connection that must go; null if none has to. */
    private synchronized StreamConnection add(StreamConnection connection) {
        busy.values().removeIf(one -> !one.isOpen());
        idle.values().removeIf(one -> !one.isOpen());
        boolean isFull = busy.size() + idle.size() >= MOST && !idle.isEmpty();
        StreamConnection oldest = isFull ? idle.remove(idle.keySet().iterator().next()) : null;
        idle.put(connection.getPeerAddress(), connection);
        return oldest;
    }

    /** Knows by the requests which connections are busy: those that become web sockets stay so. */
    HttpHandler watching(HttpHandler handler) {
        return exchange -> {
            SocketAddress address = exchange.getConnection().getPeerAddress();
            move(address, idle, busy);
            exchange.addExchangeCompleteListener((done, after) -> {
                if (!done.isUpgrade()) {
                    move(address, busy, idle);
                }
                after.proceed();
            });
            handler.handleRequest(exchange);
        };
    }

    private synchronized void move(SocketAddress address, Map<SocketAddress, StreamConnection> from, Map<SocketAddress, StreamConnection> to) {
        StreamConnection connection = from.remove(address);
        if (connection != null) {
            to.put(address, connection);
        }
    }
}
