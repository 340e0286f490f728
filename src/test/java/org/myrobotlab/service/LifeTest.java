package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.util.Collections;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.serial.SerialDeviceFactory;

/** Whatever ends a SEAR service, no thread, port or server of it is left, and another can follow. */
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

    private static void assertNothingIsLeft() {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE);
        while (!TestWorld.threads().isEmpty() && System.nanoTime() < end) {
            Thread.onSpinWait();
        }
        assertEquals(Collections.emptyList(), TestWorld.threads());
        for (String port : new String[] {TestWorld.ROOMBA_PORT, TestWorld.LIDAR_PORT, TestWorld.GPS_PORT}) {
            assertNull(SerialDeviceFactory.get(port));
        }
    }

    @Test
    public void startedAndReleasedAgainAndAgain() {
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

    @Test
    public void shutDownWithAServerForOtherProgramsOpen() throws Exception {
        SEAR sear = start("life");
        int number = sear.exportTcp(TestWorld.ROOMBA_PORT, 0);
        try (Socket client = new Socket(InetAddress.getLoopbackAddress(), number)) {
            Runtime.shutdown();
            assertTrue("the server hung up", isHungUp(client));
        }
        assertNothingIsLeft();
        try (Socket client = new Socket(InetAddress.getLoopbackAddress(), number)) {
            throw new AssertionError("the server still listens at " + client);
        } catch (ConnectException e) {
            assertNull(Runtime.getService("life"));
        }
    }

    /** A connection that the server had not accepted yet is reset, others end. */
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
    public void releasedByTwoThreadsAtOnce() throws Exception {
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
