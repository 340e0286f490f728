// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.SEAR.files.AtomicFile;

/** Original contents of files that a unit of changes has modified. One thread. */
final class Undo {
    /** Bytes by file; null for a file that did not exist. */
    private final Map<Path, byte[]> before = new LinkedHashMap<>();

    /** Notes the content of a file before it is changed. */
    void note(Path file) throws IOException {
        if (!before.containsKey(file)) {
            before.put(file, Files.isRegularFile(file) ? Files.readAllBytes(file) : null);
        }
    }

    /** Restores all files, and removes folders that are empty afterwards. */
    void putBack() throws IOException {
        for (Map.Entry<Path, byte[]> entry : before.entrySet()) {
            Path file = entry.getKey();
            if (entry.getValue() != null) {
                Files.createDirectories(file.getParent());
                AtomicFile.write(file, entry.getValue());
            } else if (Files.deleteIfExists(file)) {
                FileStore.deleteIfEmpty(file.getParent());
            }
        }
    }
}
