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
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.TestWorld;
import org.myrobotlab.service.sear.RecordingHost;
import org.myrobotlab.service.sear.run.SimulationControl;
import org.myrobotlab.service.sear.run.SimulationSession;

/** Panels look at the world again and again; one that looks while the simulation is stopped has nothing to complain of. */
public class StoppedMeanwhileTest {
    private static final int STOPS = 20;
    private static final int PANELS = 3;

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private final AtomicBoolean isDone = new AtomicBoolean();
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

    /** @return how often a world was seen */
    private int looking(Callable<Map<String, Object>> look) throws Exception {
        int seen = 0;
        while (!isDone.get()) {
            seen += Boolean.TRUE.equals(look.call().get("running")) ? 1 : 0;
        }
        return seen;
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
                sear.simSleep(0.05);
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
    public void whoOnlyLooksIsAnsweredAndWhoAsksIsToldThatNothingRuns() throws Exception {
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
