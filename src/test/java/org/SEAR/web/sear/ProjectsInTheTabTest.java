// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Base64;
import java.util.List;
import java.util.Random;
import org.SEAR.web.Browser;
import org.SEAR.web.MyRobotLab;
import org.SEAR.web.SearTab;
import org.SEAR.web.Tabs;
import org.junit.Before;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.WebElement;

/** Opening, saving, checking and exchanging projects in the SEAR tab. */
public class ProjectsInTheTabTest {
    @ClassRule
    public static final Tabs TABS = new Tabs("Runtime.start('sear', 'SEAR')");
    /** Size of more than one part of an upload and of a download, bytes. */
    private static final int LARGE = 1_500_000;
    @Rule
    public final TestRule page = TABS.page("sear");
    private final Browser browser = TABS.browser();
    private final MyRobotLab robotLab = TABS.robotLab();
    private final SearTab tab = new SearTab(TABS);

    @Before
    public void stopped() {
        tab.stopAll();
    }

    private Path project(String file) {
        return robotLab.file("SEARproject").resolve(file);
    }

    private static byte[] noise(int size) {
        byte[] bytes = new byte[size];
        new Random(7).nextBytes(bytes);
        return bytes;
    }

    @Test
    public void aProjectIsSavedAndOpenedAgainAndItsPathIsRemembered() {
        tab.openExample("maze");
        browser.type(".sear-path", "kept.sear");
        browser.click(".sear-save");
        browser.until("the bundle", () -> Files.exists(robotLab.file("kept.sear")));
        tab.openExample("ramps");
        browser.until("another project", () -> Files.notExists(project("environment/goal.xml")));
        tab.openPath("kept.sear");
        tab.waitForRobot("maze Roomba");
        tab.start();
        browser.seeText(".sear-robots", "maze Roomba");
        assertTrue(tab.isTrue("project.recent.indexOf('kept.sear') >= 0"));
        for (String css : List.of(".sear-open", ".sear-new")) {
            assertEquals("stop the simulation first", browser.see(css).getAttribute("title"));
        }
        assertFalse("no project is opened while one runs", browser.see(".sear-open").isEnabled());
    }

    /** Waits for the path in the field. */
    private void seePath(String path) {
        browser.until("the path " + path, () -> path.equals(browser.see(".sear-path").getAttribute("value")));
    }

