// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.Slow;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.edit.ProjectEditor;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Each ready-made robot is added in each way to a project that already has robots, and the project starts. */
@Category(Slow.class)
public class ReadyRobotsInProjectsTest {
    private static final Path EXAMPLES = Paths.get(System.getProperty("sear.root", ".")).resolve("examples");
    private static final Map<String, BiFunction<String, String, SEARrobot>> ALL = new LinkedHashMap<>();

    static {
        ALL.put("roomba400", (name, port) -> Robots.roomba400(name, port + "_uart", port));
        ALL.put("create", (name, port) -> Robots.create(name, port + "_uart", port));
        ALL.put("create2", (name, port) -> Robots.create2(name, port + "_uart", port));
        ALL.put("rover", (name, port) -> Robots.rover(name));
        ALL.put("fourWheeled", (name, port) -> Robots.fourWheeled(name));
        ALL.put("car", (name, port) -> Robots.car(name));
        ALL.put("chassis", (name, port) -> Robots.chassis(name));
    }

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static List<Path> examples() throws Exception {
        try (Stream<Path> all = Files.list(EXAMPLES)) {
            return all.filter(file -> file.toString().endsWith(".sear")).sorted().collect(Collectors.toList());
        }
    }

    private Project start() throws Exception {
        Project read = Project.read(project.folder());
        Simulation.of(read, 1);
        return read;
    }

    private static String parts(SEARrobot robot) {
        return Stream.concat(robot.getComponents().stream(), robot.getWheels().stream()).map(SearObject::getName)
            .collect(Collectors.joining(" "));
    }

    @Test
    public void eachTwice() throws Exception {
        new Floor("floor", 40, 40);
        for (String kind : ALL.keySet()) {
            ALL.get(kind).apply(kind + " one", "/dev/one_" + kind).placeAt(0, 0, 0);
            ALL.get(kind).apply(kind + " two", "/dev/two_" + kind).placeAt(0, 5, 0);
            List<SEARrobot> robots = Project.read(project.folder()).getRobots();
            assertEquals(kind, parts(robots.get(robots.size() - 2)), parts(robots.get(robots.size() - 1)));
        }
        assertEquals(2 * ALL.size(), start().getRobots().size());
    }

    @Test
    public void eachInEachExampleThatWasOpened() throws Exception {
        for (Path example : examples()) {
            for (String kind : ALL.keySet()) {
                Bundle.load(example, project.folder());
                List<SEARrobot> before = Project.read(project.folder()).getRobots();
                ALL.get(kind).apply("newcomer", "/dev/newcomer");
                List<SEARrobot> robots = Project.read(project.folder()).getRobots();
                assertEquals(example + " " + kind, before.size() + 1, robots.size());
                assertEquals("the first stays the first", parts(before.get(0)), parts(robots.get(0)));
                assertTrue(parts(robots.get(before.size())), parts(robots.get(before.size())).contains("body"));
            }
            start();
        }
    }

    @Test
    public void eachFromThePaletteTwiceAndInEachExample() throws Exception {
        for (Path example : examples()) {
            Bundle.load(example, project.folder());
            int before = Project.read(project.folder()).getRobots().size();
            ProjectEditor editor = new ProjectEditor(project.folder());
            for (String kind : ALL.keySet()) {
                for (int i = 0; i < 2; i++) {
                    editor.apply(Map.of("do", "robot", "template", kind));
                }
            }
            assertEquals(before + 2 * ALL.size(), start().getRobots().size());
        }
    }

    /** The robot of an opened project keeps its files, its parts and its names in scripts. */
    @Test
    public void theRobotOfAnOpenedProjectKeepsItsParts() throws Exception {
        Bundle.load(EXAMPLES.resolve("office.sear"), project.folder());
        Map<String, String> before = project.files();
        Robots.create2("newcomer");
        Map<String, String> after = project.files();
        assertEquals(before.get("robot/drive.xml"), after.get("robot/office Roomba/drive.xml"));
        assertTrue(after.get("robot/office Roomba.xml"), after.get("robot/office Roomba.xml")
            .contains("<component>office Roomba/drive</component>"));
        assertTrue(after.get("robot/newcomer.xml"), after.get("robot/newcomer.xml")
            .contains("<component>drive</component>"));
        SEARrobot old = start().getRobots().get(0);
        assertEquals("office Roomba/drive", old.getComponents().stream().filter(part -> part instanceof Dynamics)
            .findFirst().get().getFullName());
    }

    @Test
    public void aPartYieldsItsNameToObjectsAndRobots() throws Exception {
        new Box("Body", 1, 1, 1, 0).move(5, 0.5, 5);
        new Box("left", 1, 1, 1, 0).move(5, 0.5, 8);
        new Floor("caster", 40, 40);
        Robots.rover("drive");
        SEARrobot rover = Robots.rover("rover");
        rover.placeAt(3, 0, 0);
        assertEquals("rover drive rover body leftMotor rightMotor rover left right rover caster", parts(rover));
        assertEquals("drive drive drive body leftMotor rightMotor drive left right drive caster",
            parts(start().getRobots().get(0)));
        new ProjectEditor(project.folder()).apply(Map.of("do", "robot", "template", "rover", "name", "tug"));
        assertEquals("from the palette, too", "tug drive tug body leftMotor rightMotor tug left right tug caster",
            parts(start().getRobots().get(2)));
    }

    @Test
    public void aFailedRobotLeavesTheProjectUnchanged() throws Exception {
        Bundle.load(EXAMPLES.resolve("office.sear"), project.folder());
        SEARrobot present = Robots.create2("present");
        Map<String, String> before = project.files();
        for (int i = 0; i < 2; i++) {
            assertThrows(IllegalArgumentException.class, () -> Robots.create2("late", "/dev/late_uart", "no port: \n"));
            assertEquals(before, project.files());
            assertThrows(RuntimeException.class, () -> Robots.rover("a name: that no file can have"));
            assertEquals(before, project.files());
        }
        present.placeAt(1, 1, 90);
        present.addComponent(new Box("crate", 0.1, 0.1, 0.1));
        Robots.create2("another").placeAt(-1, 1, 90);
        assertEquals(before.get("robot/drive.xml"), project.files().get("robot/present/drive.xml"));
        start();
    }

    /** Wires a board and motors like the template arduino.py. */
    @Test
    public void aBoardAndMotorsComeWithIt() throws Exception {
        for (Path example : examples()) {
            Bundle.load(example, project.folder());
            SEARrobot rover = Robots.create2("newcomer");
            Arduino uno = new Arduino("uno", "uno");
            uno.setPorts("/dev/new_uart", "/dev/new_user");
            for (Wheel wheel : rover.getWheels()) {
                if (wheel.isDriven()) {
                    Motor motor = new Motor(wheel.getName() + "Motor", wheel, 0.5, 10);
                    rover.addComponent(motor);
                    uno.wire(wheel.getName().equals("left") ? 9 : 10, motor, "pwm");
                }
            }
            rover.addComponent(uno);
            start();
        }
    }
}
