// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.python3;

import java.io.IOException;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.myrobotlab.service.sear.tcp.TcpListener;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Accepts connections and passes on those that begin with the token, as Py4J's clients send it: {@code A\nTOKEN\n}.
 * Reads no byte beyond it. Py4J itself would read a first line without a limit, on one thread per connection. One
 * thread serves all connections without a token; they cost a buffer of the token's length each. Any thread.
 */
final class TokenGate implements AutoCloseable {
    /** Most connections without a token; a further one replaces the oldest. */
    static final int MAX_PENDING = 64;
    /** Time from the connection to the token's last byte. */
    static final long DEADLINE_SECONDS = 5;
    private static final Logger LOG = LoggerFactory.getLogger(TokenGate.class);
    private static final long LOOK_MILLIS = 250;
    /** Lines of the client's greeting: the command and the token. */
    private static final int LINES = 2;
    private static final byte[] ACCEPTED = ascii("!yv\n");
    private static final byte[] REFUSED = ascii("!x\n");

    private final byte[] expected;
    private final Consumer<Socket> next;
    private final Selector selector;
    private final TcpListener listener;
    private volatile boolean closed;
    /** The oldest comes first. */
    private final Deque<Pending> pending = new ArrayDeque<>();

    /** A connection without a token. */
    private static final class Pending {
        private final SocketChannel channel;
        private final ByteBuffer received;
        private final long since = System.nanoTime();

        Pending(SocketChannel channel, int length) {
            this.channel = channel;
            received = ByteBuffer.allocate(length);
        }

        /** Returns whether two lines, or as many bytes as they have, have arrived. */
        boolean isComplete() {
            int lines = 0;
            for (int i = 0; i < received.position(); i++) {
                lines += received.get(i) == '\n' ? 1 : 0;
            }
            return lines == LINES || !received.hasRemaining();
        }
    }

    private TokenGate(byte[] expected, Consumer<Socket> next, Selector selector, TcpListener listener) {
        this.expected = expected;
        this.next = next;
        this.selector = selector;
        this.listener = listener;
    }

    /**
     * Opens the port.
     *
     * @param port 0 for any free one
     * @param next takes connections with the token, blocking, on this gate's thread
     * @throws IOException if the port is not available
     */
    static TokenGate open(int port, String token, Consumer<Socket> next) throws IOException {
        TcpListener listener = TcpListener.open(port, MAX_PENDING);
        Selector selector = Selector.open();
        listener.register(selector);
        TokenGate gate = new TokenGate(ascii("A\n" + token + "\n"), next, selector, listener);
        Thread thread = new Thread(gate::serve, "Python 3 gateway " + listener.getPort());
        thread.setDaemon(true);
        thread.start();
        return gate;
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    int getPort() {
        return listener.getPort();
    }

    private void serve() {
        try {
            while (!closed) {
                long longest = listener.selectMillis();
                selector.select(pending.isEmpty() ? longest : LOOK_MILLIS);
                for (Iterator<SelectionKey> keys = selector.selectedKeys().iterator(); keys.hasNext();) {
                    SelectionKey key = keys.next();
                    keys.remove();
                    if (key.isValid()) {
                        serve(key);
                    }
                }
                dropLate();
            }
        } catch (ClosedSelectorException | CancelledKeyException e) {
            LOG.debug("Python 3 gateway closed");
        } catch (IOException e) {
            LOG.warn("Python 3 gateway ended: {}", e.toString());
        } finally {
            pending.forEach(one -> close(one.channel));
            closeAll();
        }
    }

    private void serve(SelectionKey key) throws IOException {
        if (key.attachment() instanceof Pending) {
            read(key, (Pending) key.attachment());
            return;
        }
        SocketChannel accepted = listener.accept();
        if (accepted != null) {
            if (pending.size() == MAX_PENDING) {
                close(pending.removeFirst().channel);
            }
            Pending client = new Pending(accepted, expected.length);
            pending.add(client);
            accepted.register(selector, SelectionKey.OP_READ, client);
        }
    }

    private void dropLate() {
        long now = System.nanoTime();
        while (!pending.isEmpty() && now - pending.peekFirst().since > TimeUnit.SECONDS.toNanos(DEADLINE_SECONDS)) {
            close(pending.removeFirst().channel);
        }
    }

    private void read(SelectionKey key, Pending client) {
        try {
            boolean ended = client.channel.read(client.received) < 0;
            if (ended || client.isComplete()) {
                pending.remove(client);
                if (MessageDigest.isEqual(client.received.array(), expected)) {
                    key.cancel();
                    client.channel.write(ByteBuffer.wrap(ACCEPTED));
                    client.channel.configureBlocking(true);
                    next.accept(client.channel.socket());
                } else {
                    client.channel.write(ByteBuffer.wrap(REFUSED));
                    close(client.channel);
                }
            }
        } catch (IOException e) {
            pending.remove(client);
            close(client.channel);
        }
    }

    private static void close(SocketChannel channel) {
        try {
            channel.close();
        } catch (IOException e) {
            LOG.debug("closing a connection failed: {}", e.toString());
        }
    }

    /** Closes the port and the connections without a token, on this gate's thread: only it uses the selector. */
    @Override
    public void close() {
        closed = true;
        selector.wakeup();
    }

    private void closeAll() {
        try {
            listener.close();
            selector.close();
        } catch (IOException e) {
            LOG.warn("Python 3 gateway did not close: {}", e.toString());
        }
    }
}
