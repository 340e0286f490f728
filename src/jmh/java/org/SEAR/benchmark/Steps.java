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

/** Steps per second of one four-wheeled robot among fixed boxes. Divided by 60, this is the real-time factor. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 4, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Fork(1)
public class Steps {
    private static final int BATCH = 60;

    @Param({"drive-room-20", "drive-room-1000", "lidar-room-20", "lidar-room-1000", "all-room-20", "all-room-1000",
        "camera-room-20", "blind-room-20", "lidar-hall-10", "lidar-hall-100", "lidar-hall-1000", "lidar-hall-9900",
        "lidars2-room-20", "lidars4-room-20", "lidars8-room-20"})
    public String world;

    private StepWorld steps;

    @Setup(Level.Trial)
    public void build() {
        steps = new StepWorld(world);
    }

    @TearDown(Level.Trial)
    public void end() {
        steps.close();
    }

    /** Runs one simulated second. */
    @Benchmark
    @OperationsPerInvocation(BATCH)
    public Object step() {
        for (int i = 0; i < BATCH; i++) {
            steps.step();
        }
        return steps.getSimulation().snapshot();
    }
}
