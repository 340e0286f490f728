// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.ProcessorTime;
import org.SEAR.Slow;
import org.SEAR.project.ProjectRule;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** A simulation and the clock. Tests check a ratio within one run, or a bound that holds on a busy machine. */
@Category(Slow.class)
public class SimulationClockTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    @Before
    public void floor() {
        new Floor("floor", 50, 50);
    }

    /** Returns simulated seconds per second of the clock. */
    private double pace(double speed, double simulated) throws Exception {
        SimulationRunner runner = new SimulationRunner(Worlds.start(project));
        Thread thread = new Thread(runner, "simulation under test");
        runner.setSpeed(speed);
        thread.start();
        long begin = System.nanoTime();
        runner.sleep(simulated);
        double pace = simulated * 1e9 / (System.nanoTime() - begin);
        runner.stop();
        thread.join();
        return pace;
    }

    @Test(timeout = 120_000)
    public void itKeepsPaceWithTheClock() throws Exception {
        Worlds.roomba("roomba", 0, 0, 0);
        double slow = pace(2, 2);
        double fast = pace(8, 8);
        assertTrue("2 times became " + slow, slow < 2.1);
        assertTrue("8 times became " + fast, fast < 8.4);
        assertTrue("2 and 8 times became " + slow + " and " + fast, fast > 2 * slow);
    }

    @Test(timeout = 120_000)
    public void asFastAsPossibleIsMuchFasterThanTheClock() throws Exception {
        Worlds.roomba("roomba", 0, 0, 0);
        double pace = pace(1, 1);
        double fastest = pace(Double.POSITIVE_INFINITY, 60);
        assertTrue(pace + " and " + fastest, fastest > 10 * pace);
    }

    @Test
    public void tenMinutesTakeSecondsOfCpuTime() throws Exception {
        for (int i = 0; i < 50; i++) {
            Box box = new Box("box" + i, 1, 1, 1, 0);
            box.move(10 * Math.sin(i), 0.5, 10 * Math.cos(i));
            box.rotate(0, 50 * i, 0);
        }
        Worlds.roomba("roomba", 0, 0, 0).addComponent(new LIDAR("lidar"));
        Simulation simulation = Worlds.start(project);
        simulation.getRobots().get(0).drive(0.3, 2);
        ProcessorTime time = new ProcessorTime();
        for (int tenth = 0; tenth < 6000; tenth++) {
            Worlds.run(simulation, 0.1);
            simulation.read("lidar");
        }
        double took = time.seconds();
        assertEquals(600, simulation.getTime(), 1e-6);
        assertEquals(180, simulation.getRobots().get(0).getHardware().getPath(), 2);
        assertTrue("took " + took + " s", took < 60);
    }
}
