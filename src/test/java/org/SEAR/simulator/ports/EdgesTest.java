// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ports;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.Slow;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Worlds at the limits of the simulation: the lightest objects, and too many at one spot. */
@Category(Slow.class)
public class EdgesTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void theLightestObjectFallsAndRests() throws Exception {
        new Floor("floor", 10, 10);
        Box box = new Box("box", 0.1, 0.1, 0.1, 1e-6);
        box.move(0, 0.5, 0);
        Worlds.roomba("roomba", 0, -1, 0);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 5);
        Pose pose = simulation.getPose("box");
        assertEquals(0.05, pose.y, 2e-3);
        assertTrue(Double.isFinite(pose.x) && Double.isFinite(pose.qw));
        try {
            box.setMass(1e-7);
            fail("a mass of 1e-7 kg was taken");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("legal: 0, or a number from 0.000001 to 1000000 kg"));
        }
    }

    @Test
    public void aFewObjectsAtOneSpotSeparateAndSomeAreNamed() throws Exception {
        new Floor("floor", 20, 20);
        for (int i = 0; i < 12; i++) {
            new Box("box" + i, 0.2, 0.2, 0.2, 1).move(0, 0.1, 0);
        }
        Simulation simulation = Worlds.start(project);
        List<String> warnings = simulation.snapshot().warnings;
        assertTrue(warnings.toString(),
            warnings.contains("more objects start inside each other; SEAR names the first 20 only"));
        assertEquals(21, warnings.size());
        Worlds.run(simulation, 2);
        assertFalse(Double.isNaN(simulation.getPose("box11").x));
    }

    @Test
    public void tooManyObjectsAtOneSpotAreRejected() throws Exception {
        Worlds.roomba("roomba", 0, 0, 0);
        for (int i = 0; i < 9995; i++) {
            project.put("environment/box" + i + ".xml", "<Box><name>box" + i
                + "</name><length>0.2</length><width>0.2</width><height>0.2</height><mass>1</mass><y>0.1</y></Box>");
        }
        try {
            Worlds.start(project);
            fail("9995 boxes on one spot were taken");
        } catch (ProjectException e) {
            assertTrue(e.getMessage(), e.getMessage()
                .contains("more than 50000 pairs of objects with mass start inside each other, such as box"));
        }
    }
}
