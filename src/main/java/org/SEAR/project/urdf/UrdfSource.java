// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.urdf;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.files.FileLimits;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.problems.ProjectException;

/** The file of a URDF, unpacked if it lies in a zip file. {@link #close} deletes the unpacked files. One thread. */
final class UrdfSource implements Closeable {
    private static final int SHOWN = 10;

    private final Path file;
    private final Path unpacked;

    private UrdfSource(Path file, Path unpacked) {
        this.file = file;
        this.unpacked = unpacked;
    }

    /**
     * @param path of a URDF, a zip file that contains one, or a URDF in a zip file
     * @throws IOException if there is none
     */
    static UrdfSource of(Path path) throws IOException {
        Path zip = path;
        while (zip != null && !Files.isRegularFile(zip)) {
            zip = zip.getParent();
        }
        if (zip == null) {
            throw new IOException("there is no file " + path.toAbsolutePath());
        }
        if (!isZip(zip)) {
            if (!zip.equals(path)) {
                throw FileLimits.wrong(zip.toString(), "its ending", zip.getFileName(), "a zip file, for " + path);
            }
            return new UrdfSource(path, null);
        }
        Path folder = Files.createTempDirectory("sear-urdf").toRealPath();
        boolean done = false;
        try {
            Bundle.unpackFiles(zip, folder);
            Path inside = zip.equals(path) ? only(zip, folder) : folder.resolve(zip.relativize(path).toString());
            if (!Files.isRegularFile(inside)) {
                throw FileLimits.wrong(zip.toString(), "the file in it", zip.relativize(path), shown(all(folder),
                    folder));
            }
            done = true;
            return new UrdfSource(inside, folder);
        } catch (ProjectException e) {
            throw new IOException(e.getMessage(), e);
        } finally {
            if (!done) {
                ProjectSwap.delete(folder);
            }
        }
    }

    /** Returns whether a file is a zip file by its ending. */
    static boolean isZip(Path file) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(".zip");
    }

    private static List<Path> all(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(each -> each.toString().toLowerCase(Locale.ROOT).endsWith(".urdf")).sorted()
                .collect(Collectors.toList());
        }
    }

    private static Path only(Path zip, Path folder) throws IOException {
        List<Path> all = all(folder);
        if (all.size() != 1) {
            throw FileLimits.wrong(zip.toString(), "the number of its URDFs", all.size(), all.isEmpty()
                ? "a zip file with a .urdf" : "one of them, by " + zip.resolve("PATH") + ": " + shown(all, folder));
        }
        return all.get(0);
    }

    private static String shown(List<Path> all, Path folder) {
        return all.stream().limit(SHOWN).map(each -> folder.relativize(each).toString().replace('\\', '/'))
            .collect(Collectors.joining(", ")) + (all.size() > SHOWN ? " ..." : "");
    }

    Path getFile() {
        return file;
    }

    /** Returns the file's name for messages. */
    String getName() {
        return file.getFileName().toString();
    }

    /** Returns the folder that contains everything that may be read; null if it is no zip file. */
    Path getWithin() {
        return unpacked;
    }

    @Override
    public void close() throws IOException {
        if (unpacked != null) {
            ProjectSwap.delete(unpacked);
        }
    }
}
