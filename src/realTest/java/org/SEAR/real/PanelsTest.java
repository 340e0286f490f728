package org.SEAR.real;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.After;
import org.junit.AfterClass;
import org.junit.Before;
import org.junit.BeforeClass;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.junit.rules.TestWatcher;
import org.junit.runner.Description;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** SEAR's panels in MyRobotLab's own page: what they look like at four widths, and what they do when one clicks. */
public class PanelsTest extends InRealMrl {
    private static final int[][] SIZES = {{800, 1000}, {1024, 768}, {1366, 768}, {1920, 1080}};
    /**
     * Of the service in front: panels of SEAR's that are off from the sides of its area or reach into the header, rows of MyRobotLab's that are off
     * from the sides, and what stands out to the right.
     */
    private static final String FAULTS = String.join("\n",
        "var area = [].find.call(document.querySelectorAll('.tab-content > div'), function(e) { return e.getClientRects().length })",
        "var own = [].slice.call(area.querySelectorAll(':scope > .sear-panel, :scope > .row')), faults = []",
        "var frame = area.getBoundingClientRect(), header = area.querySelector('.tab-header').getBoundingClientRect()",
        "own.forEach(function(e) {",
        "    var box = e.getBoundingClientRect(), margin = e.matches('.row') ? 15 : 0",
        "    var gaps = [box.left + margin - frame.left, frame.right + margin - box.right, margin ? 0 : Math.min(0, box.top - header.bottom)]",
        "    if (gaps.some(function(gap) { return Math.abs(gap) > 1 })) { faults.push(e.className + ' is off by ' + gaps) }",
        "})",
        "area.querySelectorAll('.sear-panel *').forEach(function(e) {",
        "    if (e.getClientRects().length && e.getBoundingClientRect().right > frame.right + 1 && !e.closest('svg, .sear-file, .sear-log')) {",
        "        faults.push('cut off: ' + e.outerHTML.substring(0, 100))",
        "    }",
        "})",
        "return own.length ? faults : ['nothing is there']");
    private static Page page;

    /** Keeps what the page showed. */
    @Rule
    public final TestRule pictures = new TestWatcher() {
        @Override
        protected void failed(Throwable e, Description test) {
            try {
                page.keep("failed-" + test.getMethodName());
            } catch (IOException | RuntimeException second) {
                e.addSuppressed(second);
            }
        }
    };

    @BeforeClass
    public static void openTheBrowser() throws IOException {
        page = new Page();
    }

    @AfterClass
    public static void closeTheBrowser() {
        page.close();
    }

    @Before
    public void startTheServices() throws Exception {
        assertEquals("", mrl.python("sear = Runtime.start('sear', 'SEAR')", "lidar = Runtime.start('lidar', 'LIDAR')",
            "gps = Runtime.start('gps', 'GPS')"));
    }

    @After
    public void lookAtTheConsole() {
        page.checkConsole();
    }

    @Test
    public void eachPanelFillsItsServicesAreaAtEveryWidth() throws Exception {
        assertEquals("", mrl.python("sear.loadProject(" + RealMrl.literal(ROOT + "/examples/sensors.sear") + ")", "sear.startSimulation()",
            "lidar.connect('/dev/SEAR_LIDAR_01')", "gps.connect('/dev/SEAR_GPS_01')", "lidar.singleScan()"));
        page.open(mrl, "sear");
        for (String service : List.of("sear", "lidar", "gps", "python")) {
            page.show(service);
            for (int[] size : SIZES) {
                page.setSize(size[0], size[1]);
                String what = service + "-" + size[0];
                page.browser.until("the panel " + what + " in its place", () -> List.of().equals(page.browser.script(FAULTS)));
                page.keep(what);
                checkWhatOneNeeds(service);
            }
        }
        page.setSize(0, 0);
    }

    /** The controls that were beside the header, or of no width. */
    private void checkWhatOneNeeds(String service) {
        List<String> controls = Map.of("sear", List.of(".sear-start", ".sear-stop", ".sear-stage canvas", ".sear-record"),
            "lidar", List.of(".lidar-port", ".sear-lidar canvas, .sear-lidar svg"), "gps", List.of(".gps-port", ".sear-gps table"),
            "python", List.of("[ng-click='exec()']")).get(service);
        for (String css : controls) {
            assertTrue(css + " is wide enough", page.browser.see(css).getSize().getWidth() >= 40);
        }
    }

