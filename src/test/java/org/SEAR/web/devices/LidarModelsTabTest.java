// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.web.Browser;
import org.SEAR.web.MyRobotLab;
import org.SEAR.web.Tabs;
import org.junit.Before;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.WebElement;

/**
 * The LIDAR tab with models other than an LMS: their rates and modes are selectable, and the plot shows a full circle.
 */
public class LidarModelsTabTest {
    private static final String RPLIDAR = "/dev/SEAR_LIDAR_02";
    private static final String HOKUYO = "/dev/SEAR_LIDAR_03";
    private static final String PANEL = ".sear-lidar";

    @ClassRule
    public static final Tabs TABS = new Tabs(String.join("\n", DeviceWorld.SCRIPT,
        // after a LIDAR service starts, Python has the service under the name LIDAR
        "from org.SEAR.POJOs import LIDAR as Scanner", "Box('behind', 20, 0.2, 1, 0).move(0, 0.5, -2)",
        "for (number, model) in ((2, 'RPLIDAR-A1'), (3, 'URG-04LX')):",
        "    another = Scanner('another%d' % number)",
        "    another.setModel(model)",
        "    another.move(0, 0.15, 0.1)",
        "    another.setPorts('/dev/my_Lidar%02d' % number, '/dev/SEAR_LIDAR_%02d' % number)",
        "    robot.addComponent(another)"));

    @Rule
    public final TestRule page = TABS.page("lidar");
    private final Browser browser = TABS.browser();
    private final MyRobotLab robotLab = TABS.robotLab();

    @Before
    public void switchDevicesOn() {
        DeviceWorld.restart(robotLab);
        robotLab.call("lidar", "setModel", "LMS200");
    }

    private void connect(String model, String port) {
        browser.until("a panel that is not connected", () -> browser.text(".lidar-status").equals("not connected"));
        browser.choose(".lidar-model", model);
        browser.until("the model", () -> robotLab.call("lidar", "getConfig").get("model").asText().equals(model));
        browser.type(".lidar-port", port);
        browser.click(".lidar-connect");
        browser.until("a connected panel", () -> browser.text(".lidar-status").startsWith("connected"));
        assertFalse("not while connected", browser.see(".lidar-model").isEnabled());
        assertFalse("millimetres only", browser.see(".lidar-cm").isEnabled());
    }

    private JsonNode scan() {
        browser.scope(PANEL, "form.seen = scan");
        browser.click(".lidar-single");
        browser.until("a new scan", () -> Boolean.TRUE.equals(browser.scope(PANEL, "scan !== form.seen")));
        return robotLab.call("lidar", "getLastScan");
    }

    private List<String> options(String select) {
        return browser.all(select + " option").stream().map(WebElement::getText).collect(Collectors.toList());
    }

    @Test
    public void aWholeCircleIsDrawnAllRound() {
        connect("RPLIDAR-A1", RPLIDAR);
        assertEquals("[115200]", options(".lidar-baud").toString());
        assertTrue(options(".lidar-mode").toString(), options(".lidar-mode")
            .containsAll(List.of("360° / 1°", "360° / 0.5°", "180° / 1°")));
        JsonNode scan = scan();
        browser.seeText(".lidar-summary", "360 values in mm, 359° in steps of 1°");
        assertEquals(Boolean.TRUE, browser.scope(PANEL, "geometry().full"));
        assertEquals("behind", -90, scan.get("angles").get(0).asDouble(), 1e-9);
        double ahead = scan.get("metres").get(180).asDouble();
        double behind = scan.get("metres").get(0).asDouble();
        assertEquals(DeviceWorld.AHEAD, ahead, 0.01);
        assertEquals(2, behind, 0.01);
        double middle = browser.number(PANEL, "geometry().y");
        assertTrue("ahead is up", browser.number(PANEL, "point(geometry(), " + ahead + ", 90).y") < middle - 20);
        assertTrue("behind is down", browser.number(PANEL, "point(geometry(), " + behind + ", -90).y") > middle + 20);
        browser.choose(".lidar-mode", "360° / 0.5°");
        browser.until("the mode", () -> robotLab.call("lidar", "getResolution").asDouble() == 0.5);
        scan();
        browser.seeText(".lidar-summary", "720 values in mm");
        browser.choose(".lidar-mode", "180° / 1°");
        browser.until("the mode", () -> robotLab.call("lidar", "getSpread").asDouble() == 180);
        scan();
        browser.seeText(".lidar-summary", "181 values in mm, 180° in steps of 1°");
        assertEquals(Boolean.FALSE, browser.scope(PANEL, "geometry().full"));
    }

    @Test
    public void aHokuyoStreamsInItsModes() {
        connect("URG-04LX", HOKUYO);
        assertEquals("[19200, 38400, 57600, 115200, 250000, 500000, 750000]", options(".lidar-baud").toString());
        browser.until("its mode", () -> "240° / 0.35°".equals(browser.scope(PANEL, "form.mode.label")));
        browser.choose(".lidar-baud", "115200");
        browser.until("the new rate", () -> robotLab.call("lidar", "getConfig").get("baud").asInt() == 115200);
        browser.click(".lidar-stream");
        browser.seeText(".lidar-status", "connected, streaming");
        browser.seeText(".lidar-rate", "scans/s");
        browser.seeText(".lidar-summary", "682 values in mm, 239.414° in steps of 0.352°");
        browser.choose(".lidar-mode", "180° / 1.05°");
        browser.seeText(".lidar-summary", "171 values in mm");
        browser.until("the mode that the device has", () -> "180° / 1.05°"
            .equals(browser.scope(PANEL, "form.mode.label")));
        browser.click(".lidar-stop");
        browser.until("the end of the stream", () -> browser.text(".lidar-status").equals("connected"));
    }
}
