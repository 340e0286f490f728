// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.Progress;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.sensors.DistanceReading;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;
import org.python.util.PythonInterpreter;

/** Parts of two robots may share a name; scripts ask for robot/part. */
public class SameNamesTest {
    private static final String SCRIPT =
        String.join("\n", "from org.SEAR.POJOs import Box, Distance, Dynamics, Floor, SEARrobot, Wheel",
        "Floor('floor', 40, 40).setVisibleToSensors(False)",
        "Box('wall', 1, 1, 1, 0).move(0, 0.5, 2)",
        "for name, x in (('rover', 0), ('scout', 4), ('tug', -4)):",
        "    robot = SEARrobot(name)",
        "    body = Box('body', 0.3, 0.2, 0.1)",
        "    robot.addComponent(body)",
        "    body.move(0, 0.1, 0)",
        "    drive = Dynamics('drive', 3)",
        "    robot.addComponent(drive)",
        "    drive.move(x, 0, 0)",
        "    for side, where in (('left', 0.12), ('right', -0.12)):",
        "        robot.addWheel(Wheel(side, 0.05, 0.02, 1, where, 0.05, 0))",
        "    if name != 'tug':",
        "        ping = Distance('ping', 'PING')",
        "        robot.addComponent(ping)",
        "        ping.move(0, 0.5, 0.1 if x else 0.2)",
        "");
    private static final Set<String> FILES = Set.of("environment/floor.xml", "environment/wall.xml", "robot/rover.xml",
        "robot/scout.xml", "robot/tug.xml", "robot/rover/body.xml", "robot/rover/drive.xml", "robot/rover/ping.xml",
        "robot/scout/body.xml", "robot/scout/drive.xml", "robot/ping.xml", "robot/body.xml", "robot/drive.xml");

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Rule
    public final SaidRule grammar = new SaidRule();

    private final List<String> said = grammar.said;

    private static void run(String script) {
        try (PythonInterpreter python = new PythonInterpreter()) {
            python.exec(script);
        }
    }

    /** Forgets the parts made before, like a new program. */
    private void forget() {
        System.setProperty("sear.project", project.getRoot().toPath().resolve("elsewhere").toString());
        run(SCRIPT);
        System.setProperty("sear.project", project.folder().toString());
    }

    @Test
    public void eachHasItsFileAndTheScriptAgainWritesTheSame() throws Exception {
        run(SCRIPT);
        Map<String, String> files = project.files();
        assertEquals(FILES, files.keySet());
        assertTrue(files.get("robot/rover.xml"), files.get("robot/rover.xml")
            .contains("<component>rover/ping</component>"));
        assertTrue(files.get("robot/scout.xml"), files.get("robot/scout.xml").contains("<component>ping</component>"));
        assertTrue("a setter behind the move", files.get("robot/rover/ping.xml").contains("<z>0.2</z>"));
        forget();
        run(SCRIPT);
        assertEquals("in a new program", files, project.files());
        run(SCRIPT);
        assertEquals("in the same program, where the robots are the last again", withoutOrder(files),
            withoutOrder(project.files()));
        assertEquals("nothing was replaced", List.of(), said);
        assertEquals(List.of(), Project.read(project.folder()).getWarnings());
    }

    private static Map<String, String> withoutOrder(Map<String, String> files) {
        files.replaceAll((file, text) -> text.replaceAll(" *<order>.*\n", ""));
        return files;
    }

