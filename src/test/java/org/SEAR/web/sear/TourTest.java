// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.web.SearPage;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** The tour leads from an empty page to a driving robot and advances when a step is done. */
public class TourTest extends SearPage {
    @Before
    public void beginAsAStranger() {
        robotLab.run("sear.newProject()");
        browser.script("localStorage.removeItem('sear.folds')");
        TABS.open("sear");
        browser.until("an empty project", () -> tab.isTrue("world.shown() && world.isEmpty()"));
        browser.click("[data-tile='tour']");
        waitForStep(0, "Choose a robot");
    }

    @After
    public void stop() {
        tab.stopAll();
    }

    private void waitForStep(int number, String title) {
        browser.until("step " + number, () -> tab.isTrue("tour.step === " + number));
        browser.seeText(".driver-popover-title", title);
    }

    private void put(String what, int number, String title) {
        browser.click("[data-make='" + what + "']");
        waitForStep(number, title);
        browser.click(".sear-middle");
    }

    /** Follows the tour up to the step that places a box in the robot's way. */
    private void goToTheObstacle() {
        put("rover", 1, "Put it on the ground");
        waitForStep(2, "Give it an eye");
        put("Distance", 3, "Mount it");
        waitForStep(4, "An obstacle");
        browser.click("[data-make='Box']");
        waitForStep(5, "In its way");
    }

    @Test
    public void eachStepThatIsDoneMakesRoomForTheNext() {
        goToTheObstacle();
        WebElement view = browser.see(".sear-stage canvas");
        Dimension size = view.getSize();
        new Actions(browser.driver()).moveToElement(view, size.getWidth() / 4, 0).click().perform();
        waitForStep(6, "Start");
        browser.click(".sear-test-drive");
        waitForStep(7, "Drive");
        browser.click(".sear-forward");
        waitForStep(8, "See what it did");
        browser.click(".sear-plots");
        waitForStep(9, "Stop");
        browser.click(".sear-stop");
        waitForStep(10, "It is a script, too");
        browser.click(".sear-fold-scripts");
        waitForStep(11, "It is a script, too");
        browser.click(".sear-show-script");
        waitForStep(12, "That is your first robot");
        assertTrue(tab.isTrue("script.shown.text.indexOf('Distance') > 0"));
        browser.click(".driver-popover-next-btn");
        browser.until("the end of the tour", () -> tab.isTrue("tour.step === null"));
        assertEquals("nothing covers the page", 0, browser.all(".driver-overlay").size());
    }

    /** Waits until an object of the palette is visible in it and marked. */
    private void seeInThePalette(String make) {
        browser.until(make + " in sight", () -> Boolean.TRUE.equals(browser.script(
            "var thing = document.querySelector('[data-make=\"' + arguments[0] + '\"].sear-marked');"
            + "var inside = thing && thing.closest('.sear-inside').getBoundingClientRect(), at = thing && "
            + "thing.getBoundingClientRect();"
            + "return Boolean(thing) && at.top >= inside.top && at.bottom <= inside.bottom && at.bottom <= "
                + "window.innerHeight", make)));
    }

    @Test
    public void clickTargetsAreVisibleOnSmallPages() {
        for (int[] size : new int[][] {{1280, 800}, {1024, 768}}) {
            browser.setPageSize(size[0], size[1]);
            try {
                seeInThePalette("rover");
                put("rover", 1, "Put it on the ground");
                waitForStep(2, "Give it an eye");
                seeInThePalette("Distance");
                put("Distance", 3, "Mount it");
                waitForStep(4, "An obstacle");
                seeInThePalette("Box");
                assertEquals("nothing else is marked", 1, browser.all(".sear-marked").size());
                beginAsAStranger();
            } finally {
                browser.setPageSize(0, 0);
            }
        }
    }

    @Test
    public void aBoxBesideTheWayIsReported() {
        goToTheObstacle();
        WebElement view = browser.see(".sear-view");
        onMap(view, 0.5, -1.5).click().perform();
        browser.seeText(".driver-popover-description", "That box is not in the rover's way. Drag it");
        assertEquals("still the same step", 5, tab.number("tour.step"), 0);
        browser.until("a box that can be dragged",
            () -> tab.isTrue("edits.object && edits.object.type == 'Box' && building.found() !== null"));
        onMap(view, 0.5, -1.5).clickAndHold().perform();
        onMap(view, 0, 0.5).perform();
        onMap(view, 0, 1).release().perform();
        waitForStep(6, "Start");
    }

    private Actions onMap(WebElement view, double x, double z) {
        double[] at = tab.toScreen(x, z);
        Dimension size = view.getSize();
        return new Actions(browser.driver()).moveToElement(view, (int) Math.round(at[0]) - size.getWidth() / 2,
            (int) Math.round(at[1]) - size.getHeight() / 2);
    }

    @Test
    public void theAxesOfWhichItSpeaksAreOnTheMap() {
        browser.until("a red axis to the north", () -> has(tab.colour(1.2, 0), 24, 8));
        browser.until("a blue one to the east", () -> has(tab.colour(0, 1.2), 8, 24));
        browser.click(".driver-popover-close-btn");
        browser.until("the end of the tour", () -> tab.isTrue("tour.step === null"));
        browser.click("[data-make='rover']");
        browser.click(".sear-middle");
        browser.until("a rover on its floor",
            () -> tab.isTrue("world.shown().robots.length == 1 && world.shown().objects.length == 1"));
        browser.until("the axis on the floor, too", () -> has(tab.colour(1.2, 0), 24, 8));
        browser.click(".sear-build");
        browser.until("no axis where nobody builds", () -> !has(tab.colour(1.2, 0), 24, 8));
    }

    /** Returns whether one channel of a colour clearly exceeds another; channels are bit offsets. */
    private static boolean has(long colour, int much, int little) {
        return (colour >> much & 0xff) > (colour >> little & 0xff) + 60;
    }

    @Test
    public void itCanBeLeftAtAnyTime() {
        browser.click(".driver-popover-close-btn");
        browser.until("the end of the tour", () -> tab.isTrue("tour.step === null"));
        browser.click(".sear-build");
        browser.see("[data-tile='tour']");
    }
}
