// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.classroom;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Output of a pupil's program in a file, which is truncated when it is too long. A separate thread for each program.
 */
final class OutputLog {
    private static final int LONGEST = 1 << 20;
    private static final int PART = 1 << 13;
    private static final String OUT_OF_MEMORY = "Terminating due to java.lang.OutOfMemoryError";

    private final Path file;
    private volatile boolean isOutOfMemory;

    private OutputLog(Path file) {
        this.file = file;
    }

    /** Copies a stream to a file until the stream ends. */
    static OutputLog keep(InputStream in, Path file) {
        OutputLog log = new OutputLog(file);
        Thread thread = new Thread(() -> log.copy(in), "output " + file.getFileName());
        thread.setDaemon(true);
        thread.start();
        return log;
    }

    private void copy(InputStream in) {
        byte[] part = new byte[PART];
        try (in) {
            for (int count = in.read(part); count >= 0; count = in.read(part)) {
                if (new String(part, 0, count, StandardCharsets.UTF_8).contains(OUT_OF_MEMORY)) {
                    isOutOfMemory = true;
                }
                write(part, count);
            }
        } catch (IOException e) {
            return;    // the program has ended
        }
    }

    /** Writes, but does not fail: a full disk must not stop the program. */
    private void write(byte[] part, int count) {
        try {
            boolean isLong = Files.exists(file) && Files.size(file) > LONGEST;
            try (OutputStream out = Files.newOutputStream(file, StandardOpenOption.CREATE,
                isLong ? StandardOpenOption.TRUNCATE_EXISTING : StandardOpenOption.APPEND)) {
                out.write(part, 0, count);
            }
        } catch (IOException e) {
            System.err.println("sear class: " + file + " can't be written: " + e.getMessage());
        }
    }

    /** Returns whether Java has reported that its memory has run out. */
    boolean isOutOfMemory() {
        return isOutOfMemory;
    }
}
