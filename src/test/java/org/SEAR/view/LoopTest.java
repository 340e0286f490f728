// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.sensors.LidarScan;
import org.SEAR.simulator.Simulation;
import org.junit.Test;
import org.junit.runner.RunWith;

/** The window doesn't change the simulation, shown on the example with 20 boxes and every sensor. */
@RunWith(UnderXvfb.class)
public class LoopTest {
    private static final String EXAMPLE = "sensors";
    private static final int STEPS = 600;

    /** Drives an arc and returns the readings of all sensors at each step. */
    private static List<String> readings(Path project, boolean windowed) throws Exception {
        List<String> lines = new ArrayList<>();
        try (RunningWorld world = new RunningWorld(project, true)) {
            SimulatorWindow window = windowed
                ? SimulatorWindow.open(world.runner, new WindowOptions().setSize(640, 400)) : null;
            world.simulation.post(simulation -> simulation.getRobots().get(0).drive(0.3, 1.5));
            world.runner.addStepListener(() -> lines.add(line(world.simulation)));
            world.runner.setSpeed(windowed ? 4 : Double.POSITIVE_INFINITY);
            world.runner.advance(STEPS);
            if (window != null) {
                assertTrue(window.getProblem(), window.isOpen());
                window.close();
            }
        }
        return lines;
    }

    private static String line(Simulation simulation) {
        StringBuilder line = new StringBuilder().append(simulation.getTime()).append(' ')
            .append(simulation.getRobots().get(0).getPose());
        for (String name : simulation.getSensorNames()) {
            Object reading = simulation.read(name);
            line.append(' ').append(name).append(' ')
                .append(reading instanceof LidarScan ? Arrays.toString(((LidarScan) reading).ranges()) : reading);
        }
        return line.toString();
    }

    @Test
    public void readingsAreTheSameWithAndWithoutWindow() throws Exception {
        Path project = Examples.folder(EXAMPLE);
        List<String> without = readings(project, false);
        List<String> with = readings(project, true);
        assertEquals(STEPS, with.size());
        assertEquals(without, with);
    }
}
