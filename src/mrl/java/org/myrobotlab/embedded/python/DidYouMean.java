package org.myrobotlab.embedded.python;

import java.io.IOException;
import java.lang.reflect.Method;
import java.util.Comparator;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.python.core.Py;
import org.python.core.PyException;
import org.python.core.PyFrame;
import org.python.core.PyObject;
import org.python.core.PyTraceback;

/** The name that was perhaps meant by one that there is not. Any thread that runs Python. */
public final class DidYouMean {
    private static final Pattern NO_NAME = Pattern.compile("name '(\\w+)' is not defined");
    private static final Pattern NO_ATTRIBUTE = Pattern.compile("'([\\w.$]+)' object has no attribute '(\\w+)'");
    /** Names that have less in common are not suggested. */
    private static final double NEAR = 0.65;
    private static final double WITHOUT_VERB = 0.9;
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
        return known.stream().filter(one -> nearness(wanted, one) >= NEAR)
            .max(Comparator.comparingDouble((String one) -> nearness(wanted, one)).thenComparing(DidYouMean::likelihood)
                .thenComparing(Comparator.reverseOrder()))
            .map(one -> "\ndid you mean " + one + "?").orElse("");
    }

    /** How near a name is to what was written: as a whole, or a little less without its first word, which people leave out: startSimulation. */
    private static double nearness(String wanted, String known) {
        String plain = wanted.toLowerCase(Locale.ROOT);
        String rest = known.replaceFirst("^[a-z]+(?=[A-Z])", "");
        double whole = similarity(plain, known.toLowerCase(Locale.ROOT));
        return rest.length() == known.length() ? whole : Math.max(whole, WITHOUT_VERB * similarity(plain, rest.toLowerCase(Locale.ROOT)));
    }

    /** Who writes the name of no question doesn't ask; start, of all actions, is what is meant by a thing that is done. */
    private static int likelihood(String name) {
        return name.matches("(is|has|get)[A-Z].*") ? 0 : name.startsWith("start") ? 2 : 1;
    }

    /** Share of letters that both have, in one order: 1 for the same. */
    private static double similarity(String a, String b) {
        int[] common = new int[b.length() + 1];
        for (int i = 0; i < a.length(); i++) {
            int diagonal = 0;
            for (int j = 0; j < b.length(); j++) {
                int above = common[j + 1];
                common[j + 1] = a.charAt(i) == b.charAt(j) ? diagonal + 1 : Math.max(above, common[j]);
                diagonal = above;
            }
        }
        return 2.0 * common[b.length()] / Math.max(1, a.length() + b.length());
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
