// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.build;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.SEAR.web.SearPage;
import org.junit.Test;

/** The SEAR tab without a run: the project from above, in its starting state. */
public class PreviewTest extends SearPage {
    private static final long BOX = 0xc49a6cffL;
    private static final long TEAL = 0x008080ffL;
    private static final long PLANT = 0x6b8e23ffL;
    private static final String OBJECTS = "from org.SEAR.POJOs import Box, Floor\n";
    /** Counts the page's requests and the seconds since. */
    private static final String SPY = "window.asks = 0; window.seconds = 0; setInterval(function() { "
        + "window.seconds++ }, 1000);var send = WebSocket.prototype.send; WebSocket.prototype.send = function(text) {"
        + "if (text.indexOf('getPreview') >= 0) { window.asks++ } send.call(this, text) }";

    private void open(String example, String robot) {
        tab.openExample(example);
        browser.until("the preview of " + robot,
            () -> tab.isTrue("world.preview.world.robots[0].name === '" + robot + "'"));
    }

    private int index(String name) {
        for (int i = 0; i < tab.number("world.shown().objects.length"); i++) {
            if (tab.isTrue("world.shown().objects[" + i + "].name === '" + name + "'")) {
                return i;
            }
        }
        return -1;
    }

    private double[] pose(String part) {
        return new double[] {tab.number(part + ".pose[0]"), tab.number(part + ".pose[2]"),
            tab.number(part + ".pose[4]")};
    }

    private long pageNumber(String name) {
        return ((Number) browser.script("return window." + name)).longValue();
    }

    private void waitForSeconds(int more) {
        long end = pageNumber("seconds") + more;
        browser.until(more + " seconds of the page", () -> pageNumber("seconds") >= end);
    }

    @Test
    public void theProjectIsSeenFromAboveAsItWillStart() {
        open("office", "office Roomba");
        browser.seeText(".sear-note", "Not running: the view shows the project before its start, by the button Start "
            + "or sear.startSimulation()");
        tab.waitForStatus("no simulation runs");
        browser.seeText(".sear-tree", "office Roomba robot");
        browser.click(".sear-beams");
        String plant = "world.shown().objects[" + index("plant") + "]";
        double[] at = pose(plant);
        browser.until("a green tree", () -> tab.colour(at[0] + 0.05, at[1] + 0.05) == PLANT);
        assertNotEquals("a metre beside it", PLANT, tab.colour(at[0] - 1, at[1]));
        double[] start = pose("world.shown().robots[0]");
        assertNotEquals("the robot is drawn", tab.colour(start[0] - 0.1, start[1] + 0.05),
            tab.colour(start[0] - 0.5, start[1] + 0.05));
        tab.start();
        browser.click(".sear-pause");
        browser.until("no note", () -> browser.see(".sear-note").getText().isEmpty());
        browser.click(".sear-reset");
        browser.until("time 0", () -> tab.time() == 0);
        assertArrayEquals("it was the robot's start", pose("world.running.robots[0]"), start, 1e-3);
        browser.click(".sear-stop");
        browser.seeText(".sear-note", "Not running");
        browser.until("the robot at its start", () -> tab.isTrue("world.shown() === world.preview.world"));
    }

    @Test
    public void thePreviewFollowsAScript() {
        robotLab.call("sear", "newProject");
        browser.seeText(".sear-welcome", "Where do you want to begin?");
        assertFalse("nothing to start", browser.see(".sear-start").isEnabled());
        robotLab.run(OBJECTS + "Floor('ground', 8, 8)\ncrate = Box('crate', 0.5, 0.5, 0.5, "
            + "0)\ncrate.move(1, 0.25, 2)\n");
        browser.until("the crate", () -> index("crate") >= 0
            && tab.number("world.shown().objects[" + index("crate") + "].pose[0]") == 1);
        browser.until("its picture", () -> tab.colour(1, 2) == BOX);
        robotLab.run("crate.move(-2, 0.25, -1)");
        browser.until("it at its new place", () -> tab.colour(-2, -1) == BOX);
        assertNotEquals(BOX, tab.colour(1, 2));
        robotLab.run("crate.setColor('teal')");
        browser.until("it in its own colour", () -> tab.colour(-2, -1) == TEAL);
        robotLab.call("sear", "saveProject", "crate.sear");
        open("maze", "maze Roomba");
        assertEquals("another project, without the crate", -1, index("crate"));
        robotLab.call("sear", "loadProject", "crate.sear");
        browser.until("the crate again", () -> index("crate") >= 0);
    }

