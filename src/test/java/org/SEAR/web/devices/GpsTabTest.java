// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import org.SEAR.web.Accessibility;
import org.SEAR.web.Browser;
import org.SEAR.web.MyRobotLab;
import org.SEAR.web.Tabs;
import org.junit.Before;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;

/** The GPS tab: table and track show the data that the service received, controls show the receiver's settings. */
public class GpsTabTest {
    @ClassRule
    public static final Tabs TABS = new Tabs(DeviceWorld.SCRIPT);
    private static final String PANEL = ".sear-gps";
    /** Tolerance in metres: a sentence has millionths of minutes, a track two digits. */
    private static final double CLOSE = 0.02;
    /** Radius of a curve that counts as straight, metres. */
    private static final double STRAIGHT = 1e6;
    /** Units of the plot from its middle to its edge. */
    private static final double EDGE = 45;

    @Rule
    public final TestRule page = TABS.page("gps");
    private final Browser browser = TABS.browser();
    private final MyRobotLab robotLab = TABS.robotLab();

    @Before
    public void switchDevicesOn() {
        DeviceWorld.restart(robotLab);
    }

    private void connect(String port, String baud) {
        browser.until("a panel that is not connected", () -> browser.text(".gps-status").equals("not connected"));
        browser.type(".gps-port", port);
        browser.choose(".gps-baud", baud);
        browser.click(".gps-connect");
    }

    private void connect() {
        connect(DeviceWorld.GPS_PORT, "38400");
        seeFix();
    }

    /** Waits for a new fix. */
    private void seeFix() {
        String before = browser.text(".gps-time");
        browser.until("a new fix", () -> browser.text(".gps-fix").equals("GPS") && !browser.text(".gps-time")
            .equals(before));
    }

    /** Pauses the simulation and waits until the panel shows the last fix. */
    private JsonNode lastFix() {
        robotLab.call("sear", "pause");
        return browser.value("the service's last fix in the panel", () -> {
            JsonNode fix = robotLab.call("gps", "getLastFix");
            String utc = fix.get("utc").asText();
            String shown = utc.substring(0, 2) + ":" + utc.substring(2, 4) + ":" + utc.substring(4) + " UTC";
            return browser.text(".gps-time").equals(shown) ? fix : null;
        });
    }

    private static String token(JsonNode fix, int index) {
        return fix.get("tokens").get(index).asText();
    }

    @Test
    public void allValuesAreThoseOfTheService() {
        connect();
        JsonNode fix = lastFix();
        assertEquals("$GPGGA", browser.text(".gps-type"));
        assertEquals(token(fix, 0), browser.text(".gps-type"));
        assertEquals(token(fix, 2), browser.text(".gps-latitude"));
        assertEquals(token(fix, 4), browser.text(".gps-longitude"));
        browser.seeText(".gps-table td", token(fix, 2) + " ddmm.mmmm");
        assertTrue("negative in the west: " + token(fix, 4), token(fix, 4).startsWith("-080"));
        assertEquals(token(fix, 9), browser.text(".gps-altitude"));
        assertEquals("GPS", browser.text(".gps-fix"));
        assertEquals(fix.get("satellites").asText(), browser.text(".gps-satellites"));
        String[] decimal = browser.text(".gps-decimal").split(", ");
        assertEquals(fix.get("latitude").asDouble(), Double.parseDouble(decimal[0]), 1e-7);
        assertEquals(fix.get("longitude").asDouble(), Double.parseDouble(decimal[1]), 1e-7);
        assertEquals(33.61, Double.parseDouble(decimal[0]), 1e-6);
        assertEquals(-80.865, Double.parseDouble(decimal[1]), 1e-6);
        int sentences = robotLab.call("gps", "getSentenceCount").asInt();
        browser.until("the number of sentences", () -> browser.text(".gps-count").equals(String.valueOf(sentences)));
    }

    @Test
    public void theModelIsThatOfTheReceiver() {
        browser.until("the panel", () -> browser.text(".gps-status").equals("not connected"));
        browser.choose(".gps-model", "NEO-M8N");
        browser.until("its speed", () -> browser.number(PANEL, "port.baud") == 9600);
        assertTrue("its fastest", browser.see(".gps-baud").getText().contains("921600"));
        browser.choose(".gps-model", "FV-M8");
        browser.until("its speed", () -> browser.number(PANEL, "port.baud") == 38400);
        connect();
        browser.seeText(".gps-firmware", "MTK3301");
        browser.until("the model", () -> "MT3301".equals(browser.scope(PANEL, "form.model")));
        assertFalse(browser.see(".gps-model").isEnabled());
    }

