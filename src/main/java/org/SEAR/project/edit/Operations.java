// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.POJOs.PlacedObject;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.ProjectFolder;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.problems.ProjectException;

/** The edits of a draft. One use, guarded by the project lock. */
final class Operations {
    /** Parameters for a robot's parts, which {@code set} does not change. */
    private static final List<String> LINKS = List.of("component", "wheel");
    private static final List<String> PORTS = List.of("uartPort", "userPort", "export");

    private static final String LEFT = " was deleted, since it needs ";

    private final EditDraft draft;
    private final Finder finder;

    Operations(EditDraft draft) {
        this.draft = draft;
        this.finder = new Finder(draft);
    }

    // ---- add, set ------------------------------------------------------------------------------------------------------

    /** Adds an object: {@code type}, {@code name} (or a free one), {@code to} a robot, {@code set} parameters. */
    EditResult add(EditRequest edit) throws IOException, ProjectException {
        String type = edit.text("type");
        Class<? extends SearObject> found = draft.classes().get(type);
        if (found == null) {
            throw EditRequest.refused("type", type, String.join(", ", draft.classes().keySet()));
        }
        String to = edit.textOrNull("to");
        if (to == null && !Grammar.standsInEnvironment(found) && found != SEARrobot.class) {
            throw EditRequest.refused("to", "", "the name of a robot: a " + type + " is a part of one");
        }
        if (to != null && !Grammar.standsOnRobot(found)) {
            throw EditRequest.refused("to", to, "nothing: a " + type + " can't be a part of a robot");
        }
        SEARrobot robot = to == null ? null : finder.robot(to);
        String name = newName(edit, defaultName(type), robot);
        SearObject object = (SearObject) ParameterTable.of(found).newInstance();
        Map<Object, Object> values = new HashMap<>();
        for (Parameter parameter : ParameterTable.of(found).getParameters()) {
            if (!parameter.getInitial().isEmpty()) {
                values.put(parameter.getName(), parameter.getInitial());
            }
        }
        values.putAll(edit.values("set"));
        assign(object, "name", name);
        if (object instanceof SEARrobot) {
            assign(object, "order", order());
        }
        ObjectLocation place = put(object, robot, name);
        set(place.path, object, values, Map.of());
        write(place);
        return new EditResult("add " + name, place.address());
    }

    /** Returns the default name of a class: box, lidar, robot. */
    private static String defaultName(String type) {
        String plain = type.startsWith("SEAR") ? type.substring(4) : type;
        boolean capitals = plain.equals(plain.toUpperCase(Locale.ROOT));
        return capitals ? plain.toLowerCase(Locale.ROOT) : Character.toLowerCase(plain.charAt(0)) + plain.substring(1);
    }

    /** @param robot the robot of a part; null for an environment object or a robot */
    private String newName(EditRequest edit, String proposed, SEARrobot robot) throws IOException, ProjectException {
        String name = edit.textOrNull("name");
        if (name == null || name.isEmpty()) {
            return finder.free(proposed);
        }
        checkName(name, robot);
        return name;
    }

    private void checkName(String name, SEARrobot robot) throws IOException, ProjectException {
        if (!TextRule.NAME.isLegal(name)) {
            throw EditRequest.refused("name", name, TextRule.NAME.legal());
        }
        if (finder.isTaken(name, robot)) {
            throw EditRequest.refused("name", name, "a name that no other object has, case-insensitively, such as " + finder.free(name));
        }
    }

    /** Returns the position of a new robot in the order of the project's robots; null for the first. */
    private Integer order() throws IOException, ProjectException {
        int last = 0;
        for (String robot : finder.robots()) {
            Integer order = finder.robot(robot).getOrder();
            last = Math.max(last, order == null ? 1 : order);
        }
        return last == 0 ? null : Integer.valueOf(last + 1);
    }

