// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.serial;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/** Reads bytes from a queue, with a timeout. */
public final class ByteReader {
    private final BlockingQueue<Integer> queue;
    private final Consumer<String> complaint;
    private volatile int timeoutMs;

    /** @param complaint gets a message when a read times out */
    public ByteReader(BlockingQueue<Integer> queue, Consumer<String> complaint) {
        this.queue = queue;
        this.complaint = complaint;
    }

    /** Sets how long a read waits for each byte, ms; 0 waits without limit. */
    public void setTimeout(int millis) {
        timeoutMs = millis;
    }

    public int getTimeout() {
        return timeoutMs;
    }

    /**
     * Reads a byte.
     *
     * @return 0 to 255
     * @throws IOException on a timeout
     */
    public int read() throws IOException, InterruptedException {
        Integer value = next();
        if (value == null) {
            String message = timeoutMs + " ms timeout was reached - no data";
            complaint.accept(message);
            throw new IOException(message);
        }
        return value;
    }

    /** Reads {@code length} bytes, or fewer on a timeout. */
    public byte[] read(int length) throws InterruptedException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        while (bytes.size() < length) {
            Integer value = next();
            if (value == null) {
                complaint.accept("expecting " + length + " bytes got " + bytes.size());
                break;
            }
            bytes.write(value);
        }
        return bytes.toByteArray();
    }

    /** Reads up to and including the delimiter, or less on a timeout. */
    public byte[] readTo(char delimiter) throws InterruptedException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        Integer value;
        do {
            value = next();
            if (value != null) {
                bytes.write(value);
            }
        } while (value != null && value != delimiter);
        return bytes.toByteArray();
    }

    private Integer next() throws InterruptedException {
        return timeoutMs == 0 ? queue.take() : queue.poll(timeoutMs, TimeUnit.MILLISECONDS);
    }
}
