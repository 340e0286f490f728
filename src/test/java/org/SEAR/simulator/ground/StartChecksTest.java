// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ground;

import static org.junit.Assert.assertEquals;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** The start warns about causes that keep a robot from driving. */
public class StartChecksTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void aRobotWithoutGroundIsReported() throws Exception {
        Worlds.roomba("roomba", 1, 2, 0);
        assertEquals("[robot roomba has no ground below its start at x 1.00, y 0.10, z 2.00 and will fall:"
            + " Floor(\"floor\", 20, 20) makes one at height 0]", Worlds.start(project).snapshot().warnings.toString());
    }

    @Test
    public void aRobotWithoutWheelsIsReported() throws Exception {
        new Floor("floor", 10, 10);
        SEARrobot robot = new SEARrobot("post");
        robot.addComponent(new Dynamics("dynamics", 1, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 0));
        robot.addComponent(new Box("body", 0.2, 0.2, 0.2, 1));
        assertEquals("[robot post has no wheels and can't drive: robot.addWheel(Wheel(...)) adds one]",
            Worlds.start(project).snapshot().warnings.toString());
    }

    @Test
    public void oneWithBothIsFine() throws Exception {
        new Floor("floor", 10, 10);
        Worlds.roomba("roomba", 0, 0, 0);
        assertEquals("[]", Worlds.start(project).snapshot().warnings.toString());
    }

    @Test
    public void aRobotWithOtherWheelsThanInItsFirmwareIsReported() throws Exception {
        new Floor("floor", 10, 10);
        SEARrobot robot = new SEARrobot("old");
        Dynamics drive = new Dynamics("drive", 4, 0, 0.1, 0, 0, 0, 0);
        drive.setModel("create2");
        robot.addComponent(drive);
        robot.addComponent(new Box("body", 0.2, 0.1, 0.05, 4));
        robot.addWheel(new Wheel("left", 0.0381, 0.03, 1, 0.16, 0, 0));
        robot.addWheel(new Wheel("right", 0.0381, 0.03, 1, -0.16, 0, 0));
        robot.addWheel(new Wheel("front", 0.0381, 0.03, 0, 0, 0, 0.16));
        robot.addWheel(new Wheel("back", 0.0381, 0.03, 0, 0, 0, -0.16));
        assertEquals("without a port nobody asks", "[]", Worlds.start(project).snapshot().warnings.toString());
        drive.setPorts("/dev/uart", "/dev/user");
        assertEquals("[robot old answers as a create2, whose wheels are 0.235 m apart, but its own are 0.320 m apart: "
            + "drivers misjudge its turns."
            + " Robots.create2(name) makes a robot that fits, robot old answers as a create2, whose wheels have a "
            + "radius of 0.036 m,"
            + " but its wheel left has 0.038 m: drivers misjudge its distances. Robots.create2(name) makes a "
            + "robot that fits]", Worlds.start(project).snapshot().warnings.toString());
    }

    @Test
    public void readyRobotsAreFineAndStandJustAboveTheGround() throws Exception {
        new Floor("floor", 10, 10);
        Robots.create2("one", "/dev/uart", "/dev/user");
        Robots.create("two", "/dev/uart2", "/dev/user2").move(1, 0, 0);
        Robots.roomba400("three").move(-1, 0, 0);
        Simulation simulation = Worlds.start(project);
        assertEquals("[]", simulation.snapshot().warnings.toString());
        Worlds.run(simulation, 1);
        simulation.getRobots().forEach(robot -> assertEquals(robot.toString(), 0.0535, robot.getPose().y, 0.001));
    }
}
