// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.lang.management.ManagementFactory;
import java.lang.management.OperatingSystemMXBean;
import java.util.Collection;
import java.util.Collections;
import org.openjdk.jmh.infra.BenchmarkParams;
import org.openjdk.jmh.infra.IterationParams;
import org.openjdk.jmh.profile.InternalProfiler;
import org.openjdk.jmh.results.AggregationPolicy;
import org.openjdk.jmh.results.IterationResult;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.ScalarResult;

/**
 * Share of a core that all threads of the JVM used in an iteration; 1 for one thread that ran all the time. A rate
 * divided by it is a rate per second of processor time, which other load on the machine affects less.
 */
public final class CpuShare implements InternalProfiler {
    /** The name of the secondary result. */
    static final String LABEL = "cpuShare";
    private long wall;
    private long cpu;

    @Override
    public String getDescription() {
        return "CPU time of the process by wall time";
    }

    private static long processTime() {
        OperatingSystemMXBean system = ManagementFactory.getOperatingSystemMXBean();
        return system instanceof com.sun.management.OperatingSystemMXBean
            ? ((com.sun.management.OperatingSystemMXBean) system).getProcessCpuTime() : 0;
    }

    @Override
    public void beforeIteration(BenchmarkParams benchmark, IterationParams iteration) {
        cpu = processTime();
        wall = System.nanoTime();
    }

    @Override
    public Collection<? extends Result<?>> afterIteration(BenchmarkParams benchmark, IterationParams iteration,
        IterationResult result) {
        double share = (double) (processTime() - cpu) / (System.nanoTime() - wall);
        return Collections.singletonList(new ScalarResult(LABEL, share, "cores", AggregationPolicy.AVG));
    }
}
