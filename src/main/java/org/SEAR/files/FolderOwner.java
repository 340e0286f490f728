// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.logging.Level;
import java.util.logging.Logger;

/**
 * The process that owns a project folder, until it ends or claims another folder. The file {@code .SEARproject.owner}
 * beside the folder contains the owner's process id. The owner locks the file by the system, which unlocks it at the
 * end of the process in any case. A file without a lock is stale, and the next process takes it over. Any thread.
 */
public final class FolderOwner {
    private static final Logger LOG = Logger.getLogger(FolderOwner.class.getName());
    /** Position of the locked byte, far behind the process id, which Windows would otherwise not let others read. */
    private static final long LOCKED = 1 << 20;
    private static final Set<StandardOpenOption> MODE =
        EnumSet.of(StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
    private static Path owned;
    private static FileChannel channel;

    private FolderOwner() {
    }

    /**
     * Makes this process the owner of a folder. Releases another folder that it owns. Does nothing where the system has
     * no locks or the folder is read-only.
     *
     * @throws IOException if another process owns the folder; names that process
     */
    public static void claim(Path folder) throws IOException {
        Path project = folder.toAbsolutePath().normalize();
        synchronized (FolderOwner.class) {
            if (!project.equals(owned)) {
                release();
                lock(project);
            }
        }
    }

    private static void release() throws IOException {
        if (channel != null) {
            channel.close();
            channel = null;
        }
        owned = null;
    }

    private static void lock(Path project) throws IOException {
        Path file = project.resolveSibling("." + project.getFileName() + ".owner");
        FileLock lock = null;
        FileChannel opened = null;
        try {
            Files.createDirectories(project.getParent());
            opened = FileChannel.open(file, MODE);
            lock = opened.tryLock(LOCKED, 1, false);
        } catch (IOException | OverlappingFileLockException e) {
            LOG.log(Level.FINE, e, () -> "no other process is kept out of " + project);
            close(opened);
            return;
        }
        if (lock == null) {
            String owner = read(opened);
            opened.close();
            throw new IOException("the project " + project + " is in use by " + owner
                + ": end that program, or start this one in another folder (in Python 3 sear.start(project=FOLDER), by"
                + " Java's option -Dsear.project=FOLDER)");
        }
        channel = opened;
        owned = project;
        write(ProcessHandle.current().pid() + "\n");
    }

    private static void write(String owner) {
        try {
            channel.truncate(0).write(ByteBuffer.wrap(owner.getBytes(StandardCharsets.US_ASCII)), 0);
        } catch (IOException e) {
            LOG.log(Level.FINE, "the lock contains no process id", e);
        }
    }

    private static void close(FileChannel opened) throws IOException {
        if (opened != null) {
            opened.close();
        }
    }

    /** Returns a description of the owner: its process id, and its program if the system tells. */
    private static String read(FileChannel opened) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate(Long.BYTES * 3);
        opened.read(bytes, 0);
        String text = new String(bytes.array(), 0, bytes.position(), StandardCharsets.US_ASCII).trim();
        if (!text.matches("[0-9]{1,18}")) {
            return "another process";
        }
        return "process " + text + ProcessHandle.of(Long.parseLong(text)).map(ProcessHandle::info)
            .flatMap(FolderOwner::program).map(program -> " (" + program + ")").orElse("");
    }

    /** Returns the script or project that a program runs, else the program. */
    private static Optional<String> program(ProcessHandle.Info info) {
        return info.arguments().flatMap(all -> Arrays.stream(all).filter(one -> one.matches(".*\\.(py|sear|ipynb)"))
            .findFirst()).or(info::command);
    }
}
