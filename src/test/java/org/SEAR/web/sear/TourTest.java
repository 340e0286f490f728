package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.web.Browser;
import org.SEAR.web.SearTab;
import org.SEAR.web.Tabs;
import org.junit.After;
import org.junit.Before;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** The tour leads from an empty page to a robot that drives, and goes on by itself when a step is done. */
public class TourTest {
    @ClassRule
    public static final Tabs TABS = new Tabs("sear = Runtime.start('sear', 'SEAR')");
    @Rule
    public final TestRule page = TABS.page("sear");
    private final Browser browser = TABS.browser();
    private final SearTab tab = new SearTab(TABS);

    @Before
    public void beginAsAStranger() {
        browser.script("localStorage.removeItem('sear.folds')");
        TABS.open("sear");
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

    @Test
    public void eachStepThatIsDoneMakesRoomForTheNext() {
        put("rover", 1, "Put it on the ground");
        waitForStep(2, "Give it an eye");
        put("Distance", 3, "Mount it");
        waitForStep(4, "An obstacle");
        browser.click("[data-make='Box']");
        waitForStep(5, "In its way");
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

    @Test
    public void itCanBeLeftAtAnyTime() {
        browser.click(".driver-popover-close-btn");
        browser.until("the end of the tour", () -> tab.isTrue("tour.step === null"));
        browser.click(".sear-build");
        browser.see("[data-tile='tour']");
    }
}
