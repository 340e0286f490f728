// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;
import org.openqa.selenium.WebElement;

/** Camera pictures on MyRobotLab's own page: they arrive as messages, and a click returns the distance. */
public class CamerasTest extends InPage {
    private static final String EYE = "[data-eye='eye']:not([data-large]) ";

    @Test
    public void cameraPicturesAreLiveAndAClickShowsTheDistance() throws Exception {
        assertEquals("", mrl.python("from org.SEAR.POJOs import Box, Camera, Floor, Robots", "sear.newProject()",
            "Floor('floor', 20, 20)", "Box('crate', 1, 1, 1, 0).move(0, 0.5, 2)", "rover = Robots.create2('rover')",
            "eye = Camera('eye', 0, 0.3, 0.1)",
            "eye.setKind('depth')", "rover.addComponent(eye)", "sear.recordRun('real', 100, 5)",
                "sear.startSimulation()"));
        page.open(mrl, "sear");
        page.await("a running simulation", "world.running !== null && view.fitted");
        if (page.isTrue("layout.isFolded('readings')")) {
            page.browser.click(".sear-fold-readings");
        }
        page.await("a picture", "cameras.seen({name: 'eye'}).picture.length > 100");
        double first = page.number("cameras.seen({name: 'eye'}).time");
        page.await("another one", "cameras.seen({name: 'eye'}).time > " + first);
        WebElement picture = page.browser.see(EYE + ".sear-eye-picture");
        page.browser.script("arguments[0].scrollIntoView(); var box = arguments[0].getBoundingClientRect();"
            + "arguments[0].dispatchEvent(new MouseEvent('click', {detail: 1, bubbles: true, clientX: box.left + 0.51 "
            + "* box.width, clientY: box.top + 0.51 * box.height}))", picture);
        page.browser.seeText(EYE + ".sear-eye-words", ": 1.400 m ahead");
        page.browser.click(EYE + ".sear-enlarge");
        page.browser.see(".sear-eye-large img");
        for (int[] size : SIZES) {
            page.setSize(size[0], size[1]);
            page.keep("camera-" + size[0]);
            assertTrue("it is seen at " + size[0], page.browser.see(".sear-eye-large").getSize().getWidth() > 150);
        }
        page.setSize(0, 0);
        page.browser.click(".sear-eye-close");
        assertEquals("", mrl.python("sear.simSleep(1)", "sear.stopSimulation()"));
        page.browser.click(".sear-plots");
        page.browser.choose(".sear-source", "real.searlog");
        page.await("the record", "replay.shown !== null && replay.shown.pictures.length === 1");
        page.await("its first picture", "cameras.seen({name: 'eye'}).path === 'real.searlog'");
        page.browser.seeText(EYE + ".sear-eye-words", ": 1.400 m ahead");
        page.checkConsole();
    }
}
