// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Locale;
import org.SEAR.web.SearPage;
import org.junit.After;
import org.junit.Test;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

/** Camera pictures in the SEAR tab, live and in records: values at a click, and no requests for hidden pictures. */
public class CameraTabTest extends SearPage {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;
    /** Longer side of a picture over the view, pixels. */
    private static final Long LARGE = 640L;
    private static final String WORLD = String.join("\n",
        "from org.SEAR.POJOs import Box, Camera, Floor, Robots, Sphere",
        "sear.newProject()",
        "Floor('floor', 20, 20)",
        "stove = Box('stove', 1, 1, 1, 0)",
        "stove.setColor('red')",
        "stove.setTemperature(80)",
        "stove.move(0, 0.5, 2)",
        "rover = Robots.create2('rover')",
        "for kind in ('color', 'depth', 'infrared'):",
        "    eye = Camera(kind, 0, 0.3, 0.1)",
        "    eye.setKind(kind)",
        "    eye.setSize(" + WIDTH + ", " + HEIGHT + ")",
        "    rover.addComponent(eye)",
        "large = Camera('large', 0, 0.3, 0.1)",
        "large.setSize(800, 600)",
        "rover.addComponent(large)");
    private static final String SCOPE = "angular.element(document.querySelector('.sear-main')).scope()";
    /** Counts further requests for pictures. */
    private static final String COUNT = "var msg = " + SCOPE + ".msg, send = msg.send; window.asked = []; msg.send = "
        + "function(method, name) {"
        + " if (/Picture$/.test(method)) { window.asked.push(name) } return send.apply(msg, arguments) }";


    @After
    public void stop() {
        tab.stopAll();
    }

    private void see() {
        robotLab.run(WORLD);
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().sensors.length === 4"));
        browser.script(COUNT);
    }

    private static String eye(String name) {
        return "[data-eye='" + name + "']:not([data-large]) ";
    }

    private void waitForPicture(String name) {
        String seen = "cameras.seen({name: '" + name + "'})";
        browser.until("a picture of " + name, () -> isInView(name) && tab.isTrue(seen
            + " && " + seen + ".time !== undefined && " + seen + ".picture.length > 50"));
    }

    /** Scrolls the picture into view: the drawer scrolls, and other sections of it may grow. */
    private boolean isInView(String name) {
        browser.script("document.querySelector(arguments[0]).scrollIntoView()", eye(name));
        return true;
    }

    /** Clicks a picture at fractions of its width and height. */
    private void click(String name, double across, double down) {
        WebElement picture = browser.see(eye(name) + ".sear-eye-picture");
        browser.script("var box = arguments[0].querySelector('img').getBoundingClientRect(); "
            + "arguments[0].dispatchEvent(new MouseEvent('click',"
            + " {detail: 1, bubbles: true, clientX: box.left + arguments[1] * box.width, clientY: box.top + "
            + "arguments[2] * box.height}))", picture, across, down);
    }

    private long asked() {
        return ((Number) browser.script("return window.asked.length")).longValue();
    }

    @Test
    public void aClickShowsDistanceTemperatureAndColourOfAPixel() {
        see();
        browser.seeText(eye("depth") + ".sear-eye-picture", "");
        tab.start();
        waitForPicture("depth");
        click("depth", 0.51, 0.51);
        JsonNode depths = robotLab.call("sear", "getDepth", "depth");
        double straight = depths.get(HEIGHT / 2 * WIDTH + WIDTH / 2).asDouble();
        assertEquals("the stove", 1.4, straight, 0.01);
        browser.seeText(eye("depth") + ".sear-eye-words",
            String.format(Locale.ROOT, "column %d, row %d: %.3f m ahead", WIDTH / 2, HEIGHT / 2, straight));
        browser.seeText(eye("depth") + ".sear-range", " m");
        click("depth", 0.001, 0.001);
        browser.seeText(eye("depth") + ".sear-eye-words", "column 0, row 0: no return");
        browser.see(eye("depth") + ".sear-eye-picture").sendKeys(Keys.ARROW_RIGHT);
        browser.seeText(eye("depth") + ".sear-eye-words", "column 1, row 0: no return");
        waitForPicture("infrared");
        click("infrared", 0.51, 0.51);
        browser.seeText(eye("infrared") + ".sear-eye-words", String.format(Locale.ROOT, ": 80.0 degC, %.2f", straight));
        browser.seeText(eye("infrared") + ".sear-range", "-20.0 degC");
        waitForPicture("color");
        click("color", 0.51, 0.51);
        browser.until("its colour",
            () -> browser.text(eye("color") + ".sear-eye-words")
                .matches(".*: #[0-9a-f]{6}, (about )?(red|maroon|brown), [0-9.]+ m ahead"));
        browser.see(eye("color") + ".sear-cross");
        browser.see(eye("color") + ".sear-eye-picture").sendKeys(Keys.ESCAPE);
        browser.until("no mark", () -> browser.all(eye("color") + ".sear-cross").isEmpty());
    }

