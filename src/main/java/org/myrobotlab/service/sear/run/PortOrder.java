// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.util.List;
import org.myrobotlab.serial.PortArrivals;
import org.myrobotlab.service.sear.lockstep.SleepingThreads;

/** Processes the ports of a simulation in one fixed order, that of the project. One thread at a time. */
final class PortOrder {
    private final List<UartLine> lines;
    private final SleepingThreads.Work settle;
    private boolean calledBack;

    /** @param settle waits for the callbacks */
    PortOrder(List<UartLine> lines, SleepingThreads.Work settle) {
        this.lines = lines;
        this.settle = settle;
    }

    /**
     * Reconnects the services that the end of an earlier simulation disconnected. In lock-step this happens when time
     * first passes. A script that connects its services itself is then always first, so that each run is the same.
     */
    void callBackUsers() {
        if (!calledBack) {
            calledBack = true;
            lines.forEach(line -> PortArrivals.arrived(line.getUserPort()));
        }
    }

    /**
     * Makes a step of lock-step, then delivers its bytes port by port. The callbacks of each port return before the
     * next port's turn.
     *
     * @param step makes the step
     */
    void step(SleepingThreads.Work step) throws InterruptedException {
        lines.forEach(line -> line.setStepping(true));
        try {
            step.run();
        } finally {
            lines.forEach(line -> line.setStepping(false));
        }
        for (UartLine line : lines) {
            if (line.handOver()) {
                settle.run();
            }
        }
    }
}
