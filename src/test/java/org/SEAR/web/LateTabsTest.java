// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.web.devices.DeviceWorld;
import org.junit.Before;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;

/** LIDAR and GPS tabs that are opened or reloaded after the device sent data. */
public class LateTabsTest {
    @ClassRule
    public static final Tabs TABS = new Tabs(DeviceWorld.SCRIPT);
    @Rule
    public final TestRule page = TABS.page("sear");
    private final Browser browser = TABS.browser();
    private final MyRobotLab robotLab = TABS.robotLab();

    @Before
    public void switchDevicesOn() {
        DeviceWorld.restart(robotLab);
    }

    @Test
    public void theLidarTabShowsTheLastScanAndThatItIsConnected() {
        robotLab.call("lidar", "connect", DeviceWorld.LIDAR_PORT, 38400);
        robotLab.call("lidar", "singleScan");
        browser.until("a scan", () -> robotLab.call("lidar", "getScanCount").asInt() > 0);
        TABS.open("lidar");
        browser.seeText(".lidar-summary", "181 values in mm");
        browser.until("the state", () -> browser.text(".lidar-status").equals("connected"));
        assertEquals(DeviceWorld.AHEAD, browser.number(".sear-lidar", "scan.metres[90]"), 0.02);
        robotLab.call("lidar", "error", "could not invoke lidar.x ([Ljava.lang.Object;@1) - check logs");
        robotLab.call("lidar", "error", "the cable is loose");
        robotLab.call("lidar", "error", "could not invoke lidar.connect ([Ljava.lang.Object;@2) - check logs");
        robotLab.call("lidar", "info", "the end");
        browser.until("the last message as a line", () -> browser.text(".sear-lidar .sear-last").equals("the end"));
        assertEquals("what has no message of its own, the message, the end", 3, browser.all(".lidar-message").size());
    }

    @Test
    public void theGpsTabShowsTheLastFixAndThatItIsConnected() {
        robotLab.call("gps", "connect", DeviceWorld.GPS_PORT, 38400);
        browser.until("a fix", () -> robotLab.call("gps", "hasFix").asBoolean());
        robotLab.call("sear", "pause");
        String latitude = robotLab.call("gps", "getLastFix").get("tokens").get(2).asText();
        TABS.open("gps");
        browser.until("the fix", () -> browser.text(".gps-latitude").equals(latitude));
        browser.until("the state", () -> browser.text(".gps-status").startsWith("connected"));
        assertTrue(browser.text(".gps-decimal"), browser.text(".gps-decimal").startsWith("33.61"));
        assertEquals("0.00 m east, 0.00 m north", browser.text(".gps-offset"));
        robotLab.call("gps", "error", "the cable is loose");
        robotLab.call("gps", "error", "could not invoke gps.connect ([Ljava.lang.Object;@2) - check logs");
        robotLab.call("gps", "info", "the end");
        browser.until("the last message as a line", () -> browser.text(".sear-gps .sear-last").equals("the end"));
        assertEquals(1, browser.texts(".gps-message").stream().filter(text -> text.contains("Error:")).count());
    }
}
