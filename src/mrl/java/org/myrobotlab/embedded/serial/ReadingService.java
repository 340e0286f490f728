// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.serial;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.SerialConfig;
import org.myrobotlab.service.interfaces.QueueSource;

/**
 * The reading side of Serial: received bytes wait in a queue, and reads wait for bytes. Any thread; reads are served
 * one after another.
 */
public abstract class ReadingService extends Service<SerialConfig> implements QueueSource {
    private static final long serialVersionUID = 1L;

    /** Received bytes that were not read yet, each 0 to 255. */
    protected final transient BlockingQueue<Integer> blockingRX = new LinkedBlockingQueue<>();
    private final transient ByteReader reader = new ByteReader(blockingRX, this::error);

    protected ReadingService(String name, String id) {
        super(name, id);
    }

    public synchronized int read() throws IOException, InterruptedException {
        return reader.read();
    }

    /** Waits until the array is full. */
    public synchronized int read(byte[] data) throws IOException, InterruptedException {
        for (int i = 0; i < data.length; i++) {
            data[i] = (byte) reader.read();
        }
        return data.length;
    }

    /** Waits for {@code length} bytes; returns fewer on a timeout. */
    public synchronized byte[] read(int length) throws InterruptedException {
        return reader.read(length);
    }

    /** Returns all received bytes. */
    public synchronized byte[] readBytes() throws IOException, InterruptedException {
        return reader.read(available());
    }

    public byte[] readLine() throws InterruptedException {
        return readLine('\n');
    }

    public byte[] readLine(char delimiter) throws InterruptedException {
        return reader.readTo(delimiter);
    }

    public String readString() throws InterruptedException {
        return readString('\n');
    }

    public String readString(char delimiter) throws InterruptedException {
        return new String(readLine(delimiter), StandardCharsets.UTF_8);
    }

    public String readString(int length) throws InterruptedException {
        return new String(read(length), StandardCharsets.UTF_8);
    }

    public int available() {
        return blockingRX.size();
    }

    public void clear() {
        blockingRX.clear();
    }

    @Override
    public BlockingQueue<?> getQueue() {
        return blockingRX;
    }

    /** Sets how long a read waits for each byte, ms; 0 waits without limit. */
    public void setTimeout(int timeoutMs) {
        reader.setTimeout(timeoutMs);
    }

    public int getTimeout() {
        return reader.getTimeout();
    }
}
