// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.nio.file.Path;

/**
 * The folder to which the relative paths of a Python program refer, for each of its threads. Java's own working folder
 * does not follow the program's {@code os.chdir}, and a connected program has another one. Python 3 sets it; Jython is
 * asked. Public because Python calls it. Any thread.
 */
public final class ScriptFolder {
    private static final ThreadLocal<Path> PRESENT = new ThreadLocal<>();

    private ScriptFolder() {
    }

    /** @param folder working folder of the program that calls on this thread, absolute; null for Java's own */
    public static void set(String folder) {
        PRESENT.set(folder == null ? null : Path.of(folder));
    }

    private static Path present() {
        Path folder = PRESENT.get();
        return folder == null ? ScriptLine.folder() : folder;
    }

    /**
     * Returns an absolute path for a relative one of a Python 3 program, or of a Jython script after {@code os.chdir};
     * any other path unchanged.
     */
    public static Path resolve(Path path) {
        Path folder = path.isAbsolute() ? null : present();
        return folder == null ? path : folder.resolve(path);
    }

    /** Returns the path as the program wrote it, if it is in the program's folder; any other path unchanged. */
    public static Path shorten(Path path) {
        Path folder = present();
        return folder != null && path.startsWith(folder) ? folder.relativize(path) : path;
    }
}
