// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.FixedJoint;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.ForceTorque;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** A load in front of a robot, measured at its joint as statics says. */
public class ForceTorqueTest {
    private static final double G = 9.81;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private SEARrobot robotWithLoad(double heading) {
        new Floor("floor", 20, 20);
        SEARrobot robot = Worlds.roomba("robot", 0, 0, heading);
        double turn = Math.toRadians(heading);
        Box load = new Box("load", 0.05, 0.05, 0.05, 0.5);
        load.move(0.3 * Math.sin(turn), 0.3, 0.3 * Math.cos(turn));
        load.rotate(0, heading, 0);
        FixedJoint arm = new FixedJoint("arm", robot, load, 0.1 * Math.sin(turn), 0.3, 0.1 * Math.cos(turn));
        assertEquals("load", arm.getSecond());
        return robot;
    }

    private double[] read(String name) throws Exception {
        try (Simulation world = Simulation.of(Project.read(project.folder()), 1)) {
            Worlds.run(world, 2);
            return world.read(name).numbers();
        }
    }

    @Test
    public void aLoadIsMeasuredAlongTheBodyAxesWhateverTheHeading() throws Exception {
        for (double heading : new double[] {0, 130}) {
            SEARrobot robot = robotWithLoad(heading);
            robot.addComponent(new ForceTorque("wrist", "arm"));
            assertArrayEquals("0.5 kg, 0.2 m ahead of the joint", new double[] {0, 0.5 * G, 0, -0.2 * 0.5 * G, 0, 0},
                read("wrist"), 0.02);
            ProjectSwap.delete(project.folder());
        }
    }

    @Test
    public void aRotatedSensorMeasuresAlongItsOwnAxes() throws Exception {
        ForceTorque wrist = new ForceTorque("wrist", "arm");
        robotWithLoad(0).addComponent(wrist);
        wrist.rotate(0, 0, 90);
        assertArrayEquals("its x axis points up", new double[] {0.5 * G, 0, 0, 0, 0.2 * 0.5 * G, 0}, read("wrist"),
            0.02);
        try (Simulation world = Simulation.of(Project.read(project.folder()), 1)) {
            assertEquals(List.of(".fx", ".fy", ".fz", ".tx", ".ty", ".tz"), world.read("wrist").names());
            assertTrue(world.read("wrist").words("").endsWith(" N m"));
        }
    }

    @Test
    public void anUnknownJointIsReported() throws Exception {
        robotWithLoad(0).addComponent(new ForceTorque("wrist", "elbow"));
        String said = assertThrows(ProjectException.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(said, said.contains("joint is \"elbow\", legal: the name of a joint"));
    }
}
