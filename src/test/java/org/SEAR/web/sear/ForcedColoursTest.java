// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;

import java.util.List;
import java.util.Map;
import org.SEAR.web.SearPage;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;

/** The SEAR tab in forced colours, as in a contrast theme of Windows. */
public class ForcedColoursTest extends SearPage {
    private static final String BACKGROUND = "return getComputedStyle(document.querySelector(arguments[0]))"
        + ".backgroundColor";

    @Before
    public void force() {
        browser.driver().executeCdpCommand("Emulation.setEmulatedMedia",
            Map.of("features", List.of(Map.of("name", "forced-colors", "value", "active"))));
    }

    @After
    public void asBefore() {
        browser.driver().executeCdpCommand("Emulation.setEmulatedMedia", Map.of("features", List.of()));
    }

    private String background(String css) {
        browser.see(css);
        return (String) browser.script(BACKGROUND, css);
    }

    @Test
    public void pressedButtonsAndTheTabInFrontDiffer() {
        tab.openExample("maze");
        browser.click(".sear-map");
        browser.see(".sear-map.active");
        assertNotEquals(background(".sear-map"), background(".sear-space"));
        assertNotEquals(background(".nav-tabs > li.active > a"), background(".nav-tabs > li:not(.active) > a"));
    }

    @Test
    public void legendsOfPlotsKeepTheColoursOfTheirLines() {
        tab.openExample("maze");
        tab.start();
        browser.click(".sear-plots");
        browser.see(".sear-swatch");
        assertEquals("rgb(51, 122, 183)", background(".sear-line:first-child .sear-swatch"));
        assertEquals("rgb(217, 83, 79)", background(".sear-line:nth-child(2) .sear-swatch"));
    }
}
