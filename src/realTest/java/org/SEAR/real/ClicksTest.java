// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.junit.runners.Parameterized;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** Clicks in SEAR's panels and in the Python tab on MyRobotLab's own page, at four widths. */
@RunWith(Parameterized.class)
public class ClicksTest extends InPage {
    private final int width;
    private final int height;

    public ClicksTest(int width, int height) {
        this.width = width;
        this.height = height;
    }

    @Parameterized.Parameters(name = "{0} px")
    public static List<Object[]> sizes() {
        return Arrays.stream(SIZES).map(size -> new Object[] {size[0], size[1]}).collect(Collectors.toList());
    }

    @Before
    public void makeThePageSoLarge() {
        page.setSize(width, height);
    }

    @After
    public void letThePageBeAsItsWindow() {
        page.setSize(0, 0);
    }

    private void showProjects() {
        page.await("a layout", "layout.room !== undefined");
        if (page.isTrue("layout.isFolded('project')")) {
            page.browser.click(".sear-fold-project");
        }
    }

    private void openExample(String name) {
        showProjects();
        if (!page.isTrue("welcome.isShown()")) {
            page.browser.click(".sear-open");
        }
        page.browser.click("[data-tile='" + name + "']");
        page.browser.seeText(".sear-last", "opened resource/SEAR/" + name + ".sear");
    }

    @Test
    public void aWorldIsStartedDrivenRecordedAndPlottedByClicks() throws Exception {
        page.open(mrl, "sear");
        openExample("office");
        page.browser.click(".sear-record");
        page.await("a record is asked for", "service.recorded");
        page.browser.click(".sear-start");
        page.await("a running simulation", "world.running !== null && view.fitted");
        page.browser.click(".sear-plots");
        driveByHeldKeysAndFilm();
        double before = page.number("world.running.robots[0].pose[0]");
        page.browser.choose(".sear-add", "office Roomba.x");
        page.browser.click(".sear-forward");
        page.await("half a metre", "world.running.robots[0].pose[0] > " + (before + 0.5));
        page.await("its line beside those of the speed and a sensor", "plot.lines.indexOf('office Roomba.x') === 2 && "
            + "plot.chart().plot"
            + " && plot.chart().lines.length == 3 && plot.chart().lines[2].values.length > 5");
        page.browser.click(".sear-halt");
        page.await("the robot stands", "world.running.robots[0].speed == 0");
        page.browser.click(".sear-stop");
        page.await("the end of the record", "!service.recorded && !service.simulating");
        page.browser.choose(".sear-source", "run.searlog");
        page.await("the record", "replay.shown !== null && plot.names.length > 5");
        page.browser.choose(".sear-replay-speed", "50 \u00d7");
        page.browser.click(".sear-play");
        page.await("played to its end", "!replay.shown.playing && replay.shown.index === "
            + "replay.shown.times.length - 1");
        assertTrue("it shows where the robot was", page.number("world.shown().robots[0].pose[0]") > before + 0.5);
        page.browser.click(".sear-share");
        String shared = Files.readString(page.browser.download("run.html"));
        assertTrue("a page with three.js in it", shared.length() > 500_000);
        assertTrue("and with the beams of the run", shared.contains("\"motion\":{\"path\":\"run.searlog\"")
            && shared.contains("\"ranges\":[\""));
        page.browser.click(".sear-end-replay");
        page.await("what is now", "replay.shown === null");
        Files.delete(mrl.folder().resolve("run.searlog"));
    }

    private void driveByHeldKeysAndFilm() throws IOException {
        page.browser.click(".sear-video");
        page.await("it films", "video.running");
        WebElement view = page.browser.see(".sear-view");
        new Actions(page.browser.driver()).moveToElement(view).click().keyDown("w").perform();
        page.await("forward", "world.running.robots[0].speed > 0.15");
        new Actions(page.browser.driver()).keyUp("w").perform();
        page.await("the robot stands", "world.running.robots[0].speed == 0");
        new Actions(page.browser.driver()).keyDown(Keys.ARROW_DOWN).perform();
        page.await("backward", "world.running.robots[0].speed < -0.15");
        new Actions(page.browser.driver()).keyUp(Keys.ARROW_DOWN).perform();
        page.await("the robot stands again", "world.running.robots[0].speed == 0");
        page.browser.click(".sear-video");
        assertTrue("a film", Files.size(page.browser.download("sear.webm")) > 1000);
        Files.delete(page.browser.downloads().resolve("sear.webm"));
    }

