// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.io.IOException;
import java.util.concurrent.TimeUnit;
import org.SEAR.project.problems.ProjectException;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Pictures per second of a camera on one thread: in a room with 20 boxes, in an example's world, and on a mountain. See
 * {@link PictureWorld}.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 4, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class Pictures {
    @Param({"room-20", "sensors", "mountain"})
    public String world;

    private PictureWorld pictures;
    private int turn;

    @Setup(Level.Trial)
    public void build() throws IOException, ProjectException {
        pictures = new PictureWorld(world);
    }

    private int next() {
        turn = (turn + 1) % PictureWorld.TURNS;
        return turn;
    }

    /** Draws colours with shadows. */
    @Benchmark
    public int[] colors() {
        return pictures.colors(next());
    }

    /** Draws depths. */
    @Benchmark
    public float[] depths() {
        return pictures.depths(next());
    }
}
