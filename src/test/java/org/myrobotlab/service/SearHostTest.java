// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.After;
import org.junit.Test;
import org.myrobotlab.service.config.SEARConfig;

/** Callbacks of SEAR's parts on their own threads. */
public class SearHostTest {
    /** Stores the thread that stops the simulation. */
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

    /** The window's thread, for which the end of a simulation waits, does not stop the simulation itself. */
    @Test(timeout = 60_000)
    public void closingTheWindowStopsOnSearsOwnThread() throws InterruptedException {
        // made directly: for a class without its own configuration MyRobotLab makes one of another type, which SEAR
        // rejects
        Stopped sear = new Stopped("hosted", Runtime.getInstance().getId());
        sear.startService();
        SEARConfig config = new SEARConfig();
        config.closingWindowStops = true;
        sear.apply(config);
        new SearHost(sear, new SearCalls(sear)).windowClosed();
        assertEquals(sear.getThisThread(), sear.stoppers.take());
        sear.releaseService();    // the registry does not know it
    }
}