    @Test
    public void picturesComeOnlyWhileTheyAreSeenAndAreSmall() {
        see();
        tab.start();
        waitForPicture("large");
        browser.until("its words", () -> browser.text("[data-sensor='large'] .sear-reading").contains("brightness"));
        double size = tab.number("cameras.seen({name: 'large'}).picture.length");
        assertTrue("a picture of the drawer has " + size + " characters", size < 40_000);
        double first = tab.number("cameras.seen({name: 'large'}).time");
        browser.until("another one", () -> isInView("large")
            && tab.number("cameras.seen({name: 'large'}).time") > first);
        browser.click(".sear-pause");
        browser.until("paused", () -> tab.isTrue("service.paused"));
        waitUntilQuiet();
        browser.click(".sear-resume");
        browser.until("they come again", () -> asked() > 0);
        browser.click(".sear-fold-readings");
        waitUntilQuiet();
        double then = tab.time();
        tab.waitForTime(then + 1);
        assertEquals("nobody looks", 0, asked());
        assertFalse("nor is it in what is told of the world", Boolean.TRUE.equals(browser.script("return " + SCOPE
            + ".world.running.sensors.some(one => one.picture || one.value)")));
        browser.click(".sear-fold-readings");
        browser.until("somebody looks", () -> asked() > 0);
    }

    /** Waits until pending pictures have arrived, then starts counting. */
    private void waitUntilQuiet() {
        long[] last = {-1};
        browser.until("nothing is asked for any more", () -> {
            boolean quiet = last[0] == 0;
            browser.script("window.asked.length = 0; window.ticks = 0; var tick = setInterval(function() {"
                + " if (++window.ticks === 10) { clearInterval(tick) } }, 100)");
            browser.until("a second", () -> ((Number) browser.script("return window.ticks")).intValue() >= 10);
            last[0] = asked();
            return quiet && last[0] == 0;
        });
    }

    @Test
    public void aPictureIsEnlargedOverTheView() {
        see();
        tab.start();
        waitForPicture("large");
        browser.click(eye("large") + ".sear-enlarge");
        WebElement over = browser.see(".sear-eye-large");
        assertTrue("inside the view", Boolean.TRUE.equals(
            browser.script("var box = arguments[0].getBoundingClientRect(),"
            + " view = document.querySelector('.sear-canvas').getBoundingClientRect(); return box.left > view.left && "
            + "box.right < view.right && box.top > view.top && box.bottom < view.bottom", over)));
        browser.until("more pixels", () ->
            LARGE.equals(browser.script("return document.querySelector('.sear-eye-large img').naturalWidth")));
        browser.click(".sear-eye-close");
        browser.until("closed", () -> browser.all(".sear-eye-large").isEmpty());
    }

    /** The lines are there before the start. */
    @Test
    public void theViewHasLinesAroundACamerasField() {
        see();
        browser.click(".sear-space");
        browser.until("its lines", () -> tab.isTrue("view.scene() && view.scene().sensors.length === 4"
            + " && view.scene().sensors[0].holder.children[0].type === 'LineSegments'"));
        assertTrue(tab.isTrue("view.scene().sensors[0].holder.visible"));
        double[] corner = {tab.number("world.shown().sensors[0].eye.edge[0]"),
            tab.number("world.shown().sensors[0].eye.edge[2]")};
        assertEquals("to the left by half of 60 degrees", Math.tan(Math.toRadians(30)) * corner[1], corner[0], 1e-6);
        browser.click(".sear-beams");
        browser.until("none", () -> tab.isTrue("!view.scene().sensors[0].holder.visible"));
        browser.click(".sear-beams");
        assertEquals(List.of(), browser.errors());
    }

    private double recordNumber(String name, String field) {
        return tab.number("cameras.seen({name: '" + name + "'})." + field);
    }

    @Test
    public void aRecordWithPicturesShowsThemAtTheirTime() {
        robotLab.run(WORLD + "\n" + String.join("\n",
            "sear.setLockStep(True)",
            "sear.recordRun('seen', 100, 5)",
            "sear.startSimulation()",
            "sear.driveStraight(0.3)",
            "sear.simSleep(2)",
            "sear.stopSimulation()",
            "sear.setLockStep(False)"));
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().sensors.length === 4"));
        browser.click(".sear-plots");
        browser.choose(".sear-source", "seen.searlog");
        browser.seeText(".sear-badge", "Replay of seen.searlog");
        waitForPicture("depth");
        assertEquals("at its start", 0, recordNumber("depth", "time"), 0);
        click("depth", 0.51, 0.51);
        browser.seeText(eye("depth") + ".sear-eye-words", ": 1.400 m ahead");
        browser.script("var s = document.querySelector('.sear-slider'); s.value = s.max; s.dispatchEvent(new "
            + "Event('input', {bubbles: true})); s.dispatchEvent(new Event('change', {bubbles: true}))");
        browser.until("at its end", () -> recordNumber("depth", "time") == 2);
        browser.until("nearer", () -> browser.text(eye("depth") + ".sear-eye-words").contains(": 0.8"));
        browser.click(".sear-back-to-now");
        browser.until("what is now", () -> tab.isTrue("replay.shown === null"));
        assertTrue("pictures can be asked for", browser.all(".sear-record-pictures").size() == 1);
    }
}
