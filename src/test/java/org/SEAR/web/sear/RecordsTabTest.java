// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.SEAR.web.Browser;
import org.SEAR.web.SearTab;
import org.SEAR.web.Tabs;
import org.junit.After;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.By;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** Plots, records and the script of the project in the SEAR tab. */
public class RecordsTabTest {
    @ClassRule
    public static final Tabs TABS = new Tabs("sear = Runtime.start('sear', 'SEAR')");
    private static final String WORLD = String.join("\n",
        "from org.SEAR.POJOs import Box, Bumper, Distance, Floor, Led, LIDAR, Robots",
        "sear.newProject()",
        "Floor('floor', 8, 8)",
        "Box('wall', 4, 0.2, 0.5, 0).move(0, 0.25, 3)",
        "robot = Robots.create2('roomba')",
        "robot.addComponent(Distance('ping', 'laser', 0, 0.1, 0, 0, 0, 0))",
        "robot.addComponent(Bumper('touch'))",
        "robot.addComponent(LIDAR('scanner', 8, 180, 1, 0, 0.2, 0))",
        "robot.addComponent(Led('lamp'))");
    /** Two runs of two simulated seconds in lock-step, each recorded. */
    private static final String RUNS = String.join("\n",
        "sear.setLockStep(True)",
        "for speed in (0.1, 0.3):",
        "    sear.recordRun('run%d' % (10 * speed))",
        "    sear.startSimulation()",
        "    sear.driveStraight(speed)",
        "    sear.simSleep(1)",
        "    sear.setLed('lamp', 1)",
        "    sear.simSleep(1)",
        "    sear.stopSimulation()",
        "sear.setLockStep(False)");

    @Rule
    public final TestRule page = TABS.page("sear");
    private final Browser browser = TABS.browser();
    private final SearTab tab = new SearTab(TABS);

    @After
    public void stop() {
        if (TABS.robotLab().call("sear", "isSimulating").asBoolean()) {
            TABS.robotLab().call("sear", "stopSimulation");
        }
    }

    private double plot(String expression) {
        return tab.number("plot.chart()." + expression);
    }

    @Test
    public void valuesOfTheRunAndOfRecordsAreDrawnAndTheRecordIsShownAgain() throws IOException {
        TABS.robotLab().run(WORLD + "\n" + RUNS);
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().robots.length == 1"));
        browser.click(".sear-map");
        browser.click(".sear-plots");
        browser.choose(".sear-source", "run3.searlog");
        browser.until("the record", () -> tab.isTrue("replay.shown !== null && plot.names.length > 5"));
        assertEquals("at its start", 0, tab.number("world.shown().robots[0].pose[2]"), 0.01);
        browser.choose(".sear-other", "run1.searlog");
        browser.until("speed and first sensor by themselves",
            () -> tab.isTrue("plot.lines.join() === 'roomba.speed,ping'"));
        browser.click("[aria-label='Plot roomba.speed no more']");
        browser.choose(".sear-add", "roomba.z");
        browser.choose(".sear-add", "roomba.speed");
        browser.until("six lines", () -> tab.isTrue("plot.chart() && plot.chart().lines.length == 6"));
        assertEquals(0.6, plot("lines[2].values[plot.chart().lines[2].values.length - 1]"), 0.03);
        assertEquals(0.2, plot("lines[3].values[plot.chart().lines[3].values.length - 1]"), 0.02);
        browser.until("all of it is drawn", () -> tab.isTrue("plot.chart().seen() !== null"));
        assertEquals(2, plot("seen()[1]"), 0.05);
        assertEquals("an axis for each unit, with title and unit",
            List.of("simulated time (s)", "length (m)", "roomba.speed (m/s)"),
            browser.script("var chart = angular.element(document.querySelector('.sear-main')).scope().plot.chart();"
                + "return chart.plot.axes.map(axis => axis.label)"));
        assertTrue("the other record in broken lines",
            tab.isTrue("!plot.chart().plot.series[1].dash && plot.chart().plot.series[2].dash.length === 2"));
        assertRangesAreChosenByMouse();
        slideTo("max");
        browser.until("the robot at its end", () -> tab.number("world.shown().robots[0].pose[2]") > 0.55);
        browser.seeText(".sear-note", "run3.searlog at 2.00 s of 2.00 s");
        browser.seeText(".sear-readings-of", "run3.searlog at 2.00 s");
        double read = plot("lines[0].values[plot.chart().lines[0].values.length - 1]");
        browser.seeText("[data-sensor='ping'] .sear-reading", String.format(Locale.ROOT, "%.3f", read));
        browser.seeText("[data-sensor='touch'] .sear-reading", "not pressed");
        browser.seeText("[data-sensor='scanner'] .sear-reading", "nearest ");
        browser.seeText("[data-led='lamp']", "lamp: 100 %");
        slideTo("min");
        browser.seeText("[data-led='lamp']", "lamp: 0 %");
        browser.click(".sear-csv");
        String csv = Files.readString(browser.download("plot.csv"));
        assertTrue(csv, csv.startsWith("time (s) run3.searlog,ping (m) run3.searlog,"));
        browser.click(".sear-png");
        BufferedImage picture = ImageIO.read(browser.download("plot.png").toFile());
        assertTrue("as wide as the plot, with its lines' names", picture.getWidth() > 600 && picture.getHeight() > 250);
        browser.choose(".sear-replay-speed", "50 \u00d7");
        browser.click(".sear-play");
        browser.until("played to its end",
            () -> tab.isTrue("!replay.shown.playing && replay.shown.index === replay.shown.times.length - 1"));
        browser.click(".sear-end-replay");
        browser.until("what is now", () ->
            tab.isTrue("replay.shown === null && world.shown().robots[0].pose[2] < 0.1"));
    }

