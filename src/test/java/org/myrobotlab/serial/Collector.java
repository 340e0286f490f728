// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import static org.junit.Assert.fail;

import java.io.ByteArrayOutputStream;
import java.util.concurrent.TimeUnit;
import org.myrobotlab.framework.QueueStats;
import org.myrobotlab.service.interfaces.SerialDataListener;

/** Stores received bytes. */
class Collector implements SerialDataListener {
    private static final long PATIENCE = 60_000;

    final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final String name;
    int longest;

    Collector(String name) {
        this.name = name;
    }

    @Override
    public synchronized void onBytes(byte[] chunk) {
        bytes.write(chunk, 0, chunk.length);
        longest = Math.max(longest, chunk.length);
        notifyAll();
    }

    synchronized byte[] await(int count) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(PATIENCE);
        while (bytes.size() < count && System.nanoTime() < end) {
            wait(100);
        }
        return bytes.toByteArray();
    }

    @Override
    public String getName() {
        return name;
    }

    @Override
    public QueueStats publishStats(QueueStats stats) {
        return stats;
    }

    @Override
    public void updateStats(QueueStats stats) {
        fail("nobody asked for statistics");
    }

    @Override
    public void onConnect(String port) {
        fail("nobody tells " + port);
    }

    @Override
    public void onDisconnect(String port) {
        fail("nobody tells " + port);
    }
}
