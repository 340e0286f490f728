// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import org.SEAR.web.SearPage;
import org.junit.Before;
import org.junit.Test;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

/** The SEAR tab's messages hold for the present state only. */
public class StatusLineTest extends SearPage {
    @Before
    public void beginWithABox() {
        robotLab.run("sear.newProject()");
        browser.until("an empty project",
            () -> tab.isTrue("world.shown() && world.shown().objects.length == 0 && edits.grammar !== null"));
        robotLab.run("from org.SEAR.POJOs import Box\nBox('crate', 1, 1, 1)");
        browser.until("the crate", () -> tab.isTrue("world.shown().objects.length == 1"));
    }

    private void type(String css, String text) {
        WebElement field = browser.see(css);
        field.sendKeys(Keys.chord(Keys.CONTROL, "a"));
        field.sendKeys(text, Keys.ENTER);
    }

    private void selectTheCrate() {
        browser.click(".sear-tree button");
        browser.until("the crate selected", () -> tab.isTrue("edits.object && edits.object.name == 'crate'"));
    }

    @Test
    public void aProjectWithoutNameIsNotSaved() {
        browser.see(".sear-path").sendKeys(Keys.chord(Keys.CONTROL, "a"), Keys.DELETE);
        browser.click(".sear-save");
        browser.seeText(".sear-last", "enter a name in the field Project before you save, for example project.sear");
        type(".sear-path", ".sear");
        browser.click(".sear-save");
        browser.seeText(".sear-last", "the path \".sear\" names no file");
        assertFalse(Files.exists(robotLab.file(".sear")));
        type(".sear-path", "y".repeat(300));        // longer than a file name can be
        browser.click(".sear-save");
        browser.seeText(".sear-last", "yyy.sear can't be saved");
        type(".sear-path", "named");
        browser.click(".sear-save");
        browser.seeText(".sear-last", "saved named.sear");
    }

    @Test
    public void undoIsOffInAnotherProject() {
        selectTheCrate();
        type("[data-field='height'] .form-control", "2");
        browser.until("something to undo", () -> tab.isTrue("edits.undoable !== null"));
        browser.click(".sear-new");
        browser.until("nothing to undo", () -> tab.isTrue("edits.undoable === null"));
        browser.click("[data-tile='build']");
        assertFalse(browser.see(".sear-undo").isEnabled());
    }

    @Test
    public void aRejectedNameIsReportedBelowItsFieldAndLeavesNothing() {
        selectTheCrate();
        type("#sear-p-name", "a/b");
        browser.seeText(".sear-name-error", "\"a/b\" is not a valid name here; legal: ");
        browser.until("the name that it has", () -> "crate".equals(browser.see("#sear-p-name").getAttribute("value")));
        type("#sear-p-name", "chest");
        browser.until("another name", () -> tab.isTrue("edits.object && edits.object.name == 'chest'"));
        assertEquals(0, browser.all(".sear-name-error").size());
    }

    @Test
    public void anErrorIsOverWithTheNextEditOrStart() {
        selectTheCrate();
        robotLab.call("sear", "error", "an old error");
        browser.seeText(".sear-last", "an old error");
        type("[data-field='height'] .form-control", "2");
        browser.until("no old error", () -> browser.text(".sear-last").isEmpty());
        robotLab.call("sear", "error", "an old error");
        browser.seeText(".sear-last", "an old error");
        tab.start();
        browser.until("no old error in a run", () -> !browser.text(".sear-last").contains("old"));
        tab.stopAll();
        assertTrue("it can still be read", browser.text(".sear-log").contains("an old error"));
    }

    @Test
    public void theDrawerOfMessagesCountsOnlyUnseenOnes() {
        robotLab.call("sear", "warn", "one");
        browser.seeText(".sear-log", "one");
        assertEquals("it is open", 0, browser.all(".sear-fold-messages .sear-count").size());
        browser.click(".sear-fold-messages");
        robotLab.call("sear", "warn", "two");
        browser.until("a count", () -> browser.texts(".sear-fold-messages .sear-count").contains("1"));
        browser.click(".sear-fold-messages");
        browser.until("no count", () -> browser.all(".sear-fold-messages .sear-count").isEmpty());
    }
}
