// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.stream.IntStream;
import org.SEAR.web.Accessibility;
import org.SEAR.web.Browser;
import org.SEAR.web.MyRobotLab;
import org.SEAR.web.Tabs;
import org.junit.Before;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** The LIDAR tab: plot, table and file show the data that the service received, controls show the device's settings. */
public class LidarTabTest {
    @ClassRule
    public static final Tabs TABS = new Tabs(DeviceWorld.SCRIPT);
    private static final String PANEL = ".sear-lidar";
    private static final double PIXEL = 1e-6;
    /** Tolerance of a colour where half-transparent edges of dots overlap. */
    private static final int ROUNDING = 8;

    @Rule
    public final TestRule page = TABS.page("lidar");
    private final Browser browser = TABS.browser();
    private final MyRobotLab robotLab = TABS.robotLab();

    @Before
    public void switchDevicesOn() {
        DeviceWorld.restart(robotLab);
    }

    private void connect(String port, String baud) {
        browser.until("a panel that is not connected", () -> browser.text(".lidar-status").equals("not connected"));
        browser.type(".lidar-port", port);
        browser.choose(".lidar-baud", baud);
        browser.click(".lidar-connect");
    }

    private void connect() {
        connect(DeviceWorld.LIDAR_PORT, "38400");
        browser.until("a connected panel", () -> browser.text(".lidar-status").startsWith("connected"));
        seeMode("180° / 1°");
    }

    private void seeMode(String mode) {
        browser.until("scan mode " + mode, () -> mode.equals(browser.scope(PANEL, "form.mode.label")));
    }

    /**
     * Requests a scan and waits until it is shown. The previous one may have the same time, because a restarted
     * simulation begins with 0.
     */
    private JsonNode scan() {
        browser.scope(PANEL, "form.seen = scan");
        browser.click(".lidar-single");
        browser.until("a new scan", () -> Boolean.TRUE.equals(browser.scope(PANEL, "scan !== form.seen")));
        return robotLab.call("lidar", "getLastScan");
    }

    /** Returns the time of the shown scan, seconds; -1 before the first. */
    private double time() {
        return ((Number) browser.scope(PANEL, "scan === null ? -1 : scan.time")).doubleValue();
    }

    private static int beam(JsonNode scan, double degrees) {
        for (int i = 0; i < scan.get("angles").size(); i++) {
            if (scan.get("angles").get(i).asDouble() == degrees) {
                return i;
            }
        }
        throw new AssertionError("no beam at " + degrees + " degrees in " + scan.get("angles"));
    }

    private static double metres(JsonNode scan, double degrees) {
        JsonNode metres = scan.get("metres").get(beam(scan, degrees));
        return metres.isNull() ? Double.POSITIVE_INFINITY : metres.asDouble();
    }

    /** Returns whether the plot has a beam's dot at a distance and angle. */
    private boolean isDotAt(double metres, double degrees) {
        String point = "point(geometry(), " + metres + ", " + degrees + ")";
        List<?> colour = (List<?>) browser.script(String.join("\n",
            "var ratio = window.devicePixelRatio || 1, pen = document.querySelector('.lidar-plot').getContext('2d')",
            "return [].slice.call(pen.getImageData(Math.round(arguments[0] * ratio), Math.round(arguments[1] * "
                + "ratio), 1, 1).data)"),
            browser.number(PANEL, point + ".x"), browser.number(PANEL, point + ".y"));
        int[] red = {217, 83, 79, 255};
        return IntStream.range(0, red.length)
            .allMatch(i -> Math.abs(((Number) colour.get(i)).intValue() - red[i]) <= ROUNDING);
    }

