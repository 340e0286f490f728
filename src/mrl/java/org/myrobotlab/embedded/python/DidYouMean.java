package org.myrobotlab.embedded.python;

import java.io.IOException;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.Comparator;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.python.core.PyFunction;
import org.python.core.PyObject;

/** The name that was perhaps meant by one that there is not. Any thread that runs Python. */
public final class DidYouMean {
    private static final Pattern NO_NAME = Pattern.compile("name '(\\w+)' is not defined");
    private static final Pattern NO_ATTRIBUTE = Pattern.compile("'([\\w.$]+)'(?: object)? has no attribute '(\\w+)'");
    /** Names that have less in common are not suggested. */
    private static final double NEAR = 0.65;
    private static final double WITHOUT_VERB = 0.9;
    private static final int MOST_ACTIONS = 4;
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

    /** For a name or a Java object's member that a script uses and that there is not: a line, or empty. */
    static String line(String message, boolean isName, Scope scope) {
        Matcher name = NO_NAME.matcher(message);
        Matcher attribute = NO_ATTRIBUTE.matcher(message);
        if (isName && name.find()) {
            String wanted = name.group(1);
            String imported = WrongNames.used(wanted);
            String called = imported.isEmpty() ? methodOf(wanted, scope) : imported;
            return called.isEmpty() ? line(wanted, scope.names()) : called;
        }
        if (isName || !attribute.find()) {
            return "";
        }
        String own = line(attribute.group(2), members(attribute.group(1), true));
        return own.isEmpty() ? line(attribute.group(2), members(attribute.group(1), false)) : own;
    }

    /** For a function of the script that there is not: ", did you mean onScan?"; empty if there is none like it. */
    static String function(String wanted, PyObject variables) {
        Set<String> functions = new TreeSet<>();
        for (PyObject name : variables.invoke("keys").asIterable()) {
            if (variables.__finditem__(name) instanceof PyFunction) {
                functions.add(name.toString());
            }
        }
        return line(wanted, functions).replace("\n", ", ");
    }

    /** A method whose object was left out: simSleep(1) for sear.simSleep(1). */
    private static String methodOf(String wanted, Scope scope) {
        for (String owner : scope.names()) {
            Class<?> type = scope.objectTypeOf(owner);
            if (type == null || !type.getName().matches("org\\.(SEAR|myrobotlab)\\..*")) {
                continue;
            }
            for (Method method : type.getMethods()) {
                if (method.getName().equalsIgnoreCase(wanted)) {
                    return "\ndid you mean " + owner + "." + method.getName() + "?";
                }
            }
        }
        return "";
    }

    private static String line(String wanted, Set<String> known) {
        for (String one : known) {
            if (one.equalsIgnoreCase(wanted)) {
                return "\ndid you mean " + one + "?";
            }
        }
        String actions = known.stream().filter(one -> isVerbOf(wanted, one)).sorted().limit(MOST_ACTIONS).collect(Collectors.joining(" or "));
        if (!actions.isEmpty()) {
            return "\ndid you mean " + actions + "?";
        }
        return known.stream().filter(one -> wanted.length() > 1 && nearness(wanted, one) >= NEAR)
            .max(Comparator.comparingDouble((String one) -> nearness(wanted, one)).thenComparing(DidYouMean::likelihood)
                .thenComparing(Comparator.reverseOrder()))
            .map(one -> "\ndid you mean " + one + "?").orElse("");
    }

    /** Whether an action's first word was written alone: start. */
    private static boolean isVerbOf(String wanted, String known) {
        return wanted.length() > 2 && known.matches(Pattern.quote(wanted) + "[A-Z].*");
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

    /**
     * Methods, and what Jython makes of getX and setX.
     *
     * @param own whether only those of the class itself, which are meant rather than those that every service has
     */
    private static Set<String> members(String type, boolean own) {
        Set<String> names = new TreeSet<>();
        try {
            Class<?> described = Class.forName(type);
            for (Method method : own ? described.getDeclaredMethods() : described.getMethods()) {
                if (Modifier.isPublic(method.getModifiers()) && !method.isSynthetic()) {
                    names.add(method.getName());
                }
            }
            for (Field field : own ? described.getDeclaredFields() : described.getFields()) {
                if (Modifier.isPublic(field.getModifiers())) {
                    names.add(field.getName());
                }
            }
        } catch (ClassNotFoundException e) {
            return names; // a class of the script's own
        }
        return names;
    }
}
