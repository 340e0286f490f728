// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import java.lang.management.ManagementFactory;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Sphere;
import org.SEAR.Slow;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.raycast.BeamScene;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Guards against slowness: operations and bytes per step instead of times. */
@Category(Slow.class)
public class StepWorkTest {
    private static final int FIXED = 200;
    private static final int LOOSE = 40;
    private static final int STEPS = 300;
    private static final int TURNING_STEPS = 30;
    /** Limit of rounds, of which the best counts: allocations shrink once the compiler has removed avoidable ones. */
    private static final int MOST_ROUNDS = 100;

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** Starts the robot on a circle of 1 m about the origin. */
    private Simulation circling() throws Exception {
        new Floor("floor", 80, 80);
        SEARrobot robot = Worlds.roomba("roomba", -1, 0, 0);
        robot.addComponent(new LIDAR("lidar", 8, 180, 0.5, 0, 0.3, 0));
        Simulation simulation = Worlds.start(project);
        simulation.post(world -> world.getRobots().get(0).drive(0.4, 1));
        return simulation;
    }

    private static void crowd() {
        for (int i = 0; i < FIXED + LOOSE; i++) {
            double angle = 2 * Math.PI * i / (FIXED + LOOSE);
            double distance = 8 + 3 * (i % 8);
            Box box = new Box("box" + i, 0.3, 0.3, 0.3, i < FIXED ? 0 : 2);
            box.move(distance * Math.sin(angle), 0.15, distance * Math.cos(angle));
        }
    }

    /** Returns the number of shapes moved and of awake bodies during some steps. */
    private static long[] work(Simulation simulation) {
        BeamScene scene = simulation.getWorld().getRobots().get(0).truth().scene();
        long moves = scene.getMoves();
        long busy = 0;
        for (int i = 0; i < STEPS; i++) {
            simulation.step();
            busy += simulation.getWorld().getPhysics().getBusyBodies();
        }
        return new long[] {scene.getMoves() - moves, busy};
    }

    @Test
    public void fixedAndSleepingObjectsCostNothing() throws Exception {
        Simulation alone = circling();
        Worlds.run(alone, 5);
        long[] expected = work(alone);
        assertTrue("the robot drives", expected[0] >= STEPS);
        assertEquals("robot and floor", 2 * STEPS, expected[1]);

        crowd();
        Simulation crowded = circling();
        Worlds.run(crowded, 5);
        List<Pose> poses = crowded.snapshot().environment;
        assertEquals(FIXED + LOOSE + 1, poses.size());
        long[] measured = work(crowded);
        assertEquals("shapes moved for the beams", expected[0], measured[0]);
        assertEquals("bodies that the physics looks at", expected[1], measured[1]);
        assertSame("poses made anew", poses, crowded.snapshot().environment);
    }

    @Test
    public void aWorldAtRestDoesNothing() throws Exception {
        crowd();
        Simulation simulation = circling();
        simulation.post(world -> world.getRobots().get(0).drive(0, 0));
        Worlds.run(simulation, 10);
        assertEquals("shapes moved", 0, work(simulation)[0]);
        assertEquals("bodies that the physics looks at", 0, work(simulation)[1]);
        allocates("at rest", simulation, 0, 600);
    }

    @Test
    public void aStepAllocatesLittle() throws Exception {
        allocates("driving", circling(), 0, 2600);
    }

    @Test
    public void aScanAllocatesItsRangesAndLittleElse() throws Exception {
        allocates("driving with a LIDAR read at each step", circling(), 361 * Double.BYTES, 2800);
    }

    /**
     * @param scan bytes of the scan read after each step; 0 for none
     * @param most other bytes per step
     */
    private static void allocates(String what, Simulation simulation, long scan, long most) {
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long least = Long.MAX_VALUE;
        for (int round = 0; round < MOST_ROUNDS && least > most; round++) {
            long before = threads.getThreadAllocatedBytes(id);
            for (int i = 0; i < STEPS; i++) {
                simulation.step();
                if (scan > 0) {
                    simulation.read("lidar");
                }
            }
            least = Math.min(least, (threads.getThreadAllocatedBytes(id) - before) / STEPS - scan);
        }
        assertTrue(what + ": " + least + " bytes a step, legal: " + most, least <= most);
    }

    /**
     * Returns the iterations of the contact solver in the first half second of boxes that fall from 10 cm, one or two
     * at a place.
     */
    private long turns(double[] places) throws Exception {
        new Floor("floor", 80, 80);
        for (int i = 0; i < places.length; i++) {
            boolean upper = i > 0 && places[i] == places[i - 1];
            new Box("box" + i, 0.4, 0.4, 0.4, 5).move(places[i], upper ? 0.7 : 0.25, 0);
        }
        Simulation simulation = Worlds.start(project);
        for (int i = 0; i < TURNING_STEPS; i++) {
            simulation.step();
        }
        return simulation.getWorld().getPhysics().getSolverIterations();
    }

    @Test
    public void bodiesThatLieApartAreSolvedWithFewTurns() throws Exception {
        long turns = turns(new double[] {0, 3, 6, 9});
        assertTrue("turns: " + turns, turns > 0 && turns <= 4 * 16 * TURNING_STEPS);
    }

    @Test
    public void aStackIsSolvedWithManyTurns() throws Exception {
        long turns = turns(new double[] {0, 0});
        assertTrue("turns: " + turns, turns > 10 * 16 && turns <= 2 * 40 * TURNING_STEPS);
    }

    /** Each iteration also covers the wheels. */
    @Test
    public void aBallOnARobotOfManyTimesItsMassIsSolvedWithFewTurns() throws Exception {
        new Floor("floor", 80, 80);
        Worlds.roomba("roomba", 0, 0, 0);
        new Sphere("ball", 0.03, 0.05).move(0, 0.17, 0);
        Simulation simulation = Worlds.start(project);
        for (int i = 0; i < TURNING_STEPS; i++) {
            simulation.step();
        }
        assertEquals("it lies on the robot", 0.16, simulation.getPose("ball").y, 0.03);
        long before = simulation.getWorld().getPhysics().getSolverIterations();
        simulation.step();
        long turns = simulation.getWorld().getPhysics().getSolverIterations() - before;
        assertTrue("turns: " + turns, turns > 1000 && turns <= 20_000);
    }
}
