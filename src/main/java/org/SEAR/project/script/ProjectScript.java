// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.script;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.SEAR.POJOs.Draft;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.BeamLibrary;
import org.SEAR.project.Project;

/**
 * Writes the Python script that creates a project's objects. Run by MyRobotLab's service {@code python}, it reproduces
 * the XML files byte by byte, as SEAR writes them. Pictures, models, maps and beams stay in the project as files. One
 * use, one thread.
 */
public final class ProjectScript {
    /**
     * Safe number of lines per block: Jython compiles each block to a method, and Java limits a method to 64 kilobytes.
     */
    private static final int LINES_OF_BLOCK = 120;

    private final Project project;
    private final Set<Class<?>> classes = new TreeSet<>(Comparator.comparing(Class::getName));
    private final List<Unit> units = new ArrayList<>();
    /** Owner of {@code robot/NAME.xml}, by name in lower case, while the script proceeds. */
    private final Map<String, SearObject> places = new HashMap<>();
    private final Map<SearObject, Boolean> aside = new LinkedHashMap<>();
    private final PythonText.Variables variables;

    /** Lines that belong together, and their variables for later units. */
    private static final class Unit {
        final List<String> lines = new ArrayList<>();
        final List<String> variables = new ArrayList<>();
    }

    private ProjectScript(Project project) {
        this.project = project;
        Collection<String> imported = new TreeSet<>();
        project.getEnvironment().forEach(object -> imported.add(object.getClass().getSimpleName()));
        project.getJoints().forEach(joint -> imported.add(joint.getClass().getSimpleName()));
        variables = new PythonText.Variables(imported);
    }

    /**
     * Returns the script of a project.
     *
     * @throws IllegalStateException if there is an object that no call can create
     */
    public static String of(Project project) {
        return Draft.of(new BeamLibrary(project.getFolder()).names(), () -> new ProjectScript(project).write());
    }

    private String write() {
        List<SearObject> world = new ArrayList<>(project.getEnvironment());
        world.sort(Comparator.comparing(object -> !(object instanceof Shape && ((Shape) object).isGround())));
        world.forEach(object -> add(object, ""));
        Map<SEARrobot, String> robots = new LinkedHashMap<>();
        project.getRobots().forEach(robot -> robots.put(robot, addRobot(robot)));
        project.getJoints().forEach(joint -> add(joint, ""));
        putInPlace(robots, true);
        putInPlace(robots, false);
        return text();
    }

    /** @return the variable; null if the object needed none */
    private String add(SearObject object, String ending) {
        ObjectScript script = script(object);
        Unit unit = new Unit();
        units.add(unit);
        boolean named = !script.calls().isEmpty();
        String variable = named ? variables.of(object.getName(), object.getClass().getSimpleName()) : null;
        int open = ending.indexOf('(');
        if (named) {
            unit.lines.add(variable + " = " + script.expression());
            script.calls().forEach(call -> unit.lines.add(variable + "." + call));
            if (open >= 0) {
                unit.lines.add(ending + variable + ")");
            }
        } else {
            unit.lines.add(open >= 0 ? ending + script.expression() + ")" : script.expression());
        }
        return variable;
    }

    private ObjectScript script(SearObject object) {
        ObjectScript script = new ObjectScript(object);
        if (!script.isPossible()) {
            throw new IllegalStateException(object + " can't be written as a script: neither its constructors nor make "
                + "take its values");
        }
        classes.addAll(script.classes());
        return script;
    }

    private String addRobot(SEARrobot robot) {
        ObjectScript script = script(robot);
        Unit unit = new Unit();
        unit.lines.add("");
        String variable = variables.of(robot.getName(), "robot");
        unit.variables.add(variable);
        unit.lines.add(variable + " = " + script.expression());
        script.calls().forEach(call -> unit.lines.add(variable + "." + call));
        if (robot.getOrder() == null && project.getRobots().size() > 1) {
            unit.lines.add(variable + ".set({\"order\": None})");
        }
        units.add(unit);
        take(robot);
        for (SearObject component : robot.getComponents()) {
            add(component, variable + ".addComponent(");
            take(component);
        }
        for (Wheel wheel : robot.getWheels()) {
            add(wheel, variable + ".addWheel(");
            take(wheel);
        }
        return variable;
    }

    /** Makes a part or robot the owner of its plain file; an earlier robot's part of the same name moves aside. */
    private void take(SearObject part) {
        SearObject holder = places.put(part.getName().toLowerCase(Locale.ROOT), part);
        if (holder != null && aside.containsKey(holder)) {
            aside.put(holder, true);
        }
        if (!(part instanceof SEARrobot) && !(part instanceof Wheel)) {
            aside.put(part, false);
        }
    }

    /** Adds calls for files whose location differs from the result of the script. */
    private void putInPlace(Map<SEARrobot, String> robots, boolean wanted) {
        Unit unit = new Unit();
        robots.forEach((robot, variable) -> {
            for (SearObject part : robot.getComponents()) {
                boolean isAside = !part.getFileName().equals(part.getName());
                if (isAside == wanted && aside.get(part) != wanted) {
                    unit.lines.add(variable + ".setOwnFolder(" + PythonText.literal(part.getName()) + ", "
                        + PythonText.literal(wanted) + ")");
                }
            }
        });
        units.add(unit);
    }

    private String text() {
        Map<String, TreeSet<String>> imports = new TreeMap<>();
        classes.forEach(type -> imports.computeIfAbsent(type.getPackageName(), key -> new TreeSet<>())
            .add(type.getSimpleName()));
        StringBuilder text = new StringBuilder();
        PythonText.imports(imports).forEach(line -> text.append(line).append('\n'));
        text.append('\n');
        int lines = units.stream().mapToInt(unit -> unit.lines.size()).sum();
        if (lines <= LINES_OF_BLOCK) {
            units.forEach(unit -> unit.lines.forEach(line -> text.append(line).append('\n')));
        } else {
            blocks(text);
        }
        return text.toString();
    }

    /** Splits a long script into functions; robots are global variables. */
    private void blocks(StringBuilder text) {
        int number = 0;
        for (int from = 0; from < units.size();) {
            int size = 0;
            int to = from;
            List<String> shared = new ArrayList<>();
            while (to < units.size() && (to == from || size + units.get(to).lines.size() <= LINES_OF_BLOCK)) {
                size += units.get(to).lines.size();
                shared.addAll(units.get(to++).variables);
            }
            StringBuilder block = new StringBuilder();
            shared.forEach(variable -> block.append("    global ").append(variable).append('\n'));
            units.subList(from, to).forEach(
                unit -> unit.lines.forEach(line -> block.append(line.isEmpty() ? "" : "    " + line).append('\n')));
            if (block.toString().trim().length() > 0) {
                number++;
                text.append("def part").append(number).append("():\n").append(block).append("\npart").append(number)
                    .append("()\n\n");
            }
            from = to;
        }
    }
}
