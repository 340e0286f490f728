// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.netcam;

import java.io.IOException;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.myrobotlab.service.sear.tcp.TcpListener;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * An HTTP server on the loopback address with one thread for all clients. Drops clients that take no bytes for a while;
 * they don't delay others.
 */
final class PictureServer {
    static final Logger LOG = LoggerFactory.getLogger(PictureServer.class);
    /** Most clients served at the same time; the server rejects more. */
    static final int MAX_CLIENTS = 128;
    /** Most additional clients that get a rejection. */
    private static final int MAX_REPORTED = 32;
    private static final int BUSY = 503;
    private static final int BUFFER = 4096;
    /** Size of the system's send buffer, bytes; small, so that slow clients get recent pictures. */
    private static final int UNSENT = 1 << 16;
    private static final long LOOK_MILLIS = 250;
    /** Attempts to find free consecutive ports. */
    private static final int TRIES = 50;

    private final String camera;
    private final DeviceProfile profile;
    private final Demand demand;
    private final long timeout;
    private final Selector selector;
    private final List<TcpListener> listeners;
    private final List<CameraConnection> clients = new ArrayList<>();
    private volatile int count;
    private volatile CameraConnection.Latest stream = CameraConnection.Latest.NONE;
    private volatile CameraConnection.Latest still = CameraConnection.Latest.NONE;

    private PictureServer(String camera, DeviceProfile likeness, Demand demand, long patience, Selector selector,
        List<TcpListener> doors) {
        this.camera = camera;
        this.profile = likeness;
        this.demand = demand;
        this.timeout = patience;
        this.selector = selector;
        this.listeners = doors;
    }

    /**
     * Opens the ports.
     *
     * @param number TCP port, 0 for any free one
     * @param patience milliseconds without progress after which a client is dropped
     */
    static PictureServer open(String camera, DeviceProfile likeness, int number, Demand demand, long patience)
        throws IOException {
        int highest = TcpListener.HIGHEST_PORT + 1 - likeness.getListeners();
        if (number < 0 || number > highest) {
            throw new IllegalArgumentException("TCP port is " + number + ", legal: 0 (any free one) to " + highest);
        }
        List<TcpListener> doors = listeners(camera, likeness.getListeners(), number);
        Selector selector = Selector.open();
        for (TcpListener door : doors) {
            door.register(selector);
        }
        return new PictureServer(camera, likeness, demand, TimeUnit.MILLISECONDS.toNanos(patience), selector, doors);
    }

    private static List<TcpListener> listeners(String camera, int count, int number) throws IOException {
        for (int tries = 0;; tries++) {
            List<TcpListener> doors = new ArrayList<>();
            int port = number;
            try {
                while (doors.size() < count) {
                    port = doors.isEmpty() ? number : doors.get(0).getPort() + doors.size();
                    doors.add(TcpListener.open(port, MAX_CLIENTS));
                }
                return doors;
            } catch (IOException | IllegalArgumentException e) {
                for (TcpListener door : doors) {
                    door.close();
                }
                if (number != 0 || tries == TRIES) {
                    throw new IOException("TCP port " + port + " for camera " + camera + " can't be opened: "
                        + e.getMessage(), e);
                }
            }
        }
    }

    /** Returns the first of its TCP ports. */
    int getNumber() {
        return listeners.get(0).getPort();
    }

    /** Returns the number of clients. Any thread. */
    int getClients() {
        return count;
    }

    /** Serves clients until the server is closed. */
    void serve() {
        ByteBuffer buffer = ByteBuffer.allocate(BUFFER);
        try {
            while (selector.isOpen()) {
                long longest = listeners.stream().mapToLong(TcpListener::selectMillis).max().orElse(0);
                selector.select(clients.isEmpty() ? longest : LOOK_MILLIS);
                for (Iterator<SelectionKey> keys = selector.selectedKeys().iterator(); keys.hasNext();) {
                    SelectionKey key = keys.next();
                    keys.remove();
                    if (key.attachment() instanceof CameraConnection) {
                        ((CameraConnection) key.attachment()).ready(buffer);
                    } else if (key.isValid() && key.isAcceptable()) {
                        accept((TcpListener) key.attachment());
                    }
                }
                handle();
            }
        } catch (ClosedSelectorException | CancelledKeyException e) {
            LOG.debug("network camera {} closed", camera);
        } catch (IOException e) {
            LOG.warn("network camera {} ended: {}", camera, e.toString());
        } finally {
            clients.forEach(CameraConnection::close);
            clients.clear();
            count = 0;
            demand.close();
            close();
        }
    }

    private void handle() {
        long now = System.nanoTime();
        CameraConnection.Latest newest = stream;
        CameraConnection.Latest answer = still;
        clients.forEach(client -> client.handle(now, newest, answer));
        clients.removeIf(CameraConnection::isGone);
        count = clients.size();
        boolean streaming = clients.stream().anyMatch(CameraConnection::isStreaming);
        if (!streaming) {
            forget();
        }
        demand.setStreaming(streaming);
    }

    private void accept(TcpListener door) throws IOException {
        SocketChannel channel = door.accept();
        if (channel != null) {
            begin(channel, listeners.indexOf(door), door.getPort());
        }
    }

    /** The longest connected client that awaits no response makes way for a new one if all places are taken. */
    private void makeRoom() {
        if (clients.size() >= MAX_CLIENTS) {
            clients.stream().filter(CameraConnection::isIdle).findFirst().ifPresent(longest -> {
                longest.close();
                clients.remove(longest);
            });
        }
    }

    private void begin(SocketChannel channel, int door, int port) throws IOException {
        makeRoom();
        if (clients.size() >= MAX_CLIENTS + MAX_REPORTED) {
            channel.close();
            return;
        }
        try {
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            channel.setOption(StandardSocketOptions.SO_SNDBUF, UNSENT);
            CameraConnection client = new CameraConnection(channel, camera, profile, door, port, demand, timeout);
            if (clients.size() >= MAX_CLIENTS) {
                client.refuse(Request.refused(BUSY, MAX_CLIENTS + " programs are connected, the most that the "
                    + "camera serves"));
            }
            client.setKey(channel.register(selector, SelectionKey.OP_READ, client));
            clients.add(client);
        } catch (IOException e) {
            LOG.debug("network camera {} lost a new program: {}", camera, e.toString());
            channel.close();
        }
    }

    /** Sets the stream's next picture; null for none. Any thread. */
    void publish(EncodedFrame shot) {
        synchronized (this) {
            stream = new CameraConnection.Latest(shot, stream.number + 1);
        }
        selector.wakeup();
    }

    /** Drops the last picture while there are no viewers, so that later ones don't see it. */
    private synchronized void forget() {
        stream = new CameraConnection.Latest(null, stream.number);
    }

    /**
     * Sets the response for waiting stills. Any thread.
     *
     * @param ticket the last one that it answers
     * @param shot null if no simulation with this camera runs
     */
    void answer(long ticket, EncodedFrame shot) {
        still = new CameraConnection.Latest(shot, ticket);
        selector.wakeup();
    }

    /** Closes ports and connections. Any thread. */
    void close() {
        try {
            for (TcpListener door : listeners) {
                door.close();
            }
            selector.close();
        } catch (IOException e) {
            LOG.warn("network camera {} did not close: {}", camera, e.toString());
        }
    }
}
