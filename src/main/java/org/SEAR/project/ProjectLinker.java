// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Assembly;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Gravity;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.PlacedObject;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SerialObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Terrain;
import org.SEAR.POJOs.Wheel;
import org.SEAR.grammar.Parameter;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.wiring.WiringCheck;
import org.SEAR.project.xml.ParsedObject;

/** Links components to their robots and checks the relations between the objects of a project. One use. */
final class ProjectLinker {
    private final Map<String, ParsedObject> environment;
    private final Map<String, ParsedObject> parts;
    private final ProblemList problems;
    private final List<String> warnings;
    private final Map<ParsedObject, SEARrobot> owners = new LinkedHashMap<>();

    ProjectLinker(Map<String, ParsedObject> environment, Map<String, ParsedObject> parts, ProblemList problems,
        List<String> warnings) {
        this.environment = environment;
        this.parts = parts;
        this.problems = problems;
        this.warnings = warnings;
    }

    void link() {
        for (ParsedObject parsed : parts.values()) {
            if (parsed.object instanceof SEARrobot) {
                linkRobot(parsed, (SEARrobot) parsed.object);
            }
        }
        for (ParsedObject parsed : parts.values()) {
            if (parsed.object instanceof Wheel) {
                warnings.add(parsed.file + ": " + parsed.object + " is on no robot and is left out; "
                    + "robot.addWheel(wheel) adds it, or a <wheel> in the robot's file");
            } else if (!parsed.isBroken() && !(parsed.object instanceof SEARrobot) && !owners.containsKey(parsed)) {
                warnings.add(parsed.file + ": " + parsed.object + " is not a component of any robot and"
                    + " is left out; robot.addComponent(...) adds it");
            }
        }
        new NameCheck(environment, parts, owners, problems).check();
        new VehicleCheck(parts, owners, problems).check();
        new WiringCheck(owners, problems).check();
        checkPorts();
        checkTerrain();
        checkGravity();
        checkPlaced();
        checkReferences();
        new JointCheck(environment, parts, owners, problems).check();
    }

    private void linkRobot(ParsedObject parsed, SEARrobot robot) {
        int index = 0;
        boolean hasDynamics = false;
        for (String name : robot.getComponentNames()) {
            int line = parsed.line("component#" + index++);
            ParsedObject part = parts.get(name);
            String own = robot.getName() + "/";
            if (name.indexOf('/') >= 0 && !name.startsWith(own)) {
                problems.add(parsed.file, line, "component", name, "a name alone for a file in robot/, or \"" + own
                    + name.substring(name.indexOf('/') + 1) + "\" for one in robot/" + own);
            } else if (part == null) {
                problems.add(parsed.file, line, "component", name, "the name of a file in robot/, without .xml");
            } else if (part.isBroken()) {
                owners.put(part, robot);
            } else if (part.object instanceof SEARrobot || part.object instanceof Wheel) {
                problems.add(parsed.file, line, "component", name, "a shape, a model, a sensor or dynamics");
            } else if (owners.containsKey(part)) {
                problems.add(parsed.file, line, "component", name, "a component that no robot has yet; "
                    + owners.get(part).getName() + " has it");
            } else if (part.object instanceof Dynamics && hasDynamics) {
                problems.add(parsed.file, line, "component", name, "only one Dynamics");
            } else {
                hasDynamics |= part.object instanceof Dynamics;
                owners.put(part, robot);
                Assembly.link(robot, (SearObject) part.object, name.startsWith(own));
            }
        }
        if (!hasDynamics) {
            warnings.add(parsed.file + ": " + robot + " has no Dynamics, and no simulation starts without; "
                + "robot.addComponent(Dynamics(name, mass)) adds one");
        }
    }

    private void checkPorts() {
        Map<String, String> seen = new HashMap<>();
        for (ParsedObject parsed : owners.keySet()) {
            if (parsed.object instanceof SerialObject) {
                SerialObject device = (SerialObject) parsed.object;
                if ((device.getUartPort() == null) != (device.getUserPort() == null)) {
                    problems.add(parsed.file, parsed.line("uartPort"), "", "one of two ports",
                        "both uartPort and userPort, or neither");
                }
                checkPort(seen, parsed, "uartPort", device.getUartPort());
                checkPort(seen, parsed, "userPort", device.getUserPort());
            }
        }
    }

    private void checkPort(Map<String, String> seen, ParsedObject parsed, String element, String port) {
        if (port == null) {
            return;
        }
        if (port.isEmpty()) {
            problems.add(parsed.file, parsed.line(element), element, port, "the name of a port");
            return;
        }
        String other = seen.putIfAbsent(port, parsed.file);
        if (other != null) {
            problems.add(parsed.file, parsed.line(element), element, port, "a port of its own; " + other
                + " has it too");
        }
    }

