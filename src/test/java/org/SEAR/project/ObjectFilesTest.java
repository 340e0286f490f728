// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.xml.Xml;
import org.junit.Rule;
import org.junit.Test;

/** Files that objects write, and objects read from files. */
public class ObjectFilesTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static final String BOX = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Box>\n  <name>Box1_name</name>\n  "
        + "<x>-1.5</x>\n  <y>1.25</y>\n  <z>0</z>\n  <rx>45</rx>\n  <ry>0</ry>\n  <rz>0</rz>\n"
        + "  <mass>0</mass>\n  <scaleX>1</scaleX>\n  <scaleY>1</scaleY>\n  <scaleZ>1</scaleZ>\n"
        + "  <visibleToSensors>true</visibleToSensors>\n  <length>0.25</length>\n  <width>0.25</width>\n  "
        + "<height>0.25</height>\n</Box>\n";

    private static void createListing2() {
        SEARrobot robot = new SEARrobot("myRoomba");
        Dynamics dynamics = new Dynamics("robotDynamics1", 400, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 180);
        dynamics.setPorts("/dev/my_Robot01", "/dev/SEAR_Robot_01");
        robot.addComponent(dynamics);
        robot.addComponent(new Cylinder("Roomba Body", 0.1666875, 0.0762, 400, "./textures/roomba.jpg"));
        Wheel front = new Wheel("frontWheel", 0.0381, 0.03, 0);
        front.move(0, 0, 0.16);
        robot.addWheel(front);
        Wheel right = new Wheel("rightWheel", 0.0381, 0.03, 1);
        robot.addWheel(right);
        right.move(-0.16, 0, 0);
        LIDAR lidar = new LIDAR("myLidar");
        lidar.setPorts("/dev/my_Lidar01", "/dev/SEAR_LIDAR_01");
        lidar.move(0, 0.15, 0.2);
        robot.addComponent(lidar);
        lidar.setNoise(new Noise().setWhite(0.01));
    }

    @Test
    public void anObjectWritesItsFileWhenItIsCreatedAndAfterEachChange() throws Exception {
        Box box = new Box("Box1_name", 0.25, 0.25, 0.25, 0);
        box.move(-1.5, 1.25, 0);
        box.rotate(45, 0, 0);
        assertEquals(Set.of("environment/Box1_name.xml"), project.files().keySet());
        assertEquals(BOX, project.text("environment/Box1_name.xml"));
    }

    @Test
    public void aColourIsWrittenOnceItIsSet() throws Exception {
        Box box = new Box("Box1_name", 0.25, 0.25, 0.25, 0);
        assertEquals("#c49a6c", box.getColor());
        assertEquals("textures/cardboard.png", box.getPicture());
        box.setColor("Orange");
        assertTrue(project.text("environment/Box1_name.xml"), project.text("environment/Box1_name.xml")
            .contains("\n  <color>Orange</color>\n"));
        Box read = (Box) Project.read(project.folder()).getEnvironment().get(0);
        assertTrue(read.hasColor());
        assertEquals("#ffa500", read.getColor());
        assertNull("plain", read.getPicture());
        box.setImage("textures/brick.png");
        assertEquals("textures/brick.png", box.getPicture());
        box.setImage(null);
        box.setColor("#12AbEf");
        assertEquals("#12abef", box.getColor());
        box.setColor(null);
        assertFalse(project.text("environment/Box1_name.xml").contains("color"));
    }

    @Test
    public void namesOfTheDissertationAreFileNames() throws Exception {
        new Floor("floor", 50, 50);
        new Cylinder("trash Can", 0.25, 0.75, 10);
        new Cone("Traffic Cone", 0.25, 2, 10);
        assertEquals(Set.of("environment/floor.xml", "environment/trash Can.xml", "environment/Traffic Cone.xml"),
            project.files().keySet());
        assertEquals(Arrays.asList("Traffic Cone", "floor", "trash Can"),
            Project.read(project.folder()).getEnvironment().stream().map(SearObject::getName)
                .collect(Collectors.toList()));
    }

    @Test
    public void componentsMoveToTheRobotFolderAndWheelsIntoTheRobotsFile() throws Exception {
        createListing2();
        assertEquals(Set.of("robot/myRoomba.xml",
            "robot/robotDynamics1.xml", "robot/Roomba Body.xml", "robot/myLidar.xml"), project.files().keySet());
        SEARrobot robot = Project.read(project.folder()).getRobots().get(0);
        assertEquals(List.of("robotDynamics1", "Roomba Body", "myLidar"), robot.getComponentNames());
        assertEquals(-0.16, robot.getWheels().get(1).getX(), 0);
        assertFalse(robot.getWheels().get(0).isDriven());
        LIDAR lidar = (LIDAR) robot.getComponents().get(2);
        assertEquals("/dev/SEAR_LIDAR_01", lidar.getUserPort());
        assertEquals(0.01, lidar.getNoise().getWhite(), 0);
    }

    @Test
    public void readObjectsAreWrittenWithTheSameBytes() throws Exception {
        createListing2();
        SEARrobot robot = Project.read(project.folder()).getRobots().get(0);
        assertEquals(project.text("robot/myRoomba.xml"), Xml.write(robot));
        for (SearObject component : robot.getComponents()) {
            assertEquals(project.text("robot/" + component.getName() + ".xml"), Xml.write(component));
        }
    }

    @Test
    public void theSameScriptRunAgainGivesTheSameFiles() throws Exception {
        createListing2();
        Object first = project.files();
        createListing2();
        assertEquals(first, project.files());
        assertTrue(Project.read(project.folder()).getWarnings().toString(), Project.read(project.folder()).getRobots()
            .size() == 1);
    }

    @Test
    public void anyOrderCommentsAndMissingOptionalElementsAreRead() throws Exception {
        project.put("environment/hand made.xml",
            "<!-- mine --><Box><mass>2</mass><!-- kg -->\n<height> 1 "
                + "</height><width>2</width><length>3e0</length><name>hand made</name></Box>");
        Box box = (Box) Project.read(project.folder()).getEnvironment().get(0);
        assertEquals(3, box.getLength(), 0);
        assertEquals(2, box.getMass(), 0);
        assertEquals(1, box.getScaleX(), 0);
        assertTrue(box.isVisibleToSensors());
    }

    @Test
    public void distanceTakesNamedBeamsConesAndPlainLists() throws Exception {
        SEARrobot robot = new SEARrobot("r");
        robot.addComponent(new Distance("ping", "PING)))"));
        robot.addComponent(new Distance("MaxBotics EZ1"));
        robot.addComponent(new Distance(
            "own", Arrays.asList(Arrays.asList(20, 1.5), Arrays.asList(10, 3, "#00ff00", 8, -5, 2))));
        robot.addComponent(new GPS("gpsUnit1", 33.61, 182.5, -80.865));
        List<SearObject> read = Project.read(project.folder()).getRobots().get(0).getComponents();
        assertEquals("PING)))", ((Distance) read.get(0)).getShape().getName());
        assertEquals("LV-EZ1", ((Distance) read.get(1)).getShape().getName());
        assertEquals(-5, ((Distance) read.get(2)).getCones().get(1).getYaw(), 0);
        assertSame(8, ((Distance) read.get(2)).getCones().get(1).getLines());
    }
}