    /** Adds an object to the environment or a robot, without writing the object. */
    @SuppressWarnings("unchecked")
    private ObjectLocation put(SearObject object, SEARrobot robot, String name) throws IOException {
        if (robot == null) {
            return new ObjectLocation(object, ObjectFiles.path(object instanceof SEARrobot, name), null);
        }
        if (object instanceof Wheel) {
            ((List<Object>) parameter(robot, "wheel").get(robot)).add(object);
            return new ObjectLocation(object, ObjectFiles.path(true, robot.getName()), robot);
        }
        String file = finder.partFile(robot.getName(), name);
        components(robot).add(file);
        draft.write(ObjectFiles.path(true, robot.getName()), robot);
        return new ObjectLocation(object, ObjectFiles.path(true, file), robot);
    }

    private void write(ObjectLocation place) {
        draft.write(place.path, place.root());
    }

    /** Sets parameters: {@code object}, {@code set} parameters, {@code was} the values that the client has read. */
    EditResult set(EditRequest edit) throws IOException, ProjectException {
        ObjectLocation place = finder.find(edit.text("object"));
        Map<?, ?> values = edit.values("set");
        set(place.path, place.object, values, edit.values("was"));
        write(place);
        return new EditResult(words(values) + place.object.getName(), place.address());
    }

    private static String words(Map<?, ?> values) {
        String names = values.keySet().stream().map(String::valueOf).sorted().collect(Collectors.joining(", "));
        return names.matches("[xyz, ]+") ? "move " : names.matches("(r[xyz]|, )+") ? "turn " : "change " + names + " of ";
    }

    private void set(String file, SearObject object, Map<?, ?> values, Map<?, ?> was) throws ProjectException {
        ProblemList problems = new ProblemList();
        for (Map.Entry<?, ?> value : values.entrySet()) {
            String link = String.valueOf(value.getKey());
            if (link.equals("name") || object instanceof SEARrobot && LINKS.contains(link)) {
                problems.add(file, 0, link, String.valueOf(value.getValue()), "nothing here: use the edits rename, add, mount and unmount");
            }
        }
        EditValues setting = new EditValues(file, problems);
        setting.refuseStale(object, values, was);
        setting.set(object, values, "");
        problems.throwIfAny();
        if (object instanceof PlacedObject) {
            standWherePut(object, values);
        }
    }

    /**
     * Clears the placement on the ground like the scripts' calls move and rotate: an object with a new height is not
     * placed on the ground.
     */
    private static void standWherePut(SearObject object, Map<?, ?> values) {
        if (values.containsKey("y") && !values.containsKey("onGround")) {
            assign(object, "onGround", null);
        }
        if ((values.containsKey("x") || values.containsKey("y") || values.containsKey("z")) && !values.containsKey("placeLatitude")) {
            assign(object, "placeLatitude", null);
            assign(object, "placeLongitude", null);
        }
        boolean turned = values.containsKey("rx") || values.containsKey("ry") || values.containsKey("rz") || values.containsKey("y");
        if (object instanceof SEARrobot && turned && !values.containsKey("placeHeading")) {
            assign(object, "placeHeading", null);
        }
    }

    private static Parameter parameter(Object object, String name) {
        return ParameterTable.of(object.getClass()).find(name);
    }

    private static void assign(Object object, String name, Object value) {
        parameter(object, name).set(object, value);
    }

    @SuppressWarnings("unchecked")
    private static List<Object> components(SEARrobot robot) {
        return (List<Object>) parameter(robot, "component").get(robot);
    }

    /** Adds a ready robot: {@code template}, {@code name} (or a free one), {@code set} parameters of the robot. */
    EditResult robot(EditRequest edit) throws IOException, ProjectException {
        String template = edit.text("template");
        String name = newName(edit, template, null);
        Integer order = order();
        SEARrobot robot = RobotTemplates.make(template, name, finder.wholes(name));
        assign(robot, "order", order);
        for (SearObject part : robot.getComponents()) {
            String file = finder.partFile(name, part.getName());
            components(robot).set(robot.getComponentNames().indexOf(part.getName()), file);
            draft.write(ObjectFiles.path(true, file), part);
        }
        ObjectLocation place = new ObjectLocation(robot, ObjectFiles.path(true, name), null);
        set(place.path, robot, edit.values("set"), Map.of());
        write(place);
        return new EditResult("add " + name, name);
    }

