package org.SEAR.project;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/** How files were before something that may fail halfway changed them. One thread. */
final class Undo {
    /** Bytes by file; null for one that was not there. */
    private final Map<Path, byte[]> before = new LinkedHashMap<>();

    /** A file is about to be changed. */
    void note(Path file) throws IOException {
        if (!before.containsKey(file)) {
            before.put(file, Files.isRegularFile(file) ? Files.readAllBytes(file) : null);
        }
    }

    /** Has all files as they were, and removes the folders that hold none then. */
    void putBack() throws IOException {
        for (Map.Entry<Path, byte[]> entry : before.entrySet()) {
            Path file = entry.getKey();
            if (entry.getValue() != null) {
                Files.createDirectories(file.getParent());
                FileStore.writeAtomically(file, entry.getValue());
            } else if (Files.deleteIfExists(file)) {
                FileStore.deleteIfEmpty(file.getParent());
            }
        }
    }
}
