package org.myrobotlab.embedded.python;

import java.io.IOException;
import java.lang.reflect.Method;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.python.core.Py;
import org.python.core.PyException;
import org.python.core.PyFrame;
import org.python.core.PyList;
import org.python.core.PyObject;
import org.python.core.PyString;
import org.python.core.PyTraceback;
import org.python.core.imp;

/** The name that was perhaps meant by one that there is not. Any thread that runs Python. */
public final class DidYouMean {
    private static final Pattern NO_NAME = Pattern.compile("name '(\\w+)' is not defined");
    private static final Pattern NO_ATTRIBUTE = Pattern.compile("'([\\w.$]+)' object has no attribute '(\\w+)'");
    private static final String SERVICES = "org.myrobotlab.service";

    private DidYouMean() {
    }

    /** For a service type: ", did you mean LIDAR?"; empty if there is none of that spelling. */
    public static String service(String type) {
        try {
            for (String known : PackageClasses.of(SERVICES, DidYouMean.class.getClassLoader())) {
                if (known.equalsIgnoreCase(type)) {
                    return ", did you mean " + known + "?";
                }
            }
            return "";
        } catch (IOException e) {
            return "";
        }
    }

    /** For a name or a Java object's method that a script uses and that there is not: a line, or empty. */
    static String line(PyException e) {
        String message = e.value.__str__().toString();
        Matcher name = NO_NAME.matcher(message);
        Matcher attribute = NO_ATTRIBUTE.matcher(message);
        if (e.match(Py.NameError) && name.find()) {
            return line(name.group(1), names(e.traceback));
        }
        return e.match(Py.AttributeError) && attribute.find() ? line(attribute.group(2), methods(attribute.group(1))) : "";
    }

    private static String line(String wanted, Set<String> known) {
        for (String one : known) {
            if (one.equalsIgnoreCase(wanted)) {
                return "\ndid you mean " + one + "?";
            }
        }
        PyList names = new PyList();
        known.forEach(one -> names.append(Py.newString(one)));
        PyObject near = imp.importName("difflib", true).invoke("get_close_matches", new PyObject[] {new PyString(wanted), names, Py.newInteger(1)});
        return near.__len__() == 0 ? "" : "\ndid you mean " + near.__getitem__(0) + "?";
    }

    /** All names that the failed line could use. */
    private static Set<String> names(PyTraceback traceback) {
        Set<String> names = new TreeSet<>();
        PyTraceback last = traceback;
        while (last != null && last.tb_next instanceof PyTraceback) {
            last = (PyTraceback) last.tb_next;
        }
        if (last != null) {
            PyFrame frame = last.tb_frame;
            add(names, frame.f_globals);
            add(names, frame.getLocals());
            add(names, frame.f_builtins);
        }
        return names;
    }

    private static void add(Set<String> names, PyObject scope) {
        for (PyObject name : scope.invoke("keys").asIterable()) {
            if (!name.toString().startsWith("_")) {
                names.add(name.toString());
            }
        }
    }

    private static Set<String> methods(String type) {
        Set<String> names = new TreeSet<>();
        try {
            for (Method method : Class.forName(type).getMethods()) {
                names.add(method.getName());
            }
        } catch (ClassNotFoundException e) {
            return names; // a class of the script's own
        }
        return names;
    }
}