    /** MyRobotLab's page is always light. */
    @Test
    public void wordsCanBeReadWhereTheUserPrefersDarkPages() {
        page.browser.setTheme("dark");
        try {
            page.open(mrl, "sear");
            page.browser.seeText(".sear-note", "Not running");
            assertEquals("#fff around black words", "rgb(255, 255, 255)", page.browser.script(
                "return getComputedStyle(document.querySelector('.sear-note')).textShadow.match(/rgb[^)]*\\)/)[0]"));
        } finally {
            page.browser.setTheme("light");
        }
    }

    private void openExample(String name) {
        page.browser.choose(".sear-example", "resource/SEAR/" + name + ".sear");
        page.browser.seeText(".sear-last", "opened resource/SEAR/" + name + ".sear");
    }

    @Test
    public void aWorldIsStartedDrivenRecordedAndPlottedByClicks() throws Exception {
        page.open(mrl, "sear");
        openExample("office");
        page.browser.click(".sear-record");
        page.await("a record is asked for", "service.recorded");
        page.browser.click(".sear-start");
        page.await("a running simulation", "state !== null && view.fitted");
        double before = page.number("state.robots[0].pose[0]");
        page.browser.click(".sear-plots");
        page.browser.choose(".sear-add", "office Roomba.x");
        page.browser.click(".sear-forward");
        page.await("half a metre", "state.robots[0].pose[0] > " + (before + 0.5));
        page.await("a line", "plot() && plot().lines.length == 1 && plot().lines[0].values.length > 5");
        page.browser.click(".sear-halt");
        page.await("the robot stands", "state.robots[0].speed == 0");
        page.browser.click(".sear-stop");
        page.await("the end of the record", "!service.recorded && !service.simulating");
        page.browser.choose(".sear-source", "run.searlog");
        page.await("the record", "replay !== null && names.length > 5");
        page.browser.choose(".sear-replay-speed", "50 \u00d7");
        page.browser.click(".sear-play");
        page.await("played to its end", "!replay.playing && replay.index === replay.times.length - 1");
        assertTrue("it shows where the robot was", page.number("world().robots[0].pose[0]") > before + 0.5);
        page.browser.click(".sear-end-replay");
        page.await("what is now", "replay === null");
        Files.delete(mrl.folder().resolve("run.searlog"));
    }

    @Test
    public void aThingIsBuiltTakenBackSavedBesideAForeignFileAndUploaded() throws Exception {
        page.open(mrl, "sear");
        page.await("an empty project", "preview !== null && grammar !== null && world() && !world().objects.length");
        page.browser.click(".sear-map");
        page.browser.click(".sear-build");
        page.browser.click(".sear-palette [data-make='Box']");
        page.await("a box to place", "armed && armed.name == 'Box'");
        WebElement view = page.browser.see(".sear-view");
        Dimension size = view.getSize();
        new Actions(page.browser.driver()).moveToElement(view, size.getWidth() / 10, -size.getHeight() / 10).click().perform();
        page.await("the box", "object && object.object == 'box1' && world().objects.length == 1");
        page.browser.click(".sear-undo");
        page.await("no box", "!world().objects.length && undoable === null");
        Path foreign = Files.write(mrl.folder().resolve("maze.sear"), new byte[] {1, 2, 3});
        openExample("maze");
        page.browser.type(".sear-path", "maze.sear");
        page.browser.click(".sear-save");
        page.browser.seeText(".sear-question", "maze.sear is there already, and this page did not write it.");
        page.browser.click(".sear-beside");
        Path saved = mrl.folder().resolve("maze-2.sear");
        page.browser.until("a bundle beside it", () -> Files.exists(saved));
        assertArrayEquals(new byte[] {1, 2, 3}, Files.readAllBytes(foreign));
        page.browser.all(".sear-file").get(0).sendKeys(ROOT.resolve("examples/ramps.sear").toString());
        page.await("the uploaded project", "form.path == 'ramps.sear'");
        page.browser.until("its files", () -> Files.notExists(mrl.folder().resolve("SEARproject/environment/goal.xml")));
        Files.delete(foreign);
        Files.delete(saved);
    }
}