    @Test
    public void anObjectIsBuiltUndoneSavedBesideAndOverAForeignFileAndUploaded() throws Exception {
        page.open(mrl, "sear");
        page.await("an empty project", "world.preview !== null && edits.grammar !== null && world.shown() && "
            + "!world.shown().objects.length");
        page.browser.click("[data-tile='build']");
        page.browser.click(".sear-map");
        page.browser.click(".sear-palette [data-make='Box']");
        page.await("a box to place", "palette.armed && palette.armed.name == 'Box'");
        WebElement view = page.browser.see(".sear-view");
        Dimension size = view.getSize();
        new Actions(page.browser.driver()).moveToElement(view, size.getWidth() / 10, -size.getHeight() / 10)
            .click().perform();
        page.await("the box", "edits.object && edits.object.object == 'box1' && world.shown().objects.length == 1");
        page.browser.click(".sear-undo");
        page.await("no box", "!world.shown().objects.length && edits.undoable === null");
        Path foreign = Files.write(mrl.folder().resolve("maze.sear"), new byte[] {1, 2, 3});
        openExample("maze");
        page.browser.type(".sear-path", "maze.sear");
        page.browser.click(".sear-save");
        page.browser.seeText(".sear-question", "maze.sear already exists.");
        page.browser.click(".sear-beside");
        page.browser.seeText(".sear-last", "saved maze-2.sear");
        Path saved = mrl.folder().resolve("maze-2.sear");
        assertArrayEquals(new byte[] {1, 2, 3}, Files.readAllBytes(foreign));
        page.browser.type(".sear-path", "maze.sear");
        page.browser.click(".sear-save");
        page.browser.click(".sear-overwrite");
        page.browser.seeText(".sear-last", "saved maze.sear");
        assertArrayEquals(Files.readAllBytes(saved), Files.readAllBytes(foreign));
        page.browser.all(".sear-file").get(0).sendKeys(ROOT.resolve("examples/ramps.sear").toString());
        page.await("the uploaded project", "project.path == 'ramps.sear'");
        page.browser.until("its files",
            () -> Files.notExists(mrl.folder().resolve("SEARproject/environment/goal.xml")));
        Files.delete(foreign);
        Files.delete(saved);
    }

    private void startSensors() throws IOException, InterruptedException {
        assertEquals("", mrl.python("sear.setLockStep(False)", "sear.setSpeed(1)",
            "sear.loadProject(" + RealMrl.literal(ROOT + "/examples/sensors.sear") + ")", "sear.startSimulation()"));
    }

    @Test
    public void aLidarIsConnectedScansAndStreamsByClicks() throws Exception {
        startSensors();
        page.open(mrl, "lidar");
        page.browser.type(".lidar-port", "/dev/SEAR_LIDAR_01");
        page.browser.click(".lidar-connect");
        page.browser.until("a connected LIDAR", () -> page.browser.text(".lidar-status").equals("connected"));
        page.browser.click(".lidar-single");
        page.browser.seeText(".lidar-summary", "361 values");
        page.browser.click(".lidar-stream");
        page.browser.seeText(".lidar-summary", "scans/s");
        page.browser.click(".lidar-stop");
        page.browser.until("no stream", () -> page.browser.text(".lidar-status").equals("connected"));
        page.browser.click(".lidar-table");
        page.browser.until("a row for each value", () -> page.browser.all(".lidar-values tbody tr").size() == 361);
        page.browser.click(".lidar-disconnect");
        page.browser.until("no LIDAR", () -> page.browser.text(".lidar-status").equals("not connected"));
    }

    @Test
    public void aReceiverIsConnectedAndShowsItsFixByClicks() throws Exception {
        startSensors();
        page.open(mrl, "gps");
        page.browser.type(".gps-port", "/dev/SEAR_GPS_01");
        page.browser.click(".gps-connect");
        page.browser.seeText(".gps-fix", "GPS");
        page.browser.seeText(".gps-decimal", "33.6");
        page.browser.click(".gps-raw");
        page.browser.seeText(".gps-sentences", "$GPGGA");
        page.browser.click(".gps-disconnect");
        page.browser.until("no receiver", () -> page.browser.text(".gps-status").equals("not connected"));
    }

    @Test
    public void aScriptIsTypedAndExecutedInThePythonTabByClicks() throws Exception {
        page.open(mrl, "python");
        page.browser.click("[ng-click='addScript()']");
        String file = "clicked" + width + ".py";
        page.browser.type(".modal-body input", file);
        page.browser.click(".modal-footer [ng-click='ok()']");
        page.browser.until("the tab of its file", () -> page.browser.all(".nav-tabs a").stream()
            .filter(tab -> tab.getText().startsWith(file)).peek(WebElement::click).count() == 1);
        page.browser.click(".tab-pane.active .ace_content");
        // starts on a line of its own: on a busy machine the text can land in the new script's first comment
        new Actions(page.browser.driver()).sendKeys(Keys.chord(Keys.CONTROL, Keys.END), Keys.ENTER,
            "print sear.getName() + ' says ' + str(7 * "
            + width + ")").perform();
        page.browser.click("[ng-click='exec()']");
        page.browser.seeText("small", "sear says " + 7 * width);
    }
}
