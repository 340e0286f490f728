// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.edit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.problems.ProjectException;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;

/** Edits do what scripts do, reject what files may not have, and can all be undone. */
public class ProjectEditorTest extends EditedProject {
    private String refusal(Object... pairs) {
        return assertThrows(ProjectException.class, () -> edit(pairs)).getMessage();
    }

    // ---- like scripts
    // ------------------------------------------------------------------------------------------------------

    /** An object that a script still holds can't recreate a renamed or deleted object under its old name. */
    @Test
    public void deletedObjectsStayDeleted() throws Exception {
        Box crate = new Box("crate", 1, 1, 1, 1);
        SEARrobot rover = Robots.rover("rover");
        edit("do", "rename", "object", "crate", "name", "chest");
        edit("do", "delete", "object", "rover");
        Map<String, String> before = objects();
        for (ThrowingRunnable change : List.<ThrowingRunnable>of(() -> crate.move(0, 1, 0), () -> crate.setMass(2),
            () -> rover.move(0, 1, 0), () -> rover.getWheels().get(0).setRollers(45))) {
            String said = assertThrows(IllegalStateException.class, change).getMessage();
            assertTrue(said, said.matches("(Box \"crate\"|SEARrobot \"rover\"|Wheel \".*\") is not in the project: "
                + "since this object was created it"
                + " was deleted or renamed there, or another project was opened; sear\\.edit.*"));
        }
        assertEquals(before, objects());
    }

    @Test
    public void editsWriteTheFilesOfAScript() throws Exception {
        Box crate = new Box("crate", 0.5, 0.4, 0.3, 2);
        crate.move(1, 0.15, -2);
        crate.setColor("red");
        SEARrobot robot = Robots.create2("rosie");
        robot.move(1, 0, 2);
        robot.addComponent(new Distance("ping", "PING)))", 0, 0.1, 0.17, 0, 15, 0));
        robot.addComponent(new Compass("compass"));
        Map<String, String> script = project.files();
        ProjectSwap.delete(project.folder());
        edit("do", "add", "type", "Box", "name", "crate", "set",
            map("length", 0.5, "width", "0.4", "height", 0.3, "mass", 2, "x", 1));
        edit("do", "set", "object", "crate", "set", map("y", 0.15, "z", -2, "color", "red"));
        edit("do", "robot", "template", "create2", "name", "rosie");
        edit("do", "set", "object", "rosie", "set", map("x", 1, "z", 2));
        edit("do", "add", "type", "Distance", "name", "ping", "to", "rosie", "set",
            map("beam", "PING)))", "y", 0.1, "z", 0.17, "ry", 15));
        edit("do", "add", "type", "Compass", "name", "compass", "to", "rosie");
        assertEquals(script, objects());
        Project.read(project.folder());
    }

    @Test
    public void namesAreProposedAndPartsAreFoundWithAndWithoutTheirRobot() throws Exception {
        assertEquals("box1", edit("do", "add", "type", "Box").object);
        assertEquals("box2", edit("do", "add", "type", "Box").object);
        assertEquals("create1", edit("do", "robot", "template", "create").object);
        assertEquals("create1/lidar1", edit("do", "add", "type", "LIDAR", "to", "create1").object);
        assertEquals("create2", edit("do", "duplicate", "object", "create1").object);
        assertEquals("create2/lidar1", editor.object("create2/lidar1").get("object"));
        assertEquals("LIDAR", editor.object("create1/lidar1").get("type"));
        assertTrue(assertThrows(ProjectException.class, () -> editor.object("lidar1")).getMessage()
            .contains("create1/lidar1 or create2/lidar1"));
        assertEquals("2", value("create2", "order"));
        Project.read(project.folder());
    }

