// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Lookup of parts of robots by name: {@code robot/part} is always legal, the part's name alone if only one robot has
 * such a part. Any thread after it is filled.
 *
 * @param <T> value of a name
 */
public final class PartNames<T> {
    private final Map<String, T> things = new HashMap<>();
    private final Map<String, List<String>> robots = new HashMap<>();

    public void add(String robot, String part, T thing) {
        things.putIfAbsent(part, thing);
        things.putIfAbsent(robot + "/" + part, thing);
        robots.computeIfAbsent(part, name -> new ArrayList<>()).add(robot);
    }

    /**
     * Returns a part.
     *
     * @return null if there is none of that name
     * @throws IllegalArgumentException with the choices if several robots have a part of that name
     */
    public T find(String name) {
        List<String> owners = robots.get(name);
        if (owners != null && owners.size() > 1) {
            throw new IllegalArgumentException('"' + name + "\" is on " + joined(owners, "and") + ": use "
                + joined(owners.stream().map(robot -> '"' + robot + "/" + name + '"')
                    .collect(Collectors.toList()), "or"));
        }
        return things.get(name);
    }

    private static String joined(List<String> words, String last) {
        int end = words.size() - 1;
        return String.join(", ", words.subList(0, end)) + " " + last + " " + words.get(end);
    }
}
