// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;

/** When the user closes the window, the SEAR service continues or stops the simulation, as configured. */
@RunWith(UnderXvfb.class)
public class ClosedByUserTest {
    private static final String TITLE = "SEAR";

    private SEAR sear;

    @Before
    public void start() throws Exception {
        ViewProjects.room();
        System.setProperty("sear.headless", "false");
        sear = (SEAR) Runtime.start("windowedSear", "SEAR");
    }

    @After
    public void release() {
        Runtime.releaseService("windowedSear");
    }

    private void closeWindow() throws Exception {
        sear.startSimulation();
        assertTrue(sear.isSimulating());
        CloseButton.press(TITLE);
    }

    /** Returns whether the thread that informs the service has ended; its message is then in the service's inbox. */
    private static boolean isTold() {
        return Thread.getAllStackTraces().keySet().stream().map(Thread::getName)
            .noneMatch(name -> name.equals("SEAR window closed") || name.equals("SEAR window commands"));
    }

    @Test
    public void theSimulationContinuesWithoutAWindow() throws Exception {
        assertFalse("default", sear.getConfig().closingWindowStops);
        closeWindow();
        Views.until("the window has gone", ClosedByUserTest::isTold);
        double then = sear.getTime() + 1;
        Views.until("time goes on", () -> sear.getTime() > then);
        assertTrue(sear.isSimulating());
    }

    @Test
    public void theSimulationStopsWhereItIsConfiguredTo() throws Exception {
        sear.getConfig().closingWindowStops = true;
        closeWindow();
        Views.until("the simulation has stopped", () -> !sear.isSimulating());
        sear.startSimulation();
        assertTrue("it starts again", sear.isSimulating());
    }
}
