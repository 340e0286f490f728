// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.robot.Robot;
import org.SEAR.sensors.LidarScan;
import org.junit.Rule;
import org.junit.Test;

/** Same project, seed and commands: same bytes. */
public class DeterminismTest {
    private static final int STEPS = 1200;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private SEARrobot world(boolean more) {
        new Floor("floor", 50, 50);
        Random random = new Random(5);
        for (int i = 0; i < 30; i++) {
            Box box = new Box("box" + i, 0.2 + 0.3 * random.nextDouble(), 0.3, 0.3, i % 3 == 0 ? 0 : 1 + i);
            box.move(6 * random.nextDouble() - 3, 0.15, 6 * random.nextDouble() - 2);
            box.rotate(0, 360 * random.nextDouble(), 0);
        }
        new Cylinder("bin", 0.2, 0.5, 3).move(0, 0.25, 1);
        SEARrobot robot = Worlds.roomba("roomba", 0, -3, 0);
        LIDAR lidar = new LIDAR("lidar");
        lidar.move(0, 0.1, 0.1);
        lidar.setNoise(new Noise().setWhite(0.01));
        robot.addComponent(lidar);
        if (more) {
            robot.addComponent(new Gyroscope("gyro"));
        }
        Worlds.roomba("second", 2, -3, -30);
        return robot;
    }

    private static long run(Simulation simulation) {
        long hash = 1;
        for (int i = 0; i < STEPS; i++) {
            if (i == 60) {
                simulation.post(world -> world.getRobots().get(0).drive(0.4, Double.POSITIVE_INFINITY));
                simulation.post(world -> world.getRobots().get(1).drive(0.3, 2));
            }
            simulation.step();
            for (Pose pose : simulation.snapshot().environment) {
                hash = 31 * hash + pose.toString().hashCode();
            }
            for (Robot robot : simulation.getRobots()) {
                hash = 31 * hash + robot.getPose().toString().hashCode();
                hash = 31 * hash + Double.hashCode(robot.getHardware().getLeftWheelAngle());
            }
            if (i % 10 == 0) {
                LidarScan scan = (LidarScan) simulation.read("lidar");
                for (double range : scan.ranges()) {
                    hash = 31 * hash + Double.hashCode(range);
                }
            }
        }
        return hash;
    }

    @Test
    public void freshStartAndResetGiveTheSameAndOtherCommandsDoNot() throws Exception {
        world(false);
        Simulation simulation = Worlds.start(project);
        long first = run(simulation);
        assertTrue("nothing was pushed", simulation.snapshot().environment.stream().anyMatch(pose -> pose.qx != 0));
        simulation.reset();
        assertEquals(0, simulation.snapshot().step);
        assertEquals("after reset", first, run(simulation));
        assertEquals("fresh start", first, run(Worlds.start(project)));
        Simulation other = Worlds.start(project);
        other.post(world -> world.getRobots().get(0).drive(0.1, 1));
        assertNotEquals(first, run(other));
    }

    @Test
    public void aResetWithAnotherSeedIsAFreshStartWithIt() throws Exception {
        SEARrobot robot = world(false);
        Camera eye = new Camera("eye", 0, 0.2, 0.1);
        eye.setSize(16, 12);
        eye.setNoise(new Noise().setWhite(5).setDrift(2));
        robot.addComponent(eye);
        Simulation other = Simulation.of(Project.read(project.folder()), 2);
        Simulation simulation = Worlds.start(project);
        long first = run(simulation);
        double[] picture = simulation.read("eye").numbers();
        simulation.reseed(2);
        simulation.reset();
        assertEquals(2, simulation.getOrigin().seed);
        long second = run(simulation);
        assertNotEquals("the LIDAR has noise", first, second);
        assertEquals(second, run(other));
        assertFalse("the camera has noise", Arrays.equals(picture, simulation.read("eye").numbers()));
        assertArrayEquals(other.read("eye").numbers(), simulation.read("eye").numbers(), 0);
    }

    @Test
    public void watchingAndAddingASensorChangesNothing() throws Exception {
        world(false);
        long first = run(Worlds.start(project));
        world(true);
        Simulation more = Worlds.start(project);
        more.watch("gyro", true);
        more.watch("lidar", true);
        assertEquals(first, run(more));
        assertTrue(more.snapshot().readings.containsKey("gyro"));
    }
}
