// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.SEAR.web.PythonTab;
import org.SEAR.web.SearPage;
import org.junit.BeforeClass;
import org.junit.Test;
import org.openqa.selenium.Keys;

/** Both tabs offer the driving examples by a click. */
public class DrivingExamplesInTheTabsTest extends SearPage {
    /** Examples of the working folder appear beside those in the jar. */
    @BeforeClass
    public static void bringExamples() throws IOException {
        Path examples = Path.of(System.getProperty("sear.root", ".")).resolve("examples");
        Path target = Files.createDirectories(TABS.robotLab().file("examples/drive"));
        try (Stream<Path> scripts = Files.list(examples.resolve("drive"))) {
            for (Path script : (Iterable<Path>) scripts::iterator) {
                Files.copy(script, target.resolve(script.getFileName()));
            }
        }
    }

    /** Runs in lock-step, so that the program keeps up with its robot on a busy machine. */
    @Test
    public void theSearTabRunsOneAndShowsTheRobotDrive() {
        tab.stopAll();
        robotLab.call("sear", "setLockStep", true);
        browser.script("localStorage.removeItem('python.draft.python')");
        TABS.open("sear");
        browser.until("the list of examples", () -> browser.texts(".sear-script option")
            .contains("obstacle avoidance"));
        browser.choose(".sear-script", "obstacle avoidance");
        browser.click(".sear-run-script");
        tab.waitForRobot("office Roomba");
        browser.until("a running simulation", () -> tab.isTrue("world.running !== null"));
        browser.until("the robot at the goal", () -> Math.hypot(tab.number("world.running.robots[0].pose[0]") - 1.9,
            tab.number("world.running.robots[0].pose[2]") - 1.8) < 0.2);
        assertTrue("no other is begun while one drives", !browser.see(".sear-run-script").isEnabled());
        tab.stopAll();
        assertEquals("the project is called as what the script has opened", "office.sear", browser.see(".sear-path")
            .getAttribute("value"));
        browser.click("#tab-python");
        assertTrue("the script is there to be changed", new PythonTab(browser).text().startsWith("# "));
        assertEquals("obstacle_avoidance.py", browser.see(".python-file").getAttribute("value"));
        browser.click("#tab-sear");
    }

    @Test
    public void thePythonTabShowsOneAndAsksBeforeItReplacesText() {
        TABS.open("python");
        browser.until("the list of examples", () -> browser.texts(".python-example option").contains("maze_solver.py"));
        browser.choose(".python-example", "maze_solver.py");
        PythonTab python = new PythonTab(browser);
        browser.until("the script", () -> python.text().startsWith("# Solves the maze"));
        assertEquals("maze_solver.py", browser.see(".python-file").getAttribute("value"));
        python.type(Keys.chord(Keys.CONTROL, Keys.END), "# mine");
        browser.choose(".python-example", "wall_follower.py");
        browser.seeText(".python-question", "The text below is not saved.");
        browser.click(".python-cancel");
        assertTrue(python.text().endsWith("# mine"));
        browser.choose(".python-example", "wall_follower.py");
        browser.click(".python-go");
        browser.until("the other script", () -> python.text().startsWith("# Follows the wall"));
        assertTrue("nothing is written to the disk", Files.notExists(robotLab.file("wall_follower.py")));
    }
}
