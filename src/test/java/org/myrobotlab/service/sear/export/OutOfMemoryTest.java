// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.export;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.framework.Message;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.sear.RecordingHost;
import org.myrobotlab.service.sear.run.SimulationControl;

/** When memory runs out anywhere, the simulation ends with a message and its ports close. */
public class OutOfMemoryTest {
    private static final String USER = "/dev/memory_user";
    private static final long PATIENCE = TimeUnit.SECONDS.toNanos(60);

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private final RecordingHost host = new RecordingHost();
    private SimulationControl control;
    private Thread.UncaughtExceptionHandler before;

    @Before
    public void start() throws Exception {
        before = Thread.getDefaultUncaughtExceptionHandler();
        Path folder = temporary.getRoot().toPath().resolve("SEARproject");
        System.setProperty("sear.project", folder.toString());
        System.setProperty("sear.headless", "true");
        new Floor("floor", 10, 10);
        SEARrobot robot = new SEARrobot("roomba");
        Dynamics dynamics = new Dynamics("drive", 4, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 0);
        dynamics.setPorts("/dev/memory_uart", USER);
        robot.addComponent(dynamics);
        robot.addComponent(new Cylinder("body", 0.16, 0.07, 4));
        for (double[] at : new double[][] {{0, 0.16, 0}, {-0.16, 0, 1}, {0.16, 0, 1}, {0, -0.16, 0}}) {
            Wheel wheel = new Wheel("wheel" + robot.getWheels().size(), 0.0381, 0.03, (int) at[2]);
            wheel.move(at[0], 0, at[1]);
            robot.addWheel(wheel);
        }
        control = new SimulationControl(host, () -> folder);
        control.start(false);
        assertNotNull(SerialDeviceFactory.get(USER));
    }

    @After
    public void stop() {
        control.stop();
        Runtime.releaseAll();
        System.clearProperty("sear.project");
        System.clearProperty("sear.headless");
    }

    private void awaitEnd() throws InterruptedException {
        long end = System.nanoTime() + PATIENCE;
        while (host.errors.isEmpty() && System.nanoTime() < end) {
            synchronized (host) {
                host.wait(10);
            }
        }
        assertEquals(host.errors.toString(), 1, host.errors.size());
        assertTrue(host.errors.get(0), host.errors.get(0).contains("because Java ran out of memory"));
        assertTrue(host.errors.get(0), host.errors.get(0).contains("its ports are closed"));
        assertFalse(control.isRunning());
        assertNull("the port is gone", SerialDeviceFactory.get(USER));
    }

    @Test
    public void onTheSimulationThread() throws Exception {
        try {
            control.session().ask(world -> {
                throw new OutOfMemoryError("Java heap space");
            });
        } catch (IllegalStateException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("broke down"));
        }
        awaitEnd();
        control.start(false);
        assertTrue("a new one starts", control.isRunning());
    }

    /** A service's own thread catches errors of a called method and continues. */
    @Test
    public void whereAMessageCallsAMethod() throws Exception {
        Runtime.start("hungry", Hungry.class.getName())
            .in(Message.createMessage("test", "hungry", "eat", new Object[0]));
        awaitEnd();
    }

    /** An endlessly growing list ends a script or a callback like this. */
    @Test
    public void inAScript() throws Exception {
        Python python = (Python) Runtime.start("python", "Python");
        assertFalse(python.exec("from java.lang import OutOfMemoryError\nraise OutOfMemoryError('Java heap space')"));
        awaitEnd();
    }

    /** Jython's translation of Java's error in its own code. */
    @Test
    public void asPythonsOwnError() throws Exception {
        Python python = (Python) Runtime.start("python", "Python");
        assertFalse(python.exec("raise MemoryError('too much')"));
        awaitEnd();
    }

    @Test
    public void aScriptThatOnlyFailsEndsNothing() {
        Python python = (Python) Runtime.start("python", "Python");
        assertFalse(python.exec("raise ValueError('no')"));
        assertFalse(python.exec("Runtime.getService('nobody').stop()"));
        assertTrue(control.isRunning());
    }

    @Test
    public void onAnotherThreadOfTheProgram() throws Exception {
        Thread other = new Thread(() -> {
            throw new OutOfMemoryError("Java heap space");
        });
        other.start();
        other.join();
        awaitEnd();
        control.stop();
        assertSame("whoever watched before watches again", before, Thread.getDefaultUncaughtExceptionHandler());
    }
}
