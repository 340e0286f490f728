// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.SEAR.files.AtomicFile;
import org.SEAR.files.FolderOwner;

/**
 * Replaces a project so that a crash at any moment leaves either the old or the new one.
 *
 * <p>The new project is prepared beside the old one as {@code SEARproject.loading}, then renamed to
 * {@code SEARproject.next}: from then on it is valid if {@code SEARproject} is missing. The old project is renamed to
 * {@code SEARproject.backup-N}, then the new one to {@code SEARproject}. An old backup is renamed before it is deleted,
 * so no backup is ever incomplete. After a crash between the two renames, {@link #recover} finishes the swap;
 * everything that opens a project calls it first. The lock excludes other programs.
 */
public final class ProjectSwap implements AutoCloseable {
    private static final String LOADING = ".loading";
    private static final String NEXT = ".next";
    private static final String DELETING = ".deleting";
    /** File with the digest of the example that was loaded last. */
    private static final String EXAMPLE = ".example";
    /**
     * Excludes other threads of this program while one replaces, writes or reads a project; file locks only exclude
     * other programs.
     */
    private static final ReentrantLock CHANGING = new ReentrantLock();

    private final Path folder;
    private final FileChannel channel;
    private final FileLock lock;

    private ProjectSwap(Path folder, FileChannel channel, FileLock lock) {
        this.folder = folder;
        this.channel = channel;
        this.lock = lock;
    }

    /** A change of files of the current project. */
    public interface Change {
        void make() throws IOException;
    }

    /**
     * Makes this process the owner of the present project, on which no other process may work: they would replace each
     * other's objects. Every change of the project and every start of its simulation claims it. Does nothing for
     * another folder.
     *
     * @throws IOException if another process owns the project; names that process
     */
    public static void claim(Path folder) throws IOException {
        if (folder.toAbsolutePath().normalize().equals(ProjectFolder.present())) {
            FolderOwner.claim(folder);
        }
    }

    /**
     * Changes files of a project. Waits while this program replaces it, and first finishes a swap that a crash
     * interrupted.
     */
    public static void change(Path folder, Change change) throws IOException {
        CHANGING.lock();
        try {
            claim(folder);
            recover(folder);
            change.make();
        } finally {
            CHANGING.unlock();
        }
    }

    /**
     * Blocks other threads of this program that replace a project or write to it, until the same thread calls
     * {@link #letGo}: data read meanwhile is consistent. May be nested.
     */
    public static void hold() {
        CHANGING.lock();
    }

    /** Ends {@link #hold}. */
    public static void letGo() {
        CHANGING.unlock();
    }

    /** A read access to a project. */
    public interface Look<T, E extends Exception> {
        T look() throws E;
    }

    /** Reads a project while it is {@link #hold held}. */
    public static <T, E extends Exception> T undisturbed(Look<T, E> look) throws E {
        hold();
        try {
            return look.look();
        } finally {
            letGo();
        }
    }

    /**
     * Locks a project folder against other loads and cleans up after a crash. Waits for other threads of this program
     * that replace a project or write to it. The same thread has to close the lock.
     *
     * @throws IOException if another program has the lock
     */
    public static ProjectSwap lock(Path folder) throws IOException {
        return lock(folder, false);
    }

    private static ProjectSwap lock(Path folder, boolean wait) throws IOException {
        CHANGING.lock();
        ProjectSwap swap = null;
        try {
            swap = lockFile(folder, wait);
            return swap;
        } finally {
            if (swap == null) {
                CHANGING.unlock();
            }
        }
    }

    private static ProjectSwap lockFile(Path folder, boolean wait) throws IOException {
        if (!wait) {
            claim(folder);
        }
        Files.createDirectories(folder.getParent());
        Path file = folder.resolveSibling("." + folder.getFileName() + ".lock");
        FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        FileLock lock = null;
        try {
            lock = tryLock(channel, wait);
            if (lock == null) {
                throw new IOException("another program is just replacing the project in " + folder
                    + "; try again when it is done");
            }
            ProjectSwap swap = new ProjectSwap(folder, channel, lock);
            swap.finishOrCleanUp();
            return swap;
        } finally {
            if (lock == null) {
                channel.close();
            }
        }
    }

    private static FileLock tryLock(FileChannel channel, boolean wait) throws IOException {
        try {
            return wait ? channel.lock() : channel.tryLock();
        } catch (OverlappingFileLockException e) {
            throw new IOException("this program is just replacing the project; try again when it is done", e);
        }
    }

