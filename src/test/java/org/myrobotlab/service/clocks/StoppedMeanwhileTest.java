// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.clocks;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.ReadWriteLock;
import java.util.concurrent.locks.ReentrantReadWriteLock;
import org.SEAR.HowMany;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.TestWorld;
import org.myrobotlab.service.sear.RecordingHost;
import org.myrobotlab.service.sear.run.SimulationControl;
import org.myrobotlab.service.sear.run.SimulationSession;

/** Panels poll the world; a poll during a stop causes no error. */
@Category(Slow.class)
public class StoppedMeanwhileTest {
    private static final int STOPS = HowMany.of("sear.stops", 40);
    private static final int PANELS = 3;
    private static final int PATIENCE_SECONDS = 60;

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private final AtomicBoolean isDone = new AtomicBoolean();
    /** Read-locked while a panel reads the world. */
    private final ReadWriteLock looks = new ReentrantReadWriteLock();
    /** Has a permit for each world seen. */
    private final Semaphore sights = new Semaphore(0);
    private Path folder;
    private SEAR sear;

    @Before
    public void start() {
        System.setProperty("sear.headless", "true");
        folder = TestWorld.build(temporary.getRoot().toPath());
        sear = (SEAR) Runtime.start("stopSear", "SEAR");
    }

    @After
    public void release() {
        Runtime.releaseService("stopSear");
        System.clearProperty("sear.project");
    }

    /** @return number of worlds seen */
    private int looking(Callable<Map<String, Object>> look) throws Exception {
        int seen = 0;
        while (!isDone.get()) {
            looks.readLock().lock();
            try {
                if (Boolean.TRUE.equals(look.call().get("running"))) {
                    seen++;
                    sights.release();
                }
            } finally {
                looks.readLock().unlock();
            }
        }
        return seen;
    }

    /** Runs the first steps of the simulation, which polling threads would otherwise starve of CPU time. */
    private void letItRun() {
        looks.writeLock().lock();
        try {
            sear.simSleep(0.05);
        } finally {
            looks.writeLock().unlock();
        }
    }

    @Test
    public void panelsSeeAWorldOrNone() throws Exception {
        ExecutorService threads = Executors.newCachedThreadPool();
        try {
            List<Future<Integer>> panels = new ArrayList<>();
            for (int i = 0; i < PANELS; i++) {
                panels.add(threads.submit(() -> looking(sear::getWorld)));
                panels.add(threads.submit(() -> looking(sear::publishSimulation)));
            }
            for (int i = 0; i < STOPS; i++) {
                sear.startSimulation();
                letItRun();
                sights.drainPermits();
                assertTrue("all look while it stops",
                    sights.tryAcquire(2 * PANELS, PATIENCE_SECONDS, TimeUnit.SECONDS));
                sear.stopSimulation();
            }
            isDone.set(true);
            for (Future<Integer> panel : panels) {
                assertTrue(panel.get() > 0);
            }
            assertNull(sear.getLastError());
        } finally {
            isDone.set(true);
            threads.shutdownNow();
        }
    }

    @Test
    public void pollsAreAnsweredAndQueriesReportThatNothingRuns() throws Exception {
        SimulationControl control = new SimulationControl(new RecordingHost(), () -> folder);
        control.start(false);
        SimulationSession session = control.session();
        assertTrue(control.look((world, running) -> running == session, false));
        assertThrows("its own", IllegalStateException.class, () -> control.look((world, running) -> {
            throw new IllegalStateException("its own");
        }, false));
        control.stop();
        assertFalse(control.look((world, running) -> true, false));
        assertThrows("the simulation has ended", IllegalStateException.class, () -> session.ask(world -> true));
    }
}
