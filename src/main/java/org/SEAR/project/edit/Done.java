package org.SEAR.project.edit;

/** What an edit has done. Immutable, any thread. */
final class Done {
    /** As in "undo: move crate". */
    final String words;
    /** What edits call its object from then on; null if that is gone. */
    final String object;

    Done(String words, String object) {
        this.words = words;
        this.object = object;
    }
}
