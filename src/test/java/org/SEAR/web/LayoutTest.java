package org.SEAR.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.Dimension;

/** The panels at the widths they have: in MyRobotLab beside its list of services, on a whole page, on a telephone. */
public class LayoutTest {
    @ClassRule
    public static final Tabs TABS = new Tabs("sear = Runtime.start('sear', 'SEAR')\nsear.loadProject('examples/sensors.sear')\n"
        + "sear.startSimulation()\nlidar = Runtime.start('lidar', 'LIDAR')\nlidar.connect('/dev/SEAR_LIDAR_01')\nlidar.singleScan()\n"
        + "gps = Runtime.start('gps', 'GPS')\ngps.connect('/dev/SEAR_GPS_01')\n");
    private static final String[] SERVICES = {"sear", "lidar", "gps"};
    /** Rows of controls whose tallest element is far lower than the row: they wrap. Of each how many lines it has, and its beginning. */
    private static final String WRAPPED = String.join("\n",
        "return [].filter.call(document.querySelectorAll(arguments[0] + ' .sear-row'), function(row) {",
        "    var tallest = Math.max.apply(null, [].map.call(row.children, function(e) { return e.getBoundingClientRect().height }))",
        "    return row.getClientRects().length && row.getBoundingClientRect().height > tallest * 1.6",
        "}).map(function(row) { return row.textContent.trim().replace(/\\s+/g, ' ').substring(0, 60) })");
    /** What stands out of its panel to the right, and lists that hide a part of themselves. */
    private static final String CUT = String.join("\n",
        "var panel = document.querySelector(arguments[0]), right = panel.getBoundingClientRect().right + 1, cut = []",
        "panel.querySelectorAll('*').forEach(function(e) {",
        "    if (e.getClientRects().length && e.getBoundingClientRect().right > right && !e.closest('svg, .sear-file, .sear-log')) {",
        "        cut.push(e.outerHTML.substring(0, 100))",
        "    }",
        "})",
        "panel.querySelectorAll('.sear-tree').forEach(function(e) {",
        "    if (e.scrollHeight > e.clientHeight + 1 || e.scrollWidth > e.clientWidth + 1) { cut.push('list of ' + e.scrollHeight) }",
        "})",
        "return cut");
    /** How far the middle of each check box is from that of its label, pixels. */
    private static final String TICKS = String.join("\n",
        "return [].map.call(document.querySelectorAll(arguments[0] + ' input[type=checkbox]'), function(box) {",
        "    function middle(e) { var r = e.getBoundingClientRect(); return (r.top + r.bottom) / 2 }",
        "    return Math.abs(middle(box) - middle(box.closest('label')))",
        "})");
    @Rule
    public final TestRule page = TABS.page("sear");
    private final Browser browser = TABS.browser();

    private static String panel(String service) {
        return "mrl-panel[name='" + service + "'] > .sear-panel";
    }

    private void open(int width, String query) {
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
        double width = ((Number) browser.script("return document.querySelector(arguments[0]).clientWidth", panel("sear"))).doubleValue();
        assertEquals("as wide as there", 900, width, 20);
        assertTrue("below a header", browser.texts(".shell-header").contains("sear SEAR"));
        checkAll(true);
        assertEquals("view and readings are side by side", true, browser.script("var view = document.querySelector('.sear-view')"
            + ".getBoundingClientRect(), table = document.querySelector('.sear-sensors').getBoundingClientRect();"
            + "return table.left > view.right && table.top < view.bottom"));
        browser.seeText(".sear-tree", "body Cylinder");
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
}