    @Test
    public void theTrackIsInMetres() {
        connect();
        JsonNode start = robotLab.call("sear", "getPose", "receiver");
        robotLab.call("sear", "drive", 0.3, 1.0);
        browser.until("a track of half a metre",
            () -> browser.number(PANEL, "track.length ? track[track.length - 1][0] : 0") > 0.5);
        robotLab.call("sear", "drive", 0, STRAIGHT);
        seeFix();
        seeFix();
        JsonNode end = robotLab.call("sear", "getPose", "receiver");
        lastFix();
        double north = end.get(0).asDouble() - start.get(0).asDouble();
        double east = end.get(2).asDouble() - start.get(2).asDouble();
        assertEquals("metres to the east", east, browser.number(PANEL, "track[track.length - 1][0]"), CLOSE);
        assertEquals("metres to the north", north, browser.number(PANEL, "track[track.length - 1][1]"), CLOSE);
        assertTrue("a left turn from east leads north: " + north, north > 0.1);
        assertEquals(String.format("%.2f m east, %.2f m north", browser.number(PANEL, "track[track.length - 1][0]"),
            browser.number(PANEL, "track[track.length - 1][1]")), browser.text(".gps-offset"));
        double reach = browser.number(PANEL, "plot.reach");
        browser.seeText(".gps-scale", (int) reach + " m to the edge");
        assertEquals(east / reach * EDGE, Double.parseDouble(browser.see(".gps-here").getAttribute("cx")),
            CLOSE * EDGE);
        assertEquals(-north / reach * EDGE, Double.parseDouble(browser.see(".gps-here").getAttribute("cy")),
            CLOSE * EDGE);
        String[] points = browser.all(".gps-track").get(0).getAttribute("points").trim().split(" ");
        assertEquals(browser.number(PANEL, "track.length"), points.length, 0);
        assertEquals("0.00,0.00", points[0].replace("-", ""));
        browser.click(".gps-clear-track");
        browser.until("no track", () -> browser.number(PANEL, "track.length") == 0);
    }

    @Test
    public void theRawSentencesAreShown() {
        connect();
        browser.click(".gps-raw");
        browser.seeText(".gps-sentences", "$GPGGA");
        browser.seeText(".gps-sentences", "$GPRMC");
        browser.seeText(".gps-sentences", "$GPVTG");
        JsonNode fix = lastFix();
        String sentence = String.join(
            ",", List.of(token(fix, 0), token(fix, 1), token(fix, 2), "N", token(fix, 4).substring(1), "W"));
        browser.seeText(".gps-sentences", sentence);
        browser.click(".gps-raw");
        browser.until("no sentences", () -> browser.all(".gps-sentences").isEmpty());
    }

    @Test
    public void theBaudRateChangesAtBothEnds() {
        connect();
        browser.choose(".gps-baud", "9600");
        browser.until("the new rate", () -> robotLab.call("gps", "getConfig").get("baud").asInt() == 9600);
        seeFix();
        seeFix();
        browser.click(".gps-disconnect");
        connect(DeviceWorld.GPS_PORT, "9600");
        seeFix();
    }

    @Test
    public void aWrongBaudRateIsShownAndCanBeCorrected() {
        connect(DeviceWorld.GPS_PORT, "4800");
        browser.seeText(".gps-message", "is it switched on, and is this its baud rate?");
        browser.seeText(".gps-status", "connected, no data");
        browser.choose(".gps-baud", "38400");
        seeFix();
        browser.until("data", () -> browser.text(".gps-status").equals("connected"));
    }

    @Test
    public void errorsOfThePortAreShown() {
        connect("/dev/nothing_here", "38400");
        browser.seeText(".gps-message", "can't be opened: Port not found; available ports: [");
        assertEquals("what was typed stays", "/dev/nothing_here", browser.see(".gps-port").getAttribute("value"));
        browser.click(".gps-port");
        browser.until("the list of ports", () -> browser.all(PANEL + " datalist option").stream()
            .anyMatch(option -> DeviceWorld.GPS_PORT.equals(option.getAttribute("value"))));
        robotLab.call("lidar", "connect", DeviceWorld.LIDAR_PORT, 38400);
        connect(DeviceWorld.LIDAR_PORT, "38400");
        browser.seeText(".gps-message", "is in use by [lidar");
        connect();
        assertEquals(DeviceWorld.GPS_PORT, robotLab.call("gps", "getConfig").get("port").asText());
    }

    @Test
    public void disconnectsAndConnectsAgain() {
        connect();
        browser.click(".gps-disconnect");
        browser.until("the disconnected panel", () -> browser.text(".gps-status").equals("not connected"));
        assertFalse(robotLab.call("gps", "isConnected").asBoolean());
        browser.click(".gps-connect");
        seeFix();
        robotLab.call("sear", "stopSimulation");
        browser.seeText(".gps-message", "was closed");
        browser.until("the disconnected panel", () -> browser.text(".gps-status").equals("not connected"));
        robotLab.call("sear", "startSimulation");
        seeFix();    // it connects by itself when its port returns
    }

    @Test
    public void aServiceThatIsReleasedComesBackWithItsTab() {
        connect();
        robotLab.call("runtime", "release", "gps");
        browser.until("no tab", () -> browser.all(PANEL).isEmpty());
        robotLab.call("runtime", "start", "gps", "GPS");
        browser.click("#tab-gps");
        assertEquals("–", browser.text(".gps-type"));
        connect();
    }

    @Test
    public void everybodyCanReadAndUseIt() {
        connect();
        browser.click(".gps-raw");
        browser.see(".gps-sentences");
        for (String level : new String[] {"error", "warn", "info"}) {
            robotLab.call("gps", level, "a message of level " + level);
            browser.seeText(".gps-message", "a message of level " + level);
        }
        Accessibility.check(browser, PANEL);
        browser.click(".gps-clear");
        browser.until("no message", () -> browser.all(".gps-message").isEmpty());
    }
}
