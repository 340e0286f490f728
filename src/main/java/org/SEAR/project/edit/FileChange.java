package org.SEAR.project.edit;

import java.util.Arrays;

/** What an edit does to one file of a project. Immutable, any thread. */
final class FileChange {
    /** Below the project's folder, with forward slashes. */
    final String path;
    private final byte[] before;
    private final byte[] after;

    /**
     * @param before what was in the file; null if there was none
     * @param after what is in it then; null if it is deleted
     */
    FileChange(String path, byte[] before, byte[] after) {
        this.path = path;
        this.before = before == null ? null : before.clone();
        this.after = after == null ? null : after.clone();
    }

    /** What was in the file; null if there was none. */
    byte[] before() {
        return before;
    }

    /** What is in the file afterwards; null if it is deleted. */
    byte[] after() {
        return after;
    }

    boolean changesAnything() {
        return !Arrays.equals(before, after);
    }

    /** Bytes that it keeps. */
    int size() {
        return (before == null ? 0 : before.length) + (after == null ? 0 : after.length);
    }
}
