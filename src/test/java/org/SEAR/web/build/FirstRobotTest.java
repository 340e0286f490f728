// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.build;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.documents.DocBlock;
import org.SEAR.web.Browser;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The tutorial works: its commands, its clicks, its script and the script's output. */
public class FirstRobotTest {
    private static final int LEAST_STEPS = 40;
    private static final int LEAST_BYTES = 2000;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();

    private static int walk(FirstRobot tutorial, Browser browser) throws Exception {
        try {
            return tutorial.walk();
        } catch (AssertionError e) {
            browser.picture(Paths.get(System.getProperty("sear.root", "."), "build/reports/web/FirstRobotTest.png"));
            throw e;
        }
    }

    @Test
    public void theTutorialEndsWithADrivingRobot() throws Exception {
        Path here = folder.getRoot().toPath().toRealPath();
        List<String> pictures = new ArrayList<>();
        try (Browser browser = new Browser(1280, 800);
                FirstRobot tutorial = new FirstRobot(browser, here, (shown, name) -> pictures.add(name))) {
            int steps = walk(tutorial, browser);
            assertTrue(steps + " steps", steps >= LEAST_STEPS);
            assertEquals("each block of the page", DocBlock.of("docs/first-robot.md").size(), tutorial.blocks);
            assertEquals(2, tutorial.printed.size());
            for (String[] printed : tutorial.printed) {
                assertEquals(printed[0], printed[1]);
            }
            assertEquals(List.of(), browser.errors());
        }
        assertEquals(List.of("first-1", "first-2", "first-4"), pictures);
        assertTrue("a plot", Files.size(here.resolve("first.png")) > LEAST_BYTES);
        assertTrue("a record", Files.size(here.resolve("first.searlog")) > LEAST_BYTES);
    }
}
