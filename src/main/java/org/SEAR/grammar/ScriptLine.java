package org.SEAR.grammar;

import java.lang.reflect.Method;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * The line of a Python script that is being carried out. Jython's classes have wrong line numbers, its frames the right ones; they are asked by
 * reflection, since SEAR works without Jython, too. Any thread.
 */
public final class ScriptLine {
    /** What Jython names the classes that it makes of scripts. */
    private static final String SCRIPT = "org.python.pycode.";
    private static final String PY4J = "py4j.";
    private static final String JYTHON = "org.python.core.";
    /** Code that Python brings along, and the line by which MyRobotLab calls a function of the script. */
    private static final Predicate<String> OTHERS = file -> file.contains("__pyclasspath__") || file.contains("/Lib/") || file.equals("<callback>");

    /** Set where a Python 3 program has Java in its process. */
    private static final boolean IN_PYTHON = Boolean.getBoolean("sear.inPython");

    private ScriptLine() {
    }

    /** Whether the calling thread carries out a script, of Python 2 or 3, which is told by what is thrown. */
    public static boolean isCalling() {
        List<String> classes = StackWalker.getInstance()
            .walk(frames -> frames.map(StackWalker.StackFrame::getClassName).collect(Collectors.toList()));
        return classes.stream().anyMatch(name -> name.startsWith(SCRIPT) || name.startsWith(PY4J))
            || IN_PYTHON && !classes.get(classes.size() - 1).equals(Thread.class.getName());
    }

    /**
     * That of the calling thread.
     *
     * @return {@code line 7 of first.py}; empty if no script calls
     */
    public static String here() {
        boolean inScript = StackWalker.getInstance().walk(frames -> frames.anyMatch(frame -> frame.getClassName().startsWith(SCRIPT)));
        if (!inScript) {
            return "";
        }
        try {
            Object state = Class.forName(JYTHON + "Py").getMethod("getThreadState").invoke(null);
            return of(state.getClass().getField("frame").get(state));
        } catch (ReflectiveOperationException | LinkageError e) {
            return ""; // another Jython than any so far
        }
    }

    /** The same of another thread; empty if it carries out no script. */
    public static String of(Thread thread) {
        try {
            Method frames = Class.forName(JYTHON + "ThreadStateMapping").getMethod("_current_frames");
            frames.setAccessible(true);
            return of(((Map<?, ?>) frames.invoke(null)).get(thread.getId()));
        } catch (ReflectiveOperationException | RuntimeException | LinkageError e) {
            return ""; // another Jython than any so far
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

    /** What is said, and behind it the line in brackets, unless there is none or the text names one. */
    public static String added(String text, String line) {
        return line.isEmpty() || text.matches("(?s).*\\bline \\d+ of .*") ? text : text + " (" + line + ")";
    }
}
