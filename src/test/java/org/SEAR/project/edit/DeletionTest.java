// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.xml.ObjectClasses;
import org.junit.Test;

/** Deleting an object removes all references to it, and one undo restores every byte. */
public class DeletionTest extends EditedProject {
    private void add(String type, String name, Object... set) throws Exception {
        edit("do", "add", "type", type, "name", name, "to", "rover", "set", map(set));
    }

    private static Map<String, Object> wire(String pin, String part, String role) {
        return map("pin", pin, "part", part, "role", role);
    }

    // ---- every kind of reference
    // -------------------------------------------------------------------------------------------

    /** A robot with a reference, the object to delete and the expected message. */
    private static final class Case {
        final String object;
        final String note;
        final Making making;

        Case(String object, String note, Making making) {
            this.object = object;
            this.note = note;
            this.making = making;
        }
    }

    private interface Making {
        void make() throws Exception;
    }

    /** Returns the cases by class and parameter of the reference: {@code Arduino.wire.part}. */
    private Map<String, Case> cases() {
        Map<String, Case> cases = new TreeMap<>();
        cases.put("SEARrobot.component", new Case("ping", null, () -> add("Distance", "ping", "beam", "laser")));
        cases.put("Motor.wheel", new Case("left", "motor leftMotor was deleted with wheel left; Undo brings back both",
            () -> { }));
        cases.put("Servo.part", new Case("ping", "servo pan lost its part ping; Undo brings back both", () -> {
            add("Distance", "ping", "beam", "laser");
            add("Compass", "north");
            add("Servo", "pan", "part", List.of("ping", "north"));
        }));
        cases.put("Bumper.part", new Case("bar", "bumper touch lost its part bar; Undo brings back both", () -> {
            add("Box", "bar", "length", 0.2, "width", 0.02, "height", 0.02);
            add("Bumper", "touch", "part", "bar");
        }));
        cases.put("ContactForce.part",
            new Case("bar", "contactforce press lost its part bar; Undo brings back both", () -> {
            add("Box", "bar", "length", 0.2, "width", 0.02, "height", 0.02);
            add("ContactForce", "press", "part", "bar");
        }));
        cases.put("Arduino.wire.part",
            new Case("ping", "arduino uno lost its wire to ping; Undo brings back both", () -> {
            add("Distance", "ping", "beam", "laser");
            add("Led", "lamp");
            add("Arduino", "uno", "wire", List.of(wire("7", "ping", "ping"), wire("8", "lamp", "light")));
        }));
        for (String type : List.of("Hinge", "Slider", "Rope", "BallJoint", "FixedJoint")) {
            addJoint(cases, type);
        }
        cases.put("ForceTorque.joint", new Case("elbow", "forcetorque scale was deleted with hinge elbow; Undo brings "
            + "back both", () -> {
            arm("Hinge");
            add("ForceTorque", "scale", "joint", "elbow");
        }));
        cases.put("Motor.joint", new Case("elbow", "motor winch was deleted with hinge elbow; Undo brings back both",
            () -> {
            arm("Hinge");
            add("Motor", "winch", "joint", "elbow");
        }));
        cases.put("SEARrobot.wheel.steeringServo", steering());
        cases.put("Wheel.steeringServo", steering());
        return cases;
    }

    private void arm(String type) throws Exception {
        add("Box", "arm", "length", 0.2, "width", 0.02, "height", 0.02);
        add("Box", "hand", "length", 0.2, "width", 0.02, "height", 0.02);
        add("Distance", "ping", "beam", "laser");
        add("Hinge", "shoulder", "second", "arm");
        add(type, "elbow", "first", "arm", "second", "hand", "part", List.of("ping"));
    }

    private void addJoint(Map<String, Case> cases, String type) {
        String elbow = type.toLowerCase(Locale.ROOT) + " elbow";
        cases.put(type + ".second", new Case("hand", elbow + " was deleted with box hand; Undo brings back both",
            () -> arm(type)));
        cases.put(type + ".first", new Case("arm", "hinge shoulder was deleted with box arm; " + elbow
            + " was deleted with box arm; Undo brings back all of it", () -> arm(type)));
        cases.put(type + ".part", new Case("ping", elbow + " lost its part ping; Undo brings back both",
            () -> arm(type)));
        if (!type.endsWith("Joint")) {
            cases.put(type + ".gear", new Case("shoulder", elbow + " lost its gear shoulder; Undo brings back both",
                () -> {
                arm(type);
                edit("do", "set", "object", "rover/elbow", "set", map("gear", "shoulder"));
            }));
        }
    }