    @Test
    public void thePlotShowsTheValuesOfTheScan() {
        connect();
        JsonNode scan = scan();
        browser.seeText(".lidar-summary", "181 values in mm, 180° in steps of 1°");
        assertEquals(DeviceWorld.AHEAD, metres(scan, 90), 0.01);
        assertEquals(DeviceWorld.AHEAD / Math.cos(Math.toRadians(30)), metres(scan, 60), 0.01);
        assertEquals(DeviceWorld.LEFT, metres(scan, 180), 0.01);
        assertEquals("nothing to the right", Double.POSITIVE_INFINITY, metres(scan, 0), 0);
        double reach = browser.number(PANEL, "geometry().reach");
        double radius = browser.number(PANEL, "geometry().radius");
        for (double degrees : new double[] {30, 60, 90, 120, 179}) {
            double length = metres(scan, degrees);
            assertEquals(length, browser.number(PANEL, "scan.metres[" + beam(scan, degrees) + "]"), 0);
            String point = "point(geometry(), " + length + ", " + degrees + ")";
            assertEquals(browser.number(PANEL, "geometry().x") + length / reach * radius * Math.cos(
                Math.toRadians(degrees)), browser.number(PANEL, point + ".x"), PIXEL);
            assertEquals(browser.number(PANEL, "geometry().y") - length / reach * radius * Math.sin(
                Math.toRadians(degrees)), browser.number(PANEL, point + ".y"), PIXEL);
            browser.until("a dot at " + degrees, () -> isDotAt(length, degrees));
            assertFalse("a dot before the object at " + degrees, isDotAt(length * 0.8, degrees));
        }
        assertFalse("no dot where nothing was hit", isDotAt(reach, 0));
    }

    @Test
    public void theRangeOfThePlotCanBeChosen() {
        connect();
        JsonNode scan = scan();
        browser.choose(".lidar-reach", "4 m");
        browser.until("a range of 4 m", () -> browser.number(PANEL, "geometry().reach") == 4);
        browser.until("the dot in its new place", () -> isDotAt(metres(scan, 90), 90));
    }

    @Test
    public void tableAndFileHaveTheScan() throws IOException {
        connect();
        JsonNode scan = scan();
        browser.click(".lidar-table");
        browser.until("a row for each beam", () -> browser.all(".lidar-values tbody tr").size() == 181);
        int ahead = beam(scan, 90);
        assertEquals("90 " + scan.get("raw").get(ahead).asInt() + " " + metres(scan, 90),
            browser.all(".lidar-values tbody tr").get(ahead).getText());
        assertEquals("0 " + scan.get("raw").get(0).asInt() + " no return", browser.all(".lidar-values tbody tr").get(0)
            .getText());
        browser.click(".lidar-csv");
        StringBuilder expected = new StringBuilder("angle_deg,raw_mm,metres\r\n");
        for (int i = 0; i < 181; i++) {
            JsonNode metres = scan.get("metres").get(i);
            expected.append(i).append(',').append(scan.get("raw").get(i).asInt()).append(',')
                .append(metres.isNull() ? "" : browser.script("return String(arguments[0])", metres.asDouble()))
                .append("\r\n");
        }
        assertEquals(expected.toString(), Files.readString(browser.download("lidar-scan.csv")));
    }

    @Test
    public void streamsUntilStopped() {
        connect();
        browser.click(".lidar-stream");
        browser.seeText(".lidar-status", "connected, streaming");
        browser.seeText(".lidar-rate", "scans/s");
        double first = time();
        browser.until("scan after scan", () -> time() > first + 1);
        browser.click(".lidar-stop");
        browser.until("the end of the stream", () -> browser.text(".lidar-status").equals("connected"));
        int count = robotLab.call("lidar", "getScanCount").asInt();
        scan();
        assertEquals("scans after the end of the stream: the one asked for", count + 1,
            robotLab.call("lidar", "getScanCount").asInt());
    }

