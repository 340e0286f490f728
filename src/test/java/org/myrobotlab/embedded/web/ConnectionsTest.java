// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import static org.junit.Assert.assertEquals;

import io.undertow.server.HttpServerExchange;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;
import org.xnio.Option;
import org.xnio.StreamConnection;

/**
 * Which connection is closed to make room for another, if all of them arrive within the moment in which each may send a
 * request.
 */
public class ConnectionsTest {
    private final Connections connections = new Connections(connection -> { });
    private final List<Stub> all = new ArrayList<>();

    /** A client's connection with nothing but a port. */
    private static final class Stub extends StreamConnection {
        private final SocketAddress peer;

        Stub(int port) {
            super(null);
            peer = InetSocketAddress.createUnresolved("client", port);
        }

        @Override
        protected void notifyWriteClosed() {
        }

        @Override
        protected void notifyReadClosed() {
        }

        @Override
        protected boolean readClosed() {
            return true;
        }

        @Override
        protected boolean writeClosed() {
            return true;
        }

        @Override
        public SocketAddress getPeerAddress() {
            return peer;
        }

        @Override
        public SocketAddress getLocalAddress() {
            return InetSocketAddress.createUnresolved("server", 1);
        }

        @Override
        public <T> T setOption(Option<T> option, T value) throws IOException {
            return null;
        }
    }

    /** Opens a connection; its sources and sinks are unused, so they are null. */
    private Stub comes() {
        Stub stub = new Stub(1 + all.size());
        all.add(stub);
        connections.handleEvent(stub);
        return stub;
    }

    /** Receives the head of a request but not its body. */
    private void asks(Stub one) {
        connections.begin(one.getPeerAddress(), new HttpServerExchange(null));
    }

    private List<Integer> closed() {
        List<Integer> closed = new ArrayList<>();
        for (int i = 0; i < all.size(); i++) {
            if (!all.get(i).isOpen()) {
                closed.add(i);
            }
        }
        return closed;
    }

    private void idleOnes(int count) {
        for (int i = 0; i < count; i++) {
            comes();
        }
    }

    @Test
    public void aRequestThatHasJustBegunOutlastsConnectionsThatCameBefore() {
        idleOnes(Connections.MOST - 1);
        asks(comes());
        idleOnes(3);
        assertEquals(List.of(0, 1, 2), closed());
    }

    @Test
    public void newConnectionsOutlastEarlierRequests() {
        for (int i = 0; i < Connections.MOST - 1; i++) {
            asks(comes());
        }
        idleOnes(4);
        assertEquals(List.of(0, 1, 2), closed());
    }

    @Test
    public void oldRequestsAreClosedForNewOnes() {
        for (int i = 0; i < Connections.MOST + 2; i++) {
            asks(comes());
        }
        assertEquals(List.of(0, 1), closed());
    }
}