    private Case steering() {
        return new Case("steer", "wheel left lost its steeringServo steer; Undo brings back both", () -> {
            add("Servo", "steer");
            add("Wheel", "back", "radius", 0.05, "width", 0.02, "type", 2, "x", 0.1, "z", -0.2);
            edit("do", "delete", "object", "rover/leftMotor");
            edit("do", "set", "object", "rover/left", "set", map("steeringServo", "steer", "type", 2, "z", 0.2));
        });
    }

    /** Adds the parameters of an object or group that refer to parts. */
    private static void addReferences(TreeSet<String> found, TreeSet<String> unknown, List<Object> all, Class<?> type,
        String path) {
        for (Parameter parameter : ParameterTable.of(type).getParameters()) {
            String name = path + "." + parameter.getName();
            if (parameter.getKind() == Parameter.Kind.GROUP) {
                addReferences(found, unknown, all, parameter.getType(), name);
            } else if (parameter.getTextRule() == TextRule.COMPONENT || all.stream().anyMatch(parameter::isNameOf)) {
                found.add(name);
            } else if (parameter.getTextRule() == TextRule.NAME && !parameter.getName().equals("name")) {
                unknown.add(name);
            }
        }
    }

    @Test
    public void everyKindOfReferenceOfTheGrammarHasACase() {
        List<Object> all = new ArrayList<>();
        for (Class<? extends SearObject> type : ObjectClasses.find().all()) {
            all.add(ParameterTable.of(type).newInstance());
        }
        TreeSet<String> found = new TreeSet<>();
        TreeSet<String> unknown = new TreeSet<>();
        for (Class<? extends SearObject> type : ObjectClasses.find().all()) {
            addReferences(found, unknown, all, type, type.getSimpleName());
        }
        assertEquals("beams and machines are no objects; other parameters that name something say so in their @Param",
            "[Distance.beam, SEARrobot.machine]", unknown.toString());
        assertEquals(new TreeSet<>(cases().keySet()), found);
    }

    @Test
    public void referencedObjectsCanBeDeletedAndOneUndoRestoresEveryByte() throws Exception {
        for (Map.Entry<String, Case> entry : cases().entrySet()) {
            Case one = entry.getValue();
            edit("do", "robot", "template", "rover", "name", "rover");
            one.making.make();
            project.put("robot/rover.xml", project.text("robot/rover.xml") + "<!-- by hand -->\n");
            Map<String, String> before = objects();
            Outcome outcome = edit("do", "delete", "object", "rover/" + one.object);
            Map<String, String> after = objects();
            assertEquals(entry.getKey(), one.note, outcome.note);
            assertEquals(entry.getKey(), 1, Project.read(project.folder()).getRobots().size());
            after.forEach((file, text) -> assertFalse(entry.getKey() + " in " + file,
                text.contains(">" + one.object + "<")));
            editor.undo();
            assertEquals(entry.getKey(), before, objects());
            editor.redo();
            assertEquals(entry.getKey(), after, objects());
            edit("do", "delete", "object", "rover");
            assertEquals(entry.getKey(), Map.of(), objects());
        }
    }

    // ---- what goes and what stays
    // -------------------------------------------------------------------------------------------

    @Test
    public void aMotorStaysWhileItTurnsAnotherWheel() throws Exception {
        edit("do", "robot", "template", "car", "name", "rover");
        assertEquals("motor engine lost its wheel rearLeft; Undo brings back both",
            edit("do", "delete", "object", "rearLeft").note);
        assertEquals(List.of("rearRight"), value("rover/engine", "wheel"));
        String refused = assertThrows(ProjectException.class, () -> edit("do", "delete", "object", "rearRight"))
            .getMessage();
        assertTrue(refused, refused.contains("legal: a steered wheel in front of or behind the axle of those that "
            + "aren't steered"));
    }

    @Test
    public void objectsDeletedWithAPartAreForgotten() throws Exception {
        edit("do", "robot", "template", "rover", "name", "rover");
        add("Distance", "ping", "beam", "laser");
        add("Arduino", "uno", "wire", List.of(wire("5", "leftMotor", "pwm"), wire("6", "leftMotor", "reverse"),
            wire("7", "ping", "ping")));
        Map<String, String> before = objects();
        Outcome outcome = edit("do", "delete", "object", "left");
        assertEquals("delete left with motor leftMotor", outcome.words);
        assertEquals("motor leftMotor was deleted with wheel left; arduino uno lost its wire to leftMotor; Undo brings "
            + "back all of it", outcome.note);
        assertEquals(List.of(wire("7", "ping", "ping")), value("rover/uno", "wire"));
        assertThrows(ProjectException.class, () -> editor.object("rover/leftMotor"));
        editor.undo();
        assertEquals(before, objects());
    }

