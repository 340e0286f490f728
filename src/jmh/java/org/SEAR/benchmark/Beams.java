// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.util.concurrent.TimeUnit;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.Pose;
import org.SEAR.raycast.BeamScene;
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
import org.openjdk.jmh.annotations.Warmup;

/** Rays per microsecond in rooms of constant size and in growing worlds. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 400, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 5, time = 300, timeUnit = TimeUnit.MILLISECONDS)
@Fork(1)
public class Beams {
    @Param({"room-20", "room-100", "room-1000", "hall-10", "hall-100", "hall-1000", "hall-10000", "hills-1000",
        "hills-10000", "hills-110000", "hills-1000000"})
    public String world;

    private BeamWorld beams;
    private BeamScene scene;
    private double[] directions;
    private double[] ranges;
    private Pose pose;
    private int next;

    @Setup(Level.Trial)
    public void build() {
        beams = new BeamWorld(world);
        scene = beams.scene();
        directions = beams.directions();
        ranges = new double[BeamWorld.BEAMS];
    }

    private int advance() {
        next = (next + 1) % BeamWorld.POSES;
        pose = beams.poses[next];
        return 3 * BeamWorld.BEAMS * next;
    }

    /** Casts a LIDAR's scan as one fan. */
    @Benchmark
    @OperationsPerInvocation(BeamWorld.BEAMS)
    public double[] fan() {
        advance();
        scene.castFan(pose, BeamWorld.startAngle(), BeamWorld.stepAngle(), BeamWorld.BEAMS, BeamWorld.RANGE,
            BeamScene.WORLD, ranges, null);
        return ranges;
    }

    /** Casts the same rays one by one. */
    @Benchmark
    @OperationsPerInvocation(BeamWorld.BEAMS)
    public double[] single() {
        int at = advance();
        for (int i = 0; i < BeamWorld.BEAMS; i++) {
            ranges[i] = scene.cast(pose.x, pose.y, pose.z, directions[at], directions[at + 1], directions[at + 2],
                BeamWorld.RANGE, BeamScene.WORLD, null);
            at += 3;
        }
        return ranges;
    }

    /** World of jbullet. */
    @State(Scope.Benchmark)
    public static class Peer {
        private JBulletWorld world;
        private final Vector3f from = new Vector3f();
        private final Vector3f to = new Vector3f();

        @Setup(Level.Trial)
        public void build(Beams beams) {
            world = new JBulletWorld(beams.beams);
        }
    }

    /** Casts the same rays with jbullet's rayTest. */
    @Benchmark
    @OperationsPerInvocation(BeamWorld.BEAMS)
    public double[] jbullet(Peer peer) {
        int at = advance();
        double range = BeamWorld.RANGE;
        for (int i = 0; i < BeamWorld.BEAMS; i++) {
            peer.from.set((float) pose.x, (float) pose.y, (float) pose.z);
            peer.to.set((float) (pose.x + range * directions[at]), (float) (pose.y + range * directions[at + 1]),
                (float) (pose.z + range * directions[at + 2]));
            ranges[i] = peer.world.cast(peer.from, peer.to);
            at += 3;
        }
        return ranges;
    }
}
