// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.nio.file.Path;

/**
 * The folder to which the relative paths of a Python 3 program refer, for each of its threads. Java's own working folder
 * does not follow the program's {@code os.chdir}, and a connected program has another one. Public because Python calls
 * it. Any thread.
 */
public final class ScriptFolder {
    private static final ThreadLocal<Path> PRESENT = new ThreadLocal<>();

    private ScriptFolder() {
    }

    /** @param folder working folder of the program that calls on this thread, absolute; null for Java's own */
    public static void set(String folder) {
        PRESENT.set(folder == null ? null : Path.of(folder));
    }

    /** Returns an absolute path for a relative one of a Python 3 program; any other path unchanged. */
    public static Path resolve(Path path) {
        Path folder = PRESENT.get();
        return folder == null ? path : folder.resolve(path);
    }

    /** Returns the path as the program wrote it, if it is in the program's folder; any other path unchanged. */
    public static Path shorten(Path path) {
        Path folder = PRESENT.get();
        return folder != null && path.startsWith(folder) ? folder.relativize(path) : path;
    }
}
