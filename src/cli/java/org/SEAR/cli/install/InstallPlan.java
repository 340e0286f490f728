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
 * Files to write and to delete below one folder, done as a whole or not at all. A journal on the disk has what they held before; deleting it is the
 * last step. While it is there, whatever was begun is put back: at once when something fails, by the next call when the program was killed, and once
 * more when that is killed, too. Folders come and go with what is in them. Paths are relative to the folder, with '/'. Any one thread.
 */
final class InstallPlan {
    /** Where new bytes wait beside their place. */
    private static final String STAGED = ".sear-new";
    private static final String JOURNAL = ".sear-install-journal.json";

    /** What will be done, or is left alone, a line each. */
    final List<String> notes = new ArrayList<>();
    /** What the user is left with when all is done, a line each. */
    final List<String> remarks = new ArrayList<>();
    /** Called before each change of the disk, so that a test can end the call there. */
    Runnable beforeStep = () -> { };

    private final Path root;
    /** What each file is to hold; null: it is to go. */
    private final Map<String, byte[]> files = new TreeMap<>();

    InstallPlan(Path root) {
        this.root = root;
    }

    /** What a file holds now, null where there is none. */
    byte[] now(String path) throws IOException {
        return Files.exists(root.resolve(path)) ? Files.readAllBytes(root.resolve(path)) : null;
    }

    /** Lets a file have these bytes; null: deletes it. */
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

    /** Refuses when something that has to be written can't be: a file, or a folder that gets or loses files, or the journal. */
    void refuseIfNotWritable() throws InstallException {
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            Path path = root.resolve(file.getKey());
            Path folder = path.getParent();
            while (!Files.exists(folder)) {
                folder = folder.getParent();
            }
            for (Path touched : List.of(root, folder, file.getValue() != null && Files.exists(path) ? path : folder)) {
                if (!Files.isWritable(touched)) {
                    throw new InstallException("No permission to write into " + touched + ". Run the command as the user who owns it.");
                }
            }
            if (!Files.isDirectory(folder)) {
                throw new InstallException(folder + " is a file, and has to be a folder. Rename it and call again.");
            }
        }
    }

    /**
     * Does it.
     *
     * @throws IOException after everything was put back as it was; what could not be put back is among its suppressed exceptions
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
     * Undoes what a call that was killed has begun.
     *
     * @return what was done, null if no call was killed
     */
    String recover() throws IOException, InstallException {
        boolean killed = Files.exists(root.resolve(JOURNAL));
        bring(Receipt.read(root.resolve(JOURNAL), "It should say what a call that was killed had begun. Call the sear install that was killed once "
            + "more, or delete this file and look for files that end in " + STAGED + ".").originals);
        return killed ? "An earlier call was interrupted. What it had begun was undone." : null;
    }

    /** Lets files have these bytes, and deletes the journal last: there is no more to put back. */
    private void bring(Map<String, byte[]> contents) throws IOException {
        for (Map.Entry<String, byte[]> file : contents.entrySet()) {
            put(file.getKey(), file.getValue());
        }
        put(JOURNAL, null);
    }

    /** Lets a file have these bytes, as a whole or not at all; null: deletes it. */
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

    /** Deletes a file, where there is one, and the folders that are empty without it. */
    private void delete(Path file) throws IOException {
        beforeStep.run();
        Files.deleteIfExists(file);
        for (Path folder = file.getParent(); !folder.equals(root) && !Files.isSymbolicLink(folder) && MrlFolder.list(folder, "*").isEmpty();
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

    /** What root writes belongs to the owner of the MyRobotLab, who has to be able to change it. */
    private void giveToOwner(Path file) throws IOException {
        PosixFileAttributeView view = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        if (view != null && "root".equals(view.getOwner().getName())) {
            PosixFileAttributes owner = Files.readAttributes(root, PosixFileAttributes.class);
            view.setOwner(owner.owner());
            view.setGroup(owner.group());
        }
    }
}