    @Test
    public void aStreamThatRunsAlreadyIsShownWithMode() {
        robotLab.call("lidar", "connect", DeviceWorld.LIDAR_PORT, 38400);
        robotLab.call("lidar", "setScanMode", 180, 0.5);
        robotLab.call("lidar", "startStreaming");
        browser.seeText(".lidar-status", "connected, streaming");
        seeMode("180° / 0.5°");
        assertEquals(DeviceWorld.LIDAR_PORT, browser.see(".lidar-port").getAttribute("value"));
        browser.seeText(".lidar-summary", "361 values");
        robotLab.call("lidar", "disconnect");
        browser.until("the disconnected panel", () -> browser.text(".lidar-status").equals("not connected"));
        browser.click(".lidar-connect");
        browser.seeText(".lidar-status", "connected, streaming");
        browser.click(".lidar-stop");
        browser.until("the end of the stream", () -> browser.text(".lidar-status").equals("connected"));
    }

    @Test
    public void theUnitChanges() {
        connect();
        assertEquals("true", browser.see(".lidar-mm").getAttribute("aria-pressed"));
        browser.click(".lidar-cm");
        browser.until("centimetres", () -> "true".equals(browser.see(".lidar-cm").getAttribute("aria-pressed")));
        JsonNode scan = scan();
        browser.seeText(".lidar-summary", "181 values in cm");
        assertEquals(DeviceWorld.AHEAD * 100, scan.get("raw").get(beam(scan, 90)).asInt(), 1.01);
        assertEquals(DeviceWorld.AHEAD, browser.number(PANEL, "scan.metres[90]"), 0.02);
        browser.click(".lidar-mm");
        browser.until("millimetres", () -> "true".equals(browser.see(".lidar-mm").getAttribute("aria-pressed")));
        assertEquals(DeviceWorld.AHEAD * 1000, scan().get("raw").get(90).asInt(), 10);
    }

    @Test
    public void theModeFollowsTheDevice() {
        connect();
        browser.choose(".lidar-mode", "100° / 0.25°");
        browser.until("the device's mode", () -> robotLab.call("lidar", "getResolution").asDouble() == 0.25);
        JsonNode scan = scan();
        browser.seeText(".lidar-summary", "401 values in mm, 100° in steps of 0.25°");
        assertEquals(40, browser.number(PANEL, "scan.angles[0]"), 0);
        browser.until("the dot ahead", () -> isDotAt(metres(scan, 90), 90));
        robotLab.call("lidar", "setScanMode", 180, 0.5);
        seeMode("180° / 0.5°");
        scan();
        browser.seeText(".lidar-summary", "361 values in mm, 180° in steps of 0.5°");
    }

    @Test
    public void theBaudRateChangesAtBothEnds() {
        connect();
        browser.choose(".lidar-baud", "500000");
        browser.until("the new rate", () -> robotLab.call("lidar", "getConfig").get("baud").asInt() == 500000);
        assertEquals(181, scan().get("raw").size());
    }

    @Test
    public void aDeviceAtAnotherRateIsFoundAndShown() {
        connect(DeviceWorld.LIDAR_PORT, "19200");
        browser.seeText(".lidar-message", "the LIDAR answers at 38400 baud");
        browser.until("the rate that was found", () -> browser.number(PANEL, "port.baud") == 38400);
        seeMode("180° / 1°");
        scan();
    }

    @Test
    public void errorsOfThePortAndTheDeviceAreShown() {
        connect("/dev/nothing_here", "38400");
        browser.seeText(".lidar-message", "can't be opened: Port not found; available ports: [");
        assertEquals("what was typed stays", "/dev/nothing_here", browser.see(".lidar-port").getAttribute("value"));
        assertEquals("not connected", browser.text(".lidar-status"));
        assertFalse(browser.see(".lidar-single").isEnabled());
        browser.click(".lidar-port");
        browser.until("the list of ports", () -> browser.all(PANEL + " datalist option").stream()
            .anyMatch(option -> DeviceWorld.LIDAR_PORT.equals(option.getAttribute("value"))));
        connect(DeviceWorld.ROBOT_PORT, "38400");
        browser.seeText(".lidar-message", "is the LIDAR switched on, and is this its port and baud rate?");
        browser.click(".lidar-clear");
        browser.until("no message", () -> browser.all(".lidar-message").isEmpty());
        browser.click(".lidar-disconnect");
        connect();
        scan();
    }

