// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** Steps per second by the number of moving bodies, and with sleeping bodies. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 2, time = 1)
@Measurement(iterations = 3, time = 1)
@Fork(1)
public class Drops {
    @Param({"drop-10", "drop-30", "drop-100", "drop-300", "drop-1000", "asleep-1000"})
    public String world;

    private DropWorld drops;

    @Setup(Level.Trial)
    public void build() {
        drops = new DropWorld(world);
    }

    /** Resets all boxes into the air. */
    @Setup(Level.Invocation)
    public void restart() {
        if (world.startsWith("drop")) {
            drops.reset();
        }
    }

    @TearDown(Level.Trial)
    public void end() {
        drops.close();
    }

    /** Runs from the drop until the first bodies sleep. */
    @Benchmark
    @OperationsPerInvocation(DropWorld.STEPS)
    public Object step() {
        for (int i = 0; i < DropWorld.STEPS; i++) {
            drops.step();
        }
        return drops.getSimulation().snapshot();
    }
}
