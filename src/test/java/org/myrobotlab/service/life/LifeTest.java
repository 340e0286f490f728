// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.life;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.TestWorld;

/** However a SEAR service ends, none of its threads, ports or servers remains, and another service can follow. */
@Category(Slow.class)
public class LifeTest {
    private static final double STRAIGHT = Double.POSITIVE_INFINITY;
    private static final int PATIENCE = 60;

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    @Before
    public void project() {
        System.setProperty("sear.headless", "true");
        System.setProperty("sear.speed", "1");
        TestWorld.build(temporary.getRoot().toPath());
    }

    @After
    public void release() {
        Runtime.releaseAll();
        System.clearProperty("sear.project");
        System.clearProperty("sear.speed");
    }

    private static SEAR start(String name) {
        SEAR sear = (SEAR) Runtime.start(name, "SEAR");
        sear.startSimulation();
        return sear;
    }

    static void assertNothingIsLeft() {
        TestWorld.assertNoThreads();
        for (String port : new String[] {TestWorld.ROOMBA_PORT, TestWorld.LIDAR_PORT, TestWorld.GPS_PORT}) {
            assertNull(SerialDeviceFactory.get(port));
        }
    }

    @Test
    public void startedAndReleasedRepeatedly() {
        for (int round = 0; round < 5; round++) {
            SEAR sear = start("life" + round % 2);
            sear.simSleep(0.1);
            assertTrue(Runtime.releaseService(sear.getName()));
            assertFalse(sear.isSimulating());
            assertNothingIsLeft();
        }
    }

    @Test
    public void stoppedAndStartedAgainItIsTheSameService() {
        SEAR sear = start("life");
        sear.stopService();
        assertFalse(sear.isSimulating());
        assertNothingIsLeft();
        sear.startService();
        sear.startSimulation();
        sear.simSleep(0.1);
        assertTrue(sear.isSimulating());
    }

    /** Runs in a separate process, because MyRobotLab's shutdown may end it. */
    @Test
    public void shutDownWithAServerForOtherProgramsOpen() throws Exception {
        Process process = new ProcessBuilder(System.getProperty("java.home") + "/bin/java", "-Dsear.headless=true",
            "-Dsear.speed=1", "-cp",
            System.getProperty("java.class.path"), ShutDownProbe.class.getName(), temporary.newFolder().getPath())
            .redirectErrorStream(true).start();
        StringBuilder log = new StringBuilder();
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(process.getInputStream()))) {
            int number = Integer.parseInt(lineThatBegins(ShutDownProbe.LISTENS, lines, log));
            try (Socket client = new Socket(InetAddress.getLoopbackAddress(), number)) {
                process.getOutputStream().close();
                assertTrue("the server hung up\n" + log, isHungUp(client));
            }
            lines.lines().forEach(line -> log.append(line).append('\n'));
            assertTrue("a thread keeps MyRobotLab alive\n" + log, process.waitFor(PATIENCE, TimeUnit.SECONDS));
            assertFalse(log.toString(), log.toString().contains("Exception in thread"));
            try (Socket client = new Socket(InetAddress.getLoopbackAddress(), number)) {
                throw new AssertionError("the server still listens at " + client);
            } catch (ConnectException e) {
                assertTrue(log.toString(), log.toString().contains(ShutDownProbe.SHUTS_DOWN));
            }
        } finally {
            process.destroyForcibly();
        }
    }

    private static String lineThatBegins(String beginning, BufferedReader lines, StringBuilder log) throws IOException {
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            log.append(line).append('\n');
            if (line.startsWith(beginning)) {
                return line.substring(beginning.length());
            }
        }
        throw new AssertionError("it ended:\n" + log);
    }

    /** Returns whether the connection is closed; connections that the server had not accepted are reset. */
    private static boolean isHungUp(Socket client) throws IOException {
        try {
            return client.getInputStream().read() == -1;
        } catch (SocketException e) {
            return true;
        }
    }

    @Test
    public void releasedWhileAScriptDrives() throws Exception {
        SEAR sear = start("life");
        CountDownLatch drives = new CountDownLatch(1);
        AtomicReference<Throwable> end = new AtomicReference<>();
        Thread script = new Thread(() -> {
            try {
                while (true) {
                    sear.drive(0.2, STRAIGHT);
                    sear.getDistanceResult("ping");
                    drives.countDown();
                }
            } catch (IllegalStateException e) {
                end.set(e);
            }
        });
        script.start();
        assertTrue(drives.await(PATIENCE, TimeUnit.SECONDS));
        Runtime.releaseService("life");
        script.join(TimeUnit.SECONDS.toMillis(PATIENCE));
        assertFalse("the script hangs", script.isAlive());
        assertNotNull("the script was not told", end.get());
        assertNothingIsLeft();
    }

    @Test
    public void releasedByTwoThreadsSimultaneously() throws Exception {
        SEAR sear = start("life");
        Thread other = new Thread(sear::releaseService);
        other.start();
        sear.releaseService();
        other.join(TimeUnit.SECONDS.toMillis(PATIENCE));
        assertFalse("the other hangs", other.isAlive());
        assertNothingIsLeft();
    }

    @Test
    public void aSecondServiceTakesOverWhenTheFirstIsReleased() {
        start("first");
        SEAR second = (SEAR) Runtime.start("second", "SEAR");
        Runtime.releaseService("first");
        second.startSimulation();
        second.simSleep(0.1);
        assertTrue(second.isSimulating());
        Runtime.releaseService("second");
        assertNothingIsLeft();
    }
}
