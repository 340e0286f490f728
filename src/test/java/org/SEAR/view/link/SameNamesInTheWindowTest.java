// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.link;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.ProjectRule;
import org.SEAR.scene.ReadingTexts;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.junit.Rule;
import org.junit.Test;

/** The window shows the sensors of two robots that share a name. */
public class SameNamesInTheWindowTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void eachHasItsBeamsAndItsReading() throws Exception {
        for (String name : List.of("rover", "scout")) {
            SEARrobot robot = new SEARrobot(name);
            Dynamics drive = new Dynamics("drive", 3);
            robot.addComponent(drive);
            drive.move(name.equals("rover") ? 0 : 2, 0, 0);
            robot.addComponent(new Distance("ping"));
        }
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            RunnerLink link = new RunnerLink(new SimulationRunner(world), () -> false);
            world.step();
            Set<String> both = Set.of("rover/ping", "scout/ping");
            assertEquals(both, link.snapshot().readings.keySet());
            assertEquals(both, new ReadingTexts(link.project()).of(link.snapshot().readings).keySet());
            both.forEach(name -> assertNotNull(link.snapshot().readings.get(name).beams()));
            assertEquals(both, link.beams().stream().map(fan -> fan.sensor).collect(Collectors.toSet()));
            link.close();
        }
    }
}
