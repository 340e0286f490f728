// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.python.core.Py;
import org.python.core.PyException;

/** Hints for Jython's errors. The thread that has failed. */
final class ScriptHints {
    private static final Pattern READ_ONLY = Pattern.compile("read-only attr: (\\w+)");
    private static final Pattern LOCAL = Pattern.compile("^local variable '(\\w+)' referenced before assignment$");
    private static final Pattern NONE = Pattern.compile("'NoneType' object has no attribute");
    private static final Set<String> PLACE = Set.of("x", "y", "z");
    private static final Set<String> TURN = Set.of("rx", "ry", "rz");

    private ScriptHints() {
    }

    /** Returns lines to append to the traceback, each with a line break before it; empty without a hint. */
    static String of(PyException e) {
        String message = e.value.__str__().toString();
        String line = SourceLine.of(e);
        if (e.match(Py.ImportError)) {
            return WrongNames.imported(message, line);
        }
        if (e.match(Py.TypeError)) {
            String made = WrongNames.made(message) + plain(message);
            return made.isEmpty() ? LegalCalls.lines(message, line, new Scope(e)) : made;
        }
        if (e.match(Py.ValueError) && message.contains("to unpack")) {
            return unpacked(line);
        }
        if (e.match(Py.UnboundLocalError)) {
            return LOCAL.matcher(message).replaceFirst("\n$1 is assigned in this function, which makes it local: start the function with global $1");
        }
        if (e.match(Py.NameError)) {
            return DidYouMean.name(message, new Scope(e));
        }
        return e.match(Py.AttributeError) ? attribute(message, line, new Scope(e)) : "";
    }

    private static String plain(String message) {
        if (message.startsWith("cannot concatenate 'str'")) {
            return "\nprint \"a\", b prints both; str(b) converts a number to a string, and \"%.2f m\" % b formats it";
        }
        return message.contains("SensorReading") ? "\na reading is an object; its number is reading.value" : "";
    }

    private static String attribute(String message, String line, Scope scope) {
        Matcher fixed = READ_ONLY.matcher(message);
        if (fixed.find()) {
            return PLACE.contains(fixed.group(1)) ? "\nlegal: move(x, y, z)" : TURN.contains(fixed.group(1)) ? "\nlegal: rotate(rx, ry, rz)" : "";
        }
        if (NONE.matcher(message).find()) {
            return "\nthe object before the dot is None: the call that returned it has failed, or returns nothing";
        }
        if (message.startsWith("'array.array'")) {
            return "\nit is a list of numbers: get one by its index, as list[0]" + answers(line);
        }
        return DidYouMean.member(message, scope);
    }

    private static String unpacked(String line) {
        String answers = answers(line);
        return answers.isEmpty() ? "" : "\nthe = needs one name on its left for each value" + answers;
    }

    private static String answers(String line) {
        return line.contains(".getPose(") ? "; getPose returns six: x, y, z, rx, ry, rz"
            : line.contains(".getGpsResult(") ? "; getGpsResult returns three: latitude, longitude, altitude" : "";
    }
}