    @Test
    public void renamingTakesFilesAndReferencesAlong() throws Exception {
        edit("do", "robot", "template", "create", "name", "a");
        edit("do", "robot", "template", "create", "name", "b");
        edit("do", "add", "type", "Compass", "name", "north", "to", "b");
        edit("do", "rename", "object", "b", "name", "bee");
        edit("do", "rename", "object", "bee/north", "name", "needle");
        edit("do", "rename", "object", "bee/left", "name", "port");
        edit("do", "rename", "object", "bee/body", "name", "hull");
        assertEquals("Wheel", editor.object("bee/port").get("type"));
        assertEquals("robot/bee/hull.xml", editor.object("bee/hull").get("file"));
        Project read = Project.read(project.folder());
        assertEquals(2, read.getRobots().size());
        assertEquals(3, read.getRobots().get(1).getComponents().size());
        assertTrue(read.getWarnings().toString(), read.getWarnings().isEmpty());
        assertFalse(Files.exists(project.folder().resolve("robot/b")));
    }

    @Test
    public void referencesFollowARenamedPartInTheSameStep() throws Exception {
        for (String robot : List.of("rover", "other")) {
            edit("do", "robot", "template", "create", "name", robot);
            edit("do", "add", "type", "Motor", "name", "engine", "to", robot, "set",
                map("wheel", List.of("right", "left")));
            edit("do", "add", "type", "Distance", "name", "eye", "to", robot);
            edit("do", "add", "type", "Servo", "name", "neck", "to", robot, "set", map("part", List.of("eye")));
            edit("do", "add", "type", "Servo", "name", "helm", "to", robot);
            edit("do", "add", "type", "Bumper", "name", "touch", "to", robot, "set", map("part", "body"));
            edit("do", "add", "type", "Wheel", "name", "fifth", "to", robot, "set",
                map("type", 2, "z", 0.3, "steeringServo", "helm"));
            edit("do", "add", "type", "Arduino", "name", "board", "to", robot, "set", map("wire", List.of(
                map("pin", 7, "part", "eye", "role", "ping"), map("pin", 9, "part", "neck", "role", "servo"),
                map("pin", 5, "part", "engine", "role", "pwm"))));
        }
        Map<String, String> before = objects();
        List<String> renamed = List.of("left", "port", "eye", "sonar", "neck", "pan", "engine", "drivetrain",
            "helm", "rudder", "body", "hull");
        for (int i = 0; i < renamed.size(); i += 2) {
            edit("do", "rename", "object", "rover/" + renamed.get(i), "name", renamed.get(i + 1));
            Project.read(project.folder());
        }
        assertEquals(List.of("right", "port"), value("rover/drivetrain", "wheel"));
        assertEquals(List.of("sonar"), value("rover/pan", "part"));
        assertEquals("rudder", value("rover/fifth", "steeringServo"));
        assertEquals("hull", value("rover/touch", "part"));
        assertEquals(List.of(map("pin", "7", "part", "sonar", "role", "ping"),
            map("pin", "9", "part", "pan", "role", "servo"),
            map("pin", "5", "part", "drivetrain", "role", "pwm")), value("rover/board", "wire"));
        assertEquals("another robot's parts are others", List.of("right", "left"), value("other/engine", "wheel"));
        assertEquals(List.of("eye"), value("other/neck", "part"));
        for (int i = 0; i < renamed.size(); i += 2) {
            editor.undo();
        }
        assertEquals(before, objects());
    }

