package org.SEAR.cli.install;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * What a call is about to do to MyRobotLab's folder, on the disk until the call has ended: when it was killed, the next one undoes what was begun, or
 * finishes it when all new files were in their places. Undoing and finishing may be killed, too, and are then done again. Any one thread.
 */
final class InstallJournal {
    /** Where new bytes wait beside their place. */
    static final String STAGED = ".sear-new";
    /** Where old bytes wait until all is done. */
    static final String KEPT = ".sear-old";
    private static final String FILE = ".sear-install-journal.json";
    private static final ObjectMapper MAPPER = new ObjectMapper();

    /** Files that were not there before; paths use '/'. */
    public Set<String> fresh = new TreeSet<>();
    /** Files that were there before, to be changed or deleted. */
    public Set<String> changed = new TreeSet<>();
    /** Folders that were not there before. */
    public Set<String> folders = new TreeSet<>();
    /** Folders to delete in the end, where they are empty then. */
    public Set<String> emptied = new TreeSet<>();
    /** Whether all new files are in their places. */
    public boolean done;

    /**
     * Undoes or finishes what a killed call has begun.
     *
     * @return what was done, null if no call was killed
     */
    static String recover(Path root) throws IOException, InstallException {
        Files.deleteIfExists(root.resolve(FILE + STAGED));
        if (!isPending(root)) {
            return null;
        }
        InstallJournal journal;
        try {
            journal = MAPPER.readValue(Files.readAllBytes(root.resolve(FILE)), InstallJournal.class);
        } catch (JsonProcessingException e) {
            throw new InstallException(root.resolve(FILE) + " can't be read (" + e.getOriginalMessage() + "): it should say what a call that was "
                + "killed had begun. Delete it, and look for files that end in " + STAGED + " or " + KEPT + ".", e);
        }
        if (journal.done) {
            journal.finish(root);
        } else {
            journal.undo(root);
        }
        delete(root);
        return "An earlier call was interrupted. What it had begun was " + (journal.done ? "finished." : "undone.");
    }

    /** Whether an earlier call was killed. */
    static boolean isPending(Path root) {
        return Files.exists(root.resolve(FILE));
    }

    /** Writes it, as a whole or not at all. */
    void write(Path root, Runnable beforeStep) throws IOException {
        beforeStep.run();
        Files.write(root.resolve(FILE + STAGED), MAPPER.writeValueAsBytes(this));
        beforeStep.run();
        Files.move(root.resolve(FILE + STAGED), root.resolve(FILE), StandardCopyOption.ATOMIC_MOVE);
    }

    /** Nothing is left to do. */
    static void delete(Path root) throws IOException {
        Files.deleteIfExists(root.resolve(FILE));
    }

    /** Puts everything back as it was. */
    void undo(Path root) throws IOException {
        for (String path : fresh) {
            deleteFile(root.resolve(path));
            deleteFile(root.resolve(path + STAGED));
        }
        for (String path : changed) {
            deleteFile(root.resolve(path + STAGED));
            if (Files.exists(root.resolve(path + KEPT))) {
                Files.move(root.resolve(path + KEPT), root.resolve(path), StandardCopyOption.ATOMIC_MOVE);
            }
        }
        deleteEmpty(root, folders);
    }

    /**
     * Deletes what was kept.
     *
     * @return what another program holds open, and therefore stays beside the new file, where nothing reads it
     */
    List<Path> finish(Path root) throws IOException {
        List<Path> leftovers = new ArrayList<>();
        for (String path : changed) {
            Path kept = root.resolve(path + KEPT);
            try {
                Files.deleteIfExists(kept);
            } catch (IOException e) {
                leftovers.add(kept);
            }
        }
        deleteEmpty(root, emptied);
        return leftovers;
    }

    private static void deleteFile(Path file) throws IOException {
        if (Files.isRegularFile(file)) {
            Files.delete(file);
        }
    }

    private static void deleteEmpty(Path root, Set<String> folders) throws IOException {
        for (String folder : new TreeSet<>(folders).descendingSet()) {
            Path path = root.resolve(folder);
            if (Files.isDirectory(path) && isEmpty(path)) {
                Files.delete(path);
            }
        }
    }

    private static boolean isEmpty(Path folder) throws IOException {
        try (DirectoryStream<Path> content = Files.newDirectoryStream(folder)) {
            return !content.iterator().hasNext();
        }
    }
}