    @Test
    public void oneBeamCanBeReadWithMouseAndKeys() {
        connect();
        JsonNode scan = scan();
        WebElement plot = browser.see(".lidar-plot");
        int x = (int) Math.round(browser.number(PANEL, "point(geometry(), 1, 60).x") - plot.getSize().getWidth() / 2.0);
        int y = (int) Math.round(browser.number(PANEL, "point(geometry(), 1, 60).y") - plot.getSize()
            .getHeight() / 2.0);
        new Actions(browser.driver()).moveToElement(plot, x, y).perform();
        browser.until("the beam under the mouse",
            () -> Math.abs(browser.number(PANEL, "beam === null ? -1 : beam") - 60) <= 1);
        new Actions(browser.driver()).moveToElement(browser.see(".lidar-single")).perform();
        browser.until("no beam", () -> browser.scope(PANEL, "beam") == null);
        plot.sendKeys(Keys.ARROW_LEFT);
        browser.seeText(".lidar-beam", "90°: " + metres(scan, 90) + " m (" + scan.get("raw").get(90).asInt() + " mm)");
        plot.sendKeys(Keys.PAGE_UP, Keys.ARROW_LEFT);
        browser.seeText(".lidar-beam", "101°: " + metres(scan, 101) + " m");
        plot.sendKeys(Keys.HOME);
        browser.seeText(".lidar-beam", "0°: no return");
        assertEquals(browser.text(".lidar-beam"), plot.getAttribute("aria-valuetext"));
        plot.sendKeys(Keys.END);
        browser.seeText(".lidar-beam", "180°: " + metres(scan, 180) + " m");
    }

    @Test
    public void aSimulationThatEndsClosesThePortAndTheNextOneIsScannedAgain() {
        connect();
        scan();
        robotLab.call("sear", "stopSimulation");
        browser.seeText(".lidar-message", "was closed");
        browser.until("the disconnected panel", () -> browser.text(".lidar-status").equals("not connected"));
        robotLab.call("sear", "startSimulation");
        browser.until("a panel that has connected by itself", () -> browser.text(".lidar-status")
            .startsWith("connected"));
        scan();
        browser.click(".lidar-disconnect");
        browser.until("the disconnected panel", () -> browser.text(".lidar-status").equals("not connected"));
        assertFalse(robotLab.call("lidar", "isConnected").asBoolean());
        browser.click(".lidar-connect");
        scan();
    }

    @Test
    public void aServiceThatIsReleasedComesBackWithItsTab() {
        connect();
        robotLab.call("runtime", "release", "lidar");
        browser.until("no tab", () -> browser.all(PANEL).isEmpty());
        robotLab.call("runtime", "start", "lidar", "LIDAR");
        browser.click("#tab-lidar");
        connect();
        scan();
    }

    @Test
    public void afterARestartOfTheServerThePanelContinues() throws Exception {
        connect();
        scan();
        browser.expectErrors("WebSocket connection");
        browser.expectErrors("ERR_CONNECTION");
        robotLab.stop();
        browser.see("#shell-offline");
        robotLab.startAgain();
        browser.until("a connection", () -> browser.all("#shell-offline").isEmpty());
        DeviceWorld.restart(robotLab);
        browser.click("#tab-lidar");
        connect();
        scan();
        assertNull(browser.scope(PANEL, "beam"));
    }

    @Test
    public void everybodyCanReadAndUseIt() {
        connect();
        scan();
        browser.click(".lidar-table");
        browser.see(".lidar-values");
        for (String level : new String[] {"error", "warn", "info"}) {
            robotLab.call("lidar", level, "a message of level " + level);
            browser.seeText(".lidar-message", "a message of level " + level);
        }
        Accessibility.check(browser, PANEL);
        browser.see(".lidar-port").sendKeys(Keys.TAB);
        assertEquals("Refresh", browser.driver().switchTo().activeElement().getText());
    }
}
