package org.SEAR.project.edit;

import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/** What an edit, an undo or a redo has come to. Immutable, any thread. */
public final class Outcome {
    /** What was done, as {@code "move crate"}; empty if everything was so already. */
    public final String words;
    /** What edits call the object from then on; null if it is gone, or for undo and redo. */
    public final String object;
    /** What else there is to say; null for nothing. */
    public final String note;
    /** Paths of the files that changed. */
    public final Set<String> files;
    /** Names of the things of the environment and robots that stand elsewhere; of robots' Dynamics, the components as robots' files name them. */
    public final Set<String> moved;
    /** Whether anything else has changed than where things and robots stand. */
    public final boolean more;
    /** What undo would take back; null for nothing. */
    public final String undo;
    /** What redo would do again; null for nothing. */
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
