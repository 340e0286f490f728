// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.Test;
import org.openqa.selenium.WebElement;

/** Layout of SEAR's panels on MyRobotLab's own page at four widths. */
public class PanelsTest extends InPage {
    /** Least width of a control, pixels. */
    private static final int NARROWEST = 24;
    /**
     * Script that returns the layout errors of the front service: SEAR panels that miss the sides of their area or
     * overlap the header, MyRobotLab rows that miss the sides, and content beyond the right edge.
     */
    private static final String FAULTS = String.join("\n",
        "var area = [].find.call(document.querySelectorAll('.tab-content > div'), function(e) { return "
        + "e.getClientRects().length })",
        "var own = [].slice.call(area.querySelectorAll(':scope > .sear-panel, :scope > .row')), faults = []",
        "var frame = area.getBoundingClientRect(), header = area.querySelector('.tab-header').getBoundingClientRect()",
        "own.forEach(function(e) {",
        "    var box = e.getBoundingClientRect(), margin = e.matches('.row') ? 15 : 0",
        "    var gaps = [box.left + margin - frame.left, frame.right + margin - box.right, margin ? 0 : Math.min(0, "
        + "box.top - header.bottom)]",
        "    if (gaps.some(function(gap) { return Math.abs(gap) > 1 })) { faults.push(e.className + ' is off "
        + "by ' + gaps) }", "})",
        "area.querySelectorAll('.sear-panel *').forEach(function(e) {",
        "    if (e.getClientRects().length && e.getBoundingClientRect().right > frame.right + 1 && !e.closest('svg, "
        + ".sear-file, .sear-log')) {", "        faults.push('cut off: ' + e.outerHTML.substring(0, 100))",
        "    }",
        "})",
        "return own.length ? faults : ['nothing is there']");

    @Test
    public void eachPanelFillsItsServicesAreaAtEveryWidth() throws Exception {
        assertEquals("", mrl.python("sear.loadProject(" + RealMrl.literal(ROOT + "/examples/sensors.sear") + ")",
            "sear.startSimulation()",
            "lidar.connect('/dev/SEAR_LIDAR_01')", "gps.connect('/dev/SEAR_GPS_01')", "lidar.singleScan()"));
        page.open(mrl, "sear");
        for (String service : List.of("sear", "lidar", "gps", "python")) {
            page.show(service);
            for (int[] size : SIZES) {
                page.setSize(size[0], size[1]);
                String what = service + "-" + size[0];
                page.browser.until("the panel " + what + " in its place", () -> List.of()
                    .equals(page.browser.script(FAULTS)));
                page.keep(what);
                checkWhatOneNeeds(service);
            }
        }
        page.setSize(0, 0);
    }

    /** Checks that the controls of a service lie beside its header and have a width; the narrowest is an icon. */
    private void checkWhatOneNeeds(String service) {
        List<String> controls = Map.of(
            "sear", List.of(".sear-start", ".sear-stop", ".sear-stage canvas", ".sear-record"),
            "lidar", List.of(".lidar-port", ".sear-lidar canvas, .sear-lidar svg"), "gps",
            List.of(".gps-port", ".sear-gps table"), "python", List.of("[ng-click='exec()']")).get(service);
        for (String css : controls) {
            assertTrue(css + " is wide enough", page.browser.see(css).getSize().getWidth() >= NARROWEST);
        }
    }

    @Test
    public void anExampleThatDrivesIsRunAndItsTextIsInTheTabOfPython() throws Exception {
        page.open(mrl, "sear");
        page.await("a layout", "layout.room !== undefined");
        if (page.isTrue("layout.isFolded('scripts')")) {
            page.browser.click(".sear-fold-scripts");
        }
        page.browser.choose(".sear-script", "obstacle avoidance");
        page.browser.click(".sear-run-script");
        page.await("a running simulation", "world.running !== null && view.fitted");
        page.await("the project's name", "project.path === 'office.sear'");
        page.browser.click(".sear-stop");
        page.show("python");
        page.browser.until("a tab with its text", () -> page.browser.all(".nav-tabs a").stream()
            .filter(tab -> tab.getText().trim().startsWith("obstacle_avoidance.py")).peek(WebElement::click)
                .count() == 1);
        page.browser.seeText(".tab-pane.active .ace_content", "loadProject");
    }

    /** MyRobotLab's page is always light. */
    @Test
    public void textIsReadableIfTheUserPrefersDarkPages() {
        page.browser.setTheme("dark");
        try {
            page.open(mrl, "sear");
            page.await("the project", "world.preview !== null");
            if (page.isTrue("welcome.isShown()")) {
                page.browser.click("[data-tile='build']");
            }
            page.browser.seeText(".sear-note", "Not running");
            assertEquals("white below black words", "rgba(255, 255, 255, 0.86)", page.browser.script(
                "return getComputedStyle(document.querySelector('.sear-note')).backgroundColor"));
        } finally {
            page.browser.setTheme("light");
        }
    }

    /**
     * The first panel of a page sends some requests late because its files load first. Later panels send them
     * immediately.
     */
    @Test
    public void aServiceStartedWhileThePageIsOpenHasACompletePanel() throws Exception {
        page.open(mrl, "sear");
        page.await("what the first panel has asked for", "edits.grammar !== null && project.examples.length > 5");
        assertEquals("", mrl.python("another = Runtime.start('another', 'SEAR')"));
        page.show("another");
        page.browser.until("what the second has asked for",
            () -> Boolean.TRUE.equals(page.browser.scope("#sear-workspace-another",
            "edits.grammar !== null && project.examples.length > 5 && project.scripts.length > 1")));
        assertEquals("", mrl.python("Runtime.release('another')", "another = Runtime.start('another', 'SEAR')"));
        page.show("another");
        page.browser.until("the panel of the one that was started again",
            () -> Boolean.TRUE.equals(page.browser.scope("#sear-workspace-another",
            "edits.grammar !== null && project.examples.length > 5 && project.scripts.length > 1")));
    }
}
