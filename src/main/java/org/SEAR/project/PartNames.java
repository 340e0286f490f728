package org.SEAR.project;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Parts of robots by what users call them: {@code robot/part} is always legal, the part's name alone where only one of these robots has it. Any
 * thread once it is filled.
 *
 * @param <T> what the names stand for
 */
public final class PartNames<T> {
    private final Map<String, T> things = new HashMap<>();
    private final Map<String, List<String>> robots = new HashMap<>();

    /** Adds a part. */
    public void add(String robot, String part, T thing) {
        things.putIfAbsent(part, thing);
        things.putIfAbsent(robot + "/" + part, thing);
        robots.computeIfAbsent(part, name -> new ArrayList<>()).add(robot);
    }

    /**
     * A part.
     *
     * @return null if there is none of that name
     * @throws IllegalArgumentException that names the choices if several robots have one of that name
     */
    public T find(String name) {
        List<String> owners = robots.get(name);
        if (owners != null && owners.size() > 1) {
            throw new IllegalArgumentException('"' + name + "\" is on " + joined(owners, "and") + ": say "
                + joined(owners.stream().map(robot -> '"' + robot + "/" + name + '"').collect(Collectors.toList()), "or"));
        }
        return things.get(name);
    }

    private static String joined(List<String> words, String last) {
        int end = words.size() - 1;
        return String.join(", ", words.subList(0, end)) + " " + last + " " + words.get(end);
    }
}
