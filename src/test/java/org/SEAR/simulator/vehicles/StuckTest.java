// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Robots that do not move although they have a command. */
public class StuckTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private String drive(double speed, double seconds) throws Exception {
        try (Simulation simulation = Worlds.start(project)) {
            simulation.getRobots().get(0).drive(speed, Double.POSITIVE_INFINITY);
            Worlds.run(simulation, seconds);
            return String.join("\n", simulation.snapshot().warnings);
        }
    }

    @Test
    public void aFixedObstacleIsNamedWithTheSensorThatDoesNotSeeIt() throws Exception {
        new Floor("floor", 4, 4);
        new Box("crate", 0.2, 0.2, 0.2, 0).move(0, 0.1, 0.4);
        SEARrobot rover = Robots.rover("rover");
        rover.addComponent(new Distance("front", "laser", 0.1, 0.05, 0, 0, 90, 0));
        assertEquals("robot rover can't obey the command to drive at 0.30 m/s: crate, which is fixed (mass 0), blocks"
            + " it. If it should move, give it a mass: crate.setMass(1). Its sensor front looks to the left, not where"
            + " it drives: front.rotate(0, 0, 0) turns it", drive(0.3, 4));
        assertEquals("away from it", "", drive(-0.1, 4));
    }

    @Test
    public void aLightObjectAndATouchOfASecondAreNoReason() throws Exception {
        new Floor("floor", 4, 4);
        new Box("crate", 0.2, 0.2, 0.2, 0.1).move(0, 0.1, 0.4);
        new Box("wall", 0.2, 1, 0.2, 0).move(0, 0.1, 1.2);
        Robots.rover("rover");
        assertEquals("", drive(0.3, 3));
    }
}
