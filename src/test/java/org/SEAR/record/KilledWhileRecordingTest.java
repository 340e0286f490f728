// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.Slow;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * A process that records a run is killed at random moments, like {@code kill -9}. Its record opens, does not count as
 * still being written, lacks only the last moments and reruns to the byte. {@code -Dsear.kills=100} sets the number of
 * kills.
 */
@Category(Slow.class)
public class KilledWhileRecordingTest {
    private static final long SEED = 31;
    private static final int KILLS = Integer.getInteger("sear.kills", 5);
    private static final int STEPS_PER_SECOND = 60;
    private static final int LONGEST_STEPS = 7 * STEPS_PER_SECOND;
    /** Limit of lost steps. Events are on the disk after a second; a busy machine may take longer. */
    private static final int MOST_LOST = 4 * STEPS_PER_SECOND;
    private static final String FILE = "run.searlog";

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** Records a run, never faster than real time, until it is killed, and prints the step number. */
    public static void main(String[] folder) throws Exception {
        Path root = Paths.get(folder[0]);
        Simulation world = Simulation.of(Project.read(root.resolve("SEARproject")), SEED);
        Recorder.begin(world, root.resolve(FILE), Recorder.LIMIT, System.err::println);
        for (int step = 1;; step++) {
            if (step % 20 == 1) {
                world.post(DriveCommand.wheels(0, 0.1 * (step % 3), 0.2));
                world.getLines().get(0).write(new byte[] {(byte) 0x80, (byte) 0x84, (byte) 0x8E, 0});
            }
            world.step();
            System.out.println(step);
            if (step == STEPS_PER_SECOND / 2) {
                // on some systems this drops the lock of the record, yet other processes must find it still being
                // written
                RunRecord.open(root.resolve(FILE));
            }
            LockSupport.parkNanos(TimeUnit.SECONDS.toNanos(1) / STEPS_PER_SECOND);
        }
    }

    private Process start() throws IOException {
        return new ProcessBuilder(Paths.get(System.getProperty("java.home"), "bin", "java").toString(), "-Xshare:auto",
            "-XX:TieredStopAtLevel=1",
            "-XX:+UseSerialGC", "-cp", System.getProperty("java.class.path"), KilledWhileRecordingTest.class.getName(),
                project.getRoot().toString())
            .redirectError(new File(project.getRoot(), "errors.txt")).start();
    }

    /** Kills a process after it printed this number of steps. */
    private void kill(Process process, int steps) throws Exception {
        try (BufferedReader in = new BufferedReader(
            new InputStreamReader(process.getInputStream(), StandardCharsets.US_ASCII))) {
            for (int step = 1; step <= steps; step++) {
                String line = in.readLine();
                assertEquals(Files.readString(project.getRoot().toPath().resolve("errors.txt")),
                    Integer.toString(step), line);
            }
            long patience = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
            while (!RunRecord.open(file()).isBeingWritten() && System.nanoTime() < patience) {
                Thread.yield();
            }
            assertTrue("its record says that it is being written", RunRecord.open(file()).isBeingWritten());
        } finally {
            process.destroyForcibly().waitFor();
        }
    }

    private Path file() {
        return project.getRoot().toPath().resolve(FILE);
    }

    @Test
    public void itsRecordIsCompleteExceptForTheLastMoments() throws Exception {
        new Floor("floor", 50, 50);
        SEARrobot robot = Robots.create("rover", "/dev/uart", "/dev/user");
        robot.addComponent(new Distance("ping"));
        robot.addComponent(new Accelerometer("accel"));
        Random random = new Random(SEED);
        long mostLost = 0;
        for (int kill = 0; kill < KILLS; kill++) {
            int steps = STEPS_PER_SECOND + random.nextInt(LONGEST_STEPS);
            kill(start(), steps);
            RunRecord record = RunRecord.open(file());
            assertFalse("its writer is dead", record.isBeingWritten());
            Rerun.Result again = Rerun.of(record, Project.read(project.folder()));
            assertFalse("it was cut off", again.whole);
            assertTrue("kill " + kill + ": " + again, again.same);
            long lost = steps - Math.round(again.seconds * STEPS_PER_SECOND);
            assertTrue("kill " + kill + ": " + lost + " of " + steps + " steps are lost", lost <= MOST_LOST);
            mostLost = Math.max(mostLost, lost);
        }
        System.out.printf("%d kills, at most %.2f s of a record lost%n", KILLS, mostLost * Simulation.STEP);
    }
}
