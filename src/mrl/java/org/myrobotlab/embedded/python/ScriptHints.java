package org.myrobotlab.embedded.python;

import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.python.core.Py;
import org.python.core.PyException;
import org.python.core.PyObject;

/** What to do about an error that Jython words for programmers. The thread that has failed. */
final class ScriptHints {
    private static final Pattern F_STRING = Pattern.compile("(?i)\\bf[r]?[\"']");
    private static final Pattern PRINT = Pattern.compile("\\bprint\\s*\\(");
    private static final String OLD_PYTHON = "\nscripts are Python 2.7 (Jython)";
    private static final Pattern READ_ONLY = Pattern.compile("read-only attr: (\\w+)");
    private static final Pattern NONE = Pattern.compile("'NoneType' object has no attribute");
    private static final Set<String> PLACE = Set.of("x", "y", "z");
    private static final Set<String> TURN = Set.of("rx", "ry", "rz");

    private ScriptHints() {
    }

    /**
     * What to add to the traceback.
     *
     * @return lines, each behind a line's end; empty if there is nothing to say
     */
    static String of(PyException e) {
        String message = e.value.__str__().toString();
        if (e.match(Py.SyntaxError)) {
            return syntax(e, message);
        }
        String line = SourceLine.of(e);
        if (e.match(Py.ImportError)) {
            return WrongNames.imported(message, line);
        }
        if (e.match(Py.TypeError)) {
            String made = WrongNames.made(message);
            return made.isEmpty() ? LegalCalls.lines(message, line, new Scope(e)) : made;
        }
        if (e.match(Py.ValueError) && message.contains("to unpack")) {
            return unpacked(line);
        }
        if (e.match(Py.NameError)) {
            return DidYouMean.name(message, new Scope(e));
        }
        return e.match(Py.AttributeError) ? attribute(message, line) : "";
    }

    private static String attribute(String message, String line) {
        Matcher fixed = READ_ONLY.matcher(message);
        if (fixed.find()) {
            return PLACE.contains(fixed.group(1)) ? "\nlegal: move(x, y, z)" : TURN.contains(fixed.group(1)) ? "\nlegal: rotate(rx, ry, rz)" : "";
        }
        if (NONE.matcher(message).find()) {
            return "\nwhat stands before the dot is None, which is what a call answers that has failed, or that answers nothing";
        }
        if (message.startsWith("'array.array'")) {
            return "\nit is a list of numbers: take one out by its place, as list[0]" + answers(line);
        }
        return DidYouMean.member(message);
    }

    private static String unpacked(String line) {
        String answers = answers(line);
        return answers.isEmpty() ? "" : "\nthere have to be as many names before the = as there are values" + answers;
    }

    private static String answers(String line) {
        return line.contains(".getPose(") ? "; getPose answers six: x, y, z, rx, ry, rz"
            : line.contains(".getGpsResult(") ? "; getGpsResult answers three: latitude, longitude, altitude" : "";
    }

    /** What today's Python writes and this one does not read, and what is forgotten most often. */
    private static String syntax(PyException e, String message) {
        PyObject text = e.value.__findattr__("text");
        String line = text == null ? "" : text.toString();
        if (F_STRING.matcher(line).find()) {
            return OLD_PYTHON + ", which has no f-strings: write \"%d m\" % metres";
        }
        if (PRINT.matcher(line).find()) {
            return OLD_PYTHON + ": write print \"a\", b, or begin the script with from __future__ import print_function";
        }
        if (message.contains("expecting COLON")) {
            return "\na line that begins a block (if, else, while, for, def, class) ends with a colon";
        }
        return message.contains("expecting INDENT") ? "\nthe lines of a block begin with blanks: four more than the line with the colon"
            : message.contains("expecting RPAREN") ? "\na bracket ( is not closed by a )" : "";
    }
}
