// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.urdf;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Inertia;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Slider;
import org.SEAR.files.InvalidFile;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.script.ProjectScript;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** Robots in URDF. {@link UrdfReport} reports those of others. */
public class UrdfImportTest {
    private static final String INERTIA = "<inertia ixx='0.4' iyy='0.5' izz='0.3' ixy='0.01' ixz='0.02' iyz='0.03'/>";
    private static final String BODY = "<link name='%s'><inertial><origin xyz='%s'/><mass value='%s'/>" + INERTIA
        + "</inertial><collision><origin xyz='%s'/><geometry><box size='0.1 0.2 0.3'/></geometry></collision></link>";
    private static final String ARM = "<robot name='arm'><link name='world'/>" + link("base", "0 0 0", 5, "0 0 0")
        + link("upper", "1 0 0", 2, "1 0 0") + link("tool", "0 0 0.5", 1, "0 0 0.5")
        + "<joint name='mount' type='fixed'><parent link='world'/><child link='base'/><origin xyz='0 0 2'/></joint>"
        + "<joint name='shoulder' type='revolute'><parent link='base'/><child link='upper'/><axis xyz='0 1 0'/>"
        + "<limit lower='-1' upper='3' effort='0' velocity='0'/><dynamics damping='0.5' friction='0.1'/></joint>"
        + "<joint name='wrist' type='fixed'><parent link='upper'/><child link='tool'/><origin xyz='1 0 0' "
        + "rpy='0 0 1.5707963267948966'/></joint><gazebo/></robot>";

    @Rule
    public final ProjectRule project = new ProjectRule();

    private final List<String> notes = new ArrayList<>();

    private static String link(String name, String centre, double mass, String at) {
        return String.format(BODY, name, centre, mass, at);
    }

    private Project add(String text) throws Exception {
        Path file = project.getRoot().toPath().resolve("robot.urdf");
        Files.write(file, text.getBytes(StandardCharsets.UTF_8));
        notes.clear();
        UrdfImport.add(file, project.folder(), Pose.IDENTITY, false, Map.of(), notes);
        return Project.read(project.folder());
    }

    @Test
    public void bodiesOfFixedLinksHaveTheirTensor() throws Exception {
        Project read = add(ARM);
        assertEquals(List.of("arm", "arm upper"), read.getRobots().stream().map(SEARrobot::getName)
            .collect(Collectors.toList()));
        assertEquals(List.of("<gazebo> of the robot is left out (line 1)"), notes);
        Dynamics upper = (Dynamics) read.getRobots().get(1).getComponents().stream()
            .filter(Dynamics.class::isInstance).findFirst().get();
        assertEquals(3, upper.getMass(), 1e-12);
        Inertia of = upper.getInertia();
        // ahead is z: both centres are 1 m ahead, the tool's 0.5 m above
        assertEquals(0, of.getX(), 1e-9);
        assertEquals(0.5 / 3, of.getY(), 1e-9);
        assertEquals(1, of.getZ(), 1e-9);
        double apart = 2 / 3.0 * 0.25;
        assertEquals("URDF's yy of the link and xx of the turned tool", 0.5 + 0.4 + apart, of.getXx(), 1e-9);
        assertEquals("URDF's zz", 0.3 + 0.3, of.getYy(), 1e-9);
        assertEquals("URDF's xx", 0.4 + 0.5 + apart, of.getZz(), 1e-9);
    }

    @Test
    public void anArmHangsAndIsShownAsPython() throws Exception {
        Project read = add(ARM.replace("name='shoulder' type='revolute'", "name='shoulder' type='continuous'")
            .replace("damping='0.5'", "damping='8'"));
        Hinge hinge = (Hinge) read.getJoints().stream().filter(Hinge.class::isInstance).findFirst().get();
        assertEquals(8, hinge.getDamping(), 0);
        String script = ProjectScript.of(read);
        assertTrue(script, script.contains("Inertia(")
            && script.contains("\"first\": \"arm\", \"second\": \"arm upper\""));
        try (Simulation simulation = Simulation.load(project.folder(), 1)) {
            for (int i = 0; i < 1800; i++) {
                simulation.step();
            }
            Pose upper = simulation.getPose("arm upper");
            double[] centre = upper.rotate(0, 0.5 / 3, 1);
            assertEquals("below its joint", 0, Math.hypot(centre[0], centre[2]), 0.02);
            assertTrue(centre[1] < -1);
        }
    }

