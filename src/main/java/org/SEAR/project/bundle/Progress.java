// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

/**
 * Listener for the progress of saving or loading a bundle. Called on the caller's thread, at least once per file and
 * every few megabytes of a large file.
 */
@FunctionalInterface
public interface Progress {
    /** Ignores the progress. */
    Progress NONE = (file, done, total) -> { };

    /**
     * @param file path inside the project
     * @param done bytes so far
     * @param total bytes of the whole project
     */
    void at(String file, long done, long total);

    /** Receives a message for the user. */
    default void said(String line) {
        // ignored by listeners that only want the progress
    }
}
