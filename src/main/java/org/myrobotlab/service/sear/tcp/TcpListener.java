// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.tcp;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A TCP port at 127.0.0.1 for a selector loop. After an error, such as too many open files, it accepts nothing for
 * a quarter of a second; it never ends the loop. One thread, except {@link #close} and {@link #getPort}.
 */
public final class TcpListener implements Closeable {
    /** Pause after an error, milliseconds. */
    static final long PAUSE_MILLIS = 250;
    public static final int HIGHEST_PORT = 65535;
    private static final Logger LOG = LoggerFactory.getLogger(TcpListener.class);
    private static final byte[] LOOPBACK = {127, 0, 0, 1};

    private final ServerSocketChannel channel;
    private SelectionKey key;
    private boolean paused;
    /** Start of the pause, ns of the computer's clock. */
    private long since;

    private TcpListener(ServerSocketChannel channel) {
        this.channel = channel;
    }

    /**
     * Opens a port.
     *
     * @param port 0 for any free one
     * @param backlog most connections that wait to be accepted
     * @throws IOException if the port is not available
     */
    public static TcpListener open(int port, int backlog) throws IOException {
        ServerSocketChannel channel = ServerSocketChannel.open();
        try {
            channel.bind(new InetSocketAddress(InetAddress.getByAddress(LOOPBACK), port), backlog);
            channel.configureBlocking(false);
            return new TcpListener(channel);
        } catch (IOException | IllegalArgumentException e) {
            channel.close();
            throw e;
        }
    }

    /**
     * Registers for new connections.
     *
     * @param selector the key's attachment is this listener
     */
    public void register(Selector selector) throws IOException {
        key = channel.register(selector, SelectionKey.OP_ACCEPT, this);
    }

    /**
     * Accepts a connection, which doesn't block.
     *
     * @return null if there is none, or after an error
     */
    public SocketChannel accept() {
        SocketChannel accepted = null;
        try {
            accepted = channel.accept();
            if (accepted != null) {
                accepted.configureBlocking(false);
            }
            return accepted;
        } catch (IOException e) {
            close(accepted);
            if (channel.isOpen()) {
                LOG.debug("TCP port {} could not accept a program: {}", getPort(), e.toString());
                paused = true;
                since = System.nanoTime();
                key.interestOps(0);
            }
            return null;
        }
    }

    private static void close(SocketChannel channel) {
        try {
            if (channel != null) {
                channel.close();
            }
        } catch (IOException e) {
            LOG.debug("closing a connection failed: {}", e.toString());
        }
    }

    /**
     * Ends a pause when its time is over. Call it before each selection.
     *
     * @return longest time to select, milliseconds; 0 for no limit
     */
    public long selectMillis() {
        if (paused && System.nanoTime() - since > TimeUnit.MILLISECONDS.toNanos(PAUSE_MILLIS)) {
            paused = false;
            key.interestOps(SelectionKey.OP_ACCEPT);
        }
        return paused ? PAUSE_MILLIS : 0;
    }

    /** Returns the port's number. Any thread. */
    public int getPort() {
        return channel.socket().getLocalPort();
    }

    /** Closes the port, not its connections. Any thread. */
    @Override
    public void close() throws IOException {
        channel.close();
    }
}
