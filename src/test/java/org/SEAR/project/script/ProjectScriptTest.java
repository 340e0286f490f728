// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.script;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Draft;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Slider;
import org.SEAR.POJOs.Wheel;
import org.SEAR.Slow;
import org.SEAR.project.BeamLibrary;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.RandomProjects;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.xml.ObjectClasses;
import org.SEAR.project.xml.Xml;
import org.junit.BeforeClass;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.python.util.PythonInterpreter;

/** A project's script, run in the embedded Jython, reproduces the project's files to the byte. */
@Category(Slow.class)
public class ProjectScriptTest {
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", "."));

    @Rule
    public final ProjectRule project = new ProjectRule();
    @Rule
    public final TemporaryFolder fresh = new TemporaryFolder();

    @BeforeClass
    public static void python() {
        Properties settings = new Properties();
        settings.setProperty("python.import.site", "false");
        settings.setProperty("python.cachedir.skip", "true");
        PythonInterpreter.initialize(System.getProperties(), settings, new String[0]);
    }

    private static void run(String script) {
        try (PythonInterpreter python = new PythonInterpreter()) {
            python.exec(script);
        }
    }

    /** Returns the XML files of objects. */
    private static Map<String, String> objects(Path folder) throws IOException {
        Map<String, String> files = new TreeMap<>(ProjectRule.files(folder));
        files.keySet().removeIf(name -> !name.matches("(environment|robot)/.*\\.xml"));
        return files;
    }

    private static Map<String, String> asWritten(Path folder) throws IOException {
        Map<String, Class<?>> classes = new TreeMap<>();
        ObjectClasses.find().all().forEach(type -> classes.put(type.getSimpleName(), type));
        Map<String, String> files = objects(folder);
        files.replaceAll((name, text) -> {
            Object read = Xml.read(folder.resolve(name), name, classes, new ProblemList()).object;
            return new String(Xml.write(read).getBytes(java.nio.charset.StandardCharsets.UTF_8),
                java.nio.charset.StandardCharsets.ISO_8859_1);
        });
        return files;
    }

    /** Runs a project's script in an empty project with the same assets and beams. */
    private String checkSame(Path folder) throws Exception {
        String script = ProjectScript.of(Project.read(folder));
        Path again = fresh.newFolder().toPath().resolve("SEARproject");
        for (String kept : List.of("assets", "beams")) {
            if (Files.isDirectory(folder.resolve(kept))) {
                copy(folder.resolve(kept), again.resolve(kept));
            }
        }
        System.setProperty("sear.project", again.toString());
        try {
            run(script);
            assertEquals(script, asWritten(folder), objects(again));
            assertTrue(script, script.chars().allMatch(c -> c == '\n' || c >= ' ' && c < 127));
        } finally {
            System.setProperty("sear.project", folder.toString());
        }
        return script;
    }

    private static void copy(Path from, Path to) throws IOException {
        try (Stream<Path> all = Files.walk(from)) {
            for (Path each : all.collect(Collectors.toList())) {
                Path target = to.resolve(from.relativize(each).toString());
                if (Files.isDirectory(each)) {
                    Files.createDirectories(target);
                } else {
                    Files.copy(each, target);
                }
            }
        }
    }

    @Test
    public void everyTypeWithEveryParameter() throws Exception {
        TreeSet<String> never = new TreeSet<>();
        int count = 0;
        for (Class<? extends SearObject> type : ObjectClasses.find().all()) {
            EveryParameter every = new EveryParameter(type);
            List<SearObject> wanted = every.objects();
            wanted.removeIf(object -> type == Wheel.class && ((Wheel) object).isOnGround());
            checkSame(wanted);
            count += wanted.size();
            never.addAll(every.never());
        }
        assertEquals("[Arduino.wire, BallJoint.first, Chessboard.image, FixedJoint.first, "
            + never("FloorPlan") + "Hinge.first, Marker.image, " + never("Maze") + "Rope.first, Slider.first,"
            + " Terrain.mass, Terrain.onGround, Terrain.placeLatitude, Terrain.placeLongitude, Terrain.rx, "
            + "Terrain.ry, Terrain.rz,"
            + " Terrain.scaleX, Terrain.scaleY, Terrain.scaleZ, Terrain.spinX, Terrain.spinY, Terrain.spinZ,"
            + " Terrain.velocityX, Terrain.velocityY, Terrain.velocityZ, Terrain.x, Terrain.y, Terrain.z, "
            + never("Wall") + "Wheel.spinX, Wheel.spinY,"
            + " Wheel.spinZ, Wheel.trail, Wheel.velocityX, Wheel.velocityY, Wheel.velocityZ]", never.toString());
        assertTrue("objects: " + count, count > 200);
    }