    @Test
    public void aLongListIsShortenedUntilAllIsAskedFor() {
        robotLab.call("sear", "newProject");
        robotLab.run(OBJECTS + "for i in range(130): Box('box %03d' % i, 0.5, 0.5, 0.5, 0).move(i % 12, "
            + "0.25, i / 12)\n");
        browser.seeText(".sear-all", "and 30 more objects: list all");
        assertEquals(100, browser.all(".sear-tree > li").size());
        browser.click(".sear-all");
        browser.until("all", () -> browser.all(".sear-tree > li").size() == 130);
        assertTrue(browser.all(".sear-all").isEmpty());
    }

    @Test
    public void aBrokenProjectShowsItsProblemsUntilTheyAreMended() throws IOException {
        open("maze", "maze Roomba");
        Path bad = robotLab.file("SEARproject/environment/bad.xml");
        Files.writeString(bad, "<Box>\n<name>bad</name>\n<length>-1</length>\n</Box>\n");
        browser.seeText(".sear-problems tbody tr", "environment/bad.xml 3 length -1");
        browser.seeText(".sear-note", "Not running, and nothing to show: the project has 3 problems, listed below");
        assertTrue("nothing is drawn that is not so", tab.isTrue("world.shown() === null"));
        TABS.open("sear");
        browser.seeText(".sear-problems tbody tr", "environment/bad.xml 3 length -1");
        assertTrue("it is no message each second", browser.all(".sear-main .alert").isEmpty());
        Files.delete(bad);
        browser.until("no problems", () -> browser.all(".sear-problems").isEmpty());
        browser.seeText(".sear-note", "Not running: the view shows the project before its start");
    }

    @Test
    public void onlyATabThatIsSeenWhileNothingRunsAsks() {
        open("maze", "maze Roomba");
        browser.script(SPY);
        browser.until("it asks whether the project has changed", () -> pageNumber("asks") > 1);
        browser.click("#tab-python");
        browser.see(".python-code");
        long hidden = pageNumber("asks");
        waitForSeconds(3);
        assertEquals("hidden", hidden, pageNumber("asks"));
        browser.click("#tab-sear");
        browser.until("it asks again", () -> pageNumber("asks") > hidden);
        tab.start();
        long running = pageNumber("asks");
        waitForSeconds(3);
        assertEquals("running", running, pageNumber("asks"));
    }

    @Test
    public void whereTheUserLooksStaysWhenTheSimulationStartsButNotInAnotherProject() {
        open("maze", "maze Roomba");
        browser.until("a fitted view", () -> tab.isTrue("view.fitted"));
        double fitted = tab.number("view.scale");
        browser.click("button[aria-label='Zoom in']");
        browser.until("closer", () -> tab.number("view.scale") > fitted);
        double chosen = tab.number("view.scale");
        tab.start();
        tab.waitForTime(0.1);
        assertEquals(chosen, tab.number("view.scale"), 0);
        browser.click(".sear-stop");
        tab.waitForStatus("no simulation runs");
        open("office", "office Roomba");
        browser.until("another view", () -> tab.isTrue("view.fitted && !view.chosen")
            && tab.number("view.scale") != chosen);
        assertFalse(tab.isTrue("view.scale === " + fitted));
    }
}
