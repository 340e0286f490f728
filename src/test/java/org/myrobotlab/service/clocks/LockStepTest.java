// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.clocks;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicReference;
import org.SEAR.Slow;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.FarEnd;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.Serial;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;

/** In lock-step a script gives the same bytes on every port each time, whatever the load of the machine. */
@Category(Slow.class)
public class LockStepTest {
    private static final String SCRIPT = String.join("\n",
        "sear = Runtime.start('sear', 'SEAR')",
        "sear.startSimulation()",
        "seen = []",
        "def onScan(data):",
        "    seen.append(min(data))",
        "    if min(data) < 1500:",
        "        for b in (137, 0, 0, 0, 0): roombaLine.write(b)",
        "roombaLine = Runtime.start('roombaLine', 'Serial')",
        "roombaLine.connect('" + TestWorld.ROOMBA_PORT + "', 57600, 8, 1, 0)",
        "lidar = Runtime.start('lockLidar', 'LIDAR')",
        "lidar.connect('" + TestWorld.LIDAR_PORT + "', 38400)",
        "lidar.addListener('publishLidarData', python.getName(), 'onScan')",
        "for b in (128, 131, 137, 0, 200, 128, 0): roombaLine.write(b)",
        "for i in range(10):",
        "    lidar.singleScan()",
        "    sear.simSleep(0.5)",
        "    roombaLine.write(142)",
        "    roombaLine.write(0)",
        "result = str(seen) + str(list(sear.getPose('roomba')))",
        "sear.stopSimulation()");

    /** Timeout, milliseconds; longer than anything here takes, even on a busy machine. */
    private static final long PATIENCE = 120_000;
    /** Duration of a pause, milliseconds; longer than the interval at which a sleeper checks for its end. */
    private static final long PAUSE = 600;

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private Python python;

    @Before
    public void start() {
        TestWorld.build(temporary.getRoot().toPath());
        python = (Python) Runtime.start("python", "Python");
    }

    /** Runs the script and returns its observations and the robot's final position. */
    private String run(Path script) throws Exception {
        assertTrue(python.execFile(script.toString()));
        return String.valueOf(python.get("result"));
    }

    @Test
    public void theSameScriptTwiceGivesTheSame() throws Exception {
        Path script = temporary.newFile("lockstep.py").toPath();
        Files.write(script, SCRIPT.getBytes(StandardCharsets.UTF_8));
        String first = run(script);
        assertTrue(first, first.contains("["));
        for (int i = 0; i < 3; i++) {
            assertEquals(first, run(script));
        }
    }

    @Test
    public void everyByteToThePortsIsTheSame() throws Exception {
        assertEquals(bytesOfARun(), bytesOfARun());
    }

    /**
     * Pauses and resets while a script sleeps for two seconds.
     * @param lockStep whether only the sleep advances time
     */
    private void resetWhileAScriptSleeps(boolean lockStep, double speed) throws Exception {
        SEAR sear = (SEAR) Runtime.start("sear", "SEAR");
        sear.startSimulation();
        sear.setLockStep(lockStep);
        sear.setSpeed(Double.POSITIVE_INFINITY);
        sear.simSleep(30);
        sear.setSpeed(speed);
        AtomicReference<Double> start = new AtomicReference<>();
        AtomicReference<Object> end = new AtomicReference<>();
        Thread script = new Thread(() -> {
            try {
                start.set(sear.getTime());
                sear.simSleep(2);
                end.set(sear.getTime());
            } catch (RuntimeException e) {
                end.set(e);
            }
        }, "sleeper");
        script.start();
        while (start.get() == null || sear.getTime() < start.get() + 0.2) {
            Thread.onSpinWait();
        }
        sear.pause();
        double slept = sear.getTime() - start.get();
        sear.reset();
        assertEquals(0, sear.getTime(), 1e-9);
        sear.resume();
        script.join(PATIENCE);
        assertFalse("still asleep at " + sear.getTime(), script.isAlive());
        assertTrue(String.valueOf(end.get()), end.get() instanceof Double);
        assertEquals("the rest of the sleep", 2 - slept, (Double) end.get(), lockStep ? 0.02 : 1);
        sear.stopSimulation();
    }

    @Test
    public void aSleepInLockStepContinuesAfterPauseAndReset() throws Exception {
        for (int i = 0; i < 3; i++) {
            resetWhileAScriptSleeps(true, 1);
        }
    }

    @Test
    public void aSleepInRealTimeIsRelativeToAReset() throws Exception {
        resetWhileAScriptSleeps(false, 1);
    }

    @Test
    public void pauseResetAndResumeWhileASleeperWaitsForTheEndOfThePause() throws Exception {
        SEAR sear = (SEAR) Runtime.start("sear", "SEAR");
        sear.startSimulation();
        sear.pause();
        AtomicReference<Throwable> failure = new AtomicReference<>();
        Thread script = new Thread(() -> sear.simSleep(1), "sleeper");
        script.setUncaughtExceptionHandler((thread, e) -> failure.set(e));
        script.start();
        while (script.getState() != Thread.State.TIMED_WAITING) {
            Thread.onSpinWait();
        }
        sear.reset();
        script.join(PAUSE);
        assertTrue("the sleeper waits on: " + failure.get(), script.isAlive());
        sear.resume();
        script.join(PATIENCE);
        assertFalse("still asleep", script.isAlive());
        assertNull(String.valueOf(failure.get()), failure.get());
        assertEquals(1, sear.getTime(), 1e-9);
        sear.stopSimulation();
    }

    private String bytesOfARun() throws Exception {
        SEAR sear = (SEAR) Runtime.start("sear", "SEAR");
        sear.startSimulation();
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        Serial line = (Serial) Runtime.start("roombaLine", "Serial");
        line.connect(TestWorld.ROOMBA_PORT, 57600, 8, 1, 0);
        line.write(FarEnd.bytes("80 83 94 02 13 14 89 00 C8 01 F4"));
        for (int i = 0; i < 5; i++) {
            sear.simSleep(1);
            int waiting = line.available();
            byte[] bytes = waiting == 0 ? new byte[0] : line.read(waiting);
            all.write(bytes, 0, bytes.length);
            all.write(Arrays.toString(sear.getPose("roomba")).getBytes(StandardCharsets.UTF_8));
        }
        sear.stopSimulation();
        Runtime.releaseService("roombaLine");
        assertTrue("bytes: " + all.size(), all.size() > 500);
        return FarEnd.hex(MessageDigest.getInstance("SHA-256").digest(all.toByteArray()));
    }
}
