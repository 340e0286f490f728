// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Sphere;
import org.SEAR.Slow;
import org.SEAR.collision.Meshes;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Objects that are placed deep in a wall leave it the shortest way. The wall is 0.4 m thick and 2 m high. */
@Category(Slow.class)
public class DeepOverlapTest {
    private static final double NEAR = 2e-3;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Before
    public void putFloor() {
        new Floor("floor", 20, 20);
    }

    private Pose start(String name, String... words) throws Exception {
        try (Simulation simulation = Worlds.start(project)) {
            for (String word : words) {
                assertTrue(simulation.snapshot().warnings.toString(), simulation.snapshot().warnings.toString()
                    .contains(word));
            }
            return Worlds.body(simulation, name).getStart();
        }
    }

    private void boxWall() {
        new Box("wall", 0.4, 4, 2, 0).move(0, 1, 0);
    }

    private void meshWall() throws Exception {
        project.put("assets/wall.obj", new Meshes().box(-0.2, 0, -2, 0.2, 2, 2).obj());
        new Model("wall", "wall.obj");
    }

    @Test
    public void aBoxLeavesABoxSideways() throws Exception {
        boxWall();
        new Box("box", 0.2, 0.2, 0.2, 1).move(-0.15, 0.1, 0);
        assertEquals(-0.3, start("box", "moved it by (-0.150, 0.000, 0.000) m, the shortest way out").x, NEAR);
    }

    @Test
    public void aBoxNearTheTopIsLifted() throws Exception {
        boxWall();
        new Box("box", 0.2, 0.2, 0.2, 1).move(-0.1, 2, 0);
        assertEquals(2.1, start("box", "lifted it by 0.100 m").y, NEAR);
    }

    @Test
    public void aBallLeavesAMeshWallSideways() throws Exception {
        meshWall();
        new Sphere("ball", 0.1, 1).move(-0.18, 0.1, 0);
        assertEquals(-0.3, start("ball").x, NEAR);
        new Sphere("ball", 0.1, 1).move(0.15, 0.1, 0);
        assertEquals(0.3, start("ball").x, NEAR);
    }

    @Test
    public void aRobotLeavesAWallSideways() throws Exception {
        boxWall();
        Worlds.roomba("robot", 4, 0.1, 0, 0);
        Pose robot = start("robot", "the shortest way out");
        assertEquals(0.2 + 0.1666875, robot.x, 0.02);
        assertEquals(0.1, robot.y, NEAR);
    }

    @Test
    public void betweenTwoWallsThereIsNoWayButUp() throws Exception {
        boxWall();
        new Box("other", 0.4, 4, 2, 0).move(0.5, 1, 0);
        new Box("third", 0.4, 4, 2, 0).move(-0.5, 1, 0);
        new Box("box", 0.2, 0.2, 0.2, 1).move(0.15, 1, 0);
        assertEquals(2.1, start("box", "lifted").y, NEAR);
    }
}
