package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Locale;
import org.SEAR.web.Browser;
import org.SEAR.web.SearTab;
import org.SEAR.web.Tabs;
import org.junit.After;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.WebElement;

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
    /** Two runs of two simulated seconds in lock-step, each into a record. */
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
        browser.choose(".sear-add", "roomba.z");
        browser.choose(".sear-add", "ping");
        browser.until("four lines", () -> tab.isTrue("plot.chart() && plot.chart().lines.length == 4"));
        assertEquals(0.6, plot("lines[0].values[plot.chart().lines[0].values.length - 1]"), 0.03);
        assertEquals(0.2, plot("lines[1].values[plot.chart().lines[1].values.length - 1]"), 0.02);
        assertEquals(2, plot("scale.to"), 0.05);
        slideTo("max");
        browser.until("the robot at its end", () -> tab.number("world.shown().robots[0].pose[2]") > 0.55);
        browser.seeText(".sear-note", "run3.searlog at 2.00 s of 2.00 s");
        browser.seeText(".sear-readings-of", "run3.searlog at 2.00 s");
        double read = plot("lines[2].values[plot.chart().lines[2].values.length - 1]");
        browser.seeText("[data-sensor='ping'] .sear-reading", String.format(Locale.ROOT, "%.3f", read));
        browser.seeText("[data-sensor='touch'] .sear-reading", "not pressed");
        browser.seeText("[data-sensor='scanner'] .sear-reading", "nearest ");
        browser.seeText("[data-led='lamp']", "lamp: 100 %");
        slideTo("min");
        browser.seeText("[data-led='lamp']", "lamp: 0 %");
        browser.click(".sear-csv");
        String csv = Files.readString(browser.download("plot.csv"));
        assertTrue(csv, csv.startsWith("time (s) run3.searlog,roomba.z run3.searlog,"));
        browser.choose(".sear-replay-speed", "50 \u00d7");
        browser.click(".sear-play");
        browser.until("played to its end", () -> tab.isTrue("!replay.shown.playing && replay.shown.index === replay.shown.times.length - 1"));
        browser.click(".sear-end-replay");
        browser.until("what is now", () -> tab.isTrue("replay.shown === null && world.shown().robots[0].pose[2] < 0.1"));
    }

    @Test
    public void aReplaySaysSoAndEndsAsSoonAsItsUserTurnsToWhatIsNow() {
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
        browser.type(".sear-path", "examples/office.sear");
        browser.click(".sear-load");
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
        browser.until(how + " takes the words away", () -> browser.all(".sear-badge").stream().noneMatch(WebElement::isDisplayed));
    }

    private void slideTo(String end) {
        browser.script("var s = document.querySelector('.sear-slider'); s.value = s[arguments[0]];"
            + "s.dispatchEvent(new Event('input', {bubbles: true}));"
            + " s.dispatchEvent(new Event('change', {bubbles: true}))", end);
    }

    @Test
    public void theRunIsPlottedWhileItGoesOnAndRecordedByAButton() {
        TABS.robotLab().run(WORLD);
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().robots.length == 1"));
        browser.click(".sear-record");
        browser.until("a record is asked for", () -> tab.isTrue("service.recorded"));
        tab.start();
        browser.click(".sear-plots");
        browser.choose(".sear-add", "ping");
        browser.until("points", () -> tab.isTrue("plot.chart() && plot.chart().lines.length == 1 && plot.chart().lines[0].values.length > 5"));
        browser.click(".sear-forward");
        browser.until("it comes nearer", () -> tab.isTrue("plot.chart().lines[0].values[plot.chart().lines[0].values.length - 1]"
            + " < plot.chart().lines[0].values[3] - 0.05"));
        browser.click(".sear-pause-plot");
        browser.until("held", () -> tab.isTrue("plot.paused !== null"));
        browser.click(".sear-stop");
        browser.until("the record has ended", () -> tab.isTrue("!service.recorded"));
        assertTrue(TABS.robotLab().call("sear", "getRecordNames", "run.searlog").toString().contains("ping"));
    }

    @Test
    public void theProjectIsShownAsItsScript() {
        TABS.robotLab().run(WORLD);
        browser.click(".sear-show-script");
        browser.until("the script", () -> tab.isTrue("script.shown && script.shown.text.indexOf('Box(\"wall\", 4, 0.2, 0.5, 0, 0, 0.25, 3)') > 0"));
        browser.click(".sear-close-script");
        browser.until("closed", () -> tab.isTrue("script.shown === null"));
    }
}
