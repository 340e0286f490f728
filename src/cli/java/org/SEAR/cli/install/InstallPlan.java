package org.SEAR.cli.install;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFileAttributes;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Files to write and to delete below one folder, done as a whole or not at all. What they held before is on the disk, in a journal, until all is
 * done: when anything fails it is put back, and when the program is killed the next call does that, or finishes when all files were in their places.
 * Putting back and finishing may be killed, too, and are then done again. Paths are relative to the folder, with '/'. Any one thread.
 */
final class InstallPlan {
    /** Where new bytes wait beside their place. */
    private static final String STAGED = ".sear-new";
    private static final String JOURNAL = ".sear-install-journal.json";
    private static final ObjectMapper MAPPER = new ObjectMapper();

    /** What will be done, or is left alone, a line each. */
    final List<String> notes = new ArrayList<>();
    /** What the user is left with when all is done, a line each. */
    final List<String> remarks = new ArrayList<>();
    /** Called before each change of the disk, so that a test can end the call there. */
    Runnable beforeStep = () -> { };

    private final Path root;
    /** What each file is to hold; null: it is to go. */
    private final Map<String, byte[]> files = new TreeMap<>();
    private final Journal journal = new Journal();

    InstallPlan(Path root) {
        this.root = root;
    }

    /** What a call is about to do, for the call after it, should it be killed. */
    private static final class Journal {
        /** What the files held; null: they were not there. */
        public Map<String, byte[]> before = new TreeMap<>();
        /** Folders that were not there before. */
        public Set<String> folders = new TreeSet<>();
        /** Folders to delete in the end, where they are empty then. */
        public Set<String> emptied = new TreeSet<>();
        /** Whether all files are in their places. */
        public boolean done;
    }

    /** What a file holds now, null where there is none. */
    byte[] now(String path) throws IOException {
        return Files.exists(root.resolve(path)) ? Files.readAllBytes(root.resolve(path)) : null;
    }

    /**
     * Lets a file have these bytes.
     *
     * @param bytes null to delete it
     */
    void write(String path, byte[] bytes) throws IOException {
        byte[] now = now(path);
        if (!Arrays.equals(now, bytes)) {
            notes.add((now == null ? "add     " : bytes == null ? "delete  " : "change  ") + path);
            files.put(path, bytes);
            journal.before.put(path, now);
        }
    }

    /** Deletes folders in the end, where they are empty then. */
    void deleteEmptied(Collection<String> folders) {
        journal.emptied.addAll(folders);
    }

    boolean isEmpty() {
        return files.isEmpty();
    }

    /** Folders that have to be made for the files. */
    Set<String> newFolders() {
        Set<String> folders = new TreeSet<>();
        for (String path : files.keySet()) {
            for (Path folder = Path.of(path).getParent(); folder != null && !Files.exists(root.resolve(folder)); folder = folder.getParent()) {
                folders.add(folder.toString().replace('\\', '/'));
            }
        }
        return folders;
    }

    /** Refuses when something that has to be written can't be: a file, or a folder that gets or loses files. */
    void refuseIfNotWritable() throws InstallException {
        Set<Path> touched = new TreeSet<>();
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            touched.add(root); // for the journal
            Path path = root.resolve(file.getKey());
            if (file.getValue() != null && Files.exists(path)) {
                touched.add(path);
            }
            do {
                path = path.getParent();
            } while (!Files.exists(path));
            touched.add(path);
        }
        for (Path path : touched) {
            if (!Files.isWritable(path)) {
                throw new InstallException("No permission to write into " + path + ". Run the command as the user who owns it.");
            }
            if (!Files.isDirectory(path) && !files.containsKey(root.relativize(path).toString().replace('\\', '/'))) {
                throw new InstallException(path + " is a file, and has to be a folder. Rename it and call again.");
            }
        }
    }

    /**
     * Does it.
     *
     * @throws IOException after everything was put back as it was; what could not be put back is among its suppressed exceptions
     */
    void apply() throws IOException {
        journal.folders = newFolders();
        write();
        try {
            for (String folder : journal.folders) {
                beforeStep.run();
                giveToOwner(Files.createDirectory(root.resolve(folder)));
            }
            for (Map.Entry<String, byte[]> file : files.entrySet()) {
                put(file.getKey(), file.getValue());
            }
        } catch (IOException e) {
            try {
                undo(journal);
            } catch (IOException more) {
                e.addSuppressed(more);
            }
            throw e;
        }
        journal.done = true;
        journal.before.clear();
        write();
        finish(journal);
    }

    /** Writes the journal, as a whole or not at all. */
    private void write() throws IOException {
        put(JOURNAL, MAPPER.writeValueAsBytes(journal));
    }

    /**
     * Undoes or finishes what a call that was killed has begun.
     *
     * @return what was done, null if no call was killed
     */
    String recover() throws IOException, InstallException {
        Files.deleteIfExists(root.resolve(JOURNAL + STAGED));
        if (!isPending()) {
            return null;
        }
        Journal begun;
        try {
            begun = MAPPER.readValue(now(JOURNAL), Journal.class);
        } catch (JsonProcessingException e) {
            throw new InstallException(root.resolve(JOURNAL) + " can't be read (" + e.getOriginalMessage() + "): it should say what a call that was "
                + "killed had begun. Call the sear install that was killed once more, or delete this file and look for files that end in " + STAGED
                + ".", e);
        }
        if (begun.done) {
            finish(begun);
        } else {
            undo(begun);
        }
        return "An earlier call was interrupted. What it had begun was " + (begun.done ? "finished." : "undone.");
    }

    /** Whether an earlier call was killed. */
    boolean isPending() {
        return Files.exists(root.resolve(JOURNAL));
    }

    private void undo(Journal begun) throws IOException {
        for (Map.Entry<String, byte[]> file : begun.before.entrySet()) {
            deleteFile(file.getKey() + STAGED);
            if (!Arrays.equals(now(file.getKey()), file.getValue())) {
                put(file.getKey(), file.getValue());
            }
        }
        begun.emptied = begun.folders;
        finish(begun);
    }

    private void finish(Journal begun) throws IOException {
        beforeStep.run();
        for (String folder : new TreeSet<>(begun.emptied).descendingSet()) {
            if (Files.isDirectory(root.resolve(folder)) && MrlFolder.list(root.resolve(folder), "*").isEmpty()) {
                Files.delete(root.resolve(folder));
            }
        }
        beforeStep.run();
        Files.deleteIfExists(root.resolve(JOURNAL));
    }

    /** Lets a file have these bytes, as a whole or not at all; null: deletes it. */
    private void put(String path, byte[] bytes) throws IOException {
        beforeStep.run();
        if (bytes == null) {
            deleteFile(path);
            return;
        }
        giveToOwner(Files.write(root.resolve(path + STAGED), bytes));
        beforeStep.run();
        Files.move(root.resolve(path + STAGED), root.resolve(path), StandardCopyOption.ATOMIC_MOVE);
    }

    private void deleteFile(String path) throws IOException {
        if (Files.isRegularFile(root.resolve(path))) {
            Files.delete(root.resolve(path));
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
