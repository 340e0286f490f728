// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.util.Arrays;

/** Change of one file of a project. Immutable, any thread. */
final class FileChange {
    /** Path below the project's folder, with forward slashes. */
    final String path;
    private final byte[] before;
    private final byte[] after;

    /**
     * @param before content before the change; null if the file did not exist
     * @param after content after the change; null if the file is deleted
     */
    FileChange(String path, byte[] before, byte[] after) {
        this.path = path;
        this.before = before == null ? null : before.clone();
        this.after = after == null ? null : after.clone();
    }

    /** Returns the content before the change; null if the file did not exist. */
    byte[] before() {
        return before;
    }

    /** Returns the content after the change; null if the file is deleted. */
    byte[] after() {
        return after;
    }

    boolean changesAnything() {
        return !Arrays.equals(before, after);
    }

    /** Returns the bytes in memory. */
    int size() {
        return (before == null ? 0 : before.length) + (after == null ? 0 : after.length);
    }
}