    /** Returns the parameters of motion, which walls do not have. */
    private static String never(String walls) {
        return Stream.of("mass", "spinX", "spinY", "spinZ", "velocityX", "velocityY", "velocityZ")
            .map(name -> walls + "." + name + ", ").collect(Collectors.joining());
    }

    /** Runs one script with a function for each object. */
    private void checkSame(List<SearObject> wanted) throws Exception {
        StringBuilder script = new StringBuilder();
        Map<String, String> expected = new TreeMap<>();
        Draft.of(new BeamLibrary(project.folder()).names(), () -> {
            for (SearObject object : wanted) {
                ObjectScript one = new ObjectScript(object);
                assertTrue("no script for " + Xml.write(object), one.isPossible());
                one.classes().forEach(type -> script.append("from ").append(type.getPackageName()).append(" import ")
                    .append(type.getSimpleName()).append('\n'));
                script.append("def make():\n    it = ").append(one.expression()).append('\n');
                one.calls().forEach(call -> script.append("    it.").append(call).append('\n'));
                if (object instanceof SEARrobot) {
                    script.append("    it.set({'order': ").append(PythonText.literal(((SEARrobot) object).getOrder()))
                        .append("})\n");
                }
                script.append("make()\n");
                expected.put(object.getName() + ".xml", Xml.write(object));
            }
            return null;
        });
        Path folder = fresh.newFolder().toPath().resolve("SEARproject");
        System.setProperty("sear.project", folder.toString());
        run(script.toString());
        Map<String, String> made = new TreeMap<>();
        objects(folder).forEach((file, text) -> made.put(file.substring(file.lastIndexOf('/') + 1), text));
        assertEquals(script.toString(), expected, made);
    }

    @Test
    public void everyExampleAndGoldenBundle() throws Exception {
        List<Path> bundles = new ArrayList<>();
        for (String folder : List.of("examples", "src/test/resources/org/SEAR/project/bundle")) {
            try (Stream<Path> all = Files.walk(ROOT.resolve(folder))) {
                all.filter(file -> file.toString().endsWith(".sear")).sorted().forEach(bundles::add);
            }
        }
        assertTrue(bundles.toString(), bundles.size() > 9);
        for (Path bundle : bundles) {
            File place = fresh.newFolder();
            Path folder = place.toPath().resolve("SEARproject");
            Bundle.load(bundle, folder);
            checkSame(folder);
            if (bundle.toString().contains("examples")) {
                assertEquals(bundle.toString(), objects(folder), asWritten(folder));
            }
        }
    }

    @Test
    public void roundingErrorsAreNotWritten() throws Exception {
        double cell = 0.8;
        Box box = new Box("box", 6 * cell + 1, 0.1 + 0.2, 11.181769303614649, 1);
        box.move(-3 * cell, 1e-7 / 3, 1.0 / 3);
        String script = checkSame(project.folder());
        assertTrue(script, script.contains("5.8, 0.3, 11.181769303614649"));
        assertTrue(script, script.contains("-2.4, 0.000000033333333333333334, 0.3333333333333333"));
    }

    @Test
    public void projectsOfAnyKind() throws Exception {
        for (long seed = 0; seed < 12; seed++) {
            Path folder = fresh.newFolder().toPath().resolve("SEARproject");
            System.setProperty("sear.project", folder.toString());
            new RandomProjects(seed).create();
            if (Files.isDirectory(folder) && Project.read(folder).getWarnings().stream()
                .noneMatch(warning -> warning.contains("is left out"))) {
                checkSame(folder);
            }
        }
    }

    @Test
    public void robotsWithPartsOfOneNameAndGapsInTheirOrder() throws Exception {
        for (String name : List.of("one", "two", "three")) {
            SEARrobot robot = new SEARrobot(name);
            robot.addComponent(new Dynamics("drive", 4));
            robot.addComponent(new Box("box", 1, 1, 1, 1));
        }
        String script = checkSame(project.folder());
        assertFalse(script, script.contains("setOwnFolder"));
        run(script);
        assertEquals("run again in its own project", asWritten(project.folder()), objects(project.folder()));
        for (String file : List.of("robot/two.xml", "robot/two/drive.xml", "robot/two/box.xml")) {
            Files.delete(project.folder().resolve(file));
        }
        script = checkSame(project.folder());
        assertTrue(script, script.contains("three.set({\"order\": 3})"));
        for (String file : List.of("robot/three.xml", "robot/drive.xml", "robot/box.xml")) {
            Files.delete(project.folder().resolve(file));
        }
        assertTrue(checkSame(project.folder()).contains("one.setOwnFolder(\"drive\", True)"));
    }

