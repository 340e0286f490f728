// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.After;
import org.junit.Test;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.embedded.Shutdown;
import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.Talker;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.config.PythonConfig;
import org.myrobotlab.service.config.SerialConfig;
import org.myrobotlab.service.config.ServiceConfig;

/** Creation, start and release of services in the embedded MyRobotLab. */
public class RuntimeTest {
    private static final String TALKER = Talker.class.getName();

    /** A service whose start fails. */
    public static class Broken extends Service<ServiceConfig> {
        private static final long serialVersionUID = 1L;

        public Broken(String name, String id) {
            super(name, id);
        }

        @Override
        public synchronized void startService() {
            super.startService();
            throw new IllegalStateException("the battery is empty");
        }
    }

    /** A service that can't be released. */
    public static class Clinging extends Service<ServiceConfig> {
        private static final long serialVersionUID = 1L;

        public Clinging(String name, String id) {
            super(name, id);
        }

        @Override
        public void preShutdown() {
            throw new IllegalStateException("not now");
        }

        @Override
        public synchronized void releaseService() {
            super.releaseService();
            throw new ClassCastException("not of that type");
        }
    }

    /** A service whose constructor needs a missing library. */
    public static class Bare extends Service<ServiceConfig> {
        private static final long serialVersionUID = 1L;

        public Bare(String name, String id) {
            super(name, id);
            throw new NoClassDefFoundError("com/jme3/math/Vector3f");
        }
    }

    @After
    public void release() {
        Runtime.releaseAll();
    }

    @Test
    public void aServiceThatCannotBeReleasedBlocksNoOtherRelease() {
        ServiceInterface first = Runtime.start("first", TALKER);
        Runtime.start("clinging", Clinging.class.getName());
        ServiceInterface last = Runtime.start("last", TALKER);
        AtomicBoolean hasEnded = new AtomicBoolean();
        Shutdown.then(() -> hasEnded.set(true));
        try {
            Runtime.shutdown();
        } finally {
            Shutdown.then(() -> { });
        }
        assertTrue(hasEnded.get());
        assertFalse(first.isRunning());
        assertFalse(last.isRunning());
        assertNull(Runtime.getService("first"));
    }

    /** Applies a configuration of any type, like a call by name. */
    @SuppressWarnings("unchecked")
    private static <C extends ServiceConfig> void applyUnchecked(Service<C> service, ServiceConfig config) {
        service.apply((C) config);
    }

    @Test
    public void aConfigurationOfAnotherTypeIsRefused() {
        for (String type : new String[] {"Serial", "SEAR", "LIDAR", "GPS"}) {
            Service<?> service = (Service<?>) Runtime.start("line" + type, type);
            ServiceConfig before = service.getConfig();
            List<String> told = new ArrayList<>();
            for (ServiceConfig wrong : new ServiceConfig[] {new ServiceConfig(), null}) {
                try {
                    applyUnchecked(service, wrong);
                } catch (IllegalArgumentException e) {
                    told.add(e.getMessage());
                }
            }
            String legal = ", legal: " + type + "Config";
            assertEquals(List.of("the configuration of line" + type + " is a ServiceConfig" + legal,
                "the configuration of line" + type + " is a null" + legal), told);
            assertSame(before, service.getConfig());
        }
    }

    @Test
    public void aCreatedServiceIsNotYetStarted() {
        ServiceInterface made = Runtime.create("s", "Serial");
        assertFalse(made.isRunning());
        assertSame(made, Runtime.start("s"));
        assertTrue(made.isRunning());
        assertSame(made, Runtime.getService("s@" + Runtime.getInstance().getId()));
        assertArrayEquals(new String[] {"runtime@embedded", "s@embedded"}, Runtime.getServiceNames());
    }

    @Test
    public void aNameInUseReturnsTheExistingServiceOfAnyType() {
        ServiceInterface serial = Runtime.start("x", "Serial");
        assertSame(serial, Runtime.start("x", "Roomba"));
        assertSame(serial, Runtime.createAndStart("x", "org.myrobotlab.service.Serial"));
    }

    @Test
    public void aFailedStartReturnsNullAndReportsTheCause() {
        assertNull(Runtime.start("a", "Nix"));
        String unknown = Runtime.getInstance().getLastError().key;
        assertTrue(unknown, unknown.matches("can't start a as Nix: there is no service type Nix; the types here are "
            + ".*GPS, .*LIDAR, .*WebGui"));
        refused(Runtime.start("a", "Lidar"), "can't start a as Lidar: " + onlyReal("Lidar")
            + "; did you mean SEAR's own, LIDAR?");
        refused(Runtime.create("a", "Clock"), "can't start a as Clock: " + onlyReal("Clock"));
        refused(Runtime.createAndStart("a", "Seriall"), "can't start a as Seriall: there is no service type Seriall; "
            + "did you mean Serial?");
        refused(Runtime.loadAndStart("a", "servo"), "can't start a as servo: there is no service type servo; did "
            + "you mean Servo?");
        refused(Runtime.start("a", "java.lang.String"), "can't start a as String: java.lang.String is not a "
            + "service type");
        refused(Runtime.start("a", Broken.class.getName()), "can't start a as Broken: the battery is empty");
        refused(Runtime.start("a", Bare.class.getName()),
            "can't start a as RuntimeTest$Bare: class com.jme3.math.Vector3f is missing: a library is not on "
                + "the class path");
        refused(Runtime.start("a/b", "Serial"), "can't start a/b as Serial: a service's name is a word without \"/\"");
        refused(Runtime.start("a"), "can't start a: its type is missing, and there is no configuration file "
            + "of that name: write Runtime.start(\"a\", \"SEAR\") with a name and a type");
        refused(Runtime.create("Clock"), "can't start Clock: its type is missing, and there is no configuration file "
            + "of that name: write Runtime.start(\"name\", \"Clock\") with a name and a type");
        assertEquals(1, Runtime.getServices().size());
    }

