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

/** Finds the objects of a project by what edits call them: {@code crate}, {@code rover}, {@code rover/ping}. Whoever holds the project's lock. */
final class Finder {
    private final EditDraft draft;

    Finder(EditDraft draft) {
        this.draft = draft;
    }

    /**
     * An object.
     *
     * @param name of a thing of the environment or a robot; of a part with its robot's before it, or alone where only one has a part of that name
     * @throws ProjectException that says what there is
     */
    ObjectLocation find(String name) throws IOException, ProjectException {
        List<ObjectLocation> found = new ArrayList<>();
        int slash = name.indexOf('/');
        if (!TextRule.NAME.isLegal(name.substring(slash + 1)) || slash >= 0 && !TextRule.NAME.isLegal(name.substring(0, slash))) {
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
     * Whether a name is that of another object, or differs from it only by capitals, so that it can't be had.
     *
     * @param robot whose part is to have it; null for a thing of the environment and a robot
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

    /** The names of what is no robot's part, and more. */
    List<String> wholes(String... more) throws IOException {
        List<String> names = new ArrayList<>(List.of(more));
        draft.list(false).forEach(path -> names.add(ObjectFiles.stem(path)));
        names.addAll(robots());
        return names;
    }

    /**
     * A robot.
     *
     * @throws ProjectException if there is none of that name
     */
    SEARrobot robot(String name) throws IOException, ProjectException {
        SearObject object = TextRule.NAME.isLegal(name) ? draft.read(ObjectFiles.path(true, name)) : null;
        if (!(object instanceof SEARrobot)) {
            throw new ProjectException(List.of(new Problem("robot", 0, "to", name, robots().isEmpty() ? "the name of a robot, and there is none yet:"
                + " make one first" : "the name of a robot: " + String.join(", ", robots()))));
        }
        return (SEARrobot) object;
    }

    /** Names of all robots whose files can be read. */
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

    /** What lies in {@code robot/} and is no robot's. */
    private void addLoose(List<ObjectLocation> found, String name) throws IOException, ProjectException {
        String path = ObjectFiles.path(true, name);
        SearObject object = draft.read(path);
        if (object != null) {
            found.add(new ObjectLocation(object, path, null));
        }
    }

    private void addPart(List<ObjectLocation> found, String robotName, String name) throws IOException, ProjectException {
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
        String legal = found.isEmpty() ? "the name of an object of the project; it may have been deleted or renamed meanwhile"
            : found.stream().map(ObjectLocation::address).collect(Collectors.joining(" or "));
        return new ProjectException(List.of(new Problem("project", 0, "object", name, legal)));
    }

    /** The names of everything, in small letters. */
    private Set<String> taken() throws IOException {
        Set<String> names = new HashSet<>();
        for (boolean part : new boolean[] {false, true}) {
            for (String path : draft.list(part)) {
                names.add(ObjectFiles.stem(path).toLowerCase(Locale.ROOT));
                SearObject object = part ? draft.readIfWhole(path) : null;
                if (object instanceof SEARrobot) {
                    ((SEARrobot) object).getComponentNames().forEach(file ->
                        names.add(file.substring(file.indexOf('/') + 1).toLowerCase(Locale.ROOT)));
                    ((SEARrobot) object).getWheels().forEach(wheel -> names.add(wheel.getName().toLowerCase(Locale.ROOT)));
                }
            }
        }
        return names;
    }

    /** A name that nothing has: the wanted one with the first number that makes it new, counted on from a number that it ends in. */
    String free(String wanted) throws IOException {
        Set<String> taken = taken();
        String stem = wanted.replaceFirst("(?<=.)[0-9]{1,6}$", "");
        int number = stem.length() < wanted.length() ? Integer.parseInt(wanted.substring(stem.length())) : 1;
        while (taken.contains((stem + number).toLowerCase(Locale.ROOT))) {
            number++;
        }
        return stem + number;
    }

    /** The file of a new part of a robot: in {@code robot/}, or in the robot's own folder if another has that name. */
    String partFile(String robot, String name) throws IOException {
        return draft.has(ObjectFiles.path(true, name)) ? robot + "/" + name : name;
    }
}
