// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import org.SEAR.files.AtomicFile;

/**
 * The bundle that a project belongs to, where the next save writes. A file beside the project stores it, {@code
 * SEARproject.origin}: the word {@code saved} or {@code proposed}, then the path. Immutable; any thread.
 */
public final class ProjectOrigin {
    /** Origin of a project without a file. */
    public static final ProjectOrigin NONE = new ProjectOrigin("project.sear", false);
    private static final String ENDING = ".origin";
    private static final String SAVED = "saved";
    private static final String PROPOSED = "proposed";

    /** Path of the bundle, as the user wrote it. */
    public final String path;
    /** Whether the project was opened from this bundle or saved to it; otherwise the path is a proposal. */
    public final boolean saved;

    public ProjectOrigin(String path, boolean saved) {
        this.path = path;
        this.saved = saved;
    }

    private static Path file(Path folder) {
        return folder.resolveSibling(folder.getFileName() + ENDING);
    }

    /** Returns the origin of a project or a backup; {@link #NONE} if it is unknown. */
    public static ProjectOrigin of(Path folder) throws IOException {
        Path file = file(folder);
        List<String> lines = Files.isRegularFile(file) ? Files.readAllLines(file) : List.of();
        return lines.size() < 2 || lines.get(1).isEmpty() ? NONE
            : new ProjectOrigin(lines.get(1), lines.get(0).equals(SAVED));
    }

    /** Stores this origin beside a project. */
    public void write(Path folder) throws IOException {
        if (this == NONE) {
            delete(folder);
            return;
        }
        String text = (saved ? SAVED : PROPOSED) + "\n" + path + "\n";
        AtomicFile.write(file(folder), text.getBytes(StandardCharsets.UTF_8));
    }

    /** Moves the origin of a project that was renamed. */
    static void move(Path folder, Path to) throws IOException {
        if (Files.exists(file(folder))) {
            Files.move(file(folder), file(to), StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Removes the origin of a deleted project. */
    static void delete(Path folder) throws IOException {
        Files.deleteIfExists(file(folder));
    }
}