    @Test
    public void thingsAreMountedAndTakenOff() throws Exception {
        edit("do", "robot", "template", "create", "name", "rover");
        edit("do", "add", "type", "Box", "name", "mast", "set", map("x", 3, "onGround", true));
        assertEquals("rover/mast", edit("do", "mount", "object", "mast", "to", "rover", "set",
            map("x", 0, "y", 0.2)).object);
        assertFalse(Files.exists(project.folder().resolve("environment/mast.xml")));
        Project.read(project.folder());
        assertEquals("mast", edit("do", "unmount", "object", "rover/mast", "set", map("x", 3)).object);
        assertEquals("3", value("mast", "x"));
        edit("do", "add", "type", "Compass", "name", "north", "to", "rover");
        assertTrue(refusal("do", "unmount", "object", "rover/north")
            .contains("legal: a shape: a Compass can't stand in the world without a robot"));
        edit("do", "robot", "template", "create", "name", "other");
        edit("do", "mount", "object", "rover/north", "to", "other");
        assertEquals("other", editor.object("north").get("robot"));
        edit("do", "delete", "object", "rover");
        assertEquals(List.of("environment/mast.xml", "robot/north.xml", "robot/other.xml", "robot/other/body.xml",
            "robot/other/drive.xml"), List.copyOf(objects().keySet()));
    }

    @Test
    public void groupsAndListsAreSetAsAWhole() throws Exception {
        edit("do", "robot", "template", "create", "name", "rover");
        edit("do", "add", "type", "Distance", "name", "sonar", "to", "rover", "set",
            map("beam", null, "cone", Arrays.asList(map("halfAngle", 10, "range", 2),
                map("halfAngle", "0", "range", "4", "yaw", 30))));
        assertEquals("4", ((Map<?, ?>) ((List<?>) value("sonar", "cone")).get(1)).get("range"));
        assertTrue(refusal("do", "set", "object", "sonar", "set",
            map("cone", List.of(map("halfAngle", 100, "range", 1))))
            .contains("cone#0.halfAngle is \"100\", legal: a number from 0 to 90 deg"));
        assertTrue(refusal("do", "set", "object", "sonar", "set", map("cone", List.of(map("range", 1))))
            .contains("cone#0.halfAngle is \"\""));
        edit("do", "set", "object", "sonar", "set", map("beam", "PING)))", "cone", List.of()));
        assertNull(((List<?>) value("sonar", "cone")).stream().findFirst().orElse(null));
    }

    // ---- refusals
    // ----------------------------------------------------------------------------------------------------------

    @Test
    public void illegalEditsAreReportedAtTheirFieldAndChangeNothing() throws Exception {
        edit("do", "add", "type", "Box", "name", "crate");
        Map<String, String> before = project.files();
        assertEquals("environment/crate.xml: length is \"-1\", legal: a number from 0.0001 to 100000 m\n"
            + "environment/crate.xml: colour is \"red\", legal: no such parameter, but name, x, y, z, rx, ry, rz, "
            + "onGround, placeLatitude,"
            + " placeLongitude, mass, image, color, scaleX, scaleY, scaleZ, visibleToSensors, friction, restitution, "
            + "rollingFriction, velocityX, velocityY, velocityZ, spinX, spinY, spinZ, temperature, length,"
            + " width, height", refusal("do", "set", "object", "crate", "set", map("length", -1, "colour", "red")));
        assertTrue(refusal("do", "set", "object", "crate", "set", map("length", ""))
            .contains("length is \"\", legal: a number"));
        assertTrue(refusal("do", "set", "object", "crate", "set", map("placeLatitude", 5))
            .contains("legal: both placeLatitude and placeLongitude"));
        assertTrue(refusal("do", "set", "object", "crate", "set", map("name", "x")).contains("rename"));
        assertTrue(refusal("do", "rename", "object", "crate", "name", "a/b")
            .contains("name is \"a/b\", legal: a name of 1 to 100"));
        assertTrue(refusal("do", "add", "type", "Box", "name", "crate")
            .contains("a name that no other object has, case-insensitively, such as crate1"));
        assertTrue(refusal("do", "add", "type", "Box", "name", "CRATE")
            .contains("name is \"CRATE\", legal: a name that no other"));
        assertTrue(refusal("do", "add", "type", "Bax").contains("type is \"Bax\", legal: Accelerometer, "));
        assertTrue(refusal("do", "add", "type", "Compass").contains("the name of a robot: a Compass is a part of one"));
        assertTrue(refusal("do", "add", "type", "Compass", "to", "../x")
            .contains("to is \"../x\", legal: the name of a robot, and there is none"));
        assertTrue(refusal("do", "set", "object", "../../crate", "set", map())
            .contains("legal: the name of an object of the project"));
        assertTrue(refusal("do", "add", "type", "Model").contains("path"));
        assertTrue(refusal("do", "fly").contains("do is \"fly\", legal: add, robot"));
        assertTrue(refusal().contains("do is \"\""));
        assertEquals(before, project.files());
    }

