// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lidar;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Paths;
import org.junit.Test;

/** The table of LIDARs. */
public class LidarModelTest {
    @Test
    public void eachRowIsLegalForItself() {
        for (LidarModel model : LidarModel.values()) {
            String name = model.getName();
            assertTrue(name, model.hasFan(model.getSpread(), model.getResolution()));
            assertTrue(name, model.hasFan(model.getWidestSpread(), model.getFinestResolution()));
            assertTrue(name, model.hasBaud(model.getBaud()));
            assertTrue(name, model.getNearest() < model.getRange() && model.getRange() <= model.getFarthest());
            assertEquals(model, LidarModel.of(name.toLowerCase().replace("-", " ")));
            assertFalse(name, model.getMaker().isEmpty());
            assertTrue(name, model.getScanRate() > 0);
        }
    }

    @Test
    public void fansOfEachKind() {
        assertTrue(LidarModel.LMS291.hasFan(100, 0.25));
        assertFalse(LidarModel.LMS291.hasFan(180, 0.25));
        assertFalse(LidarModel.LMS291.hasFan(90, 1));
        assertTrue(LidarModel.TIM561.hasFan(90, 0.333));
        assertFalse(LidarModel.TIM561.hasFan(90, 0.5));
        assertTrue(LidarModel.UTM_30LX.hasFan(25, 24.75));
        assertFalse(LidarModel.UTM_30LX.hasFan(270, 25));
        assertFalse(LidarModel.UTM_30LX.hasFan(270.25, 0.25));
        assertTrue(LidarModel.RPLIDAR_A1.hasFan(360, 0.7));
        assertFalse(LidarModel.RPLIDAR_A1.hasFan(360, 2));
        assertEquals("100 with 1, 0.5 or 0.25; 180 with 1 or 0.5", LidarModel.LMS200.fans());
        assertEquals("up to 239.765625 with 1 to 99 times 0.3515625", LidarModel.URG_04LX.fans());
        assertEquals("up to 360 with 0.18 to 1.8", LidarModel.RPLIDAR_A1.fans());
        assertEquals("LMS200, LMS221, LMS291, UTM-30LX, RPLIDAR-A1, CoLa", LidarModel.namesWith(180, 1));
        assertEquals("CoLa", LidarModel.namesWith(359, 0.1));
        assertEquals("CoLa", LidarModel.namesWith(45, 6.1));
    }

    @Test
    public void thePageHasEachRow() throws IOException {
        String page = Files.readString(Paths.get(System.getProperty("sear.root", "."), "docs/sensors.md"));
        for (LidarModel model : LidarModel.values()) {
            String speeds = model.bauds().replace("12000000", "USB, 12 Mbit/s")
                .replace("100000000", "its network's, 100 Mbit/s");
            String row = "| " + model.getName() + " | " + model.getMaker() + " | "
                + Fans.format(model.getRange()) + ", "
                + Fans.format(model.getFarthest()) + " m | " + Fans.format(model.getNearest()) + " m | "
                + Fans.format(model.getSpread()) + ", "
                + Fans.format(model.getResolution()) + " | " + model.fans() + " | " + Fans.format(model.getScanRate())
                + " | " + speeds + (speeds.endsWith("s") ? " |" : " baud |");
            assertTrue(row, page.contains(row));
        }
    }

    @Test
    public void anUnknownNameIsRejectedWithTheKnownOnes() {
        String message = "";
        try {
            LidarModel.of("LMS400");
        } catch (IllegalArgumentException e) {
            message = e.getMessage();
        }
        assertEquals("LIDAR model is \"LMS400\", legal: " + LidarModel.names(), message);
    }
}
