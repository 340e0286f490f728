// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.SEAR.web.Accessibility;
import org.SEAR.web.Browser;
import org.SEAR.web.SearTab;
import org.SEAR.web.Tabs;
import org.junit.After;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.Dimension;

/** The panels at their widths: in MyRobotLab beside its list of services, on a whole page, on a telephone. */
public class LayoutTest {
    @ClassRule
    public static final Tabs TABS =
        new Tabs("sear = Runtime.start('sear', 'SEAR')\nsear.loadProject('examples/sensors.sear')\n"
        + "sear.startSimulation()\nlidar = Runtime.start('lidar', 'LIDAR')\nlidar.connect('/dev/SEAR_LIDAR_01')\n"
        + "lidar.singleScan()\n"
        + "gps = Runtime.start('gps', 'GPS')\ngps.connect('/dev/SEAR_GPS_01')\n");
    private static final String[] SERVICES = {"sear", "lidar", "gps"};
    /**
     * Script that returns wrapped rows of controls, much higher than their tallest element: the beginning of each row's
     * text.
     */
    private static final String WRAPPED = String.join("\n",
        "return [].filter.call(document.querySelectorAll(arguments[0] + ' .sear-row'), function(row) {",
        "    var tallest = Math.max.apply(null, [].map.call(row.children, function(e) { return "
        + "e.getBoundingClientRect().height }))",
        "    return row.getClientRects().length && row.getBoundingClientRect().height > tallest * 1.6",
        "}).map(function(row) { return row.textContent.trim().replace(/\\s+/g, ' ').substring(0, 60) })");
    /**
     * Script that returns elements beyond the panel's right edge, without scrolling content of editors, and lists with
     * hidden parts.
     */
    private static final String CUT = String.join("\n",
        "var panel = document.querySelector(arguments[0]), right = panel.getBoundingClientRect().right + 1, cut = []",
        "panel.querySelectorAll('*').forEach(function(e) {",
        "    if (e.getClientRects().length && e.getBoundingClientRect().right > right && !e.closest('svg, "
        + ".sear-file, .sear-log')",
        "        && !e.parentElement.closest('.ace_editor')) {",
        "        cut.push(e.outerHTML.substring(0, 100))",
        "    }",
        "})",
        "panel.querySelectorAll('.sear-tree').forEach(function(e) {",
        "    if (e.scrollHeight > e.clientHeight + 1 || e.scrollWidth > e.clientWidth + 1) { cut.push('list of ' + "
        + "e.scrollHeight) }",
        "})",
        "return cut");
    /** Script that returns the distance between the middles of each check box and its label, pixels. */
    private static final String TICKS = String.join("\n",
        "return [].map.call(document.querySelectorAll(arguments[0] + ' input[type=checkbox]'), function(box) {",
        "    function middle(e) { var r = e.getBoundingClientRect(); return (r.top + r.bottom) / 2 }",
        "    return Math.abs(middle(box) - middle(box.closest('label')))",
        "})");
    /** Script that returns left, top, right and bottom of an element in the window, pixels. */
    private static final String BOX = "var box = arguments[0].getBoundingClientRect(); return [box.left, box.top, "
        + "box.right, box.bottom]";
    /**
     * Script that returns the gaps between a panel and its service's area: left, right, and overlap with the header,
     * pixels.
     */
    private static final String GAPS = String.join("\n",
        "var panel = document.querySelector(arguments[0]), box = panel.getBoundingClientRect(), area = "
        + "panel.parentElement.getBoundingClientRect()",
        "var header = panel.parentElement.querySelector('.tab-header').getBoundingClientRect()",
        "return [Math.abs(box.left - area.left), Math.abs(box.right - area.right), Math.max(0, "
            + "header.bottom - box.top)]");
    /** Widths of windows, pixels. MyRobotLab's header floats from 992 on. */
    private static final int[] WIDTHS = {800, 1024, 1210, 1366, 1920};
    private static final int LAPTOP_WIDTH = 1280;
    private static final int LAPTOP_HEIGHT = 720;
    private static final int PHONE_WIDTH = 390;
    private static final int PHONE_HEIGHT = 844;
    @Rule
    public final TestRule page = TABS.page("sear");
    private final Browser browser = TABS.browser();

