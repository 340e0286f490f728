package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.After;
import org.junit.Test;
import org.myrobotlab.service.config.SEARConfig;

/** What SEAR hears from its parts, on their threads. */
public class SearHostTest {
    /** Keeps the thread on which it is to stop. */
    public static class Stopped extends SEAR {
        private static final long serialVersionUID = 1L;
        private final transient BlockingQueue<Thread> stoppers = new LinkedBlockingQueue<>();

        public Stopped(String name, String id) {
            super(name, id);
        }

        @Override
        public void stopSimulation() {
            stoppers.add(Thread.currentThread());
        }
    }

    @After
    public void release() {
        Runtime.releaseAll();
    }

    /** The window's thread, which the end of a simulation waits for, does not stop it itself. */
    @Test(timeout = 60_000)
    public void aClosedWindowLeavesStoppingToSearsOwnThread() throws InterruptedException {
        // made here: a class without a configuration of its own gets one of another type, which SEAR refuses
        Stopped sear = new Stopped("hosted", Runtime.getInstance().getId());
        sear.startService();
        SEARConfig config = new SEARConfig();
        config.closingWindowStops = true;
        sear.apply(config);
        new SearHost(sear).windowClosed();
        assertEquals(sear.getThisThread(), sear.stoppers.take());
        sear.releaseService();    // the registry does not know it
    }
}
