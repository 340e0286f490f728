// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** SEAR reports objects that fall out of the world; they stop far below and return after a reset. */
public class KillPlaneTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void thingsAndRobotsThatFallOutAreNamedAndStop() throws Exception {
        new Floor("floor", 2, 2);
        new Box("box", 0.3, 0.3, 0.3, 1).move(0, 1, 5);
        Worlds.roomba("roomba", 0, -5, 0);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 2);
        List<String> warnings = simulation.snapshot().warnings;
        assertTrue(warnings.toString(),
            warnings.contains("box has fallen out of the world, below everything, at x 0.0, z 5.0; put ground there"));
        assertTrue(warnings.toString(), warnings.stream()
            .anyMatch(one -> one.startsWith("roomba has fallen out of the world")));
        Worlds.run(simulation, 20);
        double box = simulation.getPose("box").y;
        double roomba = simulation.getPose("roomba").y;
        assertTrue(box + " " + roomba, box < -1000 && box > -1010 && roomba < -1000 && roomba > -1010);
        simulation.getRobots().get(0).drive(0.2, Double.POSITIVE_INFINITY);
        Worlds.run(simulation, 1);
        assertEquals(box, simulation.getPose("box").y, 0);
        assertEquals(roomba, simulation.getPose("roomba").y, 0);
        simulation.reset();
        Worlds.run(simulation, 0.2);
        assertEquals(0.8, simulation.getPose("box").y, 0.05);
        assertTrue(simulation.getPose("roomba").y > -1);
    }
}
