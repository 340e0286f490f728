// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.SEAR.web.SearPage;
import org.junit.Before;
import org.junit.Test;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/**
 * A terrain in the SEAR tab: map, contour lines, elevation and place under the pointer, with and without a simulation.
 */
public class TerrainTabTest extends SearPage {
    private static final String WORLD = "from org.SEAR.POJOs import Box, Terrain\nsear.newProject()\n"
        + "Terrain('land', 'terrain/jacksboro.tif').setArea(36.485, -84.2308, 2000, 2000)\nBox('box', 40, 40, 20, "
        + "0).placeAt(-500, 500)\n";
    private static final Pattern POINTED =
        Pattern.compile("here (-?[\\d.]+) m, (-?[\\d.]+) m above the geoid at (-?[\\d.]+)°, (-?[\\d.]+)°");

    @Before
    public void world() {
        robotLab.run(WORLD);
        browser.until("the ground",
            () -> tab.isTrue("ground.terrain !== null && ground.terrain.picture.complete && "
                + "ground.terrain.words(0, 0) !== ''"));
        whole();
    }

    /** Makes the view show two kilometres. */
    private void whole() {
        browser.script("var scope = angular.element(document.querySelector('.sear-main')).scope(); scope.view.x = "
            + "scope.view.z = 0; "
            + "scope.view.scale = 0.2; scope.view.chosen = scope.view.fitted = true; scope.view.redraw()");
    }

    /**
     * Moves the pointer to a point of the ground and returns the tab's values: elevation, metres above the geoid,
     * latitude, longitude.
     */
    private double[] point(double x, double z) {
        WebElement view = browser.see(".sear-view");
        double[] at = tab.toScreen(x, z);
        new Actions(browser.driver()).moveToElement(view, (int) Math.round(at[0] - view.getSize().width / 2.0),
            (int) Math.round(at[1] - view.getSize().height / 2.0)).perform();
        browser.until("words under the pointer", () -> POINTED.matcher(browser.see(".sear-pointed").getText())
            .matches());
        Matcher words = POINTED.matcher(browser.see(".sear-pointed").getText());
        assertTrue(words.matches());
        return new double[] {Double.parseDouble(words.group(1)), Double.parseDouble(words.group(2)),
            Double.parseDouble(words.group(3)), Double.parseDouble(words.group(4))};
    }

    @Test
    public void thePreviewShowsTheGroundAndThePointAtThePointer() {
        double[] middle = point(0, 0);
        double pixel = 1 / tab.number("view.scale");
        assertEquals(36.485, middle[2], 2 * pixel / 111_000);
        assertEquals(-84.2308, middle[3], 2 * pixel / 89_000);
        assertEquals("the middle is the world's height 0", 0, middle[0], 1 + pixel);
        assertEquals(middle[1] - middle[0], point(150, -180)[1] - point(150, -180)[0], 0.11);
        assertNotEquals("colours differ", tab.colour(180, 180), tab.colour(-180, -180));
    }

    @Test
    public void theGroundIsSentOnceAndStaysWhileTheSimulationRuns() {
        browser.script("angular.element(document.querySelector('.sear-main')).scope().ground.terrain.mark = 1");
        tab.start();
        tab.waitForTime(1);
        assertTrue("the same ground", tab.isTrue("ground.terrain.mark === 1"));
        double height = robotLab.call("sear", "getGroundHeight", 120, -75).asDouble();
        assertEquals(height, tab.number("ground.terrain.height(120, -75)"), 0.5);
        assertEquals(height, point(120, -75)[0], 3);
        browser.click(".sear-stop");
        tab.waitForStatus("no simulation runs");
    }
}
