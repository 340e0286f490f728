// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;

/**
 * Editor of one project, for pages and scripts. An edit is a map: {@code do} names the edit, whose class
 * describes the other entries, such as {@link AddEdit}. The editor checks the resulting files and writes all of them or
 * none. Each edit is a step that {@link #undo} reverts. Changes of the same files by scripts or other programs become
 * steps of their own, so nothing is lost.
 *
 * <pre>
 * {"do": "add", "type": "Box", "set": {"x": 1, "mass": 2}}     {"do": "robot", "template": "create2"}
 * {"do": "set", "object": "box1", "set": {"x": 2}, "was": {"x": "1"}}
 * {"do": "rename", "object": "box1", "name": "crate"}          {"do": "duplicate", "object": "crate", "set": {"z": 1}}
 * {"do": "mount", "object": "crate", "to": "rover"}            {"do": "unmount", "object": "rover/crate"}
 * {"do": "delete", "object": "rover/ping"}                     {"do": "all", "edits": [..]} several as one step
 * </pre>
 *
 * <p>Any thread; edits of one project wait for each other, and for scripts that write objects.
 */
public final class ProjectEditor {
    private static final Map<String, Supplier<Edit>> EDITS = new LinkedHashMap<>();

    static {
        EDITS.put("add", AddEdit::new);
        EDITS.put("robot", RobotEdit::new);
        EDITS.put("set", SetEdit::new);
        EDITS.put("rename", RenameEdit::new);
        EDITS.put("delete", DeleteEdit::new);
        EDITS.put("duplicate", DuplicateEdit::new);
        EDITS.put("mount", MountEdit::new);
        EDITS.put("unmount", UnmountEdit::new);
        EDITS.put("all", GroupEdit::new);
    }

    private final Path folder;

    /** @param folder the SEARproject folder; the first edit creates it */
    public ProjectEditor(Path folder) {
        this.folder = folder.toAbsolutePath().normalize();
    }

    private interface Work<T> {
        T run(ObjectFiles files) throws IOException, ProjectException;
    }

    /** Runs work while the project is locked. */
    private <T> T locked(Work<T> work) throws IOException, ProjectException {
        List<T> result = new ArrayList<>();
        List<ProjectException> refused = new ArrayList<>();
        ProjectSwap.change(folder, () -> {
            try {
                result.add(work.run(new ObjectFiles(folder)));
            } catch (ProjectException e) {
                refused.add(e);
            }
        });
        if (!refused.isEmpty()) {
            throw refused.get(0);
        }
        return result.get(0);
    }

    /**
     * Does an edit.
     *
     * @throws ProjectException with all its problems; nothing has changed then
     * @throws IOException if a file can't be read or written; nothing has changed then
     */
    public Outcome apply(Map<?, ?> edit) throws IOException, ProjectException {
        return locked(files -> {
            EditJournal journal = EditJournal.open(files);
            EditDraft draft = new EditDraft(files);
            EditResult done = perform(draft, new EditRequest(edit));
            List<FileChange> changes = draft.changes();
            if (changes.isEmpty()) {
                return new Outcome("", done.object, null, changes, journal);
            }
            check(draft);
            noteOutside(journal);
            journal.add(new UndoStep(done.words, changes));
            return new Outcome(done.words, done.object, done.note(), changes, journal);
        });
    }

    static EditResult perform(EditDraft draft, EditRequest request) throws IOException, ProjectException {
        String kind = request.text("do");
        if (!EDITS.containsKey(kind)) {
            throw EditRequest.refused("do", kind, String.join(", ", EDITS.keySet()));
        }
        Edit edit = EDITS.get(kind).get();
        edit.request = request;
        edit.draft = draft;
        edit.finder = new Finder(draft);
        return edit.apply();
    }