    /** The run continues behind the replay, so that driving would be invisible. */
    @Test
    public void nothingDrivesWhileAReplayIsShown() {
        TABS.robotLab().run(WORLD + "\n" + RUNS);
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().robots.length == 1"));
        browser.click(".sear-plots");
        browser.click(".sear-map");
        tab.start();
        browser.see(".sear-driving");
        replay();
        browser.until("no buttons that drive", () -> browser.all(".sear-driving").isEmpty());
        browser.see(".sear-view").sendKeys("u");
        tab.waitForTime(tab.time() + 1);
        assertEquals("nor keys", 0, tab.number("world.running.robots[0].pose[2]"), 0.01);
        browser.click(".sear-back-to-now");
        browser.see(".sear-driving");
    }

    @Test
    public void aLongNameLeavesTheUnitBesideItsAxis() {
        TABS.robotLab().run(WORLD.replace("'roomba'", "'the vacuum cleaner of the living room upstairs'"));
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().robots.length == 1"));
        browser.click(".sear-plots");
        browser.until("its speed", () ->
            tab.isTrue("plot.chart() && plot.chart().titles()[0].title.indexOf('the v') === 0"));
        String title = tab.text("plot.chart().titles()[0].title");
        assertTrue(title, title.endsWith("speed (m/s)") && title.contains("\u2026"));
        assertTrue("it has room", Boolean.TRUE.equals(
            browser.script("var chart = angular.element(document.querySelector('.sear-main')).scope()"
            + ".plot.chart(), pen = document.createElement('canvas').getContext('2d'); pen.font = '12px system-ui, "
            + "sans-serif';"
            + "return pen.measureText(chart.plot.axes[1].label).width < chart.size().height - 30")));
    }

    @Test
    public void aReplayIsMarkedAndEndsWithTheFirstLiveAction() {
        TABS.robotLab().run(WORLD + "\n" + RUNS);
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().robots.length == 1"));
        browser.click(".sear-plots");
        replay();
        browser.click(".sear-back-to-now");
        assertEnded("the button");
        browser.click(".sear-replay");
        browser.seeText(".sear-badge", "Replay of run3.searlog");
        browser.click(".sear-build");
        assertEnded("Build");
        browser.click(".sear-build");
        browser.click(".sear-replay");
        browser.seeText(".sear-badge", "Replay of run3.searlog");
        browser.click(".sear-plots");
        assertEnded("folding the plots");
        browser.click(".sear-plots");
        browser.click(".sear-replay");
        browser.seeText(".sear-badge", "Replay of run3.searlog");
        tab.start();
        assertEnded("Start");
        browser.until("this run is plotted", () -> tab.isTrue("plot.source === ''"));
        browser.click(".sear-stop");
        tab.waitForStatus("no simulation runs");
        replay();
        tab.openExample("maze");
        assertEnded("an example");
        browser.until("the maze", () -> tab.isTrue("world.shown().objects.length > 5"));
        replay();
        tab.openPath("examples/office.sear");
        assertEnded("Open");
        browser.until("the office", () -> tab.isTrue("world.shown().robots[0].name === 'office Roomba'"));
        replay();
        browser.click(".sear-new");
        assertEnded("New");
    }