    @Test
    public void slidersAndLimitsAreInMetresAndDegrees() throws Exception {
        Project read = add(ARM.replace("'revolute'", "'prismatic'").replace("effort='0' velocity='0'",
            "effort='30' velocity='2'"));
        Slider slider = (Slider) read.getJoints().stream().filter(Slider.class::isInstance).findFirst().get();
        assertEquals(3, slider.getUpper(), 0);
        assertEquals(30, slider.getStallForce(), 0);
        Project turning = add(ARM.replace("name='arm'", "name='other'"));
        Hinge hinge = (Hinge) turning.getJoints().stream().filter(Hinge.class::isInstance).findFirst().get();
        assertEquals(Math.toDegrees(3), hinge.getUpper(), 1e-9);
    }

    @Test
    public void errorsNameTheLineThePlaceAndTheValue() throws Exception {
        String lines = ARM.replace("><", ">\n<");
        refuses(lines.replace("xyz='0 1 0'", "xyz='0 0 0'"), "robot.urdf: line 50: xyz of <axis> of joint shoulder is "
            + "0 0 0, legal: a direction");
        refuses(lines.replace("<child link='tool'/>", "<child link='none'/>"), "link of <child> of joint wrist is "
            + "none, legal: the name of a link");
        refuses(lines.replace("'revolute'", "'screw'"), "type of <joint> is screw, legal: continuous, fixed, ");
        refuses(lines.replace("0 0 2", "0 0 two"), "xyz of <origin> of joint mount is 0 0 two, legal: numbers from "
            + "-10000 to 10000");
        refuses(lines.replace("0 0 2", "0 ${a} 0"), "expand a xacro by ros2 run xacro xacro");
        refuses(lines.replace("0 0 2", "0 0"), "xyz of <origin> of joint mount is 0 0, legal: 3 numbers");
        refuses(lines.replace("<mass value='2.0'/>", "<mass value='-2'/>"), "value of <mass> of link upper is -2, "
            + "legal: numbers from 0 to 1000000");
        refuses(lines.replace("<child link='upper'/>", "<child link='base'/>"),
            "legal: a link that no other joint moves");
        refuses("<robot><link name='a'/><link name='b'/></robot>", "a second link without a parent");
        refuses("<robot><link name='a'/><link name='a'/></robot>", "legal: a name that no other link has");
        refuses("<robot><link name='a'/><link name='b'/><joint name='c' type='fixed'><parent link='a'/>"
            + "<child link='b'/></joint><joint name='d' type='fixed'><parent link='b'/><child link='a'/></joint>"
            + "</robot>", "its own ancestor");
        refuses("<sdf/>", "the root element is <sdf>, legal: <robot> of a URDF");
        refuses("<robot name='a'>", "the text is no XML at line 1: ");
    }

    @Test
    public void attackersAreRefusedInWords() throws Exception {
        refuses("<!DOCTYPE a [<!ENTITY b SYSTEM 'file:///etc/passwd'>]>" + ARM,
            "line 1 is a document type or an entity");
        refuses("<!DOCTYPE a SYSTEM 'http://localhost:1/a.dtd'>" + ARM, "line 1 is a document type or an entity");
        refuses("<robot name='a'>&b;</robot>", "robot.urdf: ");
        refuses("<a>".repeat(5000), "the depth of nesting is 33, legal: 1 to 32");
        refuses("<robot>" + "<a/>".repeat(200_000) + "</robot>", "the number of elements is 200001, legal: ");
        refuses("<robot>" + "<link/>".repeat(1001) + "</robot>", "the number of links is 1001, legal: 1 to 1000");
        for (String number : List.of("1e308", "NaN", "Infinity", "-1e5", "0x1p1023", "9".repeat(5000))) {
            refuses(ARM.replace("0 0 2", "0 0 " + number), "xyz of <origin> of joint mount is 0 0 ");
            refuses(ARM.replace("0.1 0.2 0.3", "0.1 0.2 " + number), "size of <box> of link base is 0.1 0.2 ");
        }
        String mesh = ARM.replaceFirst("<box size='0.1 0.2 0.3'/>", "<mesh filename='file:///etc/../etc/passwd.stl'/>");
        add(mesh);
        assertTrue(notes.toString(), notes.toString().contains("there is no such file in the URDF's folder"));
    }

