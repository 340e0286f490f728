// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;

/** Power switches of devices, and exports of their ports, through the SEAR service on a small world in lock-step. */
public class SearDevicesTest {
    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private Path folder;
    private SEAR sear;
    private Heard heard;

    @Before
    public void start() {
        folder = TestWorld.build(temporary.getRoot().toPath());
        sear = (SEAR) Runtime.start("testSear", "SEAR");
        heard = (Heard) Runtime.start("searStatus", "Heard");
        sear.addListener("publishStatus", "searStatus", "onStatus");
    }

    private static void assertFails(String message, Runnable call) {
        try {
            call.run();
            fail("no error: " + message);
        } catch (IllegalStateException | IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().contains(message));
        }
    }

    @Test
    public void thePowerOfADeviceIsSwitchedByItsName() throws Exception {
        sear.startSimulation();
        sear.simSleep(1);
        sear.power("scanner", false);
        assertEquals("[false]", powers("scanner"));
        sear.simSleep(1);
        assertEquals("[true]", powers("receiver"));
        sear.power("roomba/scanner", true);
        assertEquals("[true]", powers("scanner"));
        sear.pause();
        sear.power("scanner", false);
        assertEquals("while time stands still, too", "[false]", powers("scanner"));
        sear.reset();
        assertEquals("[true]", powers("scanner"));
        assertFails("no device is called \"nose\", legal: ", () -> sear.power("nose", false));
        sear.resume();
        sear.stopSimulation();
        assertFails("no simulation runs", () -> sear.power("scanner", false));
    }

    /** Returns the power state that panels get. */
    private String powers(String device) {
        List<Object> found = new ArrayList<>();
        for (Object robot : (List<?>) sear.getWorld().get("robots")) {
            for (Object one : (List<?>) ((Map<?, ?>) robot).get("devices")) {
                if (device.equals(((Map<?, ?>) one).get("name"))) {
                    found.add(((Map<?, ?>) one).get("on"));
                }
            }
        }
        return found.toString();
    }

    /** A driver may start first: the export exists before the simulation and stays after it. */
    @Test
    public void exportsOutliveSimulations() throws Exception {
        int number = sear.exportTcp(TestWorld.ROOMBA_PORT, 0);
        try (Socket driver = new Socket(InetAddress.getLoopbackAddress(), number)) {
            for (int round = 0; round < 3; round++) {
                sear.startSimulation();
                assertEquals("mode passive", 1, modeOf(driver));
                assertEquals(number, sear.exportTcp(TestWorld.ROOMBA_PORT, 0));
                sear.stopSimulation();
            }
            assertEquals("[tcp port " + number + "]", sear.getExports().get(TestWorld.ROOMBA_PORT).toString());
            sear.endExport(TestWorld.ROOMBA_PORT);
            assertTrue(sear.getExports().isEmpty());
            assertEquals("the driver is told", -1, driver.getInputStream().read());
        }
        assertFails("port \"/dev/nose\" is not exported, legal: none", () -> sear.endExport("/dev/nose"));
        sear.startSimulation();
        assertFails("there is no virtual port \"/dev/nose\"; virtual ports: ", () -> sear.exportTcp("/dev/nose", 0));
    }

    /** Returns a Roomba's answer to 128, 142 35; the simulation advances in lock-step meanwhile. */
    private int modeOf(Socket driver) throws IOException {
        driver.getOutputStream().write(new byte[] {(byte) 0x80, (byte) 0x8E, 0x23});
        while (driver.getInputStream().available() == 0) {
            sear.step(1);
        }
        return driver.getInputStream().read();
    }

    @Test
    public void anExportOfTheProjectStartsAndEndsWithTheProject() throws Exception {
        Path ports = temporary.getRoot().toPath().resolve("SEARports");
        robotOf(folder, "<export>ttyRobot</export>");
        assertFalse(Files.exists(ports));
        sear.startSimulation();
        assertTrue(heard.awaitStatus("port " + TestWorld.ROOMBA_PORT + " is exported as " + ports.resolve("ttyRobot")));
        sear.stopSimulation();
        assertTrue("it stays", Files.isSymbolicLink(ports.resolve("ttyRobot")));
        Path precious = Files.writeString(ports.resolve("ttyOther"), "precious");
        robotOf(folder, "<export>ttyOther</export>");
        sear.startSimulation();
        assertFalse(Files.exists(ports.resolve("ttyRobot"), LinkOption.NOFOLLOW_LINKS));
        assertTrue(heard.awaitStatus("the export of port " + TestWorld.ROOMBA_PORT + " does not work: " + precious));
        assertEquals("precious", Files.readString(precious));
        assertTrue(sear.getExports().toString(), sear.getExports().values().stream().allMatch(List::isEmpty));
        sear.stopSimulation();
        robotOf(folder, "<export>../.bashrc</export>");
        assertFails("export is \"../.bashrc\", legal: the name of a link", () -> sear.startSimulation());
    }

    private static void robotOf(Path project, String export) throws IOException {
        Path file = project.resolve("robot/drive.xml");
        String xml = Files.readString(file).replaceAll("\\s*<export>.*</export>", "");
        Files.writeString(file, xml.replace("</userPort>", "</userPort>\n  " + export));
    }
}