    @Test
    public void aProjectThatIsBrokenElsewhereCanBeEdited() throws Exception {
        project.put("environment/broken.xml", "<Box><name>broken</name></Box>");
        edit("do", "add", "type", "Sphere", "name", "ball");
        edit("do", "set", "object", "ball", "set", map("radius", 2));
        assertTrue(refusal("do", "set", "object", "ball", "set", map("radius", 0))
            .startsWith("environment/ball.xml: radius is \"0\""));
        edit("do", "delete", "object", "ball");
        assertEquals(1, objects().size());
    }

    @Test
    public void twoPagesEditOneObjectAndNeitherLosesAnything() throws Exception {
        edit("do", "add", "type", "Box", "name", "crate");
        edit("do", "set", "object", "crate", "set", map("x", 1), "was", map("x", "0"));
        edit("do", "set", "object", "crate", "set", map("z", 2), "was", map("z", "0"));
        String refusal = refusal("do", "set", "object", "crate", "set", map("x", 5), "was", map("x", "0"));
        assertTrue(refusal, refusal.contains("x is \"5\", legal: a value based on the present one, 1"));
        assertEquals("nothing is done that was done already", "",
            edit("do", "set", "object", "crate", "set", map("x", 1), "was", map("x", 0)).words);
        edit("do", "set", "object", "crate", "set", map("color", "red"), "was", map("color", ""));
        assertEquals("1", value("crate", "x"));
        assertEquals("2", value("crate", "z"));
    }

    // ---- undo
    // --------------------------------------------------------------------------------------------------------------

    @Test
    public void undoOfAllStepsGivesTheEmptyProjectAndRedoEverythingBack() throws Exception {
        edit("do", "add", "type", "Box", "name", "crate", "set", map("x", 1));
        edit("do", "robot", "template", "create2", "name", "rosie");
        edit("do", "add", "type", "Compass", "name", "north", "to", "rosie");
        edit("do", "duplicate", "object", "rosie", "set", map("x", 3));
        edit("do", "rename", "object", "crate", "name", "chest");
        edit("do", "delete", "object", "rosie");
        assertEquals("delete rosie", edit("do", "set", "object", "chest", "set", map("x", 1)).undo);
        Map<String, String> end = objects();
        ProjectEditor afterACrash = new ProjectEditor(project.folder());
        assertEquals("delete rosie", afterACrash.undo().words);
        assertEquals("rename crate to chest", afterACrash.undo().words);
        assertEquals("duplicate rosie", editor.undo().words);
        Outcome three = editor.undo();
        assertEquals("add rosie", three.undo);
        assertEquals("add north", three.redo);
        editor.undo();
        assertNull(editor.undo().undo);
        assertEquals(Map.of(), objects());
        assertThrows(IllegalStateException.class, editor::undo);
        while (editor.state().redo != null) {
            editor.redo();
        }
        assertEquals(end, objects());
        assertThrows(IllegalStateException.class, editor::redo);
    }

