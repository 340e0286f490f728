package org.SEAR.record;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Marks a record that is being written: a lock on a byte beyond its end, which goes with its writer, however that ends. On systems such as Linux it
 * also goes when another thread of the same program closes the file after reading it. So it is set anew now and then, on one of two bytes in turn.
 * Where files can't be locked there is no mark. For one thread, but for {@link #isOn}.
 */
final class WriteLock {
    private static final long PLACE = Long.MAX_VALUE - 2;
    private static final int BYTES = 2;

    private final FileChannel file;
    private FileLock lock;

    /** @param file open for writing; the mark goes when it is closed */
    WriteLock(FileChannel file) {
        this.file = file;
        renew();
    }

    /** Sets the mark anew. */
    void renew() {
        long place = lock == null || lock.position() > PLACE ? PLACE : PLACE + 1;
        try {
            FileLock fresh = file.tryLock(place, 1, false);
            if (fresh != null && lock != null) {
                lock.release();
            }
            lock = fresh == null ? lock : fresh;
        } catch (OverlappingFileLockException e) {
            // another thread just looks for the mark: the next time
        } catch (IOException e) {
            lock = null;    // this disk knows no locks
        }
    }

    /** Whether a file is being written by this program or another. Any thread. */
    static boolean isOn(Path path) {
        try (FileChannel file = FileChannel.open(path, StandardOpenOption.READ); FileLock free = file.tryLock(PLACE, BYTES, true)) {
            return free == null;
        } catch (OverlappingFileLockException e) {
            return true;
        } catch (IOException e) {
            return false;   // there is no such file, or this disk knows no locks
        }
    }
}
