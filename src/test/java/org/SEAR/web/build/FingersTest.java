// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.build;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.SEAR.web.SearPage;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.openqa.selenium.Point;
import org.openqa.selenium.WebElement;

/** Fingers on the views of the SEAR tab, as on a telephone. */
public class FingersTest extends SearPage {
    private static final int WIDTH = 390;
    private static final int HEIGHT = 844;
    /** Number of moves in a drag. */
    private static final int MOVES = 5;

    @Before
    public void showACrate() {
        robotLab.run("sear.newProject()\nfrom org.SEAR.POJOs import Box, Floor\nFloor('floor', 6, 6)\n"
            + "Box('crate', 0.5, 0.5, 0.5, 1).move(0, 0.25, 0)\n"
            + "for i in (-2, 2): Box('post%d' % (i + 3), 0.1, 0.1, 0.5, 0).move(i, 0.25, i)");
        browser.setPageSize(WIDTH, HEIGHT);
        browser.until("the crate", () -> tab.isTrue("world.shown().objects.length == 4 && edits.grammar !== null"));
        if (tab.isTrue("project.kept !== null")) {
            browser.click(".sear-hide-kept");       // it covers the palette
        }
    }

    @After
    public void asBefore() {
        browser.setPageSize(0, 0);
    }

    private void show(String mode) {
        browser.click(mode);
        browser.see(mode + ".active");
    }

    private WebElement canvas() {
        return browser.see(tab.isTrue("view.mode == 'map'") ? ".sear-view" : ".sear-scene");
    }

    /**
     * Sends a touch event.
     *
     * @param pixels x and y of each finger on the canvas
     */
    private void touch(String type, double... pixels) {
        Point origin = canvas().getLocation();
        double scrolled = ((Number) browser.script("return window.scrollY")).doubleValue();
        List<Map<String, Object>> points = new ArrayList<>();
        for (int i = 0; i < pixels.length; i += 2) {
            points.add(Map.of("x", origin.getX() + pixels[i], "y", origin.getY() - scrolled + pixels[i + 1],
                "id", i / 2));
        }
        browser.driver().executeCdpCommand("Input.dispatchTouchEvent", Map.of("type", type, "touchPoints", points));
    }

    /** Moves a finger from a pixel of the canvas. */
    private void drag(double x, double y, double right, double down) {
        touch("touchStart", x, y);
        for (int i = 1; i <= MOVES; i++) {
            touch("touchMove", x + right * i / MOVES, y + down * i / MOVES);
        }
        touch("touchEnd");
    }

    @Test
    public void oneFingerMovesTheMapAndTwoZoom() {
        show(".sear-map");
        double scale = tab.number("view.scale");
        double x = tab.number("view.x");
        double z = tab.number("view.z");
        drag(100, 150, 50, -30);
        browser.until("the map moved", () -> Math.abs(tab.number("view.z") - (z - 50 / scale)) < 0.02);
        assertEquals(x - 30 / scale, tab.number("view.x"), 0.02);
        touch("touchStart", 100, 150, 200, 150);
        touch("touchMove", 80, 150, 220, 150);
        touch("touchMove", 50, 150, 250, 150);
        touch("touchEnd");
        browser.until("twice the scale", () -> Math.abs(tab.number("view.scale") / scale - 2) < 0.05);
        assertEquals("the page stayed", 0L, browser.script("return window.scrollX"));
    }

    @Test
    public void aTapSelectsAndOneFingerDragsTheSelectedObject() {
        show(".sear-map");
        browser.click(".sear-build");
        browser.seeText(".sear-armed", "Choose an object, then click where to place it.");
        double[] crate = tab.toScreen(0, 0);
        touch("touchStart", crate);
        touch("touchMove", crate[0] + 3, crate[1] - 4);        // a finger is never still
        touch("touchEnd");
        browser.until("the selected crate", () -> tab.isTrue("edits.object && edits.object.object == 'crate'"));
        assertTrue("the hint is no longer true", browser.all(".sear-armed").isEmpty());
        double scale = tab.number("view.scale");
        double z = tab.number("view.z");
        drag(crate[0], crate[1], scale, 0);
        browser.until("the crate one metre to the east",
            () -> Math.abs(Double.parseDouble(tab.text("edits.object.values.z")) - 1) < 0.051);
        assertEquals("the map stayed", z, tab.number("view.z"), 1e-9);
        drag(crate[0], crate[1] + 80, scale, 0);
        browser.until("the map moved beside the crate", () -> Math.abs(tab.number("view.z") - (z - 1)) < 0.02);
        assertEquals(1, Double.parseDouble(tab.text("edits.object.values.z")), 0.051);
    }

    @Test
    public void oneFingerTurnsThe3dViewAndPlacesAnObject() {
        show(".sear-space");
        browser.until("a scene", () -> tab.isTrue("view.scene() !== null"));
        double azimuth = tab.number("view.scene().orbit.azimuth");
        drag(100, 150, 60, 0);
        browser.until("the view turned", () -> Math.abs(tab.number("view.scene().orbit.azimuth") - azimuth) > 0.1);
        browser.click(".sear-build");
        browser.click(".sear-palette [data-make='Box']");
        browser.until("a box to place", () -> tab.isTrue("palette.armed && palette.armed.name == 'Box'"));
        touch("touchStart", 180, 240);
        touch("touchEnd");
        browser.until("the box", () -> tab.isTrue("edits.object && edits.object.type == 'Box' && !palette.armed"));
    }
}
