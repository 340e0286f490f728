// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.python.core.Py;
import org.python.core.PyException;
import org.python.core.PyFrame;
import org.python.core.PyObject;
import org.python.core.PyTraceback;

/** The names that a failed line can use, with their values. The thread that has failed. */
final class Scope {
    private final Map<String, PyObject> names = new TreeMap<>();

    /** Takes the names of the error's innermost line. */
    Scope(PyException e) {
        PyTraceback last = e.traceback;
        while (last != null && last.tb_next instanceof PyTraceback) {
            last = (PyTraceback) last.tb_next;
        }
        if (last != null) {
            PyFrame frame = last.tb_frame;
            add(frame.f_builtins);
            add(frame.f_globals);
            add(frame.getLocals());
        }
    }

    private void add(PyObject scope) {
        for (PyObject name : scope.invoke("keys").asIterable()) {
            if (!name.toString().startsWith("_")) {
                names.put(name.toString(), scope.__finditem__(name));
            }
        }
    }

    Set<String> names() {
        return names.keySet();
    }

    /** Returns the value of a name; null if there is none. */
    PyObject valueOf(String name) {
        return names.get(name);
    }

    /**
     * Returns the Java class that a name denotes, or the class of its object; null for unknown names and Python's own
     * values.
     */
    Class<?> typeOf(String name) {
        PyObject value = names.get(name);
        if (value == null) {
            return null;
        }
        Object type = value.__tojava__(Class.class);
        if (type instanceof Class) {
            return isPython((Class<?>) type) ? null : (Class<?>) type;
        }
        return objectTypeOf(name);
    }

    /** Returns the Java class of a name's object; null for classes, unknown names and Python's own values. */
    Class<?> objectTypeOf(String name) {
        PyObject value = names.get(name);
        if (value == null || value.__tojava__(Class.class) instanceof Class) {
            return null;
        }
        Object object = value.__tojava__(Object.class);
        return object == null || object == Py.NoConversion || isPython(object.getClass()) ? null : object.getClass();
    }

    private static boolean isPython(Class<?> type) {
        return type.getName().startsWith("org.python.");
    }
}
