// SPDX-License-Identifier: Apache-2.0
package org.SEAR.scene;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertSame;

import java.util.List;
import java.util.Map;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.Snapshot;
import org.junit.Test;

/** The view shows objects between two steps, evenly; teleported objects appear at their new place immediately. */
public class MovementTest {
    private static final double STEP = 1 / 60.0;
    private static final double EXACT = 1e-12;

    /** Returns the state of one object at z at this step. */
    private static Snapshot state(long step, double z) {
        return new Snapshot(step, step * STEP, List.of(new Pose(0, 0, z, 0, 0, 0, 1)), List.of(), Map.of(),
            List.of(), List.of());
    }

    @Test
    public void itIsShownLateAndEvenlyThoughStatesComeUnevenly() {
        Movement movement = new Movement();
        for (int frame = 0; frame < 600; frame++) {
            long step = frame / 4 * 4; // four steps together, with every fourth picture
            movement.advance(state(step, step * STEP), 1, STEP);
            if (frame > 300) {
                double behind = frame * STEP - movement.environment(0).z;
                assertEquals("at frame " + frame, 3.5 * STEP, behind, 1.5 * STEP);
            }
        }
        assertEquals(596, movement.newest().step);
    }

    @Test
    public void inAPauseAndAfterAResetTheNewestIsShown() {
        Movement movement = new Movement();
        movement.advance(state(1, 0), 1, 0);
        movement.advance(state(2, 0.5), 1, 0);
        assertEquals(0, movement.environment(0).z, EXACT);
        movement.advance(state(2, 0.5), 0, STEP);
        assertEquals(0.5, movement.environment(0).z, EXACT);
        movement.advance(state(0, 0.25), 1, STEP);
        assertEquals(0.25, movement.environment(0).z, EXACT);
        assertEquals(0, movement.shown().step);
    }

    @Test
    public void theWayIsStraightAndTheShorterOneRound() {
        Pose from = Pose.ofDegrees(1, 2, 3, 0, 170, 0);
        Pose to = Pose.ofDegrees(1.4, 2, 2.6, 0, -170, 0);
        Pose half = Movement.between(from, to, 0.5, STEP);
        assertEquals(1.2, half.x, EXACT);
        assertEquals(2, half.y, EXACT);
        assertEquals(2.8, half.z, EXACT);
        assertEquals(-1, half.rotate(0, 0, 1)[2], EXACT);
        assertEquals(1, half.qx * half.qx + half.qy * half.qy + half.qz * half.qz + half.qw * half.qw, EXACT);
        Pose start = Movement.between(from, to, 0, STEP);
        assertEquals(from.x, start.x, EXACT);
        assertEquals(from.rotate(0, 0, 1)[0], start.rotate(0, 0, 1)[0], EXACT);
        assertSame(to, Movement.between(from, to, 1, STEP));
    }

    @Test
    public void teleportedObjectsAppearImmediately() {
        Pose from = Pose.IDENTITY;
        Pose metre = new Pose(0, 0, 1, 0, 0, 0, 1);
        Pose farther = new Pose(0, 0, 1.01, 0, 0, 0, 1);
        Pose far = new Pose(0, 0, 5.9, 0, 0, 0, 1);
        assertEquals("a metre may be driven", 0.25, Movement.between(from, metre, 0.25, 0).z, EXACT);
        assertSame(farther, Movement.between(from, farther, 0.25, STEP));
        assertEquals("in a tenth of a second a car drives farther", 2.95,
            Movement.between(from, far, 0.5, 0.1).z, EXACT);
        assertSame("back in time nothing drives", far, Movement.between(from, far, 0.5, -3));
    }
}
