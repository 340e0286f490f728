// SPDX-License-Identifier: Apache-2.0
package org.SEAR.grammar;

import java.lang.reflect.Method;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * Current line of a Python script. Jython's class files have wrong line numbers, but its frames have the right ones.
 * They are read by reflection, because SEAR also runs without Jython. Any thread.
 */
public final class ScriptLine {
    /** Prefix of the classes that Jython compiles scripts to. */
    private static final String SCRIPT = "org.python.pycode.";
    private static final String PY4J = "py4j.";
    private static final String JYTHON = "org.python.core.";
    /** Python's own library code, and the line by which MyRobotLab calls a function of the script. */
    private static final Predicate<String> OTHERS = file -> file.contains("__pyclasspath__") || file.contains("/Lib/")
        || file.equals("<callback>");

    /** Set if Java runs inside a Python 3 process. */
    private static final boolean IN_PYTHON = Boolean.getBoolean("sear.inPython");

    private ScriptLine() {
    }

    /** Returns whether the calling thread runs a script of Python 2 or 3, which receives exceptions itself. */
    public static boolean isCalling() {
        List<String> classes = StackWalker.getInstance()
            .walk(frames -> frames.map(StackWalker.StackFrame::getClassName).collect(Collectors.toList()));
        return classes.stream().anyMatch(name -> name.startsWith(SCRIPT) || name.startsWith(PY4J))
            || IN_PYTHON && !classes.get(classes.size() - 1).equals(Thread.class.getName());
    }

    /**
     * Returns the script line of the calling thread.
     *
     * @return {@code line 7 of first.py}; empty if no script calls
     */
    public static String here() {
        if (run().isEmpty()) {
            return "";
        }
        try {
            Object state = Class.forName(JYTHON + "Py").getMethod("getThreadState").invoke(null);
            return of(state.getClass().getField("frame").get(state));
        } catch (ReflectiveOperationException | LinkageError e) {
            return ""; // an unknown version of Jython
        }
    }

    /** Returns the run of a Jython script that calls, by the class that Jython compiled for it; empty if none calls. */
    public static String run() {
        return StackWalker.getInstance().walk(frames -> frames.map(StackWalker.StackFrame::getClassName)
            .filter(type -> type.startsWith(SCRIPT)).reduce("", (inner, outer) -> outer));
    }

    /**
     * Returns the working folder of the Jython script that calls, if its {@code os.chdir} has changed it.
     *
     * @return null if it is Java's working folder, or if no Jython script calls
     */
    static Path folder() {
        if (run().isEmpty()) {
            return null;
        }
        try {
            Object state = Class.forName(JYTHON + "Py").getMethod("getSystemState").invoke(null);
            Path folder = Path.of((String) state.getClass().getMethod("getCurrentWorkingDir").invoke(state));
            return folder.equals(Path.of("").toAbsolutePath()) ? null : folder;
        } catch (ReflectiveOperationException | LinkageError e) {
            return null; // an unknown version of Jython
        }
    }

    /** Returns the script line of another thread; empty if that thread runs no script. */
    public static String of(Thread thread) {
        try {
            Method frames = Class.forName(JYTHON + "ThreadStateMapping").getMethod("_current_frames");
            frames.setAccessible(true);
            return of(((Map<?, ?>) frames.invoke(null)).get(thread.getId()));
        } catch (ReflectiveOperationException | RuntimeException | LinkageError e) {
            return ""; // an unknown version of Jython
        }
    }

    private static String of(Object innermost) throws ReflectiveOperationException {
        for (Object frame = innermost; frame != null; frame = frame.getClass().getField("f_back").get(frame)) {
            Object code = frame.getClass().getField("f_code").get(frame);
            Object file = code == null ? null : code.getClass().getField("co_filename").get(code);
            int line = frame.getClass().getField("f_lineno").getInt(frame);
            if (file != null && line > 0 && !OTHERS.test(file.toString())) {
                return "line " + line + " of " + file;
            }
        }
        return "";
    }

    /** Appends a script line in brackets, unless it is empty or the text already names a line. */
    public static String added(String text, String line) {
        return line.isEmpty() || text.matches("(?s).*\\bline \\d+ of .*") ? text : text + " (" + line + ")";
    }
}
