// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/**
 * A start warning names each sensor that reads the floor when nothing else is nearer. One call hides all grounds from
 * beams.
 */
public class GroundCheckTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private SEARrobot robot;

    @Before
    public void build() {
        new Floor("tiles", 20, 20);
        robot = new SEARrobot("rover");
        robot.addComponent(new Dynamics("drive", 4, 0, 0.1, 0, 0, 0, 0));
        robot.addComponent(new Cylinder("body", 0.16, 0.07, 4));
        double[][] wheels = {{0, 0.16, 0}, {-0.16, 0, 1}, {0.16, 0, 1}, {0, -0.16, 0}};
        for (int i = 0; i < wheels.length; i++) {
            Wheel wheel = new Wheel("wheel" + i, 0.0381, 0.03, (int) wheels[i][2]);
            wheel.move(wheels[i][0], 0, wheels[i][1]);
            robot.addWheel(wheel);
        }
    }

    private void add(SearObject sensor, double height, double degreesDown) {
        sensor.move(0, height, 0.15);
        sensor.rotate(degreesDown, 0, 0);
        robot.addComponent(sensor);
    }

    private List<String> warnings(boolean groundVisible) throws Exception {
        try (Simulation simulation = Simulation.load(project.folder(), 1, groundVisible)) {
            return simulation.snapshot().warnings.stream().filter(one -> one.contains("sees the ground"))
                .collect(Collectors.toList());
        }
    }

    @Test
    public void aSensorThatReadsTheFloorIsReportedWithTheRemedy() throws Exception {
        add(new Distance("low", "PING)))"), 0.1, 0);
        add(new Distance("high", "PING)))"), 1.5, 0);
        add(new Distance("up", "PING)))"), 0.05, -40);
        add(new Distance("cliff", "laser"), 0, 90);
        add(new LIDAR("level"), 0.1, 0);
        Box box = new Box("before", 0.5, 0.5, 0.5, 0);
        box.move(0, 0.25, 1);
        List<String> warnings = warnings(true);
        assertEquals(warnings.toString(), 1, warnings.size());
        String warning = warnings.get(0);
        assertTrue(warning, warning.startsWith("sensor low sees the ground (tiles) at 0.4"));
        assertTrue(warning, warning.contains("sear.setGroundVisible(False)")
            && warning.contains("low.rotate(-20, 0, 0)"));
    }

    @Test
    public void aLidarThatLeansForwardIsNamedToo() throws Exception {
        LIDAR lidar = new LIDAR("leaning");
        lidar.setRange(8);
        add(lidar, 0.1, 5);
        assertTrue(warnings(true).toString().contains("sensor leaning sees the ground (tiles) at"));
    }

    @Test
    public void beamsPassThroughAllGroundsAtOnceAndTheRobotStillStands() throws Exception {
        add(new Distance("low", "PING)))"), 0, 0);
        assertFalse(warnings(true).isEmpty());
        assertTrue(warnings(false).isEmpty());
        try (Simulation simulation = Simulation.load(project.folder(), 1, false)) {
            for (int i = 0; i < 120; i++) {
                simulation.step();
            }
            assertFalse(((DistanceReading) simulation.read("low")).isReturn());
            assertEquals("on its wheels", 0.04, simulation.getPose("rover").y, 0.005);
        }
        try (Simulation simulation = Simulation.load(project.folder(), 1, true)) {
            assertEquals("tiles", ((DistanceReading) simulation.read("low")).getHitObject());
        }
    }
}
