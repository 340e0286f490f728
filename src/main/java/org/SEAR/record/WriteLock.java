// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Marks a record that is being written by a lock on a byte beyond its end. The lock disappears with its writer, even
 * after a crash. On systems such as Linux it also disappears when another thread of the program closes the file after
 * reading. {@link #renew} therefore sets it repeatedly, on two bytes in turn. On file systems without locks there is no
 * mark. One thread, except for {@link #isOn}.
 */
final class WriteLock {
    private static final long PLACE = Long.MAX_VALUE - 2;
    private static final int BYTES = 2;

    private final FileChannel file;
    private FileLock lock;

    /** @param file open for writing; closing it removes the mark */
    WriteLock(FileChannel file) {
        this.file = file;
        renew();
    }

    /** Sets the mark again. */
    void renew() {
        long place = lock == null || lock.position() > PLACE ? PLACE : PLACE + 1;
        try {
            FileLock fresh = file.tryLock(place, 1, false);
            if (fresh != null && lock != null) {
                lock.release();
            }
            lock = fresh == null ? lock : fresh;
        } catch (OverlappingFileLockException e) {
            // another thread is just checking the mark: the next renewal sets it
        } catch (IOException e) {
            lock = null;    // this file system has no locks
        }
    }

    /** Returns whether this or another program is writing a file. Any thread. */
    static boolean isOn(Path path) {
        try (FileChannel file = FileChannel.open(path, StandardOpenOption.READ); FileLock free =
            file.tryLock(PLACE, BYTES, true)) {
            return free == null;
        } catch (OverlappingFileLockException e) {
            return true;
        } catch (IOException e) {
            return false;   // no such file, or a file system without locks
        }
    }
}
