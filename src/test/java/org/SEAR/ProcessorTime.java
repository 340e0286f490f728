// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;

/** CPU time of this process, seconds. Unlike the clock it hardly depends on other work on the machine. */
public final class ProcessorTime {
    private static final OperatingSystemMXBean SYSTEM =
        (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    private final long start = SYSTEM.getProcessCpuTime();

    public double seconds() {
        return (SYSTEM.getProcessCpuTime() - start) / 1e9;
    }
}