    /** Throws the problems of the draft that the project does not already have. */
    private void check(EditDraft draft) throws ProjectException {
        List<Problem> after = problems(draft.overlay());
        if (!after.isEmpty()) {
            List<String> known = problems(Map.of()).stream().map(ProjectEditor::withoutLine)
                .collect(Collectors.toList());
            List<Problem> fresh = after.stream().filter(problem -> !known.contains(withoutLine(problem)))
                .collect(Collectors.toList());
            if (!fresh.isEmpty()) {
                throw new ProjectException(fresh);
            }
        }
    }

    private List<Problem> problems(Map<Path, byte[]> overlay) {
        try {
            Project.read(folder, overlay);
            return List.of();
        } catch (ProjectException e) {
            return e.getProblems();
        }
    }

    private static String withoutLine(Problem problem) {
        return String.join("\n", problem.file, problem.field, problem.value, problem.legal);
    }

    /** Records outside changes as a step, and returns it; null if there are none. */
    private static UndoStep noteOutside(EditJournal journal) throws IOException {
        List<FileChange> outside = journal.changedOutside();
        if (outside.isEmpty()) {
            return null;
        }
        String names = outside.stream().limit(3).map(change -> change.path).collect(Collectors.joining(", "));
        UndoStep step = new UndoStep("changes by a script or another program in " + names
            + (outside.size() > 3 ? " ..." : ""), outside);
        journal.note(step);
        return step;
    }

    /**
     * Reverts the last step. Outside changes of the steps' files since then are a step of their own, the last one.
     *
     * @throws IllegalStateException if there is none
     */
    public Outcome undo() throws IOException, ProjectException {
        return locked(files -> {
            EditJournal journal = EditJournal.open(files);
            UndoStep outside = noteOutside(journal);
            UndoStep step = journal.undoable();
            if (step == null) {
                throw new IllegalStateException("there is nothing to undo: SEAR keeps the last " + EditJournal.MAX_STEPS
                    + " edits of a project until another one is opened");
            }
            journal.undo();
            return new Outcome(step.words, null, outside == null ? null : "only " + outside.words
                + " was undone, since it came last; undo again reverts the edit before, redo restores the changes",
                step.changes, journal);
        });
    }

    /**
     * Repeats the step that undo reverted last.
     *
     * @throws IllegalStateException if there is none
     */
    public Outcome redo() throws IOException, ProjectException {
        return locked(files -> {
            EditJournal journal = EditJournal.open(files);
            UndoStep outside = noteOutside(journal);
            UndoStep step = journal.redoable();
            if (step == null) {
                throw new IllegalStateException(outside == null ? "there is nothing to redo"
                    : "there is nothing to redo: " + outside.words + " came after the undo");
            }
            journal.redo();
            return new Outcome(step.words, null, null, step.changes, journal);
        });
    }

    /** Returns what undo and redo would do; changes nothing. */
    public Outcome state() throws IOException, ProjectException {
        return locked(files -> new Outcome("", null, null, List.of(), EditJournal.open(files)));
    }

    /**
     * Returns an object as pages show it.
     *
     * <pre>
     * {"object": "rover/ping" (its address), "name": "ping", "type": "Distance", "robot": "rover" or null, "file":
     * "robot/ping.xml",
     *  "values": {"name": "ping", "x": "0.1", .., "cone": [{"halfAngle": "15", ..}]}} texts as in the file
     * </pre>
     *
     * @throws ProjectException if there is none of that name, or its file can't be read
     */
    public Map<String, Object> object(String name) throws IOException, ProjectException {
        return locked(files -> {
            ObjectLocation place = new Finder(new EditDraft(files)).find(name);
            Map<String, Object> map = new LinkedHashMap<>();
            map.put("object", place.address());
            map.put("name", place.object.getName());
            map.put("type", place.object.getClass().getSimpleName());
            map.put("robot", place.robot == null ? null : place.robot.getName());
            map.put("file", place.path);
            map.put("values", EditValues.of(place.object));
            return map;
        });
    }
}