    @Test
    public void mutatedFilesAreReadOrRefusedInWords() throws Exception {
        String text = Files.readString(Path.of(System.getProperty("sear.root", "."), "examples/arm.urdf"));
        Random random = new Random(61);
        for (int i = 0; i < 2000; i++) {
            StringBuilder mutated = new StringBuilder(text);
            for (int change = random.nextInt(3); change >= 0; change--) {
                int at = random.nextInt(mutated.length());
                int until = Math.min(mutated.length(), at + random.nextInt(20));
                String other = text.substring(random.nextInt(text.length() - 30)).substring(0, random.nextInt(30));
                mutated.replace(at, until, random.nextBoolean() ? other : String.valueOf((char) random.nextInt(300)));
            }
            try {
                new UrdfFile("a.urdf", mutated.toString().getBytes(StandardCharsets.UTF_8));
            } catch (InvalidFile e) {
                assertTrue(e.getMessage(), e.getMessage().startsWith("a.urdf: ")
                    && e.getMessage().contains(", legal: "));
            }
        }
    }

    @Test
    public void whatIsLeftOutIsListedWithItsLines() throws Exception {
        add(ARM.replace("<gazebo/>", "\n<transmission/>\n<transmission/>")
            .replace("<dynamics ", "<dynamics spring='1' ").replace("<axis ", "<safety_controller/><axis "));
        assertEquals(List.of("<safety_controller> of a joint is left out (line 1)",
            "attribute spring of <dynamics> is left out (line 1)",
            "<transmission> of the robot is left out (lines 2, 3)"), notes);
    }

