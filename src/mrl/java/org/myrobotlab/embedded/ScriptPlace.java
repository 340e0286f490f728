// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import org.python.core.Py;
import org.python.core.PyFrame;

/** The script line that the calling thread executes. Any thread. */
public final class ScriptPlace {
    private static final String SCRIPT = "org.python.pycode.";

    private ScriptPlace() {
    }

    /** Returns whether the file is part of Python's library, or the call of a callback. */
    private static boolean isOfOthers(String file) {
        return file.equals("<callback>") || file.contains("__pyclasspath__") || file.contains("/Lib/");
    }

    /** Returns {@code " (line 7 of first.py)"} while the calling thread executes a script; else empty. */
    public static String here() {
        if (StackWalker.getInstance().walk(
            frames -> frames.noneMatch(frame -> frame.getClassName().startsWith(SCRIPT)))) {
            return "";
        }
        PyFrame frame = Py.getThreadState().frame;
        while (frame != null && (frame.f_code == null || frame.f_lineno < 1 || isOfOthers(frame.f_code.co_filename))) {
            frame = frame.f_back;
        }
        return frame == null ? "" : " (line " + frame.f_lineno + " of " + frame.f_code.co_filename + ")";
    }
}
