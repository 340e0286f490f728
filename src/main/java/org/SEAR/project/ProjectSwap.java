package org.SEAR.project;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;

/**
 * Puts a whole new project in the place of the present one, so that after a crash at any moment either the old or the new one is there.
 *
 * <p>The new project is made ready beside the old one as {@code SEARproject.loading}, then renamed to {@code SEARproject.next}: from then on it
 * counts as soon as {@code SEARproject} is missing. The old one is renamed to {@code SEARproject.backup-N}, then the new one to {@code SEARproject}.
 * An old backup is renamed before it is deleted, so that
 * none is ever half there. A crash between these two is mended by {@link #recover}, which everything that opens a project calls
 * first. The lock keeps two programs apart.
 */
public final class ProjectSwap implements AutoCloseable {
    private static final String LOADING = ".loading";
    private static final String NEXT = ".next";
    private static final String DELETING = ".deleting";
    /** A file with the digest of the example that was loaded last. */
    private static final String EXAMPLE = ".example";
    /** Whoever replaces a project in this program, writes to it or reads it. Files' locks keep other programs out, not threads. */
    private static final ReentrantLock CHANGING = new ReentrantLock();

    private final Path folder;
    private final FileChannel channel;
    private final FileLock lock;

    private ProjectSwap(Path folder, FileChannel channel, FileLock lock) {
        this.folder = folder;
        this.channel = channel;
        this.lock = lock;
    }

    /** Something that changes files of the present project. */
    public interface Change {
        void make() throws IOException;
    }

    /** Changes files of a project: waits while this program replaces it, and finishes what a crash left halfway. */
    public static void change(Path folder, Change change) throws IOException {
        CHANGING.lock();
        try {
            recover(folder);
            change.make();
        } finally {
            CHANGING.unlock();
        }
    }

    /**
     * Until the same thread calls {@link #letGo}, other threads of this program that replace a project or write to it wait: what is read of it
     * meanwhile belongs together. May be nested.
     */
    public static void hold() {
        CHANGING.lock();
    }

    /** The end of {@link #hold}. */
    public static void letGo() {
        CHANGING.unlock();
    }

    /** A look at a project. */
    public interface Look<T, E extends Exception> {
        T look() throws E;
    }

    /** Looks at a project while it is {@link #hold held}. */
    public static <T, E extends Exception> T undisturbed(Look<T, E> look) throws E {
        hold();
        try {
            return look.look();
        } finally {
            letGo();
        }
    }

    /**
     * Locks a project folder against other loads and cleans up after a crash. Waits for other threads of this program that replace a project or
     * write to it. The same thread closes it.
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
        Files.createDirectories(folder.getParent());
        Path file = folder.resolveSibling("." + folder.getFileName() + ".lock");
        FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        FileLock lock = null;
        try {
            lock = tryLock(channel, wait);
            if (lock == null) {
                throw new IOException("another program is just replacing the project in " + folder + "; try again when it is done");
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

    /** Finishes what a crash left halfway, or waits for who is just doing it. Cheap when there is nothing to do. */
    static void recover(Path folder) throws IOException {
        if (!Files.exists(folder, LinkOption.NOFOLLOW_LINKS) && Files.exists(beside(folder, NEXT), LinkOption.NOFOLLOW_LINKS)) {
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

    /** An empty folder to make the new project ready in. */
    public Path staging() throws IOException {
        return Files.createDirectory(beside(folder, LOADING));
    }

    /**
     * Puts the staged project in the place of the present one.
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
     * Renames the present project to a backup, unless it is an example as it came. A backup of the same files goes, so that ten runs of one script
     * leave the others alone; others go, the oldest first, where they are too many or too large.
     *
     * @param reported hears which others have gone
     * @return the backup; null if there was no project, or only an example that can be had again
     */
    public Path retire(Consumer<String> reported) throws IOException {
        if (!Files.isDirectory(folder)) {
            return null;
        }
        Backups backups = Backups.of(folder);
        Path backup = backups.next();
        boolean again = isUntouchedExample();
        Files.move(folder, backup, StandardCopyOption.ATOMIC_MOVE);
        Files.deleteIfExists(beside(folder, EXAMPLE));
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

    /** The project that is in its place is an example, which can be had again: it needs no backup, unless somebody changes it. */
    public void keepAsExample() throws IOException {
        Files.writeString(beside(folder, EXAMPLE), Backups.digest(folder));
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
        delete(doomed);
    }

    /** Removes a folder with everything in it; what links point to stays. */
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

    /** Removes what is left of a load that failed, and lets go of the lock. */
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
