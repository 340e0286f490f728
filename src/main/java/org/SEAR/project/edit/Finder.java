// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;

/**
 * Finds the objects of a project by their addresses in edits: {@code crate}, {@code rover}, {@code rover/ping}. Guarded
 * by the project lock.
 */
final class Finder {
    private final EditDraft draft;

    Finder(EditDraft draft) {
        this.draft = draft;
    }

    /**
     * Finds an object.
     *
     * @param name of an environment object or a robot; or of a part, with its robot's name in front unless only one
     *     robot has such a part
     * @throws ProjectException with the choices
     */
    ObjectLocation find(String name) throws IOException, ProjectException {
        List<ObjectLocation> found = new ArrayList<>();
        int slash = name.indexOf('/');
        if (!TextRule.NAME.isLegal(name.substring(slash + 1)) || slash >= 0
            && !TextRule.NAME.isLegal(name.substring(0, slash))) {
            throw refused(name, found);
        }
        if (slash >= 0) {
            addPart(found, name.substring(0, slash), name.substring(slash + 1));
        } else {
            addWhole(found, name);
            if (found.isEmpty()) {
                for (String robot : robots()) {
                    addPart(found, robot, name);
                }
            }
            if (found.isEmpty()) {
                addLoose(found, name);
            }
        }
        if (found.size() != 1) {
            throw refused(name, found);
        }
        return found.get(0);
    }

    /**
     * Returns whether another object has the name, case-insensitive.
     *
     * @param robot the robot of a part; null for an environment object or a robot
     */
    boolean isTaken(String name, SEARrobot robot) throws IOException {
        List<String> names = new ArrayList<>();
        if (robot == null) {
            names.addAll(wholes());
        } else {
            names.add(robot.getName());
            robot.getComponentNames().forEach(file -> names.add(file.substring(file.indexOf('/') + 1)));
            robot.getWheels().forEach(wheel -> names.add(wheel.getName()));
        }
        return names.stream().anyMatch(name::equalsIgnoreCase);
    }

    /** Returns the names of environment objects and robots, and more names. */
    List<String> wholes(String... more) throws IOException {
        List<String> names = new ArrayList<>(List.of(more));
        draft.list(false).forEach(path -> names.add(ObjectFiles.stem(path)));
        names.addAll(robots());
        return names;
    }

    /**
     * Returns a robot.
     *
     * @throws ProjectException if there is none of that name
     */
    SEARrobot robot(String name) throws IOException, ProjectException {
        SearObject object = TextRule.NAME.isLegal(name) ? draft.read(ObjectFiles.path(true, name)) : null;
        if (!(object instanceof SEARrobot)) {
            throw new ProjectException(List.of(
                new Problem("robot", 0, "to", name, robots().isEmpty() ? "the name of a robot, and there is none yet:"
                + " make one first" : "the name of a robot: " + String.join(", ", robots()))));
        }
        return (SEARrobot) object;
    }

    /** Returns the names of all robots with valid files. */
    List<String> robots() throws IOException {
        List<String> names = new ArrayList<>();
        for (String path : draft.list(true)) {
            if (draft.readIfWhole(path) instanceof SEARrobot) {
                names.add(ObjectFiles.stem(path));
            }
        }
        return names;
    }

    private void addWhole(List<ObjectLocation> found, String name) throws IOException, ProjectException {
        for (boolean part : new boolean[] {false, true}) {
            String path = ObjectFiles.path(part, name);
            SearObject object = draft.read(path);
            if (object != null && (!part || object instanceof SEARrobot)) {
                found.add(new ObjectLocation(object, path, null));
            }
        }
    }

    /** Adds an object in {@code robot/} that belongs to no robot. */
    private void addLoose(List<ObjectLocation> found, String name) throws IOException, ProjectException {
        String path = ObjectFiles.path(true, name);
        SearObject object = draft.read(path);
        if (object != null) {
            found.add(new ObjectLocation(object, path, null));
        }
    }

    private void addPart(List<ObjectLocation> found, String robotName, String name)
        throws IOException, ProjectException {
        if (!(draft.readIfWhole(ObjectFiles.path(true, robotName)) instanceof SEARrobot)) {
            return;
        }
        SEARrobot robot = robot(robotName);
        for (String file : robot.getComponentNames()) {
            if (file.substring(file.indexOf('/') + 1).equals(name)) {
                String path = ObjectFiles.path(true, file);
                SearObject object = draft.read(path);
                if (object != null) {
                    found.add(new ObjectLocation(object, path, robot));
                }
            }
        }
        for (Wheel wheel : robot.getWheels()) {
            if (wheel.getName().equals(name)) {
                found.add(new ObjectLocation(wheel, ObjectFiles.path(true, robotName), robot));
            }
        }
    }

    private static ProjectException refused(String name, List<ObjectLocation> found) {
        String legal = found.isEmpty() ? "the name of an object of the project; it may have been deleted or "
            + "renamed meanwhile" : found.stream().map(ObjectLocation::address).collect(Collectors.joining(" or "));
        return new ProjectException(List.of(new Problem("project", 0, "object", name, legal)));
    }

    /** Returns the names of all objects, in lower case. */
    private Set<String> taken() throws IOException {
        Set<String> names = new HashSet<>();
        for (boolean part : new boolean[] {false, true}) {
            for (String path : draft.list(part)) {
                names.add(ObjectFiles.stem(path).toLowerCase(Locale.ROOT));
                SearObject object = part ? draft.readIfWhole(path) : null;
                if (object instanceof SEARrobot) {
                    ((SEARrobot) object).getComponentNames().forEach(file ->
                        names.add(file.substring(file.indexOf('/') + 1).toLowerCase(Locale.ROOT)));
                    ((SEARrobot) object).getWheels()
                        .forEach(wheel -> names.add(wheel.getName().toLowerCase(Locale.ROOT)));
                }
            }
        }
        return names;
    }

    /** Returns a free name: the wanted one with the first free number, counted from a number at its end. */
    String free(String wanted) throws IOException {
        Set<String> taken = taken();
        String stem = wanted.replaceFirst("(?<=.)[0-9]{1,6}$", "");
        int number = stem.length() < wanted.length() ? Integer.parseInt(wanted.substring(stem.length())) : 1;
        while (taken.contains((stem + number).toLowerCase(Locale.ROOT))) {
            number++;
        }
        return stem + number;
    }

    /**
     * Returns the file of a new part of a robot: in {@code robot/}, or in the robot's own folder if the file exists.
     */
    String partFile(String robot, String name) throws IOException {
        return draft.has(ObjectFiles.path(true, name)) ? robot + "/" + name : name;
    }
}
