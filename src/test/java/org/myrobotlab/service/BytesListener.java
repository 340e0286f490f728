// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.util.function.Consumer;
import org.myrobotlab.framework.QueueStats;
import org.myrobotlab.service.interfaces.SerialDataListener;

/** A listener of a port that only needs its bytes. */
public final class BytesListener implements SerialDataListener {
    private final Consumer<byte[]> taker;

    public BytesListener(Consumer<byte[]> taker) {
        this.taker = taker;
    }

    @Override
    public void onBytes(byte[] bytes) {
        taker.accept(bytes);
    }

    @Override
    public String getName() {
        return "test listener";
    }

    @Override
    public QueueStats publishStats(QueueStats stats) {
        return stats;
    }

    @Override
    public void updateStats(QueueStats stats) {
        throw new IllegalStateException("nobody asked for " + stats);
    }

    @Override
    public void onConnect(String port) {
        throw new IllegalStateException("nobody tells " + port);
    }

    @Override
    public void onDisconnect(String port) {
        throw new IllegalStateException("nobody tells " + port);
    }
}
