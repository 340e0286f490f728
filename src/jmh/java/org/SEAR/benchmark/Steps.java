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

/** Steps a second of one robot with four wheels that drives in a room; divided by 60 that is how many times faster than real time. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class Steps {
    private static final int BATCH = 60;

    @Param({"20", "1000"})
    public int boxes;
    @Param({"drive", "lidar", "all"})
    public String equipment;

    private StepWorld world;

    /** Makes the world. */
    @Setup(Level.Trial)
    public void build() {
        world = new StepWorld(boxes, !equipment.equals("drive"), equipment.equals("all"));
    }

    /** Lets go of it. */
    @TearDown(Level.Trial)
    public void end() {
        world.close();
    }

    /** A simulated second. */
    @Benchmark
    @OperationsPerInvocation(BATCH)
    public Object step() {
        for (int i = 0; i < BATCH; i++) {
            world.step();
        }
        return world.getSimulation().snapshot();
    }
}
