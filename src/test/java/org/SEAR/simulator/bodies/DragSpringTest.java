// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.concurrent.TimeUnit;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.SEAR.simulator.orders.DragSpring;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** A drag spring pulls its object with a limited force and ends on request or when its object is gone. */
public class DragSpringTest {
    /** Extension of the spring by the weight, metres. */
    private static final double SAG = 9.81 / 100;

    @Rule
    public final ProjectRule project = new ProjectRule();
    private long now;
    private boolean lockStep;

    @Before
    public void ground() {
        new Floor("floor", 40, 40);
    }

    private DragSpring hand(String name) {
        return new DragSpring(name, () -> lockStep, () -> now);
    }

    @Test
    public void anObjectIsDraggedAndFallsAfterTheRelease() throws Exception {
        new Box("box", 0.3, 0.3, 0.3, 2).move(0, 0.15, 0);
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 0.5);
            DragSpring hand = hand("box");
            hand.moveTo(1, 2, -0.5);
            simulation.hold(hand, "box");
            Worlds.run(simulation, 2);
            Pose held = simulation.getPose("box");
            assertEquals(1, held.x, 0.01);
            assertEquals(0.15 + 2 - SAG, held.y, 0.01);
            assertEquals(-0.5, held.z, 0.01);
            hand.moveTo(0, 2, 0);
            Worlds.run(simulation, 2);
            assertEquals(0, simulation.getPose("box").x, 0.01);
            hand.letGo();
            Worlds.run(simulation, 2);
            assertEquals("on the floor", 0.15, simulation.getPose("box").y, 0.02);
        }
    }

    @Test
    public void itPullsNoStrongerThanItMay() throws Exception {
        new Box("box", 0.3, 0.3, 0.3, 2).move(0, 10, 0);
        try (Simulation simulation = Worlds.start(project)) {
            DragSpring hand = hand("box");
            hand.moveTo(1e6, 0, 0);
            simulation.hold(hand, "box");
            Worlds.run(simulation, 0.5);
            double[] v = new double[6];
            Worlds.body(simulation, "box").velocities(v);
            assertEquals(0.5 * DragSpring.STRONGEST, v[0], 0.5);
        }
    }

    @Test
    public void itEndsWithoutFurtherMoves() throws Exception {
        new Box("box", 0.3, 0.3, 0.3, 2).move(0, 0.15, 0);
        try (Simulation simulation = Worlds.start(project)) {
            DragSpring hand = hand("box");
            hand.moveTo(0, 1, 0);
            simulation.hold(hand, "box");
            Worlds.run(simulation, 1);
            assertEquals(1.15 - SAG, simulation.getPose("box").y, 0.02);
            now += TimeUnit.SECONDS.toNanos(1);
            assertTrue(hand.isHolding());
            now += TimeUnit.SECONDS.toNanos(1);
            assertFalse(hand.isHolding());
            Worlds.run(simulation, 2);
            assertEquals(0.15, simulation.getPose("box").y, 0.02);
        }
    }

    @Test
    public void inLockStepItsTimeoutIsSimulatedTime() throws Exception {
        new Box("box", 0.3, 0.3, 0.3, 2).move(0, 0.15, 0);
        lockStep = true;
        try (Simulation simulation = Worlds.start(project)) {
            DragSpring hand = hand("box");
            hand.moveTo(0, 1, 0);
            simulation.hold(hand, "box");
            for (int i = 0; i < 10; i++) {
                hand.moveTo(0, 1, 0);
                now += TimeUnit.HOURS.toNanos(1);
                Worlds.run(simulation, 1);
                assertTrue(hand.isHolding());
            }
            assertEquals(1.15 - SAG, simulation.getPose("box").y, 0.02);
            Worlds.run(simulation, 0.6);
            assertFalse(hand.isHolding());
        }
    }

    @Test
    public void aResetAndATeleportReleaseIt() throws Exception {
        new Box("box", 0.3, 0.3, 0.3, 2).move(0, 0.15, 0);
        try (Simulation simulation = Worlds.start(project)) {
            DragSpring hand = hand("box");
            hand.moveTo(0, 1, 0);
            simulation.hold(hand, "box");
            Worlds.run(simulation, 0.5);
            simulation.reset();
            assertFalse(hand.isHolding());
            Worlds.run(simulation, 0.5);
            assertEquals("as after the start", 0.15, simulation.getPose("box").y, 0.01);
            DragSpring other = hand("box");
            simulation.hold(other, "box");
            Worlds.run(simulation, 0.1);
            simulation.move("box", simulation.getPose("box"), new Pose(2, 0.15, 0, 0, 0, 0, 1));
            assertFalse(other.isHolding());
        }
    }

    @Test
    public void aRobotIsPulledAndAFixedObjectIsNot() throws Exception {
        SEARrobot robot = Worlds.roomba("roomba", 0, 0, 0);
        new Box("wall", 1, 1, 1, 0).move(5, 0.5, 5);
        try (Simulation simulation = Worlds.start(project)) {
            Worlds.run(simulation, 0.5);
            DragSpring hand = hand(robot.getName());
            hand.moveTo(2, 0.3, 0);
            simulation.hold(hand, "roomba");
            assertThrows(IllegalArgumentException.class, () -> simulation.hold(hand("wall"), "wall"));
            Worlds.run(simulation, 3);
            assertEquals(2, simulation.getPose("roomba").x, 0.1);
        }
    }
}
