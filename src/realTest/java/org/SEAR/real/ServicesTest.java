// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import org.junit.Test;

/** Services SEAR, LIDAR and GPS are released, started again and restored from a saved configuration. */
public class ServicesTest extends InRealMrl {
    private static final String WORLD = "sear.loadProject(" + RealMrl.literal(ROOT + "/examples/sensors.sear") + ")\n";
    /** Script that checks in lock-step whether scans and fixes arrive. */
    private static final String READ = String.join("\n",
        "def readings():",
        "    scans, sentences = lidar.getScanCount(), gps.getSentenceCount()",
        "    lidar.singleScan()",
        "    sear.simSleep(4)",
        "    return lidar.getScanCount() > scans, len(lidar.getLastScan().raw), gps.getSentenceCount() > sentences",
        "def services():",
        "    global sear, lidar, gps",
        "    sear = Runtime.start('sear', 'SEAR')",
        "    lidar = Runtime.start('lidar', 'LIDAR')",
        "    gps = Runtime.start('gps', 'GPS')",
        "def connect():",
        "    lidar.connect('/dev/SEAR_LIDAR_01')",
        "    gps.connect('/dev/SEAR_GPS_01')", "");

    private void start() throws IOException, InterruptedException {
        assertEquals("", mrl.python(READ, "services()", "sear.setLockStep(True)", WORLD, "sear.startSimulation()",
            "sear.simSleep(1)", "connect()"));
        assertRead();
    }

    private void assertRead() throws IOException, InterruptedException {
        assertEquals("(True, 361, True)\n", mrl.python("print readings()"));
    }

    /** Waits until Python has removed the variable of the released service, which happens a moment later. */
    private void release(String... names) throws IOException, InterruptedException {
        for (String name : names) {
            assertEquals("", mrl.python("Runtime.release('" + name + "')"));
            mrl.await("Python to forget " + name, () -> mrl.python("print globals().get('" + name + "')")
                .equals("None\n"));
        }
    }

    @Test
    public void driversAreReleasedWhileASimulationRunsAndStartAgain() throws Exception {
        start();
        for (List<String> names : List.of(List.of("lidar"), List.of("gps"), List.of("gps", "lidar"))) {
            release(names.toArray(new String[0]));
            assertEquals("", mrl.python("sear.simSleep(1)", "services()", "connect()"));
            assertRead();
        }
    }

    @Test
    public void searIsReleasedWhileItsSimulationRunsAndStartsAgain() throws Exception {
        start();
        for (int turn = 0; turn < 2; turn++) {
            release("sear");
            assertEquals("[]\n", mrl.python(
                "print [name for name in Runtime.getServiceNames() if 'simulator' in name]"));
            assertEquals("", mrl.python("services()", "sear.setLockStep(True)", "sear.startSimulation()",
                "sear.simSleep(1)", "connect()"));
            assertRead();
        }
    }

    @Test
    public void allAreReleasedAndStartAgain() throws Exception {
        start();
        assertEquals("", mrl.python("sear.stopSimulation()"));
        release("sear", "gps", "lidar");
        assertEquals("", mrl.python("services()", "sear.setLockStep(True)", "sear.startSimulation()",
            "sear.simSleep(1)", "connect()"));
        assertRead();
    }

    /** MyRobotLab itself accepts it, and the service would fail at the next access. */
    @Test
    public void aConfigurationOfAnotherServiceIsRefused() throws Exception {
        assertEquals("", mrl.python(READ, "services()"));
        for (String name : new String[] {"sear", "lidar", "gps"}) {
            String type = name.toUpperCase(Locale.ROOT);
            assertEquals("the configuration of " + name + " is a PythonConfig, legal: " + type + "Config\n" + type
                + "Config\n", mrl.python("from java.lang import IllegalArgumentException",
                "from org.myrobotlab.service.config import PythonConfig",
                "try: " + name + ".apply(PythonConfig())",
                "except IllegalArgumentException, e: print e.getMessage()",
                "print " + name + ".getConfig().getClass().getSimpleName()"));
        }
    }

    /** Restores the LIDAR's unit, the ports and the project. The drivers connect as soon as their ports appear. */
    @Test
    public void aSavedConfigurationBringsEverythingBackAfterARestart() throws Exception {
        start();
        assertEquals("", mrl.python("lidar.setToCM()", "sear.simSleep(2)"));
        String unit = mrl.python("print lidar.getUnit()");
        List<String> names = mrl.services();
        names.removeIf(name -> name.contains("simulator"));
        assertEquals("", mrl.python("Runtime.saveConfig('kept')", "sear.stopSimulation()"));
        mrl.close();
        mrl = new RealMrl(mrl.folder(), "kept");
        RealMrl.share(mrl);
        List<String> back = mrl.services();
        back.removeIf(name -> name.contains("simulator"));
        assertEquals(names, back);
        assertEquals("", mrl.python(READ, "services()", "sear.setLockStep(True)", "sear.startSimulation()",
            "sear.simSleep(3)"));
        assertEquals("True True\n" + unit,
            mrl.python("print lidar.isConnected(), gps.isConnected()", "print lidar.getUnit()"));
        assertRead();
        mrl.close();    // the other tests' MyRobotLab has none of the services of this configuration
        mrl = new RealMrl(mrl.folder(), "tests");
        RealMrl.share(mrl);
    }
}