    private static String onlyReal(String type) {
        return "only the real MyRobotLab has the service " + type + ": install SEAR there by the command \"sear "
            + "install FOLDER\", with the"
            + " folder of its myrobotlab.jar, and run the script in its Python tab (docs/install.md)";
    }

    private static void refused(ServiceInterface answer, String why) {
        assertNull(answer);
        assertEquals(why, Runtime.getInstance().getLastError().key);
    }

    @Test
    public void typesHaveDescriptions() {
        assertEquals("reads from and writes to serial ports", Runtime.start("s", "Serial").getDescription());
        try {
            Runtime.start("t", TALKER).getDescription();
            fail("Talker has no meta data");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("TalkerMeta is missing"));
        }
    }

    @Test
    public void startsAndReleasesArePublished() throws InterruptedException {
        Talker listener = (Talker) Runtime.start("listener", TALKER);
        Runtime.getInstance().addListener("started", "listener");
        Runtime.getInstance().addListener("released", "listener");
        Runtime.start("s", "Serial");
        Runtime.release("s");
        Object first = listener.heard.take();
        while ("started runtime@embedded".equals(first) || "started listener@embedded".equals(first)) {
            first = listener.heard.take(); // sent before the listener was added
        }
        assertEquals("started s@embedded", first);
        assertEquals("released s@embedded", listener.heard.take());
    }

    @Test
    public void releasedServicesLeaveNoThread() throws InterruptedException {
        Set<Thread> before = new HashSet<>(Thread.getAllStackTraces().keySet());
        Runtime.start("python", "Python");
        Runtime.start("roomba", "Roomba");
        Talker talker = (Talker) Runtime.start("t", TALKER);
        talker.addTask(10, "tick");
        Runtime.releaseAll();
        Set<Thread> left = new HashSet<>(Thread.getAllStackTraces().keySet());
        left.removeAll(before);
        for (Thread thread : left) {
            thread.join(60_000); // the thread is ending
        }
        left.removeIf(thread -> !thread.isAlive());
        assertEquals(Set.of(), left);
        assertFalse(Runtime.exists());
        assertNull("asking for a service revives nothing", Runtime.getService("t"));
        assertFalse(Runtime.exists());
    }

    @Test
    public void shutdownReleasesAllAndThenEndsTheProgram() {
        AtomicBoolean ended = new AtomicBoolean();
        Shutdown.then(() -> ended.set(!Runtime.exists()));
        try {
            Runtime.start("s", "Serial");
            Runtime.shutdown();
            assertTrue(ended.get());
        } finally {
            Shutdown.then(() -> { });
        }
    }

    @Test
    public void servicesHaveServicesOfTheirOwn() {
        Roomba roomba = (Roomba) Runtime.start("roomba", "Roomba");
        assertEquals(roomba.getName() + ".serial", roomba.getPeerName("serial"));
        assertTrue(roomba.isPeerStarted("serial"));
        assertSame(Runtime.getService(roomba.getName() + ".serial"), roomba.getPeer("serial"));
        assertNull(roomba.startPeer("motor"));
        assertEquals("roomba has no peer \"motor\"; its peers are [serial]", roomba.getLastError().key);
    }

    @Test
    public void configurationsAreTakenOverAndWrittenAsYaml() throws ReflectiveOperationException {
        Python python = (Python) Runtime.create("p", "Python");
        assertEquals("Python", python.getConfig().type);
        python.setConfigValue("scriptRootDir", "robots");
        python.addListener("publishStdOut", "other", "input");
        String yaml = CodecUtils.toYaml(python.getFilteredConfig());
        PythonConfig read = (PythonConfig) CodecUtils.fromYaml(yaml, ServiceConfig.class);
        assertEquals("robots", read.scriptRootDir);
        assertEquals("publishStdOut --> other.input", read.listeners.get(0).toString());
        assertEquals("robots", python.apply(read).scriptRootDir);
        try {
            CodecUtils.fromYaml("!!javax.script.ScriptEngineManager []", ServiceConfig.class);
            fail("only configurations may be read");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage().startsWith("not a configuration ServiceConfig"));
        }
    }

    /** As in the real one, the script or the user of the service connects it. */
    @Test
    public void aSerialServiceKeepsItsPortInItsConfigurationAndDoesNotOpenItWhenItIsRestored() throws Exception {
        Serial serial = (Serial) Runtime.start("s", "Serial");
        Serial.connectVirtualUart("/dev/restored");
        serial.connect("/dev/restored");
        serial.disconnect();
        SerialConfig kept = (SerialConfig) serial.getFilteredConfig();
        assertEquals("/dev/restored", kept.port);
        Runtime.releaseService("s");
        serial = (Serial) Runtime.create("s", "Serial");
        serial.apply(kept);
        serial.startService();
        assertFalse(serial.isConnected());
    }

    @Test
    public void stateIsJsonOfFieldsThatAreNotTransient() {
        String json = CodecUtils.toJson(Runtime.start("s", "Serial"));
        assertTrue(json, json.contains("\"name\":\"s\"") && json.contains("\"rate\":115200")
            && json.contains("\"config\":{"));
        assertFalse(json, json.contains("blockingRX"));
        assertNotNull(CodecUtils.fromJson("[1, \"a\"]"));
    }
}
