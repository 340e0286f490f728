// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Files to write and to delete below one folder, completely or not at all. A journal on disk has their old contents;
 * deleting it is the last step. While the journal exists, the changes are rolled back: immediately after a failure, or
 * by the next call after the program was killed, even repeatedly. Folders are created and deleted with their files.
 * Paths are relative to the folder, with '/'. Any one thread.
 */
final class InstallPlan {
    /** Suffix of files before they replace the old ones. */
    private static final String STAGED = ".sear-new";
    private static final String JOURNAL = ".sear-install-journal.json";

    /** Planned changes and kept files, a line each. */
    final List<String> notes = new ArrayList<>();
    /** Remarks for the user after the installation, a line each. */
    final List<String> remarks = new ArrayList<>();
    /** Called before each change of the disk; tests end the call there. */
    Runnable beforeStep = () -> { };

    private final Path root;
    /** New contents of files; null deletes a file. */
    private final Map<String, byte[]> files = new TreeMap<>();

    InstallPlan(Path root) {
        this.root = root;
    }

    /** Returns the current content of a file; null if there is none. */
    byte[] now(String path) throws IOException {
        return Files.exists(root.resolve(path)) ? Files.readAllBytes(root.resolve(path)) : null;
    }

    /** Plans new content for a file; null deletes it. */
    void write(String path, byte[] bytes) throws IOException {
        byte[] now = now(path);
        if (!Arrays.equals(now, bytes)) {
            notes.add((now == null ? "add     " : bytes == null ? "delete  " : "change  ") + path);
            files.put(path, bytes);
        }
    }

    boolean isEmpty() {
        return files.isEmpty();
    }

    /** Throws if a file to write, a folder that gets or loses files, or the journal is not writable. */
    void refuseIfNotWritable() throws InstallException {
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            Path path = root.resolve(file.getKey());
            Path folder = path.getParent();
            while (!Files.exists(folder)) {
                folder = folder.getParent();
            }
            for (Path touched : List.of(root, folder, file.getValue() != null && Files.exists(path) ? path : folder)) {
                if (!Files.isWritable(touched)) {
                    throw new InstallException("No permission to write into " + touched
                        + ". Run the command as the user who owns it.");
                }
            }
            if (!Files.isDirectory(folder)) {
                throw new InstallException(folder + " is a file but must be a folder. Rename it and try again.");
            }
        }
    }

    /**
     * Applies the plan.
     *
     * @throws IOException after rolling back; files that could not be restored are among its suppressed exceptions
     */
    void apply() throws IOException {
        Receipt journal = new Receipt();
        for (String path : files.keySet()) {
            journal.originals.put(path, now(path));
        }
        try {
            put(JOURNAL, journal.bytes());
            bring(files);
        } catch (IOException e) {
            try {
                bring(journal.originals);
            } catch (IOException more) {
                e.addSuppressed(more);
            }
            throw e;
        }
    }

    /**
     * Rolls back the changes of a killed call.
     *
     * @return a message; null if no call was killed
     */
    String recover() throws IOException, InstallException {
        boolean killed = Files.exists(root.resolve(JOURNAL));
        bring(Receipt.read(root.resolve(JOURNAL), "It is the journal of a killed call. Repeat the killed sear install, "
            + "or delete this file and look for files that end in " + STAGED + ".").originals);
        return killed ? "An earlier call was interrupted. Its changes were undone." : null;
    }

    /** Writes the files, and deletes the journal last: from then on there is nothing to roll back. */
    private void bring(Map<String, byte[]> contents) throws IOException {
        for (Map.Entry<String, byte[]> file : contents.entrySet()) {
            put(file.getKey(), file.getValue());
        }
        put(JOURNAL, null);
    }

    /** Replaces a file atomically; null deletes it. */
    private void put(String path, byte[] bytes) throws IOException {
        Path file = root.resolve(path);
        Path staged = root.resolve(path + STAGED);
        if (Files.isRegularFile(staged)) {
            Files.delete(staged);
        }
        if (bytes == null) {
            delete(file);
        } else if (!Arrays.equals(now(path), bytes)) {
            beforeStep.run();
            makeFolder(file.getParent());
            giveToOwner(Files.write(staged, bytes));
            beforeStep.run();
            Files.move(staged, file, StandardCopyOption.ATOMIC_MOVE);
        }
    }

    /** Deletes a file, if it exists, and folders that become empty. */
    private void delete(Path file) throws IOException {
        beforeStep.run();
        Files.deleteIfExists(file);
        for (Path folder = file.getParent(); !folder.equals(root) && !Files.isSymbolicLink(folder)
            && MrlFolder.list(folder, "*").isEmpty();
                folder = folder.getParent()) {
            beforeStep.run();
            Files.deleteIfExists(folder);
        }
    }

    private void makeFolder(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            makeFolder(folder.getParent());
            giveToOwner(Files.createDirectory(folder));
        }
    }

    /** Gives files that root writes to the owner of MyRobotLab, who must be able to change them. */
    private void giveToOwner(Path file) throws IOException {
        PosixFileAttributeView view = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        if (view != null && "root".equals(view.getOwner().getName())) {
            PosixFileAttributes owner = Files.readAttributes(root, PosixFileAttributes.class);
            view.setOwner(owner.owner());
            view.setGroup(owner.group());
        }
    }
}