    /**
     * Finishes a swap that a crash interrupted, or waits for another program that is swapping. Cheap if there is
     * nothing to do.
     */
    static void recover(Path folder) throws IOException {
        if (!Files.exists(folder, LinkOption.NOFOLLOW_LINKS)
            && Files.exists(beside(folder, NEXT), LinkOption.NOFOLLOW_LINKS)) {
            lock(folder, true).close();
        }
    }

    private static Path beside(Path folder, String ending) {
        return folder.resolveSibling(folder.getFileName() + ending);
    }

    private void finishOrCleanUp() throws IOException {
        Path next = beside(folder, NEXT);
        if (Files.exists(next, LinkOption.NOFOLLOW_LINKS)) {
            if (Files.exists(folder, LinkOption.NOFOLLOW_LINKS)) {
                delete(next);
            } else {
                Files.move(next, folder, StandardCopyOption.ATOMIC_MOVE);
            }
        }
        delete(beside(folder, LOADING));
        delete(beside(folder, DELETING));
    }

    /** Creates an empty folder for the new project. */
    public Path staging() throws IOException {
        return Files.createDirectory(beside(folder, LOADING));
    }

    /**
     * Replaces the current project by the staged one.
     *
     * @param reported as for {@link #retire}
     */
    public void putInPlace(Consumer<String> reported) throws IOException {
        Path next = beside(folder, NEXT);
        Files.move(beside(folder, LOADING), next, StandardCopyOption.ATOMIC_MOVE);
        retire(reported);
        Files.move(next, folder, StandardCopyOption.ATOMIC_MOVE);
    }

    /**
     * Renames the current project to a backup, unless it is an unchanged example. An older backup with the same files
     * is removed, so repeated runs of a script do not push out other backups. Backups beyond the limits are removed,
     * the oldest first.
     *
     * @param reported receives messages about removed backups
     * @return the backup; null if there was no project, or only an unchanged example
     */
    public Path retire(Consumer<String> reported) throws IOException {
        if (!Files.isDirectory(folder)) {
            return null;
        }
        Backups backups = Backups.of(folder);
        Path backup = backups.next();
        boolean again = isUntouchedExample();
        Files.move(folder, backup, StandardCopyOption.ATOMIC_MOVE);
        ProjectOrigin.move(folder, backup);
        Files.deleteIfExists(beside(folder, EXAMPLE));
        Files.setLastModifiedTime(backup, FileTime.from(Instant.now()));
        if (again) {
            discard(backup);
            return null;
        }
        for (Path same : backups.same(backup)) {
            discard(same);
        }
        for (Path surplus : Backups.of(folder).surplus()) {
            discard(surplus);
            reported.accept("the backup " + surplus + " was removed: " + Backups.LIMITS);
        }
        return backup;
    }

    /** Returns the backups of a project, the newest first; a folder's modification time is that of the backup. */
    public static List<Path> backups(Path folder) throws IOException {
        return undisturbed(() -> Files.isDirectory(folder.getParent()) ? Backups.of(folder).newestFirst() : List.of());
    }

    /** Marks the current project as an example, which needs no backup unless the user changes it. */
    public void keepAsExample() throws IOException {
        AtomicFile.write(beside(folder, EXAMPLE), Backups.digest(folder).getBytes(StandardCharsets.UTF_8));
    }

    private boolean isUntouchedExample() throws IOException {
        Path example = beside(folder, EXAMPLE);
        return Files.isRegularFile(example) && Files.size(example) > 0
            && Files.readString(example).equals(Backups.digest(folder));
    }

    private void discard(Path backup) throws IOException {
        Path doomed = beside(folder, DELETING);
        delete(doomed);
        Files.move(backup, doomed, StandardCopyOption.ATOMIC_MOVE);
        ProjectOrigin.delete(backup);
        delete(doomed);
    }

    /** Removes a folder with its content; targets of links stay. */
    public static void delete(Path root) throws IOException {
        if (!Files.exists(root, LinkOption.NOFOLLOW_LINKS)) {
            return;
        }
        Files.walkFileTree(root, new SimpleFileVisitor<Path>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
                Files.delete(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path directory, IOException failure) throws IOException {
                if (failure != null) {
                    throw failure;
                }
                Files.delete(directory);
                return FileVisitResult.CONTINUE;
            }
        });
    }

    /** Removes the remains of a failed load, and releases the lock. */
    @Override
    public void close() throws IOException {
        try {
            delete(beside(folder, LOADING));
        } finally {
            try {
                lock.release();
                channel.close();
            } finally {
                CHANGING.unlock();
            }
        }
    }
}
