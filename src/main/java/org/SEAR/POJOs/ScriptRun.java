package org.SEAR.POJOs;

import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.SEAR.grammar.ScriptLine;

/**
 * Which names the present run of a Python script has given to objects. Jython makes a class of its own of each run of a script; a script that is run
 * again is another run, which may make the same objects. Any thread.
 */
final class ScriptRun {
    private static final String SCRIPT = "org.python.pycode.";
    private final Set<String> names = new HashSet<>();
    /** Where the script has made each. */
    private final Map<String, String> lines = new HashMap<>();
    private String run = "";
    private boolean taken;

    /** Whether this run of a script has given the name before; never outside of scripts. */
    synchronized boolean isAgain(String name) {
        if (!follow()) {
            return false;
        }
        lines.put(name, ScriptLine.here());
        return !names.add(name);
    }

    /** Another project: nothing in it has been given a name yet. */
    synchronized void forget() {
        names.clear();
        lines.clear();
        taken = false;
    }

    /**
     * Where the script has made the first object that a text names.
     *
     * @return {@code line 7 of first.py}; empty if it names none of the script's
     */
    synchronized String lineOf(String text) {
        String found = "";
        int first = Integer.MAX_VALUE;
        for (Map.Entry<String, String> made : lines.entrySet()) {
            Matcher named = Pattern.compile("(?<![\\w.])" + Pattern.quote(made.getKey()) + "(?![\\w.])").matcher(text);
            if (named.find() && named.start() < first) {
                first = named.start();
                found = made.getValue();
            }
        }
        return found;
    }

    /** This run of a script has taken a project, whose objects it means to have. */
    synchronized void hasTaken() {
        taken = follow();
    }

    /** Which of these names this run of a script did not give; none if it gave no name at all, or has taken a project. */
    synchronized List<String> others(Collection<String> all) {
        boolean builds = follow() && !names.isEmpty() && !taken;
        return builds ? all.stream().filter(name -> !names.contains(name)).collect(Collectors.toList()) : List.of();
    }

    /**
     * Looks which run is calling; another than before begins with no names.
     *
     * @return whether one is
     */
    private boolean follow() {
        Optional<String> present = StackWalker.getInstance().walk(frames -> frames.map(StackWalker.StackFrame::getClassName)
            .filter(type -> type.startsWith(SCRIPT)).reduce((inner, outer) -> outer));
        if (present.isPresent() && !present.get().equals(run)) {
            run = present.get();
            names.clear();
            lines.clear();
            taken = false;
        }
        return present.isPresent();
    }
}
