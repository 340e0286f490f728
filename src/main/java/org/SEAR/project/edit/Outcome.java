// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/** Result of an edit, an undo or a redo. Immutable, any thread. */
public final class Outcome {
    /** Description, such as {@code "move crate"}; empty if nothing changed. */
    public final String words;
    /** Address of the edited object; null if it was deleted, and for undo and redo. */
    public final String object;
    /** Note for the user; null for none. */
    public final String note;
    /** Paths of the changed files. */
    public final Set<String> files;
    /**
     * Names of the environment objects and robots with a changed pose; for the Dynamics of robots, the component's name
     * in the robot's file.
     */
    public final Set<String> moved;
    /** Whether anything other than poses has changed. */
    public final boolean more;
    /** Description of the step that undo reverts; null for none. */
    public final String undo;
    /** Description of the step that redo repeats; null for none. */
    public final String redo;

    Outcome(String words, String object, String note, List<FileChange> changes, EditJournal journal) {
        this.words = words;
        this.object = object;
        this.note = note;
        TreeSet<String> paths = new TreeSet<>();
        changes.forEach(change -> paths.add(change.path));
        this.files = Collections.unmodifiableSet(paths);
        PoseChanges poses = PoseChanges.of(changes);
        this.moved = poses.moved;
        this.more = poses.more;
        this.undo = journal.undoable() == null ? null : journal.undoable().words;
        this.redo = journal.redoable() == null ? null : journal.redoable().words;
    }
}
