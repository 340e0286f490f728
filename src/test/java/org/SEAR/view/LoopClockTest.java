// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertTrue;

import com.jme3.material.Material;
import com.jme3.material.RenderState;
import com.jme3.math.ColorRGBA;
import com.jme3.renderer.Camera;
import com.jme3.renderer.queue.RenderQueue;
import com.jme3.scene.Geometry;
import com.jme3.scene.Node;
import com.jme3.scene.Spatial;
import com.jme3.scene.shape.Quad;
import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.concurrent.locks.LockSupport;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.junit.Test;
import org.junit.runner.RunWith;

/**
 * The window hardly slows the simulation on the example with 20 boxes and every sensor: CPU time as ratios within one
 * run.
 */
@RunWith(UnderXvfb.class)
public class LoopClockTest {
    private static final String EXAMPLE = "sensors";
    private static final double FRAMES_PER_SECOND = 30;
    /** Limit of the window's cores; the rest of two is the simulation's. */
    private static final double CORES = 1.2;
    /**
     * Limit of the ratio to a reference picture of the same window, which other work on the machine slows down equally:
     * measured 1.1 to 1.2.
     */
    private static final double YARDSTICKS = 1.5;
    private static final int SHEETS = 8;
    private static final float SEE_THROUGH = 0.5f;
    private static final int PICTURES = 40;
    private static final int WARM_UP_PICTURES = 20;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    /** Growth of the 99th percentile of a step's time at which measuring ends ... */
    private static final double WANTED = 1.2;
    /** ... and limit beyond which the test fails, because test machines have other work as well. */
    private static final double SLOWER = 1.4;
    private static final int LEAST_TURNS = 2;
    private static final int MOST_TURNS = 8;
    private static final int WARM_UP_STEPS = 10_000;
    private static final int TRIES = 6;
    private static final int TIMED_STEPS = 300;
    private static final long STEP_LENGTH = 16_666_667L;

    /** Counts CPU time without the simulation's, because the test machine has other work as well. */
    @Test
    public void thirtyPicturesASecondOnSoftwareOpenGlLeaveTheSimulationItsShareOfTwoCores() throws Exception {
        try (Views view = new Views(Examples.folder(EXAMPLE), new WindowOptions())) {
            view.press("u");
            double cores = Double.POSITIVE_INFINITY;
            double ratio = Double.POSITIVE_INFINITY;
            for (int i = 0; i < TRIES && cores > CORES && ratio > YARDSTICKS; i++) {
                double yardstick = yardstick(view);
                double picture = picture(view);
                cores = FRAMES_PER_SECOND * picture;
                ratio = picture / Math.max(yardstick, yardstick(view));
                System.out.println("30 pictures a second at 1024 x 640 take " + cores + " cores; a picture " + ratio
                    + " of " + yardstick + " s");
            }
            view.press("semicolon");
            assertTrue("30 pictures a second take " + cores + " cores, a picture " + ratio + " yardsticks",
                cores <= CORES || ratio <= YARDSTICKS);
        }
    }

    /** Returns the CPU time of a picture, seconds. */
    private static double picture(Views view) {
        view.frames(WARM_UP_PICTURES);
        long start = processorTime(view);
        view.frames(PICTURES);
        return (processorTime(view) - start) / 1e9 / PICTURES;
    }

    /**
     * Returns the CPU time of a reference picture from the same OpenGL in the same window, only transparent sheets of
     * the window's size, seconds.
     */
    private static double yardstick(Views view) throws Exception {
        Node sheets = new Node("sheets");
        view.ask(() -> {
            Camera camera = view.app().getCamera();
            for (int i = 0; i < SHEETS; i++) {
                Geometry sheet = new Geometry("sheet", new Quad(camera.getWidth(), camera.getHeight()));
                Material material = new Material(view.app().getAssetManager(), "Common/MatDefs/Misc/Unshaded.j3md");
                material.setColor("Color", new ColorRGBA(0, (float) i / SHEETS, 1, SEE_THROUGH));
                material.getAdditionalRenderState().setBlendMode(RenderState.BlendMode.Alpha);
                sheet.setMaterial(material);
                sheet.setQueueBucket(RenderQueue.Bucket.Gui);
                sheets.attachChild(sheet);
            }
            view.app().getRootNode().setCullHint(Spatial.CullHint.Always);
            return view.app().getGuiNode().attachChild(sheets);
        });
        double time = picture(view);
        view.ask(() -> {
            view.app().getRootNode().setCullHint(Spatial.CullHint.Inherit);
            return sheets.removeFromParent();
        });
        return time;
    }

    private static long processorTime(Views view) {
        return ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getProcessCpuTime()
            - THREADS.getThreadCpuTime(view.world.thread.getId());
    }

    /**
     * Runs at real time.
     * @return the CPU time of each step, ns
     */
    private static long[] steps(Simulation simulation, int count) {
        long[] times = new long[count];
        long due = System.nanoTime();
        for (int i = 0; i < count; i++) {
            long start = THREADS.getCurrentThreadCpuTime();
            simulation.step();
            times[i] = THREADS.getCurrentThreadCpuTime() - start;
            due += STEP_LENGTH;
            while (due - System.nanoTime() > 0) {
                LockSupport.parkNanos(due - System.nanoTime());
            }
        }
        return times;
    }

    /** Returns the 99th percentile of a round's step times, ns. */
    private static long slowStep(long[] times) {
        return Arrays.stream(times).sorted().toArray()[times.length * 99 / 100];
    }

    /**
     * Compares compiled code: earlier steps run as fast as possible. Rounds with and without window alternate, because
     * other work on the machine changes both; the best round counts.
     */
    @Test
    public void stepsTakeNoLongerWithTheWindow() throws Exception {
        Simulation simulation = Simulation.load(Examples.folder(EXAMPLE), 1);
        SimulationRunner runner = new SimulationRunner(simulation);
        simulation.getRobots().get(0).drive(0.2, 0.5);
        for (String name : simulation.getSensorNames()) {
            simulation.watch(name, true);
        }
        for (int i = 0; i < WARM_UP_STEPS; i++) {
            simulation.step();
        }
        steps(simulation, TIMED_STEPS);
        double ratio = Double.POSITIVE_INFINITY;
        for (int turn = 0; turn < LEAST_TURNS || ratio > WANTED && turn < MOST_TURNS; turn++) {
            long without = slowStep(steps(simulation, TIMED_STEPS));
            SimulatorWindow window = SimulatorWindow.open(runner, new WindowOptions());
            assertTrue(window.getProblem(), window.isOpen());
            steps(simulation, TIMED_STEPS / 2);
            long with = slowStep(steps(simulation, TIMED_STEPS));
            window.close();
            ratio = Math.min(ratio, (double) with / without);
            System.out.println("99th percentile of a step, us: " + without / 1000 + " without, " + with / 1000
                + " with window; best ratio " + ratio);
        }
        assertTrue("99 % of the steps take at least " + ratio + " times as long with the window", ratio <= SLOWER);
    }
}