    @Test
    public void partsOfADeletedServoKeepTheirPose() throws Exception {
        edit("do", "robot", "template", "rover", "name", "rover");
        add("Distance", "ping", "beam", "laser", "y", 0.2);
        add("Servo", "pan", "part", List.of("ping"));
        String ping = project.text("robot/ping.xml");
        assertNull("nobody names it", edit("do", "delete", "object", "pan").note);
        assertEquals(ping, project.text("robot/ping.xml"));
    }

    @Test
    public void aPartThatLeavesItsRobotIsForgottenThere() throws Exception {
        edit("do", "robot", "template", "rover", "name", "rover");
        add("Box", "bar", "length", 0.2, "width", 0.02, "height", 0.02);
        add("Bumper", "touch", "part", "bar");
        edit("do", "mount", "object", "bar", "to", "rover");
        assertEquals("mounted where it is, it is the bumper's still", "bar", value("rover/touch", "part"));
        Map<String, String> before = objects();
        assertEquals("bumper touch lost its part bar; Undo brings back both",
            edit("do", "unmount", "object", "rover/bar").note);
        assertNull(value("rover/touch", "part"));
        editor.undo();
        assertEquals(before, objects());
        edit("do", "robot", "template", "fourWheeled", "name", "other");
        assertEquals("motor leftMotor was deleted, since it needs wheel left; Undo brings back both",
            edit("do", "mount", "object", "rover/left", "to", "other", "set", map("x", 0.3)).note);
    }

    @Test
    public void aRobotOfTheSameNamesKeepsItsOwn() throws Exception {
        edit("do", "robot", "template", "rover", "name", "rover");
        edit("do", "duplicate", "object", "rover", "name", "twin", "set", map("x", 2));
        Map<String, String> before = objects();
        edit("do", "delete", "object", "twin/left");
        assertEquals(List.of("left"), value("rover/leftMotor", "wheel"));
        assertThrows(ProjectException.class, () -> editor.object("twin/leftMotor"));
        editor.undo();
        assertEquals(before, objects());
    }

    @Test
    public void everyPartOfEveryTemplateCanBeDeleted() throws Exception {
        for (String template : RobotTemplates.names()) {
            edit("do", "robot", "template", template, "name", "rover");
            SEARrobot robot = Project.read(project.folder()).getRobots().get(0);
            List<SearObject> parts = new ArrayList<>(robot.getComponents());
            parts.addAll(robot.getWheels());
            assertTrue(template, template.equals("chassis") ? parts.size() == 2 : parts.size() > 3);
            Map<String, String> before = objects();
            for (SearObject part : parts) {
                edit("do", "delete", "object", "rover/" + part.getName());
                Project.read(project.folder());
                editor.undo();
                assertEquals(template + " without " + part, before, objects());
            }
            edit("do", "delete", "object", "rover");
        }
    }

    // ---- with others
    // ---------------------------------------------------------------------------------------------------------

    @Test
    public void changesOfAnotherPageAndByHandAreNotLost() throws Exception {
        edit("do", "robot", "template", "rover", "name", "rover");
        ProjectEditor other = new ProjectEditor(project.folder());
        other.apply(map("do", "set", "object", "rover/leftMotor", "set", map("gearRatio", 3)));
        project.put("robot/rightMotor.xml", project.text("robot/rightMotor.xml") + "<!-- by hand -->\n");
        Map<String, String> before = objects();
        edit("do", "delete", "object", "rover/left");
        String refused = assertThrows(ProjectException.class, () -> other.apply(
            map("do", "set", "object", "rover/leftMotor", "set", map("gearRatio", 4), "was", map("gearRatio", "3"))))
            .getMessage();
        assertTrue(refused, refused.contains("it may have been deleted or renamed meanwhile"));
        other.apply(map("do", "set", "object", "rover/rightMotor", "set", map("gearRatio", 5)));
        assertEquals("change gearRatio of rightMotor", other.undo().words);
        assertEquals("delete left with motor leftMotor", editor.undo().words);
        assertEquals(before, objects());
        assertEquals("3", value("rover/leftMotor", "gearRatio"));
    }

    @Test
    public void severalDeletionsReportAllDependentDeletions() throws Exception {
        edit("do", "robot", "template", "rover", "name", "rover");
        Map<String, String> before = objects();
        Outcome outcome = edit("do", "all", "edits",
            List.of(map("do", "delete", "object", "rover/left"), map("do", "delete", "object", "rover/right")));
        assertEquals("motor leftMotor was deleted with wheel left; motor rightMotor was deleted with wheel right; Undo "
            + "brings back all of it", outcome.note);
        editor.undo();
        assertEquals(before, objects());
    }
}
