// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.myrobotlab.embedded.python.hints.ForeignCharacters;
import org.myrobotlab.embedded.python.hints.SourceScan;
import org.myrobotlab.embedded.python.hints.SyntaxHints;
import org.python.core.Py;
import org.python.core.PyException;
import org.python.core.PyInteger;
import org.python.core.PyObject;

/** Messages for syntax errors: the place in the script, Jython's message, and a hint. The thread that has failed. */
final class SyntaxErrors {
    private static final Pattern NO_BYTE = Pattern.compile("Cannot create PyString with non-byte value.*?\\\\u(\\p{XDigit}{4})", Pattern.DOTALL);

    private SyntaxErrors() {
    }

    /**
     * Returns the message for a syntax error of a script.
     *
     * @return null for another error, or if the script's source is unknown
     */
    static String of(PyException e) {
        if (!e.match(Py.SyntaxError) || e.traceback != null) {
            return null;
        }
        String file = text(e, "filename");
        List<String> lines = SourceLine.lines(file);
        PyObject number = e.value.__findattr__("lineno");
        if (lines.isEmpty() || !(number instanceof PyInteger)) {
            return null;
        }
        SourceScan scan = new SourceScan(lines);
        int line = number.asInt();
        if (scan.foreign() != null && scan.foreign().line <= line) {
            return foreign(file, scan);
        }
        PyObject offset = e.value.__findattr__("offset");
        String said = text(e, "msg");
        int column = offset instanceof PyInteger ? offset.asInt() - 1 : Integer.MAX_VALUE;
        String error = (e.match(Py.IndentationError) ? "IndentationError: " : "SyntaxError: ") + said;
        return shown(file, line, scan.line(line), column, error)
            + SyntaxHints.of(scan, line, said);
    }

    /**
     * Returns the message for the first foreign character of a script whose error Jython can't represent; null if there
     * is none.
     */
    static String foreign(String file) {
        SourceScan scan = new SourceScan(SourceLine.lines(file));
        return scan.foreign() == null ? null : foreign(file, scan);
    }

    /**
     * Returns the message for a module's error that Jython can't represent, from Java's message; null for another
     * error.
     */
    static String ofModule(String message) {
        Matcher character = NO_BYTE.matcher(message);
        return character.find() ? "SyntaxError: in the code that this line loads, " + ForeignCharacters.sentence(
            new SourceScan.Place(1, 0, String.valueOf((char) Integer.parseInt(character.group(1), 16))), "") : null;
    }

    private static String foreign(String file, SourceScan scan) {
        SourceScan.Place place = scan.foreign();
        String line = scan.line(place.line);
        return shown(file, place.line, line, place.column, "SyntaxError: " + ForeignCharacters.sentence(place, line));
    }

    /** Formats the error as Python does, with the column mark corrected for non-ASCII characters. */
    private static String shown(String file, int number, String line, int column, String error) {
        String text = line.strip();
        int indent = line.length() - line.stripLeading().length();
        int blanks = column < -1 || column > line.length() ? -1 : line.codePointCount(indent, Math.max(indent, column));
        return "  File \"" + file + "\", line " + number + (text.isEmpty() ? "" : "\n    " + text)
            + (text.isEmpty() || blanks < 0 ? "" : "\n    " + " ".repeat(blanks) + "^") + "\n" + error;
    }

    private static String text(PyException e, String attribute) {
        PyObject value = e.value.__findattr__(attribute);
        return value == null || value == Py.None ? "" : value.toString();
    }
}