    private byte[] bytes(String file) {
        try {
            return Files.readAllBytes(robotLab.file(file));
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    public void aReplacedWorldIsKeptListedAndBroughtBack() {
        robotLab.run("sear.newProject()\nfrom org.SEAR.POJOs import *\nFloor('ground', 4, 4)\n"
            + "Box('crate', 0.2, 0.2, 0.2).move(1, 0.1, 1)\nRobots.rover('own')");
        tab.waitForRobot("own");
        browser.type(".sear-path", "own.sear");
        browser.click(".sear-save");
        browser.seeText(".sear-main .alert-info", "saved own.sear");
        robotLab.run("from org.SEAR.POJOs import Box\nBox('second', 0.2, 0.2, 0.2).move(1, 0.1, 0)");
        browser.until("the second box", () -> tab.isTrue("world.shown().objects.length == 3"));
        browser.scope(SearTab.ROOT, "edits.select('crate')");
        tab.openExample("maze");
        browser.seeText(".sear-kept", "Your world is kept: own, 2 boxes");
        seePath("maze.sear");
        assertTrue("the inspector follows", tab.isTrue("edits.selected === null"));
        TABS.open("sear");
        seePath("maze.sear");
        tab.showProjects();
        browser.seeText(".sear-welcome", "own, 2 boxes");
        browser.until("pictures",
            () -> tab.isTrue("welcome.groups()[1].tiles[0].plan().indexOf('data:image/svg') == 0"));
        browser.see("[data-tile='own.sear']");
        browser.click(".sear-close-projects");
        browser.click(".sear-new");
        browser.until("an empty project", () -> tab.isTrue("world.isEmpty()"));
        browser.click("[data-tile*='backup']");
        browser.until("the kept world", () -> tab.isTrue("world.shown().objects.length == 3"));
        TABS.open("sear");
        seePath("own.sear");
        browser.click(".sear-save");
        browser.seeText(".sear-main .alert-info", "saved own.sear");
        assertTrue("its own file needs no question", browser.all(".sear-question").isEmpty());
    }

    @Test
    public void foreignFilesAreOnlyOverwrittenOnConfirmation() throws IOException {
        byte[] foreign = {1, 2, 3};
        Files.write(robotLab.file("maze.sear"), foreign);
        tab.openExample("maze");
        seePath("maze.sear");
        browser.click(".sear-save");
        browser.seeText(".sear-question", "maze.sear already exists.");
        browser.click(".sear-cancel");
        browser.until("no question", () -> browser.all(".sear-question").isEmpty());
        assertArrayEquals(foreign, bytes("maze.sear"));
        browser.click(".sear-save");
        browser.click(".sear-beside");
        browser.seeText(".sear-main .alert-info", "saved maze-2.sear");
        seePath("maze-2.sear");
        assertArrayEquals(foreign, bytes("maze.sear"));
        byte[] first = bytes("maze-2.sear");
        robotLab.run("from org.SEAR.POJOs import Box\nBox('one more', 1, 1, 1, 0)");
        browser.click(".sear-save");
        browser.until("its own file is saved again without a question", () -> bytes("maze-2.sear").length
            != first.length);
        browser.type(".sear-path", "maze");
        browser.click(".sear-save");
        browser.click(".sear-overwrite");
        browser.seeText(".sear-main .alert-info", "saved maze.sear");
        assertArrayEquals(bytes("maze-2.sear"), bytes("maze.sear"));
        Files.delete(robotLab.file("maze.sear"));
    }

    @Test
    public void theNameProposedAfterNewAndUploadIsAnother() throws IOException {
        tab.openExample("maze");
        seePath("maze.sear");
        browser.click(".sear-new");
        seePath("project.sear");
        drop("dropped.sear", Files.readAllBytes(MyRobotLab.example("ramps")));
        seePath("dropped.sear");
        browser.type(".sear-path", "shortened");
        browser.click(".sear-save");
        browser.seeText(".sear-main .alert-info", "saved shortened.sear");
        assertFalse(Files.exists(robotLab.file("shortened")));
        tab.openPath("shortened");
        browser.seeText(".sear-main .alert-info", "opened shortened");
    }

    @Test
    public void noFolderIsMadeUnasked() {
        tab.openExample("maze");
        browser.type(".sear-path", "mispelt/x.sear");
        browser.click(".sear-save");
        browser.seeText(".sear-main .alert-danger", "there is no folder " + robotLab.file("mispelt"));
        assertFalse(Files.exists(robotLab.file("mispelt")));
    }

    @Test
    public void myRobotLabsRepetitionOfAnErrorIsDroppedAndOtherwiseShown() {
        robotLab.call("sear", "error", "the door is shut");
        robotLab.call("sear", "error", "could not invoke sear.open ([Ljava.lang.Object;@1b2c) - check logs");
        robotLab.call("sear", "info", "all is well");
        robotLab.call("sear", "error", "could not invoke sear.shut ([Ljava.lang.Object;@1b2d) - check logs");
        browser.seeText(".sear-main .alert-danger", "could not invoke sear.shut");
        assertEquals(2, browser.all(".sear-main .alert-danger").size());
        assertTrue(browser.text(".sear-log").contains("the door is shut"));
    }

    @Test
    public void messagesDoNotPushTheViewDown() {
        tab.openExample("maze");
        int before = browser.see(".sear-view").getLocation().getY();
        for (int i = 0; i < 12; i++) {
            robotLab.call("sear", "error", "failure " + i + "\nwith a second line");
        }
        browser.seeText(".sear-log", "failure 11");
        assertEquals(before, browser.see(".sear-view").getLocation().getY());
        assertEquals("failure 11", browser.text(".sear-last"));
        List<String> texts = browser.texts(".sear-log .alert-danger");
        assertTrue(texts.toString(), texts.get(0).contains("failure 11") && texts.get(11).contains("failure 0"));
        robotLab.call("sear", "error", "failure 11\nwith a second line");
        browser.seeText(".sear-log", "(2 times)");
        assertEquals(12, browser.all(".sear-log .alert-danger").size());
    }

    @Test
    public void theTabReportsAMissingFile() {
        tab.openPath("nix.sear");
        browser.seeText(".sear-main .alert-danger", "there is no file ");
        tab.openPath("nor this.sear");
        browser.seeText(".sear-main .alert-danger", "nor this.sear");
        assertEquals("each is told once", 2, browser.all(".sear-main .alert-danger").size());
        browser.click(".sear-clear");
        browser.until("no messages", () -> browser.all(".sear-main .alert").isEmpty());
        robotLab.call("sear", "loadProject", MyRobotLab.example("maze").toString());
        browser.seeText(".sear-main .alert-info", "opened by another page");
    }

    @Test
    public void theProblemsOfABadProjectAreListed() throws IOException {
        tab.openExample("maze");
        browser.until("the project", () -> Files.exists(project("environment")));
        browser.click(".sear-check");
        browser.seeText(".sear-main .alert-info", "the project has no problems");
        robotLab.run("sear.edit({'do': 'add', 'type': 'Box', 'name': 'mast', 'to': 'maze Roomba', 'set': {'y': 1, "
            + "'mass': 3, 'height': 0.3,"
            + " 'length': 0.04, 'width': 0.04}})");
        browser.click(".sear-check");
        browser.seeText(".sear-main .alert-info", "the project has no problems, but 1 warning");
        browser.seeText(".sear-main .alert-warning", "robot maze Roomba tips over");
        robotLab.run("sear.undo()");
        Files.writeString(project("environment/bad.xml"),
            "<Box>\n<name>bad</name>\n<length>-1</length>\n<color>x</color>\n</Box>\n");
        browser.click(".sear-check");
        browser.seeText(".sear-problems tbody tr", "environment/bad.xml 3 length -1");
        TABS.open("sear");
        browser.click(".sear-start");
        browser.seeText(".sear-problems tbody tr", "environment/bad.xml 3 length -1");
        browser.seeText(".sear-problems tbody tr", "environment/bad.xml 4");
        browser.seeText(".sear-main .alert-danger", "problems, listed below");
        tab.waitForStatus("no simulation runs");
        Files.delete(project("environment/bad.xml"));
    }

    @Test
    public void aBundleIsUploadedInPartsAndDownloadedAgain() throws IOException {
        tab.openExample("maze");
        tab.waitForRobot("maze Roomba");
        byte[] ballast = noise(LARGE);
        Files.createDirectories(project("assets"));
        Files.write(project("assets/ballast.bin"), ballast);
        browser.type(".sear-path", "folder/large.sear");
        browser.click(".sear-download");
        Path large = browser.download("large.sear");
        assertTrue(Files.size(large) > LARGE);
        robotLab.call("sear", "newProject");
        WebElement file = browser.all(".sear-file").get(0);
        file.sendKeys(large.toString());
        browser.seeText(".sear-main .alert-info", "loaded large.sear");
        assertArrayEquals(ballast, Files.readAllBytes(project("assets/ballast.bin")));
        tab.waitForRobot("maze Roomba");
    }

    @Test
    public void onlyThePageThatAskedForADownloadGetsIt() throws IOException {
        tab.openExample("maze");
        tab.waitForRobot("maze Roomba");
        Files.createDirectories(project("assets"));
        Files.write(project("assets/ballast.bin"), noise(LARGE));
        try (Browser other = new Browser(1000, 800)) {
            TABS.open(other, "sear");
            browser.type(".sear-path", "mine.sear");
            browser.click(".sear-download");
            browser.download("mine.sear");
            robotLab.call("sear", "saveProject", "later.sear");
            other.seeText(".sear-last", "saved by another page");
            assertEquals("nothing was loaded beside it", 0, other.downloads().toFile().list().length);
            assertEquals("nor begun", null, other.scope(SearTab.ROOT, "project.transfer"));
        }
    }

    @Test
    public void aDroppedBundleIsOpened() throws IOException {
        tab.openExample("maze");
        tab.waitForRobot("maze Roomba");
        drop("dropped.sear", Files.readAllBytes(MyRobotLab.example("ramps")));
        browser.seeText(".sear-main .alert-info", "loaded dropped.sear");
        tab.waitForRobot("climber");
    }

    @Test
    public void aDroppedOrChosenRobotInUrdfIsAdded() throws IOException {
        tab.openExample("maze");
        tab.waitForRobot("maze Roomba");
        Path arm = MyRobotLab.example("maze").resolveSibling("arm.urdf");
        drop("arm.urdf", Files.readAllBytes(arm));
        browser.seeText(".sear-main .alert-info", "loaded arm.urdf");
        tab.waitForRobot("arm");
        assertTrue(Files.exists(project("robot/maze Roomba.xml")));
        browser.all(".sear-file").get(1).sendKeys(arm.toAbsolutePath().normalize().toString());
        tab.waitForRobot("arm_2");
    }

    @Test
    public void aDroppedFileOtherThanABundleIsRejectedAndTheProjectStays() throws IOException {
        tab.openExample("maze");
        tab.waitForRobot("maze Roomba");
        drop("nonsense.sear", noise(100));
        browser.see(".sear-main .alert-danger");
        browser.seeText(".sear-main .alert-danger", "nonsense.sear");
        assertFalse(browser.text(".sear-main .alert-danger"), browser.text(".sear-main .alert-danger")
            .contains("/tmp"));
        browser.until("no upload", () -> tab.isTrue("project.transfer === null"));
        tab.waitForRobot("maze Roomba");
    }

    /** Simulates a dropped file. */
    private void drop(String name, byte[] content) {
        browser.script("var text = atob(arguments[1]); var bytes = new Uint8Array(text.length);"
            + "for (var i = 0; i < text.length; i++) { bytes[i] = text.charCodeAt(i) }"
            + "var data = new DataTransfer(); data.items.add(new File([bytes], arguments[0]));"
            + "var event = function(type) { return new DragEvent(type, {dataTransfer: data, bubbles: true, "
            + "cancelable: true}) };"
            + "arguments[2].dispatchEvent(event('dragover')); arguments[2].dispatchEvent(event('drop'))",
            name, Base64.getEncoder().encodeToString(content), browser.see(SearTab.ROOT));
    }

    @Test
    public void templatesAreCopiedOnce() throws IOException {
        browser.choose(".sear-template", "controller");
        browser.type(".sear-folder", "scripts of mine");
        browser.click(".sear-copy");
        browser.seeText(".sear-main .alert-info", "controller.py");
        assertTrue(Files.readString(robotLab.file("scripts of mine/controller.py")).contains("def "));
        browser.click(".sear-copy");
        browser.seeText(".sear-main .alert-danger", "already exists");
    }

    @Test
    public void aNewProjectIsEmptyAndTheOldOneIsKept() throws IOException {
        tab.openExample("maze");
        tab.waitForRobot("maze Roomba");
        Files.writeString(project("environment/goal.xml"), "<!-- changed: untouched examples are not kept -->",
            StandardOpenOption.APPEND);
        browser.click(".sear-new");
        browser.seeText(".sear-kept", "Your world is kept: maze Roomba");
        browser.until("no project", () -> Files.notExists(project("robot")));
        browser.until("nothing to start", () -> !browser.see(".sear-start").isEnabled());
        browser.seeText(".sear-welcome", "Where do you want to begin?");
        assertEquals("no simulation runs", browser.text(".sear-status"));
    }
}
