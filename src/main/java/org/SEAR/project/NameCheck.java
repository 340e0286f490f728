// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Assembly;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ParsedObject;

/**
 * Checks that names are unique, since scripts address objects by name. Names of environment objects and robots are
 * unique in the project, and names of parts in their robot, case-insensitively, because some file systems ignore case.
 * Parts of two robots with the same name get a full name with their robot's. One use.
 */
final class NameCheck {
    private final Map<String, ParsedObject> environment;
    private final Map<String, ParsedObject> parts;
    private final Map<ParsedObject, SEARrobot> owners;
    private final ProblemList problems;
    private final Map<String, String> whole = new HashMap<>();
    private final Map<String, Integer> robotsWithPart = new HashMap<>();

    NameCheck(Map<String, ParsedObject> environment, Map<String, ParsedObject> parts,
        Map<ParsedObject, SEARrobot> owners, ProblemList problems) {
        this.environment = environment;
        this.parts = parts;
        this.owners = owners;
        this.problems = problems;
    }

    void check() {
        List<ParsedObject> robots = new ArrayList<>();
        environment.values().forEach(parsed -> check(parsed, "name", parsed.object, whole));
        for (ParsedObject parsed : parts.values()) {
            if (parsed.object instanceof SEARrobot) {
                robots.add(parsed);
                check(parsed, "name", parsed.object, whole);
            }
        }
        checkFiles();
        Map<SEARrobot, Map<String, String>> seen = new HashMap<>();
        robots.forEach(parsed -> seen.put((SEARrobot) parsed.object, new HashMap<>()));
        for (ParsedObject parsed : parts.values()) {
            if (owners.containsKey(parsed)) {
                check(parsed, "name", parsed.object, seen.get(owners.get(parsed)));
            }
        }
        for (ParsedObject parsed : robots) {
            int index = 0;
            for (Wheel wheel : ((SEARrobot) parsed.object).getWheels()) {
                check(parsed, "wheel#" + index++, wheel, seen.get(parsed.object));
            }
        }
        robots.forEach(parsed -> eachPart((SEARrobot) parsed.object)
            .forEach(part -> robotsWithPart.merge(part.getName(), 1, Integer::sum)));
        robots.forEach(parsed -> name((SEARrobot) parsed.object));
    }

    private void check(ParsedObject parsed, String element, Object object, Map<String, String> seen) {
        if (object == null) {
            return;
        }
        String name = ((SearObject) object).getName();
        String key = TextRule.onAnySystem(name);
        String other = whole.containsKey(key) ? whole.get(key) : seen.putIfAbsent(key, parsed.file);
        if (other != null) {
            problems.add(parsed.file, parsed.line(element), "name", name, "a name of its own (capitals don't count); "
                + other + " has it too");
        }
    }

    /** Checks that parts of two robots with the same name do not share a file. */
    private void checkFiles() {
        Map<String, ParsedObject> seen = new LinkedHashMap<>();
        for (ParsedObject parsed : parts.values()) {
            ParsedObject other = owners.containsKey(parsed)
                ? seen.putIfAbsent(TextRule.onAnySystem(parsed.file), parsed) : null;
            if (other != null && owners.get(other) != owners.get(parsed)) {
                problems.add(parsed.file, parsed.line("name"), "name", ((SearObject) parsed.object).getName(),
                    "a name that differs from that of "
                    + other.file + " by more than capitals or accents' spelling, since some systems take both for "
                        + "the same file");
            }
        }
    }

    private static List<SearObject> eachPart(SEARrobot robot) {
        List<SearObject> all = new ArrayList<>(robot.getComponents());
        all.addAll(robot.getWheels());
        return all;
    }

    private void name(SEARrobot robot) {
        for (SearObject part : eachPart(robot)) {
            if (robotsWithPart.get(part.getName()) > 1) {
                Assembly.setFullName(part, robot.getName() + "/" + part.getName());
            }
        }
    }
}
