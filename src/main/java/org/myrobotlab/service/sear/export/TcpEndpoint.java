// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import java.io.IOException;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.Iterator;
import org.myrobotlab.service.sear.tcp.TcpListener;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A TCP server on the loopback address for one program at a time; a new one replaces the old. Its
 * {@link TcpSession.Kind} defines the meaning of the bytes. The system buffers bytes for a slow program; beyond that,
 * an {@link Outbox} drops whole messages.
 */
final class TcpEndpoint implements ExternalEndpoint {
    private static final Logger log = LoggerFactory.getLogger(TcpEndpoint.class);
    private static final int BUFFER = 4096;
    /** Most programs that wait to be accepted; each replaces the one before. */
    private static final int BACKLOG = 50;

    private final String port;
    private final TcpSession.Kind kind;
    private final Selector selector;
    private final TcpListener server;
    private LineEnd end;
    /** Guarded by this, like the following fields; null without a program. */
    private SocketChannel client;
    private TcpSession session;
    private Outbox outbox;

    private TcpEndpoint(String port, TcpSession.Kind kind, Selector selector, TcpListener server) {
        this.port = port;
        this.kind = kind;
        this.selector = selector;
        this.server = server;
    }

    /** @param number TCP port, 0 for any free one */
    static TcpEndpoint open(String port, TcpSession.Kind kind, int number) throws IOException {
        if (number < 0 || number > TcpListener.HIGHEST_PORT) {
            throw new IllegalArgumentException("TCP port is " + number + ", legal: 0 (any free one) to "
                + TcpListener.HIGHEST_PORT);
        }
        try {
            TcpListener server = TcpListener.open(number, BACKLOG);
            Selector selector = Selector.open();
            server.register(selector);
            return new TcpEndpoint(port, kind, selector, server);
        } catch (IOException e) {
            throw new IOException("TCP port " + number + " for " + port + " can't be opened: " + e.getMessage(), e);
        }
    }

    int getNumber() {
        return server.getPort();
    }

    @Override
    public void start(LineEnd lineEnd) {
        end = lineEnd;
        Thread thread = new Thread(this::serve, "TCP server of " + port);
        thread.setDaemon(true);
        thread.start();
    }

    @Override
    public void deviceAt(int baud) {
        // A raw connection has no rate; RFC 2217 queries it.
    }

    @Override
    public String describe() {
        return kind.getName() + " port " + getNumber();
    }

    private void serve() {
        try {
            ByteBuffer buffer = ByteBuffer.allocate(BUFFER);
            while (selector.isOpen()) {
                selector.select(server.selectMillis());
                for (Iterator<SelectionKey> keys = selector.selectedKeys().iterator(); selector.isOpen()
                    && keys.hasNext();) {
                    SelectionKey key = keys.next();
                    keys.remove();
                    serve(key, buffer);
                }
            }
        } catch (ClosedSelectorException e) {
            log.debug("TCP server of {} closed", port);
        } catch (IOException e) {
            log.warn("TCP server of {} ended: {}", port, e.toString());
        } finally {
            drop(client());
        }
    }

    private void serve(SelectionKey key, ByteBuffer buffer) {
        if (key.attachment() == server) {
            SocketChannel accepted = server.accept();
            if (accepted != null) {
                drop(client());
                begin(accepted);
            }
            return;
        }
        SocketChannel from = (SocketChannel) key.channel();
        try {
            if (key.isWritable()) {
                sendRest(from, key);
            }
            if (key.isReadable()) {
                read(from, buffer);
            }
        } catch (CancelledKeyException e) {
            log.debug("the device's thread has closed a connection of {}", port);
        }
    }

    private void begin(SocketChannel accepted) {
        try {
            accepted.setOption(StandardSocketOptions.TCP_NODELAY, true);
            accepted.register(selector, SelectionKey.OP_READ);
        } catch (IOException e) {
            leave(accepted, e);
            return;
        }
        synchronized (this) {
            client = accepted;
            session = kind.begin(end, bytes -> reply(accepted, bytes));
            outbox = new Outbox(session::encode);
        }
        end.opened();
    }

    private synchronized SocketChannel client() {
        return client;
    }

    private synchronized TcpSession sessionOf(SocketChannel channel) {
        return channel == client ? session : null;
    }

    private void read(SocketChannel from, ByteBuffer buffer) {
        buffer.clear();
        try {
            if (from.read(buffer) < 0) {
                drop(from);
                return;
            }
        } catch (IOException e) {
            leave(from, e);
            return;
        }
        buffer.flip();
        byte[] received = new byte[buffer.remaining()];
        buffer.get(received);
        TcpSession present = sessionOf(from);
        if (present != null) {
            present.received(received);
        }
    }

    private void leave(SocketChannel channel, IOException reason) {
        log.debug("a program left the TCP server of {}: {}", port, reason.toString());
        drop(channel);
    }

    private void drop(SocketChannel channel) {
        if (channel == null) {
            return;
        }
        try {
            channel.close();
        } catch (IOException e) {
            log.debug("closing a connection of {} failed: {}", port, e.toString());
        }
        boolean last;
        synchronized (this) {
            last = client == channel;
            if (last) {
                client = null;
                session = null;
                outbox = null;
            }
        }
        if (last) {
            end.closed();
        }
    }

    @Override
    public void write(byte[] bytes, int[] starts) {
        SocketChannel to = client();
        int dropped = 0;
        try {
            synchronized (this) {
                if (to != null && to == client) {
                    flush(to);
                    dropped = outbox.add(bytes, starts);
                    flush(to);
                }
            }
        } catch (IOException e) {
            leave(to, e);
        }
        if (dropped > 0) {
            end.lost(dropped);
        }
    }

    private void reply(SocketChannel to, byte[] bytes) {
        try {
            synchronized (this) {
                if (to == client) {
                    outbox.reply(bytes);
                    flush(to);
                }
            }
        } catch (IOException e) {
            leave(to, e);
        }
    }

    private void sendRest(SocketChannel to, SelectionKey key) {
        try {
            synchronized (this) {
                if (to == client) {
                    flush(to);
                }
                if (to != client || outbox.isEmpty()) {
                    key.interestOps(SelectionKey.OP_READ);
                }
            }
        } catch (IOException e) {
            leave(to, e);
        }
    }

    /** Sends what the system takes to the present program, and asks the selector for the moment when it takes more. */
    private void flush(SocketChannel to) throws IOException {
        outbox.flush((bytes, from, count) -> to.write(ByteBuffer.wrap(bytes, from, count)));
        if (!outbox.isEmpty()) {
            listenFor(to, SelectionKey.OP_READ | SelectionKey.OP_WRITE);
        }
    }

    private void listenFor(SocketChannel channel, int operations) {
        try {
            SelectionKey key = channel.keyFor(selector);
            if (key != null) {
                key.interestOps(operations);
                selector.wakeup();
            }
        } catch (CancelledKeyException | ClosedSelectorException e) {
            log.debug("a program left the TCP server of {} while it was written to", port);
        }
    }

    @Override
    public void close() {
        try {
            server.close();
            selector.close();
        } catch (IOException e) {
            log.warn("TCP server of {} did not close: {}", port, e.toString());
        }
    }
}
