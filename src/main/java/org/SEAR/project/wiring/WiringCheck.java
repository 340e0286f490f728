// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.wiring;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.BoardWire;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.WireRules;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ParsedObject;

/**
 * Checks that wires lead to suitable components of their robot, and that no two boards share the same wire. One use.
 */
public final class WiringCheck {
    private final Map<ParsedObject, SEARrobot> owners;
    private final ProblemList problems;
    /** Files of boards by robot, component and role. */
    private final Map<String, String> wired = new HashMap<>();

    /** @param owners the parts and their robots, which have all their components */
    public WiringCheck(Map<ParsedObject, SEARrobot> owners, ProblemList problems) {
        this.owners = owners;
        this.problems = problems;
    }

    /** Adds the problems of all boards. */
    public void check() {
        owners.forEach((parsed, robot) -> {
            if (parsed.object instanceof Arduino) {
                check(parsed, (Arduino) parsed.object, robot);
            }
        });
    }

    private void check(ParsedObject parsed, Arduino board, SEARrobot robot) {
        int index = 0;
        for (BoardWire wire : board.getWires()) {
            int line = parsed.line("wire#" + index++);
            SearObject part = robot.getComponents().stream().filter(each -> each.getName().equals(wire.getPart()))
                .findFirst().orElse(null);
            String problem = part == null ? null : WireRules.problem(part, wire.getRole());
            String other = wired.putIfAbsent(robot.getName() + "/" + wire.getPart() + "/" + wire.getRole(),
                parsed.file);
            if (part == null) {
                problems.add(parsed.file, line, "wire", wire.getPart(), "the name of a component of " + robot.getName()
                    + " that has wires: " + wirable(robot));
            } else if (problem != null) {
                problems.add(parsed.file, line, "wire", wire.getPart(), problem);
            } else if (other != null && !other.equals(parsed.file)) {
                problems.add(parsed.file, line, "wire", wire.getPart(),
                    "one board for its " + wire.getRole().getWord() + "; " + other + " has it too");
            }
        }
    }

    private static String wirable(SEARrobot robot) {
        List<String> names = robot.getComponents().stream().filter(part -> WireRules.problem(part, null) == null)
            .map(SearObject::getName).collect(Collectors.toList());
        return names.isEmpty() ? "it has none" : String.join(", ", names);
    }
}
