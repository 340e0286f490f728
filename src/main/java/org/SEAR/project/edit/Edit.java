// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.PlacedObject;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.problems.ProjectException;

/**
 * An edit of a draft, made from a request. The draft's changed files become an {@link UndoStep}, which reverts any
 * edit. One use, guarded by the project lock.
 */
abstract class Edit {
    /** Parameters for a robot's parts, which {@code set} does not change. */
    private static final List<String> LINKS = List.of("component", "wheel");
    private static final String LEFT = " was deleted, since it needs ";

    EditRequest request;
    EditDraft draft;
    Finder finder;

    /** Changes the draft. */
    abstract EditResult apply() throws IOException, ProjectException;

    /**
     * Returns the request's name, or a free one.
     * @param robot the robot of a part; null for an environment object or a robot
     */
    String newName(String proposed, SEARrobot robot) throws IOException, ProjectException {
        String name = request.textOrNull("name");
        if (name == null || name.isEmpty()) {
            return finder.free(proposed);
        }
        checkName(name, robot);
        return name;
    }

    void checkName(String name, SEARrobot robot) throws IOException, ProjectException {
        if (!TextRule.NAME.isLegal(name)) {
            throw EditRequest.refused("name", name, TextRule.NAME.legal());
        }
        if (finder.isTaken(name, robot)) {
            throw EditRequest.refused("name", name, "a name that no other object has, case-insensitively, such as "
                + finder.free(name));
        }
    }

    /** Returns the position of a new robot in the order of the project's robots; null for the first. */
    Integer order() throws IOException, ProjectException {
        int last = 0;
        for (String robot : finder.robots()) {
            Integer order = finder.robot(robot).getOrder();
            last = Math.max(last, order == null ? 1 : order);
        }
        return last == 0 ? null : Integer.valueOf(last + 1);
    }

    /** Adds an object to the environment or a robot, without writing the object. */
    @SuppressWarnings("unchecked")
    ObjectLocation put(SearObject object, SEARrobot robot, String name) throws IOException {
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

    void write(ObjectLocation place) {
        draft.write(place.path, place.root());
    }

    /** @param was the values that the client has read */
    void set(String file, SearObject object, Map<?, ?> values, Map<?, ?> was) throws ProjectException {
        ProblemList problems = new ProblemList();
        for (Map.Entry<?, ?> value : values.entrySet()) {
            String link = String.valueOf(value.getKey());
            if (link.equals("name") || object instanceof SEARrobot && LINKS.contains(link)) {
                problems.add(file, 0, link, String.valueOf(value.getValue()),
                    "nothing here: use the edits rename, add, mount and unmount");
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
    static void standWherePut(SearObject object, Map<?, ?> values) {
        if (values.containsKey("y") && !values.containsKey("onGround")) {
            assign(object, "onGround", null);
        }
        if ((values.containsKey("x") || values.containsKey("y") || values.containsKey("z"))
            && !values.containsKey("placeLatitude")) {
            assign(object, "placeLatitude", null);
            assign(object, "placeLongitude", null);
        }
        boolean turned = values.containsKey("rx") || values.containsKey("ry") || values.containsKey("rz")
            || values.containsKey("y");
        if (object instanceof SEARrobot && turned && !values.containsKey("placeHeading")) {
            assign(object, "placeHeading", null);
        }
    }

    static Parameter parameter(Object object, String name) {
        return ParameterTable.of(object.getClass()).find(name);
    }

    static void assign(Object object, String name, Object value) {
        parameter(object, name).set(object, value);
    }

    @SuppressWarnings("unchecked")
    static List<Object> components(SEARrobot robot) {
        return (List<Object>) parameter(robot, "component").get(robot);
    }

    /** Returns the effects on other objects of an object's leaving its robot. */
    static List<String> besides(References others, ObjectLocation place, String why) {
        List<String> besides = new ArrayList<>();
        others.deleted().forEach(object ->
            besides.add(References.called(object) + why + References.called(place.object)));
        besides.addAll(others.lost());
        return besides;
    }

    /** Removes an object from its place, and its name from the other parts of its robot. */
    References leave(ObjectLocation place) throws IOException, ProjectException {
        takeAway(place);
        References others = new References(draft, place.robot);
        if (place.robot != null) {
            others.forget(place.object);
        } else {
            others.deleted().addAll(JointReferences.delete(draft, place.object.getName()));
        }
        return others;
    }

    /** Removes an object from its place. */
    @SuppressWarnings("unchecked")
    void takeAway(ObjectLocation place) throws IOException, ProjectException {
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

    /** Sets the request's parameters of an object in its place, and writes it. */
    EditResult finish(ObjectLocation place, String words, String... besides) throws ProjectException {
        set(place.path, place.object, request.values("set"), request.values("was"));
        write(place);
        return new EditResult(words, place.address(), List.of(besides));
    }

    /**
     * Moves an object to a robot.
     * @param to its name; null for the environment
     */
    EditResult move(ObjectLocation place, String to, String words) throws IOException, ProjectException {
        List<String> besides = List.of();
        if (place.robot != null && place.robot.getName().equals(to)) {
            takeAway(place);
        } else {
            besides = besides(leave(place), place, LEFT);
        }
        ObjectLocation there = put(place.object, to == null ? null : finder.robot(to), place.object.getName());
        return finish(there, words, besides.toArray(new String[0]));
    }
}
