// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** Imports of robots and environments from other projects. */
public class ImportTest {
    private static final String BEAM = "<Beam><name>own</name><minRange>0</minRange>"
        + "<cone><halfAngle>5</halfAngle><range>RANGE</range></cone></Beam>";

    @Rule
    public final ProjectRule project = new ProjectRule();
    private Path bundle;

    @Before
    public void haveABundle() throws Exception {
        project.put("robot/rover.xml",
            "<SEARrobot><name>rover</name><component>drive</component><component>body</component>"
            + "<component>eye</component></SEARrobot>");
        project.put("robot/drive.xml",
            "<Dynamics><name>drive</name><mass>3</mass><uartPort>COM1</uartPort><userPort>COM2</userPort></Dynamics>");
        project.put("robot/body.xml", "<Box><name>body</name><length>1</length>"
            + "<width>1</width><height>1</height><image>skin.png</image></Box>");
        project.put("robot/eye.xml", "<Distance><name>eye</name><beam>own</beam></Distance>");
        project.put("beams/own.xml", BEAM.replace("RANGE", "2"));
        project.put("assets/skin.png", "one");
        project.put("environment/crate.xml",
            "<Box><name>crate</name><length>1</length><width>1</width><height>1</height></Box>");
        bundle = project.getRoot().toPath().resolve("rover.sear");
        Bundle.save(project.folder(), bundle);
    }

    private Project read() throws ProjectException {
        return Project.read(project.folder());
    }

    private static String parts(SEARrobot robot) {
        return robot.getName() + robot.getComponents().stream().map(part -> part.getName())
            .collect(Collectors.toList());
    }

    @Test
    public void jointsComeWithAllTheirObjectsAndOthersAreNamed() throws Exception {
        project.put("environment/mast.xml", "<Hinge><name>mast</name><second>rover</second></Hinge>");
        project.put("environment/hook.xml",
            "<BallJoint><name>hook</name><first>crate</first><second>rover</second></BallJoint>");
        project.put("environment/pin.xml", "<FixedJoint><name>pin</name><second>crate</second></FixedJoint>");
        project.put("environment/crate.xml", project.text("environment/crate.xml").replace("</height>",
            "</height><mass>1</mass>"));
        project.put("robot/rover.xml", project.text("robot/rover.xml").replace("<component>eye</component>",
            "<component>eye</component><component>scale</component><component>wrist</component>"));
        project.put("robot/scale.xml", "<ForceTorque><name>scale</name><joint>mast</joint></ForceTorque>");
        project.put("robot/wrist.xml", "<ForceTorque><name>wrist</name><joint>hook</joint></ForceTorque>");
        Bundle.save(project.folder(), bundle);
        List<String> said = new ArrayList<>();
        Map<String, String> renamed = Bundle.importRobot(bundle, project.folder(), "rover", saying(said));
        assertEquals("mast_2", renamed.get("mast"));
        assertEquals("[ForceTorque \"wrist\" stays behind: the import does not copy hook, which it measures, "
            + "BallJoint \"hook\" stays behind: the import does not copy crate, which it joins]", said.toString());
        assertEquals("[BallJoint \"hook\", Hinge \"mast\", Hinge \"mast_2\", FixedJoint \"pin\"]",
            read().getJoints().toString());
        assertEquals("rover_2", read().getJoints().get(2).getSecond());
        assertTrue(project.text("robot/rover_2/scale.xml").contains("<joint>mast_2</joint>"));
        said.clear();
        renamed = Bundle.importEnvironment(bundle, project.folder(), saying(said));
        assertEquals("pin_2", renamed.get("pin"));
        assertEquals("[BallJoint \"hook\" stays behind: the import does not copy rover, which it joins, "
            + "Hinge \"mast\" stays behind: the import does not copy rover, which it joins]", said.toString());
    }

    @Test
    public void jointsWithinARobotComeWithItsParts() throws Exception {
        project.put("robot/rover.xml", project.text("robot/rover.xml").replace("<component>eye</component>",
            "<component>eye</component><component>arm</component><component>pivot</component>"));
        project.put("robot/arm.xml", project.text("environment/crate.xml").replace("crate", "arm"));
        project.put("robot/pivot.xml", "<Hinge><name>pivot</name><second>arm</second><part>eye</part></Hinge>");
        Bundle.save(project.folder(), bundle);
        project.put("robot/rover.xml", project.text("robot/rover.xml")
            .replace("<component>arm</component><component>pivot</component>", ""));
        Files.delete(project.folder().resolve("robot/arm.xml"));
        Files.delete(project.folder().resolve("robot/pivot.xml"));
        project.put("environment/arm.xml", project.text("environment/crate.xml").replace("crate", "arm"));
        Map<String, String> renamed = Bundle.importRobot(bundle, project.folder(), "rover", saying(new ArrayList<>()));
        assertEquals("the world has an arm", "arm_2", renamed.get("arm"));
        Joint pivot = read().getAllJoints().get(0);
        assertEquals("arm_2 [eye]", pivot.getSecond() + " " + pivot.getPartNames());
    }

