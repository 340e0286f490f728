// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.documents.DocBlock;
import org.SEAR.geometry.Pose;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** Projects as users write them: by the instructions of the docs, with typical assumptions. */
public class HandWrittenProjectTest {
    private static final String ROBOT = "<SEARrobot><name>r</name><wheel><name>left</name>"
        + "<radius>0.1</radius><width>0.1</width></wheel></SEARrobot>";

    @Rule
    public final ProjectRule project = new ProjectRule();

    private void robotOfThePage() throws Exception {
        for (String block : DocBlock.of("docs/projects.md", "xml")) {
            String name = block.replaceAll("(?s)<\\w+>\n  <name>([^<]+)</name>.*", "$1");
            project.put((block.startsWith("<Beam>") ? "beams/" : "robot/") + name + ".xml", block);
        }
    }

    @Test
    public void theRobotOfThePageStandsLevelAndDrives() throws Exception {
        robotOfThePage();
        new Floor("floor", 20, 20);
        Simulation world = Simulation.load(project.folder(), 1);
        assertEquals(List.of(), world.snapshot().warnings);
        steps(world, 60);
        double[] up = world.getPose("rover").rotate(0, 1, 0);
        assertTrue("tilted by " + Math.toDegrees(Math.acos(Math.min(1, up[1]))) + " degrees",
            up[1] > Math.cos(Math.toRadians(0.5)));
        assertEquals(3.0, (Double) world.read("frontEye").value(), 1e-9);
        Pose start = world.getPose("rover");
        world.post(DriveCommand.wheels(0, 0.3, 0.3));
        steps(world, 240);
        assertEquals(0.3 * 4, world.getPose("rover").z - start.z, 0.05);
        assertEquals(0, world.getPose("rover").x - start.x, 0.02);
        assertTrue(world.getPose("rover").rotate(0, 1, 0)[1] > Math.cos(Math.toRadians(2)));
        assertEquals(List.of(), world.snapshot().warnings);
    }

    private static void steps(Simulation world, int count) {
        for (int i = 0; i < count; i++) {
            world.step();
        }
    }

    @Test
    public void theRobotOfThePageIsWholeAndStarts() throws Exception {
        robotOfThePage();
        Simulation world = Simulation.load(project.folder(), 1);
        world.step();
        assertEquals(List.of("frontEye"), world.getSensorNames());
        assertEquals(List.of(), Project.read(project.folder()).getWarnings());
    }

    @Test
    public void everyRobotMayHaveALeftWheel() throws Exception {
        for (String name : List.of("first", "second")) {
            SEARrobot robot = new SEARrobot(name);
            robot.addComponent(new Dynamics(name + " drive", 2));
            Wheel left = new Wheel("left", 0.1, 0.05);
            robot.addWheel(left);
            left.move(0.2, 0, 0);
        }
        assertEquals(2, Project.read(project.folder()).getRobots().size());
        new Box("left", 1, 1, 1);
        try {
            Project.read(project.folder());
            throw new AssertionError("a wheel has the name of a box");
        } catch (ProjectException e) {
            assertEquals(2, e.getProblems().size());
        }
    }

    @Test
    public void aRobotWithoutDynamicsIsWarnedOfBeforeItIsStarted() throws Exception {
        project.put("robot/r.xml", ROBOT);
        List<String> warnings = Project.read(project.folder()).getWarnings();
        assertTrue(warnings.toString(), warnings.size() == 1 && warnings.get(0)
            .startsWith("robot/r.xml: SEARrobot \"r\" has no Dynamics"));
    }

    @Test
    public void aFileWhoseEndingHasCapitalsIsWarnedOf() throws Exception {
        project.put("environment/crate.XML",
            "<Box><name>crate</name><length>1</length><width>1</width><height>1</height></Box>");
        List<String> warnings = Project.read(project.folder()).getWarnings();
        assertTrue(warnings.toString(), warnings.size() == 1 && warnings.get(0)
            .startsWith("environment/crate.XML is not read: "));
    }

    @Test
    public void limitsOfADeviceAreReportedAtStartAndReset() throws Exception {
        new Floor("floor", 10, 10).move(0, -0.2, 0);
        SEARrobot robot = new SEARrobot("r");
        robot.addComponent(new Dynamics("drive", 2));
        robot.addWheel(new Wheel("wheel", 0.1, 0.03, 1, 0, 0, 0));
        LIDAR lidar = new LIDAR("lidar");
        lidar.setPorts("/dev/a", "/dev/b");
        lidar.setBaud(57600);
        lidar.setSpread(90);
        robot.addComponent(lidar);
        Simulation world = Simulation.load(project.folder(), 1);
        for (int start = 0; start < 2; start++) {
            List<String> warnings = new ArrayList<>(world.snapshot().warnings);
            warnings.removeIf(warning -> !warning.startsWith("lidar: "));
            assertEquals(warnings.toString(), 2, warnings.size());
            assertTrue(warnings.toString(), warnings.get(0)
                .startsWith("lidar: spread 90.0 with resolution 1.0 is not available on an LMS200"));
            world.step();
            world.reset();
        }
    }

    /** Jython turns each byte of a plain Python 2 string into a character. */
    @Test
    public void aPlainPythonStringIsTheNameThatItsAuthorWrote() throws Exception {
        String bytes = new String("T\u00fcr".getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
        assertEquals("T\u00fcr", new Box(bytes, 1, 1, 1).getName());
        assertEquals("caf\u00e9 \u00df", new Box("caf\u00e9 \u00df", 1, 1, 1).getName());
        assertEquals("\u65e5\u672c", new Box("\u65e5\u672c", 1, 1, 1).getName());
        assertTrue(project.files().toString(), Files.exists(project.folder().resolve("environment/T\u00fcr.xml")));
        assertEquals(3, Project.read(project.folder()).getEnvironment().size());
    }
}