    // ---- rename, delete, duplicate -----------------------------------------------------------------------------------------

    /** Renames an object: {@code object}, {@code name}. */
    EditResult rename(EditRequest edit) throws IOException, ProjectException {
        ObjectLocation place = finder.find(edit.text("object"));
        String old = place.object.getName();
        String name = edit.text("name");
        if (!name.equalsIgnoreCase(old)) {
            checkName(name, place.robot);
        }
        assign(place.object, "name", name);
        if (place.isWheel()) {
            write(place);
        } else if (place.robot != null) {
            String stem = ObjectFiles.stem(place.path);
            draft.delete(place.path);
            String file = stem.contains("/") ? place.robot.getName() + "/" + name : finder.partFile(place.robot.getName(), name);
            components(place.robot).set(place.robot.getComponentNames().indexOf(stem), file);
            draft.write(ObjectFiles.path(true, file), place.object);
            draft.write(place.robotPath(), place.robot);
        } else {
            draft.delete(place.path);
            if (place.object instanceof SEARrobot) {
                moveOwnFolder((SEARrobot) place.object, old);
            }
            draft.write(ObjectFiles.path(place.path.startsWith(ProjectFolder.ROBOT + "/"), name), place.object);
        }
        if (place.robot != null) {
            new References(draft, place.robot).follow(place.object, old);
        }
        return new EditResult("rename " + old + " to " + name, place.address());
    }

    /** Moves the parts in a robot's own folder when the robot is renamed. */
    private void moveOwnFolder(SEARrobot robot, String old) throws IOException, ProjectException {
        for (String file : List.copyOf(robot.getComponentNames())) {
            if (file.startsWith(old + "/")) {
                String moved = robot.getName() + file.substring(old.length());
                SearObject part = draft.read(ObjectFiles.path(true, file));
                if (part != null) {
                    draft.write(ObjectFiles.path(true, moved), part);
                    draft.delete(ObjectFiles.path(true, file));
                }
                components(robot).set(robot.getComponentNames().indexOf(file), moved);
            }
        }
    }

    /** Deletes an {@code object}; a robot with all of its parts, a part with the parts that need it. */
    EditResult delete(EditRequest edit) throws IOException, ProjectException {
        ObjectLocation place = finder.find(edit.text("object"));
        References others = leave(place);
        if (place.object instanceof SEARrobot) {
            ((SEARrobot) place.object).getComponentNames().forEach(file -> draft.delete(ObjectFiles.path(true, file)));
        }
        int also = others.deleted().size();
        String with = also == 0 ? "" : " with " + (also == 1 ? References.called(others.deleted().get(0)) : also + " more");
        return new EditResult("delete " + place.object.getName() + with, null, besides(others, place, " was deleted with "));
    }

    /** Returns the effects on other objects of an object's leaving its robot. */
    private static List<String> besides(References others, ObjectLocation place, String why) {
        List<String> besides = new ArrayList<>();
        others.deleted().forEach(object -> besides.add(References.called(object) + why + References.called(place.object)));
        besides.addAll(others.lost());
        return besides;
    }

    /** Removes an object from its place, and its name from the other parts of its robot. */
    private References leave(ObjectLocation place) throws IOException, ProjectException {
        takeAway(place);
        References others = new References(draft, place.robot);
        if (place.robot != null) {
            others.forget(place.object);
        }
        return others;
    }

    /** Removes an object from its place. */
    @SuppressWarnings("unchecked")
    private void takeAway(ObjectLocation place) throws IOException, ProjectException {
        if (place.isWheel()) {
            ((List<Object>) parameter(place.robot, "wheel").get(place.robot)).remove(place.object);
        } else {
            draft.delete(place.path);
        }
        if (place.robot != null) {
            String file = ObjectFiles.stem(place.path);
            components(place.robot).removeIf(name -> !place.isWheel() && name.equals(file));
            draft.write(place.robotPath(), place.robot);
        }
    }

