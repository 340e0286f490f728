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
    /** Which lines have replaced what others made. */
    private final Set<String> replaced = new HashSet<>();
    private String run = "";
    private boolean taken;

    /**
     * Notes a name.
     *
     * @param taken whether its object replaces another
     * @return whether it replaces one that this run of a script has made, at a line that has replaced none of that one's line until now: a ready
     *     robot replaces each of its parts; never outside of scripts
     */
    synchronized boolean isAgain(String name, boolean taken) {
        if (!follow()) {
            return false;
        }
        String line = ScriptLine.here();
        String former = lines.put(name, line);
        return !names.add(name) && taken && (line.isEmpty() || replaced.add(former + " by " + line));
    }

    /** Another project: nothing in it has been given a name yet. */
    synchronized void forget() {
        names.clear();
        lines.clear();
        replaced.clear();
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
            replaced.clear();
            taken = false;
        }
        return present.isPresent();
    }
}