    @Test
    public void aManualChangeIsASeparateStep() throws Exception {
        edit("do", "add", "type", "Box", "name", "crate");
        edit("do", "set", "object", "crate", "set", map("x", 1));
        String hand = project.text("environment/crate.xml").replace("<x>1</x>", "<x>7</x>");
        project.put("environment/crate.xml", hand);
        Outcome first = editor.undo();
        assertTrue(first.note, first.note.contains("changes by a script or another program in environment/crate.xml"));
        assertEquals("1", value("crate", "x"));
        editor.redo();
        assertEquals(hand, project.text("environment/crate.xml"));
        editor.undo();
        editor.undo();
        assertEquals("0", value("crate", "x"));
        project.put("environment/crate.xml", hand);
        assertTrue(assertThrows(IllegalStateException.class, editor::redo).getMessage()
            .contains("came after the undo"));
        edit("do", "set", "object", "crate", "set", map("z", 1));
        editor.undo();
        assertEquals(hand, project.text("environment/crate.xml"));
    }

    @Test
    public void aCrashInTheMiddleLosesTheEditInFlightAndNothingElse() throws Exception {
        edit("do", "add", "type", "Box", "name", "crate");
        Map<String, String> before = objects();
        edit("do", "all", "edits", List.of(map("do", "set", "object", "crate", "set", map("x", 1)),
            map("do", "add", "type", "Sphere", "name", "ball")));
        Map<String, String> after = objects();
        Path state = project.folder().resolve(".edits/state");
        for (boolean undoing : new boolean[] {false, true}) {
            Files.write(state, (undoing ? "done 2 doing 2\n" : "done 1 doing 2\n").getBytes("UTF-8"));
            Files.deleteIfExists(project.folder().resolve("environment/ball.xml"));
            editor.state();
            assertEquals(undoing ? after : before, objects());
            assertEquals("done " + (undoing ? 2 : 1) + "\n", new String(Files.readAllBytes(state), "UTF-8"));
            Files.write(state, "done 2\n".getBytes("UTF-8"));
            for (Map.Entry<String, String> file : after.entrySet()) {
                project.put(file.getKey(), file.getValue());
            }
        }
    }

    @Test
    public void theNumberOfStepsIsBounded() throws Exception {
        edit("do", "add", "type", "Sphere", "name", "ball");
        for (int i = 1; i <= EditJournal.MAX_STEPS + 5; i++) {
            Files.write(project.folder().resolve(".edits/" + i + ".step"), new UndoStep("step " + i, List.of())
                .toBytes());
        }
        Files.write(project.folder().resolve(".edits/state"), ("done " + (EditJournal.MAX_STEPS + 5) + "\n")
            .getBytes("UTF-8"));
        edit("do", "set", "object", "ball", "set", map("x", 1));
        try (Stream<Path> files = Files.list(project.folder().resolve(".edits"))) {
            assertEquals(EditJournal.MAX_STEPS + 1, files.count());
        }
        assertEquals("move ball", editor.undo().words);
    }

    @Test
    public void aJournalFromAStrangerWritesNothingButObjects() throws Exception {
        edit("do", "add", "type", "Sphere", "name", "ball");
        UndoStep bad = new UndoStep("harmless", List.of(new FileChange("../../escaped.xml", new byte[] {1}, null)));
        Files.write(project.folder().resolve(".edits/1.step"), bad.toBytes());
        String message = assertThrows(IOException.class, editor::undo).getMessage();
        assertTrue(message, message.contains("it names \"../../escaped.xml\", legal: the file of an object"));
    }

    @Test
    public void severalEditsAreOneStep() throws Exception {
        edit("do", "all", "words", "build a wall", "edits", List.of(map("do", "add", "type", "Box", "name", "a"),
            map("do", "duplicate", "object", "a", "name", "b", "set", map("x", 1)),
                map("do", "set", "object", "b", "set", map("mass", 1))));
        assertEquals(2, objects().size());
        assertEquals("build a wall", editor.undo().words);
        assertEquals(Map.of(), objects());
        assertTrue(refusal("do", "all", "edits",
            List.of(map("do", "add", "type", "Box", "name", "a"), map("do", "delete", "object", "c")))
            .contains("object is \"c\""));
        assertEquals(Map.of(), objects());
    }
}