    @Test
    public void theyAreReadByTheirRobots() throws Exception {
        run(SCRIPT);
        Path bundle = project.getRoot().toPath().resolve("two.sear");
        Bundle.save(project.folder(), bundle);
        Map<String, String> files = project.files();
        Bundle.newProject(project.folder(), Progress.NONE);
        Bundle.load(bundle, project.folder());
        assertEquals(files, project.files());
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            assertEquals(List.of("rover/ping", "scout/ping"), world.getSensorNames());
            world.watch("rover/ping", true);
            world.step();
            assertEquals(1.3, ((DistanceReading) world.read("rover/ping")).getDistance(), 0.1);
            assertNotEquals("scout looks past the wall", 1.3, ((DistanceReading) world.read("scout/ping"))
                .getDistanceOrRange(), 0.1);
            assertEquals(Set.of("rover/ping"), world.snapshot().readings.keySet());
            assertEquals(0.2, world.getPose("rover/ping").z - world.getPose("rover").z, 0.01);
            assertEquals(4.12, world.getPose("scout/left").x, 0.01);
            assertEquals(world.getPose("tug").toString(), world.getPose("tug/drive").toString());
            String choices = "\"ping\" is on rover and scout: use \"rover/ping\" or \"scout/ping\"";
            assertEquals(choices, assertThrows(IllegalArgumentException.class, () -> world.read("ping")).getMessage());
            assertEquals(choices, assertThrows(IllegalArgumentException.class, () -> world.watch("ping", true))
                .getMessage());
            assertEquals("\"body\" is on rover, scout and tug: use \"rover/body\", \"scout/body\" or \"tug/body\"",
                assertThrows(IllegalArgumentException.class, () -> world.getPose("body")).getMessage());
            assertEquals("no sensor is called \"tug/ping\", legal: rover/ping, scout/ping",
                assertThrows(IllegalArgumentException.class, () -> world.read("tug/ping")).getMessage());
        }
    }

    @Test
    public void theRobotMayAlwaysBeNamed() throws Exception {
        robot("rover", "eye");
        robot("scout", "ear");
        assertTrue("as ever", project.files().keySet().containsAll(Set.of("robot/eye.xml", "robot/ear.xml")));
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            assertEquals(List.of("ear", "eye"), world.getSensorNames());
            assertEquals(world.read("eye"), world.read("rover/eye"));
            assertEquals(world.getPose("ear").toString(), world.getPose("scout/ear").toString());
        }
    }

    private static SEARrobot robot(String name, String sensor) {
        SEARrobot robot = new SEARrobot(name);
        robot.addComponent(new Dynamics(name + " drive", 3));
        robot.addComponent(new Distance(sensor));
        return robot;
    }

    @Test
    public void partsThatAreMadeFirstAndAddedLater() throws Exception {
        SEARrobot rover = new SEARrobot("rover");
        SEARrobot scout = new SEARrobot("scout");
        Distance first = new Distance("ping");
        Distance second = new Distance("ping");
        rover.addComponent(first);
        scout.addComponent(second);
        first.move(0, 1, 0);
        second.move(0, 2, 0);
        assertTrue(project.text("robot/rover/ping.xml"), project.text("robot/rover/ping.xml").contains("<y>1</y>"));
        assertTrue(project.text("robot/ping.xml"), project.text("robot/ping.xml").contains("<y>2</y>"));
        assertEquals(List.of("rover/ping"), rover.getComponentNames());
        assertEquals(2, Project.read(project.folder()).getRobots().size());
    }

    @Test
    public void aWheelOfAPartsNameLeavesThePartAlone() throws Exception {
        robot("rover", "left");
        SEARrobot scout = robot("scout", "ping");
        scout.addWheel(new Wheel("left", 0.1, 0.05));
        Wheel late = new Wheel("right", 0.1, 0.05);
        Distance right = new Distance("right");
        SEARrobot tug = new SEARrobot("tug");
        tug.addComponent(right);
        scout.addWheel(late);
        assertTrue(project.files().keySet().toString(), project.files().keySet()
            .containsAll(Set.of("robot/rover/left.xml", "robot/right.xml")));
        assertEquals(3, Project.read(project.folder()).getRobots().size());
    }

    @Test
    public void ifAPartCantMoveNothingIsLost() throws Exception {
        SEARrobot rover = robot("rover", "ping");
        Map<String, String> before = project.files();
        project.put("robot/rover", "no folder");
        assertThrows(UncheckedIOException.class, () -> new Distance("ping"));
        Files.delete(project.folder().resolve("robot/rover"));
        assertEquals(before, project.files());
        assertEquals(List.of("rover drive", "ping"), rover.getComponentNames());
        robot("scout", "ping");
        assertEquals(2, Project.read(project.folder()).getRobots().size());
        assertEquals(List.of("rover drive", "rover/ping"), rover.getComponentNames());
    }

    @Test
    public void aRemovedRobotIsNotWrittenAgain() throws Exception {
        robot("rover", "ping");
        Bundle.newProject(project.folder(), Progress.NONE);
        robot("scout", "ping");
        assertEquals(Set.of("robot/scout.xml", "robot/scout drive.xml", "robot/ping.xml"), project.files().keySet());
    }

    @Test
    public void replacedPartsAreReported() throws Exception {
        run("from org.SEAR.POJOs import Distance\nDistance('ping', 'PING')\nDistance('ping', 'PING')\n");
        assertEquals(said.toString(), 1, said.size());
        assertTrue(said.get(0), said.get(0)
            .startsWith("Distance \"ping\" has the name of an object that this script has made already, and"));
    }

    @Test
    public void handWrittenFilesInTheRobotsFolder() throws Exception {
        byHand("rover", "rover/drive", "rover/eye");
        byHand("scout", "drive", "eye");
        Project read = Project.read(project.folder());
        assertEquals(List.of(), read.getWarnings());
        assertEquals("rover/eye", read.getRobots().get(0).getComponents().get(1).getFullName());
        assertEquals("rover/eye", read.getRobots().get(0).getComponents().get(1).getFileName());
        assertEquals("eye", read.getRobots().get(1).getComponents().get(1).getFileName());
        project.put("robot/rover/notes.txt", "mine");
        project.put("robot/rover/old.xml", "mine, too");
        project.put("robot/nobody/old.xml", "mine, too");
        assertEquals(List.of("robot/rover/old.xml is not a component of SEARrobot \"rover\" and is left out; "
            + "<component>rover/old</component> in the"
            + " robot's file adds it"), Project.read(project.folder()).getWarnings());
    }

    private void byHand(String robot, String drive, String eye) throws Exception {
        project.put("robot/" + robot + ".xml", "<SEARrobot>\n<name>" + robot + "</name>\n<component>" + drive
            + "</component>\n<component>" + eye + "</component>\n</SEARrobot>");
        project.put("robot/" + drive + ".xml", "<Dynamics><name>drive</name><mass>3</mass></Dynamics>");
        project.put("robot/" + eye + ".xml", "<Compass>\n<name>eye</name>\n</Compass>");
    }

    @Test
    public void invalidInputIsReported() throws Exception {
        byHand("rover", "rover/drive", "rover/eye");
        byHand("scout", "drive", "eye");
        refused("robot/scout.xml:4: component is \"rover/eye\", legal: a name alone for a file in robot/, or "
            + "\"scout/eye\" for one in robot/scout/",
            "robot/scout.xml", "<SEARrobot>\n<name>scout</name>\n<component>drive</component>\n"
                + "<component>rover/eye</component>\n</SEARrobot>");
        refused("robot/scout.xml:4: component is \"scout/ear\", legal: the name of a file in robot/, without .xml",
            "robot/scout.xml", "<SEARrobot>\n<name>scout</name>\n<component>drive</component>\n"
                + "<component>scout/ear</component>\n</SEARrobot>");
        refused("robot/scout.xml:4: component is \"../eye\", legal: a name of 1 to 100 characters",
            "robot/scout.xml", "<SEARrobot>\n<name>scout</name>\n<component>drive</component>\n"
                + "<component>../eye</component>\n</SEARrobot>");
        refused("robot/rover/eye.xml:2: name is \"ear\", legal: the name of the file without .xml, \"eye\"",
            "robot/rover/eye.xml", "<Compass>\n<name>ear</name>\n</Compass>");
        refused("robot/rover/eye.xml:2: name is \"eye\", legal: a name of its own (capitals don't count); "
            + "environment/Eye.xml has it too",
            "environment/Eye.xml", "<Box><name>Eye</name><length>1</length><width>1</width><height>1</height></Box>");
        refused("robot/rover/eye.xml:1: <SEARrobot> is not an object here, legal: ",
            "robot/rover/eye.xml", "<SEARrobot><name>eye</name></SEARrobot>");
        String ports = "<uartPort>a</uartPort>\n<userPort>b</userPort></Dynamics>";
        project.put("robot/drive.xml", "<Dynamics><name>drive</name><mass>3</mass>" + ports);
        refused("robot/drive.xml:1: uartPort is \"a\", legal: a port of its own; robot/rover/drive.xml has it too",
            "robot/rover/drive.xml", "<Dynamics><name>drive</name><mass>3</mass>" + ports);
        project.put("robot/Drive.xml", "<Dynamics><name>Drive</name><mass>3</mass></Dynamics>");
        refused("legal: a name that differs from that of robot/Drive.xml by more than capitals",
            "robot/tug.xml", "<SEARrobot><name>tug</name><component>Drive</component></SEARrobot>");
        project.put("robot/eye.xml", "<Compass><name>eye</name></Compass>");
        refused("robot/rover/eye.xml:2: name is \"eye\", legal: a name of its own (capitals don't count); "
            + "robot/eye.xml has it too", "robot/rover.xml", "<SEARrobot><name>rover</name>"
                + "<component>rover/drive</component><component>eye</component>"
            + "<component>rover/eye</component></SEARrobot>");
    }

    private void refused(String message, String file, String text) throws Exception {
        String before = Files.exists(project.folder().resolve(file)) ? project.text(file) : null;
        project.put(file, text);
        String told = assertThrows(ProjectException.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(told, told.contains(message));
        if (before == null) {
            Files.delete(project.folder().resolve(file));
        } else {
            project.put(file, before);
        }
    }
}
