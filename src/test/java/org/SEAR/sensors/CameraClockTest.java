// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Robots;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** A camera without viewers does not slow a simulation down; a viewed one costs only its pictures. */
public class CameraClockTest {
    private static final int SECONDS = 4;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Simulation world(boolean camera) throws Exception {
        Path folder = project.folder();
        Bundle.load(Paths.get(System.getProperty("sear.root", "."), "examples", "sensors.sear"), folder);
        if (camera) {
            Robots.rover("looker").addComponent(new Camera("eye", 0, 0.3, 0));
        } else {
            Robots.rover("looker");
        }
        assertEquals(2, Project.read(folder).getRobots().size());
        return Simulation.load(folder, 1);
    }

    /** Returns CPU time of this thread for some simulated seconds, s. */
    private static double time(Simulation world, boolean look) {
        long start = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        for (int step = 1; step <= 60 * SECONDS; step++) {
            world.step();
            if (look && step % 6 == 0) {
                world.read("eye");
            }
        }
        return (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - start) / 1e9;
    }

    @Test
    public void tenUnreadPicturesASecondCostNextToNothing() throws Exception {
        double with = Double.POSITIVE_INFINITY;
        double without = Double.POSITIVE_INFINITY;
        Simulation one = world(false);
        Simulation other = world(true);
        for (int i = 0; i < 5; i++) {
            without = Math.min(without, time(one, false));
            with = Math.min(with, time(other, false));
        }
        assertTrue(with + " s with a camera, " + without + " s without", with < 1.5 * without + 0.01);
        assertTrue("ten times real time: " + with + " s for " + SECONDS, with < SECONDS / 10.0);
    }

    @Test
    public void aPictureIsMadeOnceHoweverOftenItIsRead() throws Exception {
        Simulation world = world(true);
        time(world, true);
        long start = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
        for (int i = 0; i < 10_000; i++) {
            world.read("eye");
        }
        double reads = (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - start) / 1e9;
        assertTrue(reads + " s for 10000 reads of one picture", reads < 0.5);
    }
}