    private static String panel(String service) {
        return "mrl-panel[name='" + service + "'] > .sear-panel";
    }

    /** Resets the page to the state of a first visit. */
    private void forgetWhatIsOpen() {
        browser.script("localStorage.removeItem('sear.folds')");
    }

    private void open(int width, String query) {
        forgetWhatIsOpen();
        browser.driver().manage().window().setSize(new Dimension(width, 1000));
        browser.driver().get(TABS.robotLab().url() + "?" + query + "#/sear");
        browser.see(panel("sear"));
        browser.see(".sear-sensors");
    }

    private void checkAll(boolean rows) {
        for (String service : SERVICES) {
            browser.click("#tab-" + service);
            browser.see(panel(service));
            if (rows) {
                assertEquals(service, List.of(), browser.script(WRAPPED, panel(service)));
            }
            assertEquals(service, List.of(), browser.script(CUT, panel(service)));
            for (Object offset : (List<?>) browser.script(TICKS, panel(service))) {
                assertEquals("a check box beside its label", 0, ((Number) offset).doubleValue(), 3);
            }
        }
        browser.click("#tab-sear");
    }

    @Test
    public void besideMyRobotLabsListOfServicesNoRowWrapsAndNothingIsCutOff() {
        open(1400, "layout=myrobotlab");
        double width = ((Number) browser.script("return document.querySelector(arguments[0]).clientWidth",
            panel("sear"))).doubleValue();
        assertEquals("as wide as there", 1088, width, 1);
        assertTrue("below a header", browser.texts(".tab-name").contains("SEAR sear"));
        checkAll(true);
        assertEquals("view and readings are side by side", true,
            browser.script("var view = document.querySelector('.sear-view')"
            + ".getBoundingClientRect(), readings = document.querySelector('.sear-readings').getBoundingClientRect();"
            + "return readings.left > view.right && readings.top < view.bottom"));
        browser.seeText(".sear-tree", "body Cylinder");
    }

    @Test
    public void belowTheFloatingHeaderEachPanelFillsItsServicesArea() {
        for (String query : new String[] {"layout=myrobotlab", ""}) {
            open(WIDTHS[0], query);
            for (int width : WIDTHS) {
                browser.setPageSize(width, 900);
                for (String service : new String[] {"sear", "lidar", "gps", "python"}) {
                    String panel = service.equals("python") ? ".mrl-python" : panel(service);
                    String what = service + " at " + width + " " + query;
                    browser.click("#tab-" + service);
                    browser.see(panel);
                    assertEquals(what, List.of(0L, 0L, 0L), browser.script(GAPS, panel));
                    assertEquals(what, List.of(), browser.script(CUT, panel));
                }
            }
        }
    }

    @Test
    public void onTheWholePageNoRowWraps() {
        open(1400, "");
        checkAll(true);
    }

    @Test
    public void onATelephoneNothingIsCutOff() {
        try {
            open(1400, "layout=myrobotlab");
            browser.setPageWidth(390);
            checkAll(false);
        } finally {
            browser.setPageWidth(0);
        }
    }

    @After
    public void giveThePageItsOwnSize() {
        browser.setPageSize(0, 0);
    }

    private void openAt(int width, int height) {
        forgetWhatIsOpen();
        browser.setPageSize(width, height);
        TABS.open("sear");
        browser.see(".sear-sensors");
    }

    private double[] box(String css) {
        return ((List<?>) browser.script(BOX, browser.see(css))).stream()
            .mapToDouble(number -> ((Number) number).doubleValue()).toArray();
    }

    private void checkInWindow(int width, int height, String... all) {
        for (String css : all) {
            browser.until(css + " in the window", () -> {
                double[] box = box(css);
                return box[0] >= 0 && box[1] >= 0 && box[2] <= width && box[3] <= height && box[3] > box[1];
            });
        }
    }

    private void checkNothingScrolls(String when) {
        browser.until("a page that does not scroll, " + when,
            () -> ((Number) browser.script("return Math.max(document.documentElement.scrollHeight,"
            + " document.body.scrollHeight)")).intValue() <= LAPTOP_HEIGHT);
        checkInWindow(LAPTOP_WIDTH, LAPTOP_HEIGHT, ".sear-fold-project", ".sear-start", ".sear-status",
            ".sear-stage canvas", ".sear-halt",
            ".sear-plots");
    }