    /**
     * Duplicates an object: {@code object}, {@code name} (or a free one), {@code set} parameters of the copy. The copy
     * has no ports, since ports belong to one device.
     */
    EditResult duplicate(EditRequest edit) throws IOException, ProjectException {
        ObjectLocation place = finder.find(edit.text("object"));
        String old = place.object.getName();
        String name = newName(edit, old, place.robot);
        SearObject copy = copy(place);
        assign(copy, "name", name);
        clearPorts(copy);
        if (copy instanceof SEARrobot) {
            assign(copy, "order", order());
            copyParts((SEARrobot) copy, name);
        }
        ObjectLocation to = put(copy, place.robot, name);
        set(to.path, copy, edit.values("set"), Map.of());
        write(to);
        return new EditResult("duplicate " + old, to.address());
    }

    /** Returns a copy of the object. */
    private SearObject copy(ObjectLocation place) throws IOException, ProjectException {
        if (place.isWheel()) {
            SEARrobot again = (SEARrobot) draft.read(place.path);
            return again.getWheels().get(place.robot.getWheels().indexOf(place.object));
        }
        return draft.read(place.path);
    }

    private void copyParts(SEARrobot robot, String name) throws IOException, ProjectException {
        for (String file : List.copyOf(robot.getComponentNames())) {
            SearObject part = draft.read(ObjectFiles.path(true, file));
            if (part != null) {
                clearPorts(part);
                String own = name + "/" + part.getName();
                draft.write(ObjectFiles.path(true, own), part);
                components(robot).set(robot.getComponentNames().indexOf(file), own);
            }
        }
    }

    private static void clearPorts(SearObject object) {
        for (String port : PORTS) {
            if (parameter(object, port) != null) {
                assign(object, port, null);
            }
        }
    }

    // ---- mount, unmount ------------------------------------------------------------------------------------------------

    /** Mounts an object: {@code object}, {@code to} a robot, {@code set} parameters in the robot's frame. */
    EditResult mount(EditRequest edit) throws IOException, ProjectException {
        ObjectLocation place = finder.find(edit.text("object"));
        String to = edit.text("to");
        if (!Grammar.standsOnRobot(place.object.getClass())) {
            throw EditRequest.refused("to", to, "nothing: a " + place.object.getClass().getSimpleName() + " can't be a part of a robot");
        }
        List<String> besides = List.of();
        if (place.robot != null && place.robot.getName().equals(to)) {
            takeAway(place);
        } else {
            besides = besides(leave(place), place, LEFT);
        }
        ObjectLocation there = put(place.object, finder.robot(to), place.object.getName());
        if (place.object instanceof PlacedObject) {
            standWherePut(place.object, Map.of("y", ""));
        }
        set(there.path, place.object, edit.values("set"), Map.of());
        write(there);
        return new EditResult("mount " + place.object.getName() + " on " + to, there.address(), besides);
    }

    /** Unmounts a shape: {@code object}, {@code set} parameters in the world frame. */
    EditResult unmount(EditRequest edit) throws IOException, ProjectException {
        ObjectLocation place = finder.find(edit.text("object"));
        if (place.robot == null) {
            throw EditRequest.refused("object", place.address(), "a part of a robot");
        }
        if (!Grammar.standsInEnvironment(place.object.getClass())) {
            throw EditRequest.refused("object", place.address(), "a shape: a " + place.object.getClass().getSimpleName()
                + " can't stand in the world without a robot; mount it on another one, or delete it");
        }
        List<String> besides = besides(leave(place), place, LEFT);
        ObjectLocation there = put(place.object, null, place.object.getName());
        set(there.path, place.object, edit.values("set"), Map.of());
        write(there);
        return new EditResult("take " + place.object.getName() + " off " + place.robot.getName(), there.address(), besides);
    }
}