    /** Objects that are legal only together with others. */
    @Test
    public void wiresMotorsServosAndCasters() throws Exception {
        SEARrobot robot = new SEARrobot("rover");
        robot.addComponent(new Dynamics("drive", 4));
        robot.addComponent(new Box("box", 1, 1, 1, 1));
        Wheel left = new Wheel("left", 0.1, 0.05, 1);
        Wheel right = new Wheel("right", 0.1, 0.05, 1);
        Wheel caster = new Wheel("caster", 0.1, 0.05, 0);
        caster.setTrail(0.04);
        for (Wheel wheel : List.of(left, right, caster)) {
            robot.addWheel(wheel);
        }
        Motor motor = new Motor("motor", left);
        motor.addWheel(right);
        robot.addComponent(motor);
        Distance eye = new Distance("eye", "GP2Y0A21");
        robot.addComponent(eye);
        Servo servo = new Servo("servo");
        robot.addComponent(servo);
        servo.mount(eye);
        Box lid = new Box("lid", 1, 1, 1, 1);
        robot.addComponent(lid);
        Hinge hinge = new Hinge("hinge", null, lid, 0, 1, 0);
        hinge.mount(servo);
        hinge.setMotor(1, 90);
        robot.addComponent(hinge);
        robot.addComponent(new Slider("shaft", lid, robot.getPart("box")));
        Arduino uno = new Arduino("uno");
        robot.addComponent(uno);
        uno.wire("A0", eye);
        uno.wire(9, motor, "pwm");
        uno.wire(10, servo);
        Map<String, String> made = objects(project.folder());
        assertTrue(made.toString(), made.get("robot/uno.xml").contains("A0") && made.get("robot/rover.xml")
            .contains("<trail>0.04</trail>"));
        checkSame(project.folder());
    }

    @Test
    public void aTextNeverBecomesCode() throws Exception {
        String evil = "'+__import__('os').system('x')+'";
        String odd = "\u00c3\u00bc \u00fc \ud83e\udd16 {0} %s #";
        Box box = new Box(evil, 1, 1, 1);
        box.setMass(2);
        box.setFriction(0.5);
        new Box(odd, 1, 1, 1).move(1e-7, 12345.678, 1.0 / 3);
        new Box("print", 1, 1, 1).setFriction(1);
        new Box("Box", 1, 1, 1).setFriction(1);
        SEARrobot robot = new SEARrobot("1 robot\u00e9");
        Dynamics dynamics = new Dynamics("d", 1);
        dynamics.setPorts("\"); import os; x=(\"\\", "a\\\"'''\u2028${x}\\u0022");
        robot.addComponent(dynamics);
        robot.addComponent(new Distance("PING)))"));
        String script = checkSame(project.folder());
        assertTrue(script, script.contains("dynamics")
            || script.contains("d.setPorts(\"\\\"); import os; x=(\\\"\\\\\","));
        assertTrue(script, script.contains("addComponent(Distance(\"PING)))\"))"));
    }

    @Test
    public void aLargeProjectIsCutIntoFunctions() throws Exception {
        for (int i = 0; i < 150; i++) {
            new Box("crate " + i, 0.5 + i, 1, 1, 2, i, 0.25 * i, -i).setFriction(0.001 * i);
        }
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("drive", 4));
        for (int i = 0; i < 60; i++) {
            robot.addComponent(new Distance("eye " + i, "laser", 0, 0, 0.001 * i, 0, i, 0));
        }
        String script = checkSame(project.folder());
        assertTrue(script, script.contains("\ndef part2():\n") && script.contains("    global robot\n"));
    }

    @Test
    public void readsAsOneWouldWriteIt() throws Exception {
        new Box("crate", 1, 0.5, 0.25, 2).setColor("red");
        new Box("wall", 1, 0.5, 0.25).placeAt(4, 5.5);
        SEARrobot robot = new SEARrobot("rover");
        robot.addComponent(new Dynamics("drive", 4, 0, 0.1, 0, 0, 90, 0));
        robot.addWheel(new Wheel("left", 0.1, 0.05, 1, 0.2, 0, 0));
        assertEquals("from org.SEAR.POJOs import Box, Dynamics, SEARrobot, Wheel\n\n"
            + "crate = Box(\"crate\", 1, 0.5, 0.25, 2)\ncrate.setColor(\"red\")\nwall = Box(\"wall\", 1, 0.5, 0.25)\n"
            + "wall.placeAt(4, 5.5)\n\nrover = SEARrobot(\"rover\")\n"
            + "rover.addComponent(Dynamics(\"drive\", 4, 0, 0.1, 0, 0, 90, 0))\n"
            + "rover.addWheel(Wheel(\"left\", 0.1, 0.05, 1, 0.2, 0, 0))\n", checkSame(project.folder()));
    }
}
