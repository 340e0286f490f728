// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.stream.Stream;
import org.junit.After;
import org.junit.Test;
import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.Talker;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.config.RuntimeConfig;
import org.myrobotlab.service.config.ServiceConfig;

/** The embedded MyRobotLab treats plug-ins like the real one. */
public class ImitationTest {
    private static final String SET = "imitation-test";
    private static final String TALKER = Talker.class.getName();

    /** A service whose isRunning has another meaning. */
    public static class Denier extends Service<ServiceConfig> {
        private static final long serialVersionUID = 1L;

        public Denier(String name, String id) {
            super(name, id);
        }

        @Override
        public boolean isRunning() {
            return false;
        }
    }

    @After
    public void release() throws Exception {
        Runtime.releaseAll();
        Runtime.setConfig("default");
        Path folder = Paths.get(Runtime.ROOT_CONFIG_DIR, SET);
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path file : (Iterable<Path>) files::iterator) {
                    Files.delete(file);
                }
            }
            Files.delete(folder);
        }
    }

    @Test
    public void aServiceThatDeniesRunningIsStartedAgainAndThusRejected() {
        assertNotNull(Runtime.start("denier", Denier.class.getName()));
        assertFalse(Runtime.isStarted("denier"));
        assertNull(Runtime.start("denier", Denier.class.getName()));
        assertTrue(Runtime.getInstance().getLastError().toString().contains("IllegalThreadStateException"));
    }

    @Test
    public void aSecondStartReturnsTheSameService() {
        for (String type : new String[] {"SEAR", "LIDAR", "GPS"}) {
            ServiceInterface first = Runtime.start("the" + type, type);
            assertNotNull(type, first);
            assertSame(first, Runtime.start("the" + type, type));
            assertTrue(Runtime.isStarted("the" + type));
        }
        assertFalse(Runtime.getInstance().hasError());
    }

    @Test
    public void aSavedConfigurationHasEveryServiceAndItsListeners() {
        Runtime.start("sear", "SEAR");
        LIDAR lidar = (LIDAR) Runtime.start("lidar", "LIDAR");
        Runtime.start("gps", "GPS");
        Runtime.start("wire", "Serial");
        lidar.setModel("LMS291");
        lidar.addListener("publishScan", "wire", "onScan");
        assertTrue(Runtime.saveConfig(SET));
        Runtime.releaseAll();
        Runtime.startConfig(SET);
        for (String name : new String[] {"sear", "lidar", "lidar.serial", "gps", "gps.serial", "wire"}) {
            assertTrue(name, Runtime.isStarted(name));
        }
        lidar = (LIDAR) Runtime.getService("lidar");
        assertEquals("LMS291", lidar.getConfig().model);
        assertTrue(lidar.hasSubscribed("wire", "publishScan"));
        assertFalse(String.valueOf(Runtime.getInstance().getLastError()), Runtime.getInstance().hasError());
        Runtime.startConfig(SET);
        assertFalse("again", Runtime.getInstance().hasError());
    }

    @Test
    public void aServiceThatDeniesRunningAbortsASavedConfiguration() {
        Runtime.start("denier", Denier.class.getName());
        Runtime.start("wire", "Serial");
        RuntimeConfig runtime = Runtime.getInstance().getConfig();
        assertTrue(runtime.getRegistry().contains("denier"));
        assertTrue(Runtime.saveConfig(SET));
        Runtime.release("wire");
        try {
            Runtime.startConfig(SET);
            fail("the denier is started again");
        } catch (IllegalThreadStateException e) {
            assertFalse(Runtime.isStarted("wire"));
        }
        assertFalse(Runtime.getInstance().isProcessingConfig());
    }

    @Test
    public void aMissingConfigurationIsAnError() {
        Runtime.startConfig(SET);
        assertEquals("there is no saved configuration " + SET + ": its runtime.yml is missing", Runtime.getInstance()
            .getLastError().key);
    }

    @Test
    public void aCallbackAlwaysGetsTheFirstPublishersValueForTheLifeOfThePythonService() throws Exception {
        Python python = (Python) Runtime.start("python", "Python");
        Talker first = (Talker) Runtime.start("first", TALKER);
        Talker second = (Talker) Runtime.start("second", TALKER);
        first.addListener("publishNumber", "python", "shared");
        assertTrue(python.exec("from java.util.concurrent import LinkedBlockingQueue as Q\ngot = Q()\ndef "
            + "shared(data): got.put(data)"));
        first.invoke("publishNumber", 1);
        assertTrue(python.exec("assert got.take() == 1"));
        assertTrue(python.exec("got = Q()\ndef shared(data): got.put(data)"));
        second.addListener("publishNumber", "python", "shared");
        second.invoke("publishNumber", 2);
        assertTrue("in the next script too", python.exec("assert got.take() == 1"));
        Runtime.release("python");
        python = (Python) Runtime.start("python", "Python");
        second.addListener("publishNumber", "python", "shared");
        assertTrue(python.exec("from java.util.concurrent import LinkedBlockingQueue as Q\ngot = Q()\ndef "
            + "shared(data): got.put(data)"));
        second.invoke("publishNumber", 3);
        assertTrue("a new Python service has forgotten", python.exec("assert got.take() == 3"));
    }

    @Test
    public void callbacksRunOnAThreadNamedAfterPythonAndTheService() {
        Python python = (Python) Runtime.start("snake", "Python");
        Talker talker = (Talker) Runtime.start("talker", TALKER);
        talker.addListener("publishNumber", "snake", "nameOfThread");
        assertTrue(python.exec("from java.util.concurrent import LinkedBlockingQueue as Q\nfrom java.lang import "
            + "Thread\ngot = Q()\ndef nameOfThread(data): got.put(Thread.currentThread().getName())"));
        talker.invoke("publishNumber", 1);
        assertTrue(python.exec("assert got.take() == 'python.snake.input'"));
    }

    @Test
    public void startingALidarReplacesAnImportedClassOfThatName() {
        Python python = (Python) Runtime.start("python", "Python");
        assertTrue(python.exec("from org.SEAR.POJOs import LIDAR\nfrom java.util.concurrent import TimeUnit\nimport "
            + "time\nimported = LIDAR\n"
            + "Runtime.start('scanner', 'LIDAR')\nend = time.time() + 20\nwhile LIDAR is imported and time.time() < "
            + "end: time.sleep(0.005)\nassert LIDAR is not imported"));
        assertFalse(python.exec("LIDAR('x')"));
        assertTrue(python.getLastError().key, python.getLastError().key.contains("expected 2 args"));
    }
}
