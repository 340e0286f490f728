// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.records;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.SEAR.record.RecordPictures;
import org.SEAR.record.RunRecord;

/**
 * Index of the pictures in the last requested record. Reads the record once, and again after a change; a growing record
 * at most every ten seconds. Any thread.
 */
public final class RecordPictureCache {
    private static final long TIMEOUT = TimeUnit.SECONDS.toNanos(10);

    private String stamp = "";
    private Path known;
    private boolean growing;
    private long read;
    private RecordPictures last;

    /**
     * Returns the pictures of a record.
     *
     * @throws IOException with the path, if it is not a record
     */
    public synchronized RecordPictures of(String path) throws IOException {
        RunRecord record = Records.open(path);
        Path file = record.getPath();
        String now = file.toAbsolutePath() + " " + Files.size(file) + " " + Files.getLastModifiedTime(file);
        boolean grows = growing && record.isBeingWritten() && file.equals(known) && System.nanoTime() - read < TIMEOUT;
        if (!now.equals(stamp) && !grows) {
            last = RecordPictures.of(record);
            stamp = now;
            known = file;
            growing = record.isBeingWritten();
            read = System.nanoTime();
        }
        return last;
    }
}
