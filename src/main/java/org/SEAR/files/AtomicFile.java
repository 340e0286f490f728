// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Writes files beside their place and then moves them there. So a file is the old one or the whole new one, also on a
 * full disk. A new file keeps the permissions of the old one; a symbolic link is replaced. A pipe or device is written
 * directly. Every writer of files that outlive a call uses this class. Any thread.
 */
public final class AtomicFile {
    /** Keeps the temporary files of several programs apart. */
    private static final long PROCESS = ProcessHandle.current().pid();
    private static final AtomicLong NUMBER = new AtomicLong();

    private AtomicFile() {
    }

    /**
     * Writes the content of a file.
     *
     * @param <E> type of further errors
     */
    public interface Content<E extends Exception> {
        /** @param place an empty file, or a pipe or device */
        void writeTo(Path place) throws IOException, E;
    }

    /**
     * Writes a file.
     *
     * @throws IOException if it can't be written; an earlier file is unchanged then, and no other file is left
     */
    public static void write(Path file, byte[] bytes) throws IOException {
        AtomicFile.<RuntimeException>write(file, place -> Files.write(place, bytes));
    }

    /**
     * Writes a file.
     *
     * @throws IOException if it can't be written; an earlier file is unchanged then, and no other file is left
     * @throws E as the content throws; likewise
     */
    public static <E extends Exception> void write(Path file, Content<E> content) throws IOException, E {
        boolean exists = Files.exists(file);
        if (exists && !Files.isRegularFile(file)) {
            content.writeTo(file);
            return;
        }
        if (exists && !file.toFile().canWrite()) {
            throw new AccessDeniedException(file.toString());
        }
        Path temporary = create(file);
        try {
            content.writeTo(temporary);
            if (exists) {
                keepPermissions(file, temporary);
            }
            Files.move(temporary, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } catch (FileSystemException e) {
            throw temporary.toString().equals(e.getFile()) ? named(file, e) : e;
        } finally {
            Files.deleteIfExists(temporary);
        }
    }

    /** Creates an empty hidden file in the same folder. */
    private static Path create(Path file) throws IOException {
        while (true) {
            Path temporary = file.resolveSibling(".sear-" + PROCESS + "-" + NUMBER.incrementAndGet() + ".tmp");
            try {
                return Files.createFile(temporary);
            } catch (FileAlreadyExistsException e) {
                continue; // left by a program of the same number that was killed
            } catch (FileSystemException e) {
                throw named(file, e);
            }
        }
    }

    /** Returns the error with the file's own name. */
    private static FileSystemException named(Path file, FileSystemException e) {
        FileSystemException named = e instanceof NoSuchFileException ? new NoSuchFileException(file.toString())
            : e instanceof AccessDeniedException ? new AccessDeniedException(file.toString())
            : new FileSystemException(file.toString(), null, e.getReason());
        named.initCause(e);
        return named;
    }

    private static void keepPermissions(Path file, Path temporary) throws IOException {
        PosixFileAttributeView posix = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        if (posix != null) {
            Files.setPosixFilePermissions(temporary, posix.readAttributes().permissions());
        }
    }
}
