package org.myrobotlab.service.sear.export;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.Iterator;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** A TCP server on the loopback address: raw bytes, one program at a time, a new one takes over. */
final class TcpEndpoint implements ExternalEndpoint {
    private static final Logger log = LoggerFactory.getLogger(TcpEndpoint.class);
    private static final int BUFFER = 4096;
    private static final int HIGHEST_PORT = 65535;

    private final String port;
    private final Selector selector;
    private final ServerSocketChannel server;
    private volatile SocketChannel client;

    private TcpEndpoint(String port, Selector selector, ServerSocketChannel server) {
        this.port = port;
        this.selector = selector;
        this.server = server;
    }

    /** @param number of the TCP port, 0 for any free one */
    static TcpEndpoint open(String port, int number) throws IOException {
        if (number < 0 || number > HIGHEST_PORT) {
            throw new IllegalArgumentException("TCP port is " + number + ", legal: 0 (any free one) to " + HIGHEST_PORT);
        }
        Selector selector = Selector.open();
        ServerSocketChannel server = ServerSocketChannel.open();
        try {
            server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), number));
            server.configureBlocking(false);
            server.register(selector, SelectionKey.OP_ACCEPT);
            return new TcpEndpoint(port, selector, server);
        } catch (IOException e) {
            server.close();
            selector.close();
            throw new IOException("TCP port " + number + " for " + port + " can't be opened: " + e.getMessage(), e);
        }
    }

    int getNumber() {
        return server.socket().getLocalPort();
    }

    @Override
    public void start(Consumer<byte[]> bytes, IntConsumer baud) {
        Thread thread = new Thread(() -> serve(bytes), "TCP server of " + port);
        thread.setDaemon(true);
        thread.start();
    }

    private void serve(Consumer<byte[]> bytes) {
        try {
            ByteBuffer buffer = ByteBuffer.allocate(BUFFER);
            while (server.isOpen()) {
                selector.select();
                for (Iterator<SelectionKey> keys = selector.selectedKeys().iterator(); server.isOpen() && keys.hasNext();) {
                    SelectionKey key = keys.next();
                    keys.remove();
                    if (key.isValid() && key.isAcceptable()) {
                        accept();
                    } else if (key.isValid() && key.isReadable()) {
                        read((SocketChannel) key.channel(), buffer, bytes);
                    }
                }
            }
        } catch (java.nio.channels.ClosedSelectorException e) {
            log.debug("TCP server of {} closed", port);
        } catch (IOException e) {
            log.warn("TCP server of {} ended: {}", port, e.toString());
        } finally {
            drop(client);
        }
    }

    private void accept() throws IOException {
        SocketChannel accepted = server.accept();
        if (accepted != null) {
            drop(client);
            accepted.configureBlocking(false);
            accepted.register(selector, SelectionKey.OP_READ);
            client = accepted;
        }
    }

    private void read(SocketChannel from, ByteBuffer buffer, Consumer<byte[]> bytes) {
        buffer.clear();
        try {
            if (from.read(buffer) < 0) {
                drop(from);
                return;
            }
        } catch (IOException e) {
            log.debug("a program left the TCP server of {}: {}", port, e.toString());
            drop(from);
            return;
        }
        buffer.flip();
        byte[] received = new byte[buffer.remaining()];
        buffer.get(received);
        bytes.accept(received);
    }

    private void drop(SocketChannel channel) {
        if (channel != null) {
            try {
                channel.close();
            } catch (IOException e) {
                log.debug("closing a connection of {} failed: {}", port, e.toString());
            }
            if (client == channel) {
                client = null;
            }
        }
    }

    @Override
    public void write(byte[] bytes) {
        SocketChannel to = client;
        if (to != null) {
            try {
                to.write(ByteBuffer.wrap(bytes));
            } catch (IOException e) {
                log.debug("a program left the TCP server of {}: {}", port, e.toString());
                drop(to);
            }
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
