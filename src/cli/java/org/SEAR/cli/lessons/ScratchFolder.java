// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.concurrent.TimeUnit;
import org.SEAR.project.problems.FileReasons;

/** A temporary folder in which a hostile script may have run. One thread. */
final class ScratchFolder {
    /** Longest time for deleting a folder, s. */
    private static final int DELETE_SECONDS = 60;

    private final Path path;
    private final long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DELETE_SECONDS);
    private int moved;

    private ScratchFolder(Path path) {
        this.path = path;
    }

    /**
     * Deletes a folder with its content. Folders of any depth are possible, because subfolders move to the top before
     * their parent is deleted: no path becomes too long.
     *
     * @return why something is left; null if nothing is
     */
    static String delete(Path folder) {
        try {
            ScratchFolder scratch = new ScratchFolder(folder);
            while (scratch.isFlattened()) {
                continue;
            }
            Files.deleteIfExists(folder);
            return null;
        } catch (IOException | DirectoryIteratorException e) {
            return FileReasons.of(e instanceof DirectoryIteratorException ? ((DirectoryIteratorException) e).getCause()
                : e);
        }
    }

    /** Empties the folders at the top; returns whether there were any. */
    private boolean isFlattened() throws IOException {
        if (!isFolder(path)) {
            return false;
        }
        allow(path);
        boolean found = false;
        try (DirectoryStream<Path> entries = Files.newDirectoryStream(path)) {
            for (Path entry : entries) {
                found |= isFolder(entry);
                remove(entry);
            }
        }
        return found;
    }

    private void remove(Path entry) throws IOException {
        checkTime();
        if (isFolder(entry)) {
            allow(entry);
            try (DirectoryStream<Path> inner = Files.newDirectoryStream(entry)) {
                for (Path one : inner) {
                    lift(one);
                }
            }
        }
        Files.deleteIfExists(entry);
    }

    private void lift(Path inner) throws IOException {
        checkTime();
        if (isFolder(inner)) {
            allow(inner);
            Files.move(inner, free());
        } else {
            Files.deleteIfExists(inner);
        }
    }

    private void checkTime() throws IOException {
        if (System.nanoTime() > deadline) {
            throw new IOException("it could not be emptied in " + DELETE_SECONDS + " s");
        }
    }

    /** Returns a path at the top that does not exist. */
    private Path free() {
        Path to = path.resolve("moved-" + moved++);
        return Files.exists(to, LinkOption.NOFOLLOW_LINKS) ? free() : to;
    }

    private static boolean isFolder(Path entry) {
        return Files.isDirectory(entry, LinkOption.NOFOLLOW_LINKS);
    }

    /** Gives the owner all rights to a folder. */
    private static void allow(Path folder) throws IOException {
        PosixFileAttributeView view = Files.getFileAttributeView(folder, PosixFileAttributeView.class,
            LinkOption.NOFOLLOW_LINKS);
        if (view != null && !(Files.isReadable(folder) && Files.isWritable(folder) && Files.isExecutable(folder))) {
            Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwx------"));
        }
    }
}