    @Test
    public void gearsComeWithTheJointsThatTheyFollow() throws Exception {
        project.put("environment/crate.xml", project.text("environment/crate.xml").replace("</height>",
            "</height><mass>1</mass>"));
        project.put("environment/mast.xml", "<Hinge><name>mast</name><second>rover</second></Hinge>");
        project.put("environment/axle.xml", "<Hinge><name>axle</name><second>crate</second><gear>rack</gear></Hinge>");
        project.put("environment/rack.xml",
            "<Slider><name>rack</name><second>crate</second><gear>mast</gear></Slider>");
        Bundle.save(project.folder(), bundle);
        List<String> said = new ArrayList<>();
        Bundle.importEnvironment(bundle, project.folder(), saying(said));
        assertTrue(project.text("environment/axle_2.xml").contains("<gear>rack_2</gear>"));
        assertFalse(project.text("environment/rack_2.xml").contains("<gear>"));
        assertTrue(said.toString(), said.contains("Slider \"rack\" leaves its gear behind: the import does not copy "
            + "mast, which it follows"));
    }

    private static Progress saying(List<String> said) {
        return new Progress() {
            @Override
            public void at(String file, long done, long total) {
                // only messages count
            }

            @Override
            public void said(String line) {
                if (line.contains("behind")) {
                    said.add(line);
                }
            }
        };
    }

    @Test
    public void theSameRobotIsPlacedTwice() throws Exception {
        Map<String, String> renamed = Bundle.importRobot(bundle, project.folder(), "rover", Progress.NONE);
        assertEquals("{rover=rover_2, drive=drive, body=body, eye=eye}", renamed.toString());
        assertEquals("rover[drive, body, eye]", parts(read().getRobots().get(0)));
        assertEquals("rover_2[drive, body, eye]", parts(read().getRobots().get(1)));
        assertTrue(project.text("robot/rover_2/drive.xml"), project.text("robot/rover_2/drive.xml")
            .contains("<uartPort>COM1_2</uartPort>"));
        assertTrue(project.text("robot/rover_2/body.xml"), project.text("robot/rover_2/body.xml")
            .contains("<image>skin.png</image>"));
        assertTrue(project.text("robot/rover_2/eye.xml"), project.text("robot/rover_2/eye.xml")
            .contains("<beam>own</beam>"));
        assertEquals("rover_3", Bundle.importRobot(bundle, project.folder(), "", Progress.NONE).get("rover"));
        assertEquals(3, read().getRobots().size());
        assertEquals(1, read().getEnvironment().size());
    }

    @Test
    public void beamsAndPicturesOfOtherContentStayApart() throws Exception {
        project.put("beams/own.xml", BEAM.replace("RANGE", "7"));
        project.put("assets/skin.png", "two");
        Bundle.importRobot(bundle, project.folder(), "rover", Progress.NONE);
        assertTrue(project.text("robot/rover_2/eye.xml"), project.text("robot/rover_2/eye.xml")
            .contains("<beam>own_2</beam>"));
        assertTrue(project.text("beams/own_2.xml"), project.text("beams/own_2.xml").contains("<range>2</range>"));
        assertTrue(project.text("beams/own.xml"), project.text("beams/own.xml").contains("<range>7</range>"));
        assertTrue(project.text("robot/rover_2/body.xml"), project.text("robot/rover_2/body.xml")
            .contains("<image>imported1/skin.png</image>"));
        assertEquals("one", project.text("assets/imported1/skin.png"));
        assertEquals("two", project.text("assets/skin.png"));
    }

    @Test
    public void anEnvironmentComesFromAFolderToo() throws Exception {
        Path other = project.getRoot().toPath().resolve("other/SEARproject");
        Files.createDirectories(other.getParent());
        Bundle.load(bundle, other);
        assertEquals("{crate=crate_2}", Bundle.importEnvironment(other.getParent(), project.folder(), Progress.NONE)
            .toString());
        assertEquals(2, read().getEnvironment().size());
        Bundle.newProject(project.folder(), Progress.NONE);
        assertEquals("{crate=crate}", Bundle.importEnvironment(other, project.folder(), Progress.NONE).toString());
        assertEquals(0, read().getRobots().size());
    }

    @Test
    public void aFolderIsLoadedAsACopy() throws Exception {
        Path mine = project.getRoot().toPath().resolve("mine/SEARproject");
        Files.createDirectories(mine.getParent());
        assertEquals("rover", Bundle.load(project.folder(), mine).getRobots().get(0).getName());
        assertEquals(ProjectRule.files(project.folder()), ProjectRule.files(mine));
    }

    @Test
    public void aFailedImportChangesNothing() throws Exception {
        Map<String, String> before = ProjectRule.files(project.folder());
        try {
            Bundle.importRobot(bundle, project.folder(), "nobody", Progress.NONE);
            fail("imported");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("robot is \"nobody\", legal: a robot of")
                && e.getMessage().contains("[rover]"));
        }
        try {
            Bundle.importEnvironment(Paths.get("nothere.sear"), project.folder(), Progress.NONE);
            fail("imported");
        } catch (ProjectException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("there is no such file"));
        }
        assertEquals(before, ProjectRule.files(project.folder()));
    }
}
