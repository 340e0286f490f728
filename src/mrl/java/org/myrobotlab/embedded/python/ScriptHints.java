// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.StreamSupport;
import org.python.core.Py;
import org.python.core.PyException;
import org.python.core.PyInteger;
import org.python.core.PyObject;
import org.python.core.PyString;
import org.python.core.PyUnicode;
import org.python.core.imp;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Hints for errors of scripts from the Python package {@code sear_hints}, which the interpreter loads at the first
 * error. The thread that has failed.
 */
final class ScriptHints {
    private static final Logger LOG = LoggerFactory.getLogger(ScriptHints.class);
    /** Text of scripts that may have a mistake which Python accepts silently; the package looks closer. */
    private static final Pattern SUSPICIOUS =
        Pattern.compile("\\d\\s*/\\s*\\d|=\\s*-?\\d+,\\d|radians|\\bpi\\b|simSleep\\(\\s*\\d{4}"
        + "|LIDAR\\([^,\\n]*,\\s*\\d{2}|getDistanceResult\\([^)\\n]*\\)\\s*[<>=]=?\\s*\\d{2}|"
            + "(?m)^\\s*\\w+(\\.\\w+)+\\s*(#.*)?$");

    /** Errors that the package explains. */
    private static final List<PyObject> KINDS = List.of(Py.TypeError, Py.NameError, Py.AttributeError, Py.ImportError,
        Py.ValueError, Py.IndexError);

    private ScriptHints() {
    }

    /** Returns an answer of the package; the default if that fails, because a hint must not hide the error. */
    private static PyObject ask(String question, PyObject otherwise, PyObject... about) {
        try {
            return imp.importName("sear_hints.jython", false).invoke(question, about);
        } catch (RuntimeException e) { // Python's errors, and Jython's own
            LOG.debug("no hint", e);
            return otherwise;
        }
    }

    private static String text(String question, PyObject... about) {
        return ask(question, Py.EmptyString, about).toString();
    }

    private static PyObject source(String file) {
        return new PyUnicode(SourceText.of(file));
    }

    /**
     * Returns lines to append to the traceback, each with a line break before it; empty without a hint.
     *
     * @param calledBack the function that was called back; null if none was
     */
    static String of(PyException e, String message, PyObject calledBack) {
        if (KINDS.stream().noneMatch(e::match)) {
            return "";
        }
        PyObject traceback = e.traceback == null ? Py.None : e.traceback;
        String hint = text("failed", e.type, new PyUnicode(message), traceback, calledBack == null ? Py.None
            : calledBack, Py.java2py(new SourceText()));
        return hint.isEmpty() ? "" : "\n" + hint;
    }

    /** Returns the message for a script's syntax error; null for another error, or if the source is unknown. */
    static String syntax(PyException e) {
        PyObject file = e.match(Py.SyntaxError) && e.traceback == null ? e.value.__findattr__("filename") : null;
        boolean isKnown = file != null && e.value.__findattr__("lineno") instanceof PyInteger
            && !SourceText.of(file.toString()).isEmpty();
        String text = isKnown ? text("invalid", e.value, source(file.toString())) : "";
        return text.isEmpty() ? null : text;
    }

    /**
     * Returns the message for the first foreign character of a script that Jython can't represent; null without one.
     */
    static String foreign(String file) {
        String text = text("foreign", new PyUnicode(file), source(file));
        return text.isEmpty() ? null : text;
    }

    /** Returns the message for a module's error that Jython can't represent, from Java's message; null for others. */
    static String ofModule(String message) {
        String text = message.contains("Cannot create PyString") ? text("in_module", new PyUnicode(message)) : "";
        return text.isEmpty() ? null : text;
    }

    /** Returns "; did you mean onScan?" for a missing function of the script; empty without a similar one. */
    static String function(String wanted, PyObject variables) {
        return text("function", new PyString(wanted), variables);
    }

    /** Returns mistakes that Python accepts silently, each with its line. */
    static List<String> silent(byte[] source, String file) {
        String code = new String(source, StandardCharsets.ISO_8859_1);
        if (!SUSPICIOUS.matcher(code).find()) {
            return List.of();
        }
        PyObject found = ask("mistakes", Py.EmptyTuple, new PyString(code), new PyString(file));
        return StreamSupport.stream(found.asIterable().spliterator(), false).map(PyObject::toString)
            .collect(Collectors.toList());
    }
}
