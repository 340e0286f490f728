package org.myrobotlab.service.sear.run;

import java.util.List;
import org.myrobotlab.serial.PortArrivals;
import org.myrobotlab.service.sear.lockstep.SleepingThreads;

/**
 * What the ports of a simulation have to do in one order always, that of the project. One thread at a time.
 */
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
     * Those who were disconnected when an earlier simulation ended are connected again. In lock-step when time first passes, so that a script that
     * connects its services itself comes first, and does the same each time.
     */
    void callBackUsers() {
        if (!calledBack) {
            calledBack = true;
            lines.forEach(line -> PortArrivals.arrived(line.getUserPort()));
        }
    }

    /**
     * A step of lock-step: what it brings is handed over port after port, each when the callbacks of the one before have returned.
     *
     * @param step makes it
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
