// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.TestWorld;
import org.myrobotlab.service.sear.RecordingHost;

/** A panel's read of the world is interrupted at the program's end, for example by Ctrl+C while a page is open. */
public class LookAtTheEndTest {
    private static final int PATIENCE_SECONDS = 120;

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();
    private final CountDownLatch asked = new CountDownLatch(1);
    private final CountDownLatch goOn = new CountDownLatch(1);

    @After
    public void end() {
        goOn.countDown();
        System.clearProperty("sear.project");
    }

    private boolean keep() {
        asked.countDown();
        try {
            return goOn.await(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }

    @Test
    public void anInterruptedReadReturnsNothingWithoutAnError() throws Exception {
        System.setProperty("sear.headless", "true");
        Path folder = TestWorld.build(temporary.getRoot().toPath());
        SimulationControl control = new SimulationControl(new RecordingHost(), () -> folder);
        control.start(false);
        SimulationSession session = control.session();
        FutureTask<String> look = new FutureTask<>(
            () -> control.look((world, running) -> keep() ? "a world" : "none", "nothing")
            + (Thread.currentThread().isInterrupted() ? ", interrupted" : ""));
        Thread looker = new Thread(look, "looker");
        looker.start();
        assertTrue(asked.await(PATIENCE_SECONDS, TimeUnit.SECONDS));
        Thread ending = new Thread(control::stop, "ending");
        ending.start();
        while (!session.isEnding()) {
            Thread.onSpinWait();
        }
        looker.interrupt();
        assertEquals("nothing, interrupted", look.get(PATIENCE_SECONDS, TimeUnit.SECONDS));
        goOn.countDown();
        ending.join();
    }
}
