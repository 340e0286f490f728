package org.SEAR.project.bundle;

/** Hears how far saving or loading a bundle is. Called on the caller's thread, at least once a file and every few megabytes of a large one. */
@FunctionalInterface
public interface Progress {
    /** Tells nobody. */
    Progress NONE = (file, done, total) -> { };

    /**
     * @param file path inside the project
     * @param done bytes so far
     * @param total bytes of the whole project
     */
    void at(String file, long done, long total);

    /** Something that happened on the way and that the user should know, in words. */
    default void said(String line) {
        // who asks for the progress only need not know
    }
}