    @Test
    public void onASmallLaptopThePageDoesNotScrollWhateverIsOpen() {
        openAt(LAPTOP_WIDTH, LAPTOP_HEIGHT);
        checkNothingScrolls("as it is opened");
        checkInWindow(LAPTOP_WIDTH, LAPTOP_HEIGHT, ".sear-fold-world", ".sear-tree > li", ".sear-fold-inspector",
            ".sear-sensors tr");
        double[] world = box(".sear-world");
        double[] view = box(".sear-stage canvas");
        double[] side = box(".sear-side");
        assertTrue("world, view, inspector from left to right", world[2] <= view[0] && view[2] <= side[0]);
        assertTrue("two thirds of the page are the view " + Arrays.toString(view),
            view[2] - view[0] > LAPTOP_WIDTH * 0.64
            && view[3] - view[1] > LAPTOP_HEIGHT * 0.66);
        browser.click(".sear-tree .btn-link");
        browser.see(".sear-inspector .sear-field");
        browser.click(".sear-build");
        browser.see(".sear-palette");
        checkNothingScrolls("while one builds");
        for (String part : new String[] {".sear-fold-project", ".sear-plots", ".sear-fold-messages",
            ".sear-fold-scripts"}) {
            browser.click(part);
        }
        browser.see(".sear-plot");
        browser.see(".sear-messages");
        checkNothingScrolls("with all parts open");
        double[] small = box(".sear-stage canvas");
        assertTrue("room for the view " + Arrays.toString(small), small[3] - small[1] >= 90);
        browser.click(".sear-show-script");
        browser.see(".sear-python");
        checkNothingScrolls("with the project as a script");
        Accessibility.check(browser, SearTab.ROOT);
    }

    @Test
    public void foldedSectionsEnlargeTheViewAndStayFolded() {
        openAt(LAPTOP_WIDTH, LAPTOP_HEIGHT);
        double[] before = box(".sear-stage canvas");
        for (String part : new String[] {"world", "inspector", "readings"}) {
            assertEquals("true", browser.see(".sear-fold-" + part).getAttribute("aria-expanded"));
            browser.click(".sear-fold-" + part);
        }
        browser.until("a wider view", () -> box(".sear-stage canvas")[2] - box(".sear-stage canvas")[0] > before[2]
            - before[0] + 400);
        openAgain();
        browser.until("the view as wide", () -> box(".sear-stage canvas")[2] - box(".sear-stage canvas")[0] > before[2]
            - before[0] + 400);
        assertEquals("false", browser.see(".sear-fold-world").getAttribute("aria-expanded"));
        assertTrue(browser.texts(".sear-tree").isEmpty());
        browser.click(".sear-fold-world");
        browser.see(".sear-tree");
        browser.click(".sear-fold-messages");
        browser.see(".sear-messages");
        openAgain();
        browser.see(".sear-tree");
        browser.see(".sear-messages");
        assertTrue("still folded", browser.texts(".sear-sensors").isEmpty());
    }

    private void openAgain() {
        TABS.open("sear");
        browser.until("the world", () -> Boolean.TRUE.equals(
            browser.scope(SearTab.ROOT, "world.shown() && world.shown().robots.length > 0")));
    }

    @Test
    public void aTelephoneShowsViewAndDriveButtonsFirst() {
        openAt(PHONE_WIDTH, PHONE_HEIGHT);
        checkInWindow(PHONE_WIDTH, PHONE_HEIGHT, ".sear-start", ".sear-stop", ".sear-status", ".sear-stage canvas",
            ".sear-left", ".sear-forward",
            ".sear-halt", ".sear-backward", ".sear-right");
        double[] view = box(".sear-stage canvas");
        assertTrue(Arrays.toString(view), view[2] - view[0] > 300 && view[3] - view[1] >= 240);
        assertTrue("folded", browser.texts(".sear-save").isEmpty());
        browser.click(".sear-fold-project");
        browser.see(".sear-save");
    }
}
