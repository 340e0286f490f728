// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.SEAR.grammar.ScriptLine;

/**
 * Names that the current run of a Python script has given to objects. Jython compiles each run of a script to a class
 * of its own; a repeated run may create the same objects again. Any thread.
 */
final class ScriptRun {
    private final Set<String> names = new HashSet<>();
    /** Script line that created each object. */
    private final Map<String, String> lines = new HashMap<>();
    /** Pairs of lines of which the second has replaced objects of the first. */
    private final Set<String> replaced = new HashSet<>();
    private String run = "";
    private boolean taken;

    /**
     * Notes a name, and returns whether to report it.
     *
     * @param taken whether its object replaces another
     * @return whether the object replaces one that the same run of a script has created; only once per pair of lines,
     *     since a ready robot replaces each of its parts; false outside of scripts
     */
    synchronized boolean isAgain(String name, boolean taken) {
        if (!follow()) {
            return false;
        }
        String line = ScriptLine.here();
        String former = lines.put(name, line);
        return !names.add(name) && taken && (line.isEmpty() || replaced.add(former + " by " + line));
    }

    /** Forgets all names, for another project. */
    synchronized void forget() {
        names.clear();
        lines.clear();
        replaced.clear();
        taken = false;
    }

    /**
     * Returns the script line that created the first object named in a text.
     *
     * @return {@code line 7 of first.py}; empty if the text names none of the script's objects
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

    /** Notes that this run of a script has opened a project, whose objects it uses. */
    synchronized void hasTaken() {
        taken = follow();
    }

    /** Returns the names that this run of a script did not give; empty if it gave no name, or has opened a project. */
    synchronized List<String> others(Collection<String> all) {
        boolean builds = follow() && !names.isEmpty() && !taken;
        return builds ? all.stream().filter(name -> !names.contains(name)).collect(Collectors.toList()) : List.of();
    }

    /**
     * Finds the calling run of a script; a new run starts without names.
     *
     * @return whether a script calls
     */
    private boolean follow() {
        String present = ScriptLine.run();
        if (!present.isEmpty() && !present.equals(run)) {
            run = present;
            forget();
        }
        return !present.isEmpty();
    }
}