    private void replay() {
        browser.choose(".sear-source", "run3.searlog");
        browser.seeText(".sear-badge", "Replay of run3.searlog");
    }

    private void assertEnded(String how) {
        browser.until(how + " ends the replay", () -> tab.isTrue("replay.shown === null && world.instead === null"));
        browser.until(how + " takes the words away", () -> browser.all(".sear-badge").stream()
            .noneMatch(WebElement::isDisplayed));
    }

    @Test
    public void aRecordIsSharedAsOnePageThatPlaysItWithoutSearAndFilmed() throws IOException {
        TABS.robotLab().run(WORLD + "\n" + RUNS);
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().robots.length == 1"));
        browser.click(".sear-plots");
        assertFalse("there is nothing to share", browser.see(".sear-share").isEnabled());
        replay();
        film();
        browser.script("angular.element(document.querySelector('.sear-main')).scope()"
            + ".replay.shown.world.objects[0].note = 'x'.repeat(24e6)");
        browser.click(".sear-share");
        browser.seeText(".sear-main .alert-danger", "MB, legal: at most 24 MB");
        browser.script("delete angular.element(document.querySelector('.sear-main')).scope()"
            + ".replay.shown.world.objects[0].note");
        browser.click(".sear-share");
        Path page = browser.download("run3.html");
        Path film = browser.download("sear.webm");
        browser.driver().get(film.toUri().toString());
        browser.until("a film that can be seen",
            () -> Boolean.TRUE.equals(browser.script("return document.querySelector('video').videoWidth > 300")));
        browser.driver().get(page.toUri().toString());
        browser.until("the robot drives on its own", () -> inPlayer("robots[0].shown[2]") > 0.5);
        assertEquals("in the shapes and pictures that it had", Boolean.TRUE,
            browser.script("return player.scene.objects.concat("
            + "player.scene.robots[0].parts).every(item => item.dressed) && "
                + "Object.keys(player.scene.looks.textures).length > 1"));
        assertBeamsAndWheels();
        browser.until("its lamp is lit", () -> inPlayer("robots[0].lights[0].bulb.material.color.r") > 0.9);
        browser.script("var slider = document.getElementById('slider'); slider.value = 0; slider.oninput()");
        browser.until("back at its start", () -> inPlayer("robots[0].shown[2]") < 0.01);
        browser.click("#play");
        browser.until("it drives again", () -> inPlayer("robots[0].shown[2]") > 0.3);
        assertEquals("nothing is fetched", 0L,
            browser.script("return performance.getEntriesByType('resource').filter(one => "
                + "/^http/.test(one.name)).length"));
        TABS.open("sear");
    }

    /** Checks beams and wheels against the live view. */
    private void assertBeamsAndWheels() {
        browser.until("its wheels turn",
            () -> inPlayer("robots[0].parts.filter(part => part.source.type === 'Wheel' && part.shown"
            + " && Math.abs(part.shown[3]) > 0.01).length") > 1);
        String scanner = "sensors.filter(one => one.source.name.endsWith('scanner'))[0].";
        browser.until("a beam ends on the wall", () ->
            Math.abs(inPlayer(scanner + "source.ranges[90]") + inPlayer(scanner + "source.pose[2]") - 2.9) < 0.03);
        assertTrue("with the others it is a fan", inPlayer(scanner + "fan.geometry.attributes.position.array.length")
            == 9 * 180);
        browser.until("the laser's spot is on it",
            () -> Math.abs(inPlayer("sensors.filter(one => one.source.name.endsWith('ping'))[0].hit.position.z")
                - 2.9) < 0.01);
        assertEquals(1, inPlayer(scanner + "holder.visible ? 1 : 0"), 0);
        browser.click("#beams");
        browser.until("no beams", () -> inPlayer("sensors.filter(one => one.holder.visible).length") == 0);
    }

