// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.concurrent.TimeUnit;
import org.SEAR.project.problems.FileReasons;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A temporary folder in which a hostile script may run. Its deletion, also at the end of this program, never fails a
 * result: what is left is only reported. Any thread.
 */
public final class ScratchFolder implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ScratchFolder.class);
    /** Longest time for deleting a folder, s. */
    private static final int DELETE_SECONDS = 60;

    private final Path path;
    private ExitHook exit;
    private volatile long deadline;
    private int moved;

    private ScratchFolder(Path path) {
        this.path = path;
    }

    /** Makes a folder, which {@link #close} or the end of this program deletes. */
    public static ScratchFolder create(String prefix) throws IOException {
        ScratchFolder made = new ScratchFolder(Files.createTempDirectory(prefix));
        made.exit = new ExitHook(made::delete);
        return made;
    }

    public Path path() {
        return path;
    }

    @Override
    public void close() {
        delete();
        exit.cancel();
    }

    private synchronized void delete() {
        String left = delete(path);
        if (left != null) {
            LOG.warn("the temporary folder {} could not be deleted: {}", path, left);
        }
    }

    /**
     * Deletes a folder with its content. Folders of any depth are possible, because subfolders move to the top before
     * their parent is deleted: no path becomes too long.
     *
     * @return why something is left; null if nothing is
     */
    static String delete(Path folder) {
        try {
            new ScratchFolder(folder).empty();
            return null;
        } catch (IOException | DirectoryIteratorException e) {
            return FileReasons.of(e instanceof DirectoryIteratorException ? ((DirectoryIteratorException) e).getCause()
                : e);
        }
    }

    private void empty() throws IOException {
        deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DELETE_SECONDS);
        while (Files.exists(path, LinkOption.NOFOLLOW_LINKS)) {
            checkTime();
            try {
                while (isFlattened()) {
                    continue;
                }
                Files.deleteIfExists(path);
            } catch (DirectoryNotEmptyException | NoSuchFileException e) {
                LOG.debug("{} is still in use", path, e);
            }
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
