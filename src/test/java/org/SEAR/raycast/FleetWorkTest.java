// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import static org.junit.Assert.assertTrue;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.Slow;
import org.SEAR.physics.PhysicsWorld;
import org.SEAR.physics.WheelCast;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Guards against costs that grow faster than the number of robots. It counts a robot's operations and bytes per step
 * instead of times.
 */
@Category(Slow.class)
public class FleetWorkTest {
    private static final int MANY = 36;
    private static final int BOXES = 10;
    private static final double CELL = 10;
    private static final int STEPS = 120;
    private static final int ROUNDS = 5;

    @Rule
    public final ProjectRule project = new ProjectRule();

    /**
     * Makes robots that drive in circles, each among its own boxes and with a scanner at a port, without walls between
     * them.
     */
    private void fleet(int robots) throws Exception {
        int columns = (int) Math.ceil(Math.sqrt(robots));
        new Floor("floor", CELL * columns, CELL * columns);
        Random random = new Random(5);
        for (int i = 0; i < robots; i++) {
            double x = CELL * (i % columns - (columns - 1) / 2.0);
            double z = CELL * (i / columns - (columns - 1) / 2.0);
            for (int k = 0; k < BOXES; k++) {
                double angle = 2 * Math.PI * (k + random.nextDouble()) / BOXES;
                double distance = 2.8 + 1.5 * random.nextDouble();
                new Box("box" + i + "-" + k, 0.4, 1, 0.4, 0)
                    .move(x + distance * Math.sin(angle), 0.5, z + distance * Math.cos(angle));
            }
            SEARrobot robot = Worlds.roomba("robot" + i, x - 1, z, 0);
            LIDAR lidar = new LIDAR("lidar" + i, 8, 180, 0.5, 0, 0.3, 0);
            lidar.setPorts("uart" + i, "user" + i);
            robot.addComponent(lidar);
        }
    }

    /**
     * Returns the work per robot and step: shapes moved, busy bodies, solver iterations, boxes and shapes tested by
     * beams and wheels, bytes allocated.
     */
    private double[] work(int robots) throws Exception {
        fleet(robots);
        try (Simulation simulation = Worlds.start(project)) {
            simulation.setThreads(1);
            simulation.post(world -> world.getRobots().forEach(robot -> robot.drive(0.4, 1)));
            Worlds.run(simulation, 2);
            double[] least = new double[5];
            Arrays.fill(least, Double.POSITIVE_INFINITY);
            for (int round = 0; round < ROUNDS; round++) {
                double[] now = count(simulation);
                for (int i = 0; i < least.length; i++) {
                    least[i] = Math.min(least[i], now[i] / robots / STEPS);
                }
            }
            return least;
        }
    }

    private static double[] count(Simulation simulation) {
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        PhysicsWorld physics = Worlds.physics(simulation);
        BeamScene scene = simulation.getRobots().get(0).getTruth().scene();
        RayCaster beams = BeamScene.casters().rays;
        WheelCast wheels = Worlds.scenes(simulation).wheels;
        double[] before = {scene.getMoves(), 0, physics.getSolverIterations(), beams.nodes() + beams.fanNodes
            + beams.tested + wheels.getNodes(), threads.getThreadAllocatedBytes(id)};
        long busy = 0;
        for (int i = 0; i < STEPS; i++) {
            simulation.step();
            busy += physics.getBusyBodies() - 1;    // without the floor
            if (i % 6 == 0) {
                simulation.read(simulation.getSensorNames());
            }
        }
        double[] after = {scene.getMoves(), busy, physics.getSolverIterations(), beams.nodes() + beams.fanNodes
            + beams.tested + wheels.getNodes(), threads.getThreadAllocatedBytes(id)};
        for (int i = 0; i < after.length; i++) {
            after[i] -= before[i];
        }
        return after;
    }

    @Test
    public void aRobotAmongManyHasTheWorkOfOneAlone() throws Exception {
        double[] alone = work(1);
        double[] among = work(MANY);
        String found = "moves, bodies, turns, boxes of beams, bytes: "
            + Arrays.toString(alone) + " alone, " + Arrays.toString(among) + " among " + MANY;
        assertTrue(found, alone[0] > 1 && alone[1] >= 1 && alone[3] > 50);
        for (int i = 0; i < 3; i++) {
            assertTrue(found, among[i] <= alone[i] * 1.02 + 0.01);
        }
        assertTrue("the hierarchy has log2(36) = 5.2 levels more: " + found, among[3] <= 2 * alone[3]);
        assertTrue(found, among[4] <= 1.1 * alone[4]);
    }
}
