// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.python.core.CompileMode;
import org.python.core.CompilerFlags;
import org.python.core.Py;
import org.python.core.PyException;
import org.python.core.PyObject;
import org.python.core.PyStringMap;
import org.python.core.PyTraceback;

/**
 * Threads that scripts create with {@code threading}. They count as running: they are cancelled with the script, and
 * their errors are reported as the script's. Python calls the public members. Any thread.
 */
public final class ScriptThreads {
    /** Patches this interpreter's Thread class: each thread is known from its start call on and runs its work here. */
    private static final String HOOK = "import threading\ndef known(start):\n    def begin(thread):\n"
        + "        threads.starts()\n        try:\n            start(thread)\n        except:\n"
        + "            threads.failedToStart()\n            raise\n    return begin\ndef hooked(bootstrap):\n"
        + "    def begin(thread):\n        work = thread.run\n"
        + "        thread.run = lambda: threads.run(work, thread.getName(), thread.isDaemon())\n"
        + "        bootstrap(thread)\n    return begin\n"
        + "threading.Thread._Thread__bootstrap = hooked(threading.Thread._Thread__bootstrap)\n"
        + "threading.Thread.start = known(threading.Thread.start)\n";
    private static final Pattern OWN = Pattern.compile("  File \".*(/Lib/|__pyclasspath__|\\$py\\.class).*");
    private static final Pattern JAVA = Pattern.compile("^java\\.[\\w.]+: ");

    private final PythonEngine engine;
    private boolean hooked;

    ScriptThreads(PythonEngine engine) {
        this.engine = engine;
    }

    /** Patches Thread before code that may create threads. */
    synchronized void hook(String code) {
        if (!hooked && code.contains("threading")) {
            hooked = true;
            PyStringMap names = new PyStringMap();
            names.__setitem__("threads", Py.java2py(this));
            Py.exec(Py.compile_flags(HOOK, "<callback>", CompileMode.exec, new CompilerFlags()), names, names);
        }
    }

    /** Announces a thread that is about to run. */
    public void starts() {
        engine.threadStarts(1);
    }

    /** Withdraws a thread that could not be started. */
    public void failedToStart() {
        engine.threadStarts(-1);
    }

    /** Runs a thread's work on that thread. */
    public void run(PyObject work, String name, boolean daemon) {
        engine.runThread(work, name, daemon);
    }

    /** Returns the message for a thread that has ended with an error; null if it has none. */
    static String failed(PyException e, String name) {
        String traceback = ScriptResult.of(e, null).getTraceback();
        if (traceback == null) {
            return null;
        }
        String[] lines = traceback.split("\n");
        StringBuilder reported = new StringBuilder("thread " + name + " ended with an error:");
        for (int i = 0; i < lines.length; i++) {
            if (OWN.matcher(lines[i]).matches()) {
                i += i + 1 < lines.length && lines[i + 1].startsWith("    ") ? 1 : 0;
            } else {
                reported.append('\n').append(JAVA.matcher(lines[i]).replaceFirst(""));
            }
        }
        return reported.toString().lines().distinct().collect(Collectors.joining("\n"));
    }

    /** Returns the message for a thread that outlived the script. */
    static String outlived(PyException e, String name) {
        return "thread " + name + " was still running when the script ended, and was stopped" + place(e)
            + ": to wait for it, end the script with thread.join()";
    }

    /** Returns the script's innermost line of the error; empty if there is none. */
    private static String place(PyException e) {
        String place = "";
        for (PyTraceback at = e.traceback; at != null; at = at.tb_next instanceof PyTraceback
            ? (PyTraceback) at.tb_next : null) {
            String file = at.tb_frame.f_code == null ? "" : at.tb_frame.f_code.co_filename;
            place = OWN.matcher("  File \"" + file).matches() || file.isEmpty() ? place : " at line " + at.tb_lineno
                + " of " + file;
        }
        return place;
    }
}
