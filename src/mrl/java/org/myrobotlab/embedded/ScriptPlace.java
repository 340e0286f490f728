package org.myrobotlab.embedded;

import org.python.core.Py;
import org.python.core.PyFrame;

/** The line of a script that is being carried out. Any thread. */
public final class ScriptPlace {
    private static final String SCRIPT = "org.python.pycode.";

    private ScriptPlace() {
    }

    /** Code that Python brings along, and the line by which a function of the script is called. */
    private static boolean isOfOthers(String file) {
        return file.equals("<callback>") || file.contains("__pyclasspath__") || file.contains("/Lib/");
    }

    /** {@code " (line 7 of first.py)"}, where the calling thread carries out a script; else empty. */
    public static String here() {
        if (StackWalker.getInstance().walk(frames -> frames.noneMatch(frame -> frame.getClassName().startsWith(SCRIPT)))) {
            return "";
        }
        PyFrame frame = Py.getThreadState().frame;
        while (frame != null && (frame.f_code == null || frame.f_lineno < 1 || isOfOthers(frame.f_code.co_filename))) {
            frame = frame.f_back;
        }
        return frame == null ? "" : " (line " + frame.f_lineno + " of " + frame.f_code.co_filename + ")";
    }
}
