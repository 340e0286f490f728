package org.SEAR;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;

/** Seconds that processors worked for this process: other work on the machine hardly counts, unlike seconds of the clock. */
public final class ProcessorTime {
    private static final OperatingSystemMXBean SYSTEM = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    private final long start = SYSTEM.getProcessCpuTime();

    /** Since this was made. */
    public double seconds() {
        return (SYSTEM.getProcessCpuTime() - start) / 1e9;
    }
}
