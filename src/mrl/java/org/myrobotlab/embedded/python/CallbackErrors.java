// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.util.regex.Pattern;
import org.python.core.Py;
import org.python.core.PyBaseCode;
import org.python.core.PyException;
import org.python.core.PyFunction;
import org.python.core.PyObject;
import org.python.core.PyTraceback;

/** Hints for errors of callbacks. The thread that has failed. */
final class CallbackErrors {
    private static final Pattern ARGUMENTS = Pattern.compile("\\(\\) takes .* arguments? \\(\\d+ given\\)$");

    private CallbackErrors() {
    }

    /** Returns the expected signature and the place of a function with the wrong number of parameters; else empty. */
    static String hint(PyException e, PyObject function) {
        boolean inside = e.traceback != null && e.traceback.tb_next instanceof PyTraceback;
        String message = e.value.__str__().toString();
        if (inside || !e.match(Py.TypeError) || !ARGUMENTS.matcher(message).find() || !(function instanceof PyFunction)) {
            return "";
        }
        PyObject code = ((PyFunction) function).__code__;
        String place = code instanceof PyBaseCode
            ? " (line " + ((PyBaseCode) code).co_firstlineno + " of " + ((PyBaseCode) code).co_filename + ")" : "";
        return "\na callback gets one argument: def " + ((PyFunction) function).__name__ + "(value):" + place;
    }
}
