// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.SEAR.files.AtomicFile;

/**
 * Undo and redo steps of a project, each in a file of the folder {@code .edits}, and the number of steps done. The
 * journal records a step before its files change, so that a crash loses only that step. Guarded by the project lock.
 */
final class EditJournal {
    /** Largest number of steps; older ones can't be undone. */
    static final int MAX_STEPS = 500;
    /** Largest size of all steps together, bytes. */
    static final long MAX_BYTES = 16L << 20;
    private static final String FOLDER = ".edits";
    private static final String STATE = "state";
    private static final Pattern STEP = Pattern.compile("([1-9][0-9]{0,8})\\.step");
    private static final Pattern STATE_TEXT = Pattern.compile("done ([0-9]{1,9})(?: doing ([0-9]{1,9}))?\n");

    private final ObjectFiles files;
    private final Path folder;
    /** Steps by number. */
    private final TreeMap<Integer, UndoStep> steps = new TreeMap<>();
    /** Number of the last step done. */
    private int done;

    private EditJournal(ObjectFiles files) {
        this.files = files;
        this.folder = files.file(FOLDER);
    }

    /**
     * Reads the journal of a project and reverts a step that a crash interrupted.
     *
     * @throws IOException if it can't be read
     */
    static EditJournal open(ObjectFiles files) throws IOException {
        EditJournal journal = new EditJournal(files);
        if (Files.isDirectory(journal.folder)) {
            journal.read();
        }
        return journal;
    }

    private void read() throws IOException {
        try (DirectoryStream<Path> all = Files.newDirectoryStream(folder)) {
            for (Path file : all) {
                Matcher name = STEP.matcher(file.getFileName().toString());
                if (name.matches() && Files.size(file) <= MAX_BYTES) {
                    steps.put(Integer.parseInt(name.group(1)), UndoStep.of(Files.readAllBytes(file)));
                }
            }
        } catch (IOException e) {
            throw new IOException("the undo steps in " + folder + " can't be read (" + e.getMessage()
                + "): delete that folder to continue without them", e);
        }
        Path state = folder.resolve(STATE);
        Matcher text = STATE_TEXT.matcher(
            Files.exists(state) ? new String(Files.readAllBytes(state), StandardCharsets.UTF_8) : "");
        if (text.matches()) {
            done = Integer.parseInt(text.group(1));
            if (text.group(2) != null) {
                revert(Integer.parseInt(text.group(2)));
            }
        }
    }

    /** Reverts the changes of an interrupted step. */
    private void revert(int number) throws IOException {
        UndoStep step = steps.get(number);
        boolean undoing = number == done;
        for (FileChange change : step == null ? List.<FileChange>of() : step.changes) {
            byte[] from = undoing ? change.before() : change.after();
            if (Arrays.equals(files.read(change.path), from)) {
                files.write(change.path, undoing ? change.after() : change.before());
            }
        }
        writeState(0);
    }

    private void writeState(int doing) throws IOException {
        String text = "done " + done + (doing > 0 ? " doing " + doing : "") + "\n";
        AtomicFile.write(folder.resolve(STATE), text.getBytes(StandardCharsets.UTF_8));
    }

    /** Returns the step that undo reverts; null for none. */
    UndoStep undoable() {
        return steps.get(done);
    }

    /** Returns the step that redo repeats; null for none. */
    UndoStep redoable() {
        return steps.get(done + 1);
    }

    /**
     * Does a step: writes its files and removes the redo steps.
     *
     * @throws IOException if a file can't be written; nothing has changed then
     */
    void add(UndoStep step) throws IOException {
        write(step);
        apply(step, done + 1, true);
        forgetOldest();
    }

    /** Adds a step that was done outside of the journal. */
    void note(UndoStep step) throws IOException {
        write(step);
        done++;
        writeState(0);
        forgetOldest();
    }

    private void write(UndoStep step) throws IOException {
        Files.createDirectories(folder);
        while (!steps.isEmpty() && steps.lastKey() > done) {
            Files.deleteIfExists(file(steps.lastKey()));
            steps.pollLastEntry();
        }
        AtomicFile.write(file(done + 1), step.toBytes());
        steps.put(done + 1, step);
    }

    private Path file(int number) {
        return folder.resolve(number + ".step");
    }

    /** Reverts the last step. */
    void undo() throws IOException {
        apply(steps.get(done), done, false);
    }

    /** Repeats the next step. */
    void redo() throws IOException {
        apply(steps.get(done + 1), done + 1, true);
    }

    private void apply(UndoStep step, int number, boolean forwards) throws IOException {
        writeState(number);
        List<FileChange> written = new ArrayList<>();
        boolean whole = false;
        try {
            for (FileChange change : step.changes) {
                written.add(change);
                files.write(change.path, forwards ? change.after() : change.before());
            }
            done = forwards ? number : number - 1;
            writeState(0);
            whole = true;
        } finally {
            if (!whole) {
                done = forwards ? number - 1 : number;
                for (FileChange change : written) {
                    files.write(change.path, forwards ? change.before() : change.after());
                }
                writeState(0);
            }
        }
    }

    private void forgetOldest() throws IOException {
        long bytes = steps.values().stream().mapToLong(UndoStep::size).sum();
        while (steps.size() > 1 && (steps.size() > MAX_STEPS || bytes > MAX_BYTES)) {
            bytes -= steps.firstEntry().getValue().size();
            Files.deleteIfExists(file(steps.pollFirstEntry().getKey()));
        }
    }

    /** Returns the changes that scripts and other programs have made to the files of the steps; empty for none. */
    List<FileChange> changedOutside() throws IOException {
        Map<String, byte[]> expected = new LinkedHashMap<>();
        for (Map.Entry<Integer, UndoStep> step : steps.entrySet()) {
            for (FileChange change : step.getValue().changes) {
                if (step.getKey() <= done) {
                    expected.put(change.path, change.after());
                } else if (!expected.containsKey(change.path)) {
                    expected.put(change.path, change.before());
                }
            }
        }
        List<FileChange> changes = new ArrayList<>();
        for (Map.Entry<String, byte[]> one : expected.entrySet()) {
            FileChange change = new FileChange(one.getKey(), one.getValue(), files.read(one.getKey()));
            if (change.changesAnything()) {
                changes.add(change);
            }
        }
        return changes;
    }
}