    @Test
    public void jointsStartWhereTheyAreTold() throws Exception {
        Path file = project.getRoot().toPath().resolve("robot.urdf");
        Files.write(file, ARM.getBytes(StandardCharsets.UTF_8));
        UrdfImport.add(file, project.folder(), Pose.IDENTITY, true, Map.of("shoulder", 90.0), notes);
        try (Simulation simulation = Simulation.load(project.folder(), 1)) {
            double[] ahead = simulation.getPose("arm upper").rotate(0, 0, 1);
            assertEquals("URDF's x axis points downwards", -1, ahead[1], 1e-9);
            assertEquals(90, position(simulation, "arm shoulder"), 1e-9);
            for (int i = 0; i < 600; i++) {
                simulation.step();
            }
            assertEquals("at the limit of 3 rad or hanging", 90, position(simulation, "arm shoulder"), 15);
        }
        try {
            UrdfImport.add(file, project.folder(), Pose.IDENTITY, true, Map.of("shoulder", 180.0), notes);
            fail();
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("the position of joint shoulder is 180.0, legal: "
                + "-57.2958 degrees to 171.887 degrees"));
        }
    }

    @Test
    public void jointsWhoseLimitsExclude0StartAtTheNearest() throws Exception {
        Project read = add(ARM.replace("lower='-1'", "lower='0.5'"));
        Hinge hinge = (Hinge) read.getJoints().stream().filter(Hinge.class::isInstance).findFirst().get();
        assertEquals(Math.toDegrees(0.5), hinge.getStart(), 1e-9);
        assertTrue(notes.toString(), notes.get(notes.size() - 1).startsWith("0 is no position of joint shoulder, which "
            + "starts at 28.6479 degrees"));
    }

    @Test
    public void theExampleArmReachesAndGrips() throws Exception {
        Path file = Path.of(System.getProperty("sear.root", "."), "examples/arm.urdf");
        assertEquals("arm", UrdfImport.add(file, project.folder(), null, true, Map.of(), notes));
        assertEquals(List.of(), notes.stream().filter(note -> !note.startsWith("<visual>"))
            .collect(Collectors.toList()));
        try (Simulation simulation = Simulation.load(project.folder(), 1)) {
            drive(simulation, "arm lift", 45);
            drive(simulation, "arm elbow", 60);
            drive(simulation, "arm grip", 0.03);
            for (int i = 0; i < 300; i++) {
                simulation.step();
            }
            assertEquals(45, position(simulation, "arm lift"), 1);
            assertEquals(60, position(simulation, "arm elbow"), 1);
            assertEquals(0.03, position(simulation, "arm grip"), 0.001);
            assertEquals("mimic", position(simulation, "arm grip"), position(simulation, "arm grip_right"), 1e-5);
        }
    }

    private static void drive(Simulation simulation, String joint, double position) {
        simulation.order(new ActuatorOrder(ActuatorOrder.Kind.JOINT_POSITION, joint, position));
    }

    private static double position(Simulation simulation, String joint) {
        return simulation.getJoints().reading(joint).numbers()[0];
    }

    @Test
    public void aZipFileWithPackagesIsImported() throws Exception {
        Path zip = project.getRoot().toPath().resolve("robots.zip");
        String urdf = ARM.replaceFirst("<box size='0.1 0.2 0.3'/>",
            "<mesh filename='package://arm_description/meshes/part.stl' scale='0.001 0.001 0.001'/>");
        String stl = "solid a\n" + facet("0 0 0", "0 1000 0", "1000 0 0") + facet("0 0 0", "1000 0 0", "0 0 1000")
            + facet("0 0 0", "0 0 1000", "0 1000 0") + facet("1000 0 0", "0 1000 0", "0 0 1000") + "endsolid a\n";
        try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(zip))) {
            entry(out, "arm_description/urdf/arm.urdf", urdf);
            entry(out, "arm_description/meshes/part.stl", stl);
            entry(out, "other/b.urdf", "<robot name='b'><link name='l'/></robot>");
        }
        try {
            UrdfImport.add(zip, project.folder(), null, false, Map.of(), notes);
            fail();
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("the number of its URDFs is 2, legal: one "
                + "of them, by "));
        }
        UrdfImport.add(zip.resolve("arm_description/urdf/arm.urdf"), project.folder(), null, false, Map.of(), notes);
        Project read = Project.read(project.folder());
        Model model = (Model) read.getRobots().get(0).getComponents().stream().filter(Model.class::isInstance)
            .findFirst().get();
        assertEquals("arm/meshes/part.stl", model.getPath());
        assertEquals(0.001, model.getScaleX(), 0);
        Simulation.load(project.folder(), 1).close();
        assertTrue(UrdfImport.isRobot(zip));
    }

    @Test
    public void namesInUseAreNotTakenAgain() throws Exception {
        SEARrobot cart = new SEARrobot("cart");
        cart.addComponent(new Box("Arm", 0.1, 0.1, 0.1, 1));
        assertTrue(add(ARM).getRobots().stream().anyMatch(robot -> robot.getName().equals("arm_2")));
    }

    @Test
    public void aLinkThatLeadsElsewhereIsNotCopied() throws Exception {
        Path folder = project.getRoot().toPath();
        Files.writeString(folder.resolve("part.obj"), "mtllib part.mtl\nmtllib inside.mtl\nv 0 0 0\nv 0 1 0\nv 1 0 0\n"
            + "v 0 0 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n");
        Files.writeString(folder.resolve("inside.mtl"), "newmtl a\n");
        Files.createSymbolicLink(folder.resolve("part.mtl"), Path.of("/etc/passwd"));
        add(ARM.replaceFirst("<box size='0.1 0.2 0.3'/>", "<mesh filename='part.obj'/>"));
        assertEquals(List.of("inside.mtl", "part.obj"), files().stream().filter(Files::isRegularFile)
            .map(file -> file.getFileName().toString()).filter(name -> name.endsWith(".mtl") || name.endsWith(".obj"))
            .collect(Collectors.toList()));
    }

    private static String facet(String a, String b, String c) {
        return "facet normal 0 0 0\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c
            + "\nendloop\nendfacet\n";
    }

    private static void entry(ZipOutputStream out, String name, String text) throws IOException {
        out.putNextEntry(new ZipEntry(name));
        out.write(text.getBytes(StandardCharsets.UTF_8));
        out.closeEntry();
    }

    @Test
    public void aFailedImportLeavesTheProject() throws Exception {
        add(ARM);
        List<Path> before = files();
        refuses(ARM.replace("'revolute'", "'screw'"), "type of <joint>");
        assertEquals(before, files());
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> all = Files.walk(project.folder())) {
            return all.sorted().collect(Collectors.toList());
        }
    }

    private void refuses(String text, String part) throws Exception {
        try {
            add(text);
            fail(text);
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().contains(part));
        }
    }
}
