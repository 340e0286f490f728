// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;

/** The contents of a project in a few words, such as {@code rover1, 2 boxes}. Any thread. */
public final class ProjectWords {
    private static final int MAX_ROBOTS = 3;
    private static final int MAX_KINDS = 3;

    private ProjectWords() {
    }

    /** Returns the robots' names and the number of objects of each kind; empty for an empty project. */
    public static String of(Project project) {
        List<String> words = new ArrayList<>();
        List<SEARrobot> robots = project.getRobots();
        robots.stream().limit(MAX_ROBOTS).forEach(robot -> words.add(robot.getName()));
        if (robots.size() > MAX_ROBOTS) {
            words.add(count(robots.size() - MAX_ROBOTS, "more robot"));
        }
        Map<String, Integer> kinds = kinds(project, false);
        if (words.isEmpty() && kinds.isEmpty()) {
            kinds = kinds(project, true);
        }
        kinds.entrySet().stream().limit(MAX_KINDS).forEach(kind -> words.add(count(kind.getValue(), kind.getKey())));
        int others = kinds.values().stream().skip(MAX_KINDS).mapToInt(Integer::intValue).sum();
        if (others > 0) {
            words.add(count(others, "other object"));
        }
        return String.join(", ", words);
    }

    private static Map<String, Integer> kinds(Project project, boolean ground) {
        Map<String, Integer> kinds = new LinkedHashMap<>();
        for (SearObject object : project.getEnvironment()) {
            if (object instanceof Shape && ((Shape) object).isGround() == ground) {
                String name = object.getClass().getSimpleName().replaceAll("(?<=[a-z])(?=[A-Z])", " ");
                name = name.toLowerCase(Locale.ROOT);
                kinds.merge(name, 1, Integer::sum);
            }
        }
        return kinds;
    }

    private static String count(int number, String what) {
        return number == 1 ? "1 " + what : number + " " + what + (what.matches(".*(x|s|ch|sh)") ? "es" : "s");
    }
}
