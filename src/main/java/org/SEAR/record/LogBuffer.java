// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * Buffers bytes on their way to a file. The simulation thread fills preallocated pieces; a writer thread writes them.
 * When the disk falls behind by all pieces, the simulation waits up to {@value #TIMEOUT_SECONDS} s.
 */
final class LogBuffer {
    private static final int PIECE = 1 << 18;
    private static final int PIECES = 8;
    private static final int TIMEOUT_SECONDS = 10;
    private static final int MARK_SECONDS = 1;
    private static final ByteBuffer LAST = ByteBuffer.allocate(0);

    private final BlockingQueue<ByteBuffer> free = new ArrayBlockingQueue<>(PIECES);
    private final BlockingQueue<ByteBuffer> full = new ArrayBlockingQueue<>(PIECES + 1);
    private final FileChannel file;
    private final WriteLock mark;
    private final Thread writer;
    private volatile String failure;
    private ByteBuffer present;
    private long size;

    LogBuffer(Path path) throws IOException {
        if (WriteLock.isOn(path)) {
            throw new IOException(path + " is being written by another simulation: end its record, or choose "
                + "another name");
        }
        file = FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE);
        mark = new WriteLock(file);
        for (int i = 1; i < PIECES; i++) {
            free.add(ByteBuffer.allocate(PIECE));
        }
        present = ByteBuffer.allocate(PIECE);
        writer = new Thread(this::write, "SEAR record");
        writer.setDaemon(true);
        writer.start();
    }

    private void write() {
        try (FileChannel out = file) {
            for (ByteBuffer piece = taken(); piece != LAST; piece = taken()) {
                piece.flip();
                while (failure == null && piece.hasRemaining()) {
                    out.write(piece);
                }
                piece.clear();
                free.add(piece);
            }
        } catch (IOException e) {
            failure = e.getMessage() == null ? e.toString() : e.getMessage();
        } catch (InterruptedException e) {
            failure = "its thread was interrupted";
        }
    }

    /** Waits for a full piece and renews the file's write lock meanwhile. */
    private ByteBuffer taken() throws InterruptedException {
        ByteBuffer piece = full.poll(MARK_SECONDS, TimeUnit.SECONDS);
        while (piece == null) {
            mark.renew();
            piece = full.poll(MARK_SECONDS, TimeUnit.SECONDS);
        }
        mark.renew();
        return piece;
    }

    /** Returns why writing has stopped; null while it works. Any thread. */
    String failure() {
        return failure;
    }

    /** Returns the bytes put so far. */
    long size() {
        return size;
    }

    private ByteBuffer room(int bytes) {
        if (present.remaining() < bytes) {
            next();
        }
        size += bytes;
        return present;
    }

    /** Passes buffered bytes to the writer, unless it is behind. Does not wait. */
    void flush() {
        if (present.position() > 0 && !free.isEmpty()) {
            next();
        }
    }

    private void next() {
        try {
            ByteBuffer fresh = failure == null && full.offer(present)
                ? free.poll(TIMEOUT_SECONDS, TimeUnit.SECONDS) : null;
            if (fresh == null) {
                failure = failure == null ? "the disk is too slow" : failure;
                fresh = ByteBuffer.allocate(PIECE);
            }
            present = fresh;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            failure = "the simulation was interrupted";
            present = ByteBuffer.allocate(PIECE);
        }
    }

    LogBuffer put(int value) {
        room(1).put((byte) value);
        return this;
    }

    LogBuffer putShort(int value) {
        room(2).putShort((short) value);
        return this;
    }

    LogBuffer putInt(int value) {
        room(4).putInt(value);
        return this;
    }

    LogBuffer putLong(long value) {
        room(8).putLong(value);
        return this;
    }

    LogBuffer putDouble(double value) {
        room(8).putDouble(value);
        return this;
    }

    LogBuffer putBytes(byte[] bytes, int count) {
        for (int at = 0; at < count;) {
            ByteBuffer piece = room(0);
            if (!piece.hasRemaining()) {
                next();
                piece = present;
            }
            int part = Math.min(piece.remaining(), count - at);
            piece.put(bytes, at, part);
            at += part;
            size += part;
        }
        return this;
    }

    /** Writes the remaining bytes and waits for the writer. */
    void close() throws IOException {
        try {
            if (failure == null && full.offer(present, TIMEOUT_SECONDS, TimeUnit.SECONDS)) {
                full.put(LAST);
            } else {
                writer.interrupt();
            }
            writer.join(TimeUnit.SECONDS.toMillis(TIMEOUT_SECONDS));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("the record was not written completely", e);
        }
        if (failure != null) {
            throw new IOException("the record is incomplete: " + failure);
        }
    }
}
