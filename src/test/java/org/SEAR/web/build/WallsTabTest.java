// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.build;

import static org.junit.Assert.assertEquals;

import org.SEAR.web.Browser;
import org.SEAR.web.SearTab;
import org.SEAR.web.Tabs;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** Walls drawn by clicks in the SEAR tab. */
public class WallsTabTest {
    @ClassRule
    public static final Tabs TABS = new Tabs("sear = Runtime.start('sear', 'SEAR')");
    private static final String CORNERS = "edits.object.values.x + ' ' + edits.object.values.z + ' ' + "
        + "edits.object.values.corner.length + ' ' + edits.object.values.corner[1].x + ' ' + "
        + "edits.object.values.corner[1].z + ' ' + edits.object.values.corner[2].x + ' ' + "
        + "edits.object.values.corner[2].z";

    @Rule
    public final TestRule page = TABS.page("sear");
    private final Browser browser = TABS.browser();
    private final SearTab tab = new SearTab(TABS);

    private void clickOnMap(double x, double z) {
        double[] at = tab.toScreen(x, z);
        WebElement view = browser.see(".sear-view");
        Dimension size = view.getSize();
        new Actions(browser.driver()).moveToElement(view, (int) Math.round(at[0]) - size.getWidth() / 2,
            (int) Math.round(at[1]) - size.getHeight() / 2).click().perform();
    }

    private void press(CharSequence key) {
        new Actions(browser.driver()).sendKeys(key).perform();
    }

    @Test
    public void clicksDrawAWallThatSnaps() {
        browser.until("no simulation", () -> tab.isTrue("service && !service.simulating && edits.grammar !== null"));
        TABS.robotLab().run("from org.SEAR.POJOs import Floor\nsear.newProject()\nFloor('floor', 8, 8)");
        browser.until("the floor", () -> tab.isTrue("world.shown() && world.shown().objects.length == 1"));
        browser.click(tab.isTrue("welcome.isShown()") ? "[data-tile='build']" : ".sear-build");
        browser.click(".sear-map");
        browser.script("var scope = angular.element(document.querySelector('.sear-main')).scope();"
            + "angular.extend(scope.view, {x: 0, z: 0, scale: 60, chosen: true}); scope.view.redraw()");
        browser.until("the map", () -> Math.abs(tab.toScreen(1, 0)[1] - tab.toScreen(0, 0)[1] + 60) < 0.1);

        browser.click(".sear-palette [data-make='Wall']");
        browser.seeText(".sear-armed", "Click the first corner of the wall");
        clickOnMap(-1, -2);
        browser.seeText(".sear-armed", "Click the next corner");
        clickOnMap(-1.1, 1);
        clickOnMap(2, 2);
        browser.until("three corners", () -> tab.isTrue("palette.armed.drawing.corners.length == 3"));
        press(Keys.BACK_SPACE);
        browser.until("two corners", () -> tab.isTrue("palette.armed.drawing.corners.length == 2"));
        clickOnMap(1, 1.1);
        press(Keys.ENTER);
        browser.until("the wall", () -> tab.isTrue("edits.object && edits.object.type == 'Wall'"));
        assertEquals("straight although the clicks were not", "-1 -2 3 0 3 2 3", tab.text(CORNERS));

        browser.click(".sear-palette [data-make='Wall']");
        clickOnMap(1.1, 0.9);
        clickOnMap(2, 1);
        clickOnMap(2, -1);
        browser.click(".sear-end-wall");
        browser.until("the second wall", () -> tab.isTrue("world.shown().objects.length == 3 && edits.object "
            + "&& edits.object.values.x == '1'"));
        assertEquals("from the first one's corner", "1 1 3 1 0 1 -2", tab.text(CORNERS));
        browser.click(".sear-undo");
        browser.until("one wall", () -> tab.isTrue("world.shown().objects.length == 2"));
    }
}