    @Test
    public void aRecordOfAProjectThatHasChangedIsSharedWithoutItsBeams() throws IOException {
        TABS.robotLab().run(WORLD + "\n" + RUNS + "\nBox('another', 1, 1, 1, 0).move(3, 0.5, -3)");
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().objects.length == 3"));
        browser.click(".sear-plots");
        browser.choose(".sear-source", "run1.searlog");
        browser.seeText(".sear-badge", "Replay of run1.searlog");
        browser.click(".sear-share");
        browser.seeText(".sear-main .alert-info", "without beams and wheel rotation: run1.searlog is of "
            + "another project");
        browser.driver().get(browser.download("run1.html").toUri().toString());
        browser.until("the robot drives", () -> inPlayer("robots[0].shown[2]") > 0.1);
        assertFalse("there are none to be shown", browser.driver().findElement(By.id("beams")).isDisplayed());
        TABS.open("sear");
    }

    private double inPlayer(String expression) {
        return ((Number) browser.value(expression,
            () -> browser.script("return typeof player === 'undefined' || !player.scene.robots[0].shown ? null"
            + " : player.scene." + expression))).doubleValue();
    }

    private void film() {
        browser.click(".sear-video");
        browser.until("it films", () -> tab.isTrue("video.running"));
        browser.click(".sear-play");
        browser.until("a second of it", () -> tab.number("replay.time()") > 1);
        browser.click(".sear-video");
        browser.seeText(".sear-main .alert-info", "saved the video as sear.webm");
    }

    private void assertRangesAreChosenByMouse() {
        WebElement over = browser.see(".sear-plot .u-over");
        new Actions(browser.driver()).moveToElement(over).clickAndHold().moveByOffset(100, 0).moveByOffset(50, 0)
            .release().perform();
        browser.until("a part of it", () -> tab.isTrue("plot.chart().seen()[0] > 0.9 && plot.chart().seen()[1] < 1.6"));
        new Actions(browser.driver()).doubleClick(browser.see(".sear-plot .u-over")).perform();
        browser.until("all again", () -> tab.isTrue("plot.chart().range === null && plot.chart().seen()[0] < 0.1"));
    }

    private void slideTo(String end) {
        browser.script("var s = document.querySelector('.sear-slider'); s.value = s[arguments[0]];"
            + "s.dispatchEvent(new Event('input', {bubbles: true}));"
            + " s.dispatchEvent(new Event('change', {bubbles: true}))", end);
    }

    @Test
    public void aRunIsPlottedLiveAndRecordedByAButton() {
        TABS.robotLab().run(WORLD.replace("'ping'", "'constructor'"));     // a name that every JavaScript object has
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().robots.length == 1"));
        browser.click(".sear-plots");
        browser.seeText(".sear-plot-hint", "Start the simulation, or choose a record");
        browser.click(".sear-record");
        browser.until("a record is asked for", () -> tab.isTrue("service.recorded"));
        tab.start();
        browser.until("no hint", () -> browser.all(".sear-plot-hint").stream().noneMatch(WebElement::isDisplayed));
        browser.until("points", () -> tab.isTrue(
            "plot.chart() && plot.chart().lines.length == 2 && plot.chart().lines[1].values.length > 5"));
        browser.click(".sear-forward");
        browser.until("it comes nearer",
            () -> tab.isTrue("plot.chart().lines[1].values[plot.chart().lines[1].values.length - 1]"
            + " < plot.chart().lines[1].values[3] - 0.05"));
        browser.click(".sear-pause-plot");
        browser.until("held", () -> tab.isTrue("plot.paused !== null"));
        browser.click(".sear-stop");
        browser.until("the record has ended", () -> tab.isTrue("!service.recorded"));
        assertTrue(TABS.robotLab().call("sear", "getRecordNames", "run.searlog").toString().contains("constructor"));
    }

    @Test
    public void theProjectIsShownAsItsScript() {
        TABS.robotLab().run(WORLD);
        browser.click(".sear-show-script");
        browser.until("the script", () -> tab.isTrue("script.shown && script.shown.text.indexOf('Box(\"wall\", 4, 0.2, "
            + "0.5, 0, 0, 0.25, 3)') > 0"));
        browser.click(".sear-close-script");
        browser.until("closed", () -> tab.isTrue("script.shown === null"));
    }
}
