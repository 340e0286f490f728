// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.lms;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.Golden;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.devices.FakeContext;
import org.SEAR.devices.FakeScanner;
import org.SEAR.devices.SerialDevice;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** LMS221 and LMS291: the telegrams of the LMS200 with their own identity and configuration. */
public class OutdoorScannersTest {
    private static final Golden LMS = Golden.of("lms200");
    private static final String TYPE = LMS.get("ask for the type");
    private static final String CONFIGURATION = LMS.get("ask for the configuration");
    private static final String ALL_VALUES = LMS.get("ask for a scan");
    private static final int DISTANCES_AT = 8;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private FakeContext line;

    private SerialDevice power(String model) {
        System.setProperty("sear.project", folder.getRoot().toPath().resolve("SEARproject").toString());
        LIDAR lidar = new LIDAR("scanner");
        lidar.setModel(model);
        System.clearProperty("sear.project");
        FakeScanner scanner = new FakeScanner();
        scanner.world = beam -> beam < 100 ? 79.994 : 81.95;
        line = new FakeContext();
        line.sensor = scanner;
        return line.attach(new Lms200Type().create(lidar, line));
    }

    private String ask(String hex) {
        line.pass(0.1);
        line.take();
        line.host(hex);
        line.pass(2);
        return line.takeHex();
    }

    @Test
    public void theyReportTheirIdentity() {
        assertTrue(power("LMS221").status().startsWith("LMS221: 180 degrees every 1.0, cm"));
        assertEquals("06 " + LMS.get("type of an LMS221"), ask(TYPE));
        power("LMS291");
        assertEquals("06 " + LMS.get("type of an LMS291"), ask(TYPE));
        power("LMS200");
        assertEquals("06 " + LMS.get("type of an LMS200 with V02.10"), ask(TYPE));
    }

    @Test
    public void theyAreDeliveredInCentimetres() {
        power("LMS291");
        assertEquals("06 02 80 24 00 F4 00 00 70 00 00 00 00 00 00 02 02" + " 00".repeat(21) + " 02 00 10 9C 9B",
            ask(CONFIGURATION));
        String[] scan = ask(ALL_VALUES).split(" ");
        assertEquals("181 values, centimetres", "B5 00", scan[6] + " " + scan[7]);
        assertEquals("79.99 m", "3F 1F", scan[DISTANCES_AT] + " " + scan[DISTANCES_AT + 1]);
        assertEquals("beyond what it can tell", "F7 1F", scan[DISTANCES_AT + 200] + " " + scan[DISTANCES_AT + 201]);
    }
}
