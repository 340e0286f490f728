// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.python.core.Py;
import org.python.core.PyException;
import org.python.core.PyFile;
import org.python.core.PyInteger;
import org.python.core.PyObject;

/** Result of a script. */
public final class ScriptResult {
    /** The script ran to its end. */
    static final ScriptResult GOOD = new ScriptResult(0, null, false);
    /** The script was cancelled. */
    static final ScriptResult STOPPED = new ScriptResult(1, null, true);

    /** A Java exception's class, which Jython prints twice. */
    private static final Pattern TWICE = Pattern.compile("^([\\w.$]+): \\1: ");

    private static final int ASCII_END = 128;
    private static final int BYTE_END = 255;

    private final int exitCode;
    private final String traceback;
    private final boolean stopped;

    private ScriptResult(int exitCode, String traceback, boolean stopped) {
        this.exitCode = exitCode;
        this.traceback = traceback;
        this.stopped = stopped;
    }

    /** Result of a script that reports its errors itself. */
    static ScriptResult exited(int status) {
        return new ScriptResult(status, null, false);
    }

    static ScriptResult failed(String traceback) {
        return new ScriptResult(1, traceback, false);
    }

    /** @param calledBack the function that was called back; null if none was */
    static ScriptResult of(PyException e, PyObject calledBack) {
        if (e.match(Py.SystemExit)) {
            return exit(e);
        }
        e.normalize();
        String syntax = ScriptHints.syntax(e);
        if (syntax != null) {
            return failed(syntax);
        }
        String message = letters(e.value.__str__().toString().trim());
        String headline = message.contains("\n") ? message.substring(0, message.indexOf('\n')) + "\n" : "";
        return failed(headline + traceback(e) + ScriptHints.of(e, message, calledBack));
    }

    /** Ends as Python does: sys.exit(n) with n, sys.exit() with 0, sys.exit(text) with 1 and the text. */
    private static ScriptResult exit(PyException e) {
        e.normalize();
        PyObject code = e.value.__findattr__("code");
        if (code == null || code == Py.None) {
            return GOOD;
        }
        return code instanceof PyInteger ? new ScriptResult(code.asInt(), null, false) : failed(code.toString());
    }

    /** Returns the traceback as Python prints it, without the Java frames. */
    private static String traceback(PyException e) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PyFile file = new PyFile(bytes);
        e.normalize();
        Py.displayException(e.type, e.value, e.traceback, file);
        file.flush();
        String message = e.value.__str__().toString();
        String shown = bytes.toString(StandardCharsets.UTF_8);
        if (e.traceback != null) {
            shown = spelt(shown, e.traceback.dumpStack());
        }
        shown = spelt(shown, message);
        if (e.value.__tojava__(Throwable.class) instanceof Throwable) {
            String foreign = ScriptHints.ofModule(message);
            if (message.contains("\n") || foreign != null) {
                return shown.lines().takeWhile(line -> line.startsWith("Traceback") || line.startsWith("  "))
                    .collect(Collectors.joining("\n")) + "\n" + (foreign == null ? message : foreign);
            }
        }
        return shown.lines().filter(line -> !line.startsWith("\tat ") && !line.startsWith("\t... "))
            .distinct().map(line -> TWICE.matcher(line).replaceFirst("$1: ")).collect(Collectors.joining("\n"));
    }

    /** Restores the last occurrence of a text in which Jython has printed a question mark for each non-ASCII letter. */
    private static String spelt(String shown, String text) {
        StringBuilder marks = new StringBuilder();
        text.chars().forEach(c -> marks.append(c < ASCII_END ? (char) c : '?'));
        int at = shown.lastIndexOf(marks.toString());
        String whole = Stream.of(text.split("\n", -1)).map(ScriptResult::letters).collect(Collectors.joining("\n"));
        return at < 0 ? shown : shown.substring(0, at) + whole + shown.substring(at + text.length());
    }

    /** Decodes UTF-8 from a plain Python 2 string, which Jython holds as one character per byte. */
    private static String letters(String text) {
        String spelt = new String(text.getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
        return text.chars().anyMatch(c -> c > BYTE_END) || spelt.indexOf('\ufffd') >= 0 ? text : spelt;
    }

    /** Returns the exit status; 0 on success. */
    public int getExitCode() {
        return exitCode;
    }

    /** Returns the traceback; null without an error. */
    public String getTraceback() {
        return traceback;
    }

    /** Returns whether the script was cancelled. */
    public boolean isStopped() {
        return stopped;
    }
}
