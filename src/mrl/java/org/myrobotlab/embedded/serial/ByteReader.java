package org.myrobotlab.embedded.serial;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/** Takes bytes out of a queue, with a time-out. */
public final class ByteReader {
    private final BlockingQueue<Integer> queue;
    private final Consumer<String> complaint;
    private volatile int timeoutMs;

    /** @param complaint told when a time-out ends a read */
    public ByteReader(BlockingQueue<Integer> queue, Consumer<String> complaint) {
        this.queue = queue;
        this.complaint = complaint;
    }

    /** Milliseconds that a read waits for each byte; 0 without end. */
    public void setTimeout(int millis) {
        timeoutMs = millis;
    }

    public int getTimeout() {
        return timeoutMs;
    }

    /**
     * @return 0 to 255.
     * @throws IOException when the time-out ends
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

    /** That many bytes, or fewer when the time-out ends. */
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

    /** Bytes up to and with the delimiter, or fewer when the time-out ends. */
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