    private void checkTerrain() {
        String first = null;
        for (ParsedObject parsed : environment.values()) {
            String element = terrainElement(parsed.object);
            if (element != null) {
                if (first != null) {
                    problems.add(parsed.file, parsed.line(element), element, element.equals("path")
                        ? ((Terrain) parsed.object).getPath() : "true", "one terrain; " + first + " is it already");
                }
                first = parsed.file;
            }
        }
        for (ParsedObject parsed : owners.keySet()) {
            if (terrainElement(parsed.object) != null) {
                problems.add(parsed.file, parsed.line("terrain"), "terrain", "true",
                    "false for a component of a robot");
            }
        }
    }

    private void checkGravity() {
        String first = null;
        for (ParsedObject parsed : environment.values()) {
            if (parsed.object instanceof Gravity) {
                if (first != null) {
                    problems.add(parsed.file, parsed.line("acceleration"), "acceleration",
                        Parameter.format(((Gravity) parsed.object).getAcceleration()), "one gravity; " + first
                        + " is it already");
                }
                first = parsed.file;
            }
        }
    }

    /** Returns the element that makes an object the terrain; null for any other object. */
    private static String terrainElement(Object object) {
        return object instanceof Terrain ? "path" : object instanceof Model && ((Model) object).isTerrain()
            ? "terrain" : null;
    }

    /** Checks that a GPS has a geographic reference of its own or from the terrain. */
    private void checkReferences() {
        boolean terrain = environment.values().stream()
            .anyMatch(parsed -> parsed.isBroken() || parsed.object instanceof Terrain
            && !((Terrain) parsed.object).hasSize());
        for (ParsedObject parsed : owners.keySet()) {
            if (!terrain && parsed.object instanceof GPS && !((GPS) parsed.object).hasReference()) {
                problems.add(parsed.file, parsed.line("latitude"), "", parsed.object + " has no latitude, altitude "
                    + "and longitude", "all three of them, or a Terrain whose map says where on Earth the world lies");
            }
        }
    }

    /** Checks that parts of a robot have neither a place on the ground nor a velocity of their own. */
    private void checkPlaced() {
        for (ParsedObject parsed : owners.keySet()) {
            checkPlaced(parsed, parsed.object);
        }
        for (ParsedObject parsed : parts.values()) {
            if (parsed.object instanceof SEARrobot) {
                ((SEARrobot) parsed.object).getWheels().forEach(wheel -> checkPlaced(parsed, wheel));
            }
        }
    }

    private void checkPlaced(ParsedObject parsed, Object part) {
        if (part instanceof PlacedObject && ((PlacedObject) part).isOnGround()) {
            PlacedObject placed = (PlacedObject) part;
            String element = placed.hasPlaceOnEarth() ? "placeLatitude" : "onGround";
            problems.add(parsed.file, parsed.line(element), element, placed.hasPlaceOnEarth()
                ? Parameter.format(placed.getPlaceLatitude()) : "true",
                "none for " + placed + ", a part of a robot; the robot may have it");
        }
        if (part instanceof Model && ((Model) part).hasCollision() && ((Model) part).getCollision()
            .equals(Model.EXACT)) {
            problems.add(parsed.file, parsed.line("collision"), "collision", Model.EXACT, Model.MOVABLE);
        }
        if (part instanceof Shape && !(part instanceof Wheel)) {
            ((Shape) part).toFaultsOfLaunch((element, value, legal) ->
                problems.add(parsed.file, parsed.line(element), element, Parameter.format((Double) value), legal),
                "0 for " + part + ", a part of a robot, which moves with it");
        }
    }

    List<SearObject> environment() {
        List<SearObject> objects = new ArrayList<>();
        environment.values().stream().filter(p -> !p.isBroken() && !(p.object instanceof Joint))
            .forEach(p -> objects.add((SearObject) p.object));
        return objects;
    }

    List<Joint> joints() {
        List<Joint> joints = new ArrayList<>();
        environment.values().stream().filter(p -> p.object instanceof Joint).forEach(p -> joints.add((Joint) p.object));
        return joints;
    }

    /** Returns the Terrain; null if there is none. */
    ParsedObject terrain() {
        return environment.values().stream().filter(parsed -> parsed.object instanceof Terrain).findFirst()
            .orElse(null);
    }

    /** Returns the robots in the order of their creation; the parts are ordered by file name. */
    List<SEARrobot> robots() {
        List<SEARrobot> robots = new ArrayList<>();
        parts.values().stream().filter(p -> p.object instanceof SEARrobot)
            .forEach(p -> robots.add((SEARrobot) p.object));
        robots.sort(Comparator.comparing(SEARrobot::getOrder, Comparator.nullsFirst(Comparator.naturalOrder())));
        return robots;
    }

    /** Returns all valid objects of the project. */
    List<ParsedObject> all() {
        List<ParsedObject> all = new ArrayList<>(environment.values());
        parts.values().stream().filter(p -> p.object instanceof SEARrobot).forEach(all::add);
        all.addAll(owners.keySet());
        all.removeIf(ParsedObject::isBroken);
        return all;
    }
}
