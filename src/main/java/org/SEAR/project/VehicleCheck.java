package org.SEAR.project;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ParsedObject;

/** Checks what motors are to the wheels of their robots. One use. */
final class VehicleCheck {
    private final Map<ParsedObject, SEARrobot> owners;
    private final ProblemList problems;
    /** What turns a wheel already, by robot/wheel. */
    private final Map<String, String> turned = new HashMap<>();

    VehicleCheck(Map<ParsedObject, SEARrobot> owners, ProblemList problems) {
        this.owners = owners;
        this.problems = problems;
    }

    void check() {
        owners.forEach((parsed, robot) -> {
            if (parsed.object instanceof Motor) {
                check(parsed, (Motor) parsed.object, robot);
            }
        });
    }

    private void check(ParsedObject parsed, Motor motor, SEARrobot robot) {
        int index = 0;
        for (String name : motor.getWheelNames()) {
            int line = parsed.line("wheel#" + index++);
            Wheel wheel = robot.getWheels().stream().filter(one -> one.getName().equals(name)).findFirst().orElse(null);
            String other = turned.putIfAbsent(robot.getName() + "/" + name, parsed.file);
            if (wheel == null) {
                problems.add(parsed.file, line, "wheel", name, "a driven wheel (type 1) of the motor's robot " + robot.getName() + ": "
                    + driven(robot));
            } else if (!wheel.isDriven()) {
                problems.add(parsed.file, line, "wheel", name, "a driven wheel (type 1), and this one has type " + wheel.getType());
            } else if (other != null) {
                problems.add(parsed.file, line, "wheel", name, "a wheel that nothing turns yet; " + other + " turns it");
            }
        }
    }

    private static String driven(SEARrobot robot) {
        List<String> names = robot.getWheels().stream().filter(Wheel::isDriven).map(Wheel::getName).collect(Collectors.toList());
        return names.isEmpty() ? "it has none" : String.join(", ", names);
    }
}
