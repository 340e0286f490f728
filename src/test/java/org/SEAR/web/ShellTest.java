// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

/** The page around the tabs, light and dark, in one browser and in two. */
public class ShellTest {
    @ClassRule
    public static final Tabs TABS =
        new Tabs("sear = Runtime.start('sear', 'SEAR')\nsear.loadProject('examples/sensors.sear')\n"
        + "Runtime.start('line', 'Serial')");
    /** Least contrast by the guidelines for accessible pages (WCAG 2, level AA). */
    private static final double CONTRAST = 4.5;
    /** Page width of a telephone, pixels. */
    private static final int NARROW = 400;
    /**
     * Script that returns texts with too little contrast to their background: contrast and beginning of each. It skips
     * disabled controls.
     */
    private static final String FAINT = "var limit = arguments[0]; var faint = [];"
        + "function parse(c) { var n = c.match(/[\\d.]+/g).map(Number); return n.length < 4 ? n.concat(1) : n }"
        + "function mix(top, under) { return [0, 1, 2].map(function(i) { return top[i] * top[3] + under[i] * (1 - "
        + "top[3]) }).concat(1) }"
        + "function ground(e) { var c = e ? parse(getComputedStyle(e).backgroundColor) : [255, 255, 255, 1];"
        + "  return c[3] === 1 ? c : mix(c, ground(e.parentElement)) }"
        + "function light(c) { var v = c.slice(0, 3).map(function(x) {"
        + "  x /= 255; return x <= 0.03928 ? x / 12.92 : Math.pow((x + 0.055) / 1.055, 2.4) });"
        + "  return 0.2126 * v[0] + 0.7152 * v[1] + 0.0722 * v[2] }"
        + "document.querySelectorAll('body *').forEach(function(e) {"
        + "  var own = Array.prototype.some.call(e.childNodes, function(n) { return n.nodeType === 3 && "
        + "n.data.trim() });  var off = e.matches(':disabled, .python-code') || e.closest('[disabled]');"
        + "  if (!own && !e.matches('input, select') || !e.getClientRects().length || off) { return }"
        + "  var under = ground(e); var a = light(under), b = light(mix(parse(getComputedStyle(e).color), under));"
        + "  var ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);"
        + "  if (ratio < limit) { faint.push(ratio.toFixed(1) + ' ' + e.tagName + '.' + e.className + ' ' + "
        + "e.textContent.trim().substring(0, 30)) }}); return faint";
    @Rule
    public final TestRule page = TABS.page("sear");
    private final Browser browser = TABS.browser();
    private final MyRobotLab robotLab = TABS.robotLab();
    private final SearTab tab = new SearTab(TABS);

    @Test
    public void everyServiceHasATabAndItsAddress() {
        browser.seeText("#tab-python", "Python");
        browser.click("#tab-python");
        browser.see(".python-run");
        assertTrue(browser.driver().getCurrentUrl().endsWith("#/python"));
        browser.driver().navigate().back();
        browser.see(".sear-start");
        browser.seeText(".sear-status", "no simulation runs");
        assertEquals("sear", robotLab.call("sear", "getName").asText());
    }

    @Test
    public void myRobotLabsOwnMembersAreOnAPanelsScopeAfterItsControllerHasRun() {
        String members = "[save, saveDefault, release, apply, startPeer, releasePeer, toggleVirtual, "
            + "updateServiceData]";
        for (String panel : new String[] {SearTab.ROOT, ".mrl-python", ".mrl-serial"}) {
            browser.until(panel, () -> !browser.all(panel).isEmpty());
            assertEquals(panel, 8L, browser.script(
                "return angular.element(document.querySelector(arguments[0])).scope().$eval(arguments[1])"
                + ".filter(angular.isFunction).length", panel, members));
            assertEquals(false, browser.scope(panel, "showPeers"));
        }
        assertEquals("sear", browser.scope(SearTab.ROOT, "parentPanel.name"));
    }

    @Test
    public void messagesThatAPanelShowsAreNotShownTwice() {
        robotLab.call("sear", "warn", "only in the tab");
        browser.seeText(".sear-log", "only in the tab");
        assertFalse(browser.text("footer").contains("only in the tab"));
        browser.click("#tab-python");
        browser.seeText("#shell-statuses", "only in the tab");
    }

    @Test
    public void aServiceIsStartedInThePage() {
        browser.click("#shell-more");
        browser.type("#shell-name", "second");
        browser.type("input[aria-label='Type']", "Serial");
        browser.click("#shell-menu button[type='submit']");
        browser.click("#tab-second");
        browser.see("mrl-panel[name='second'] .serial-connect");
        assertEquals("the menu names what is in front", "More: second", browser.text("#shell-more"));
        assertFalse(browser.see("#shell-more").getAttribute("aria-expanded").equals("true"));
        robotLab.call("runtime", "release", "second");
        browser.until("no tab", () -> browser.all("#tab-second").isEmpty());
    }

    @Test
    public void theMenuClosesByEscapeAndByAClickBesideIt() {
        for (boolean byKey : new boolean[] {true, false}) {
            browser.click("#shell-more");
            browser.see("#shell-menu");
            if (byKey) {
                browser.see("#shell-name").sendKeys(Keys.ESCAPE);
            } else {
                browser.click(".sear-status");
            }
            browser.until("a closed menu", () -> !browser.see("#shell-more").getAttribute("aria-expanded")
                .equals("true") && browser.all("#shell-menu").stream().noneMatch(WebElement::isDisplayed));
        }
    }

    @Test
    public void theMeasureOfContrastFindsFaintTexts() {
        browser.script("document.querySelector('.sear-status').style.color = '#999'");
        assertEquals(List.of("2.8 SPAN.ng-binding no simulation runs"), browser.script(FAINT, 3));
    }

    @Test
    public void textsCanBeReadInLightAndInDark() {
        tab.start();
        try {
            for (String theme : new String[] {"light", "dark"}) {
                browser.setTheme(theme);
                for (String service : new String[] {"sear", "python", "line", "runtime"}) {
                    TABS.show(service);
                    browser.see("mrl-panel[name='" + service + "'] > *");
                    // the editor takes its colours a moment later
                    browser.until("no faint texts, " + theme + ", " + service,
                        () -> List.of().equals(browser.script(FAINT, CONTRAST)));
                }
                Object ground = browser.script("return getComputedStyle(document.body).backgroundColor");
                assertEquals("light".equals(theme) ? "rgb(255, 255, 255)" : "rgb(30, 30, 30)", ground);
            }
        } finally {
            browser.setTheme("light");
            robotLab.call("sear", "stopSimulation");
        }
    }

    @Test
    public void aNarrowPageFitsIntoItsWindow() {
        tab.start();
        try {
            browser.setPageWidth(NARROW);
            for (String service : new String[] {"sear", "python", "line", "runtime"}) {
                TABS.show(service);
                browser.see("mrl-panel[name='" + service + "'] > *");
                browser.until(service + " without anything beside the window", () ->
                    ((Number) browser.script("return document.documentElement.scrollWidth")).intValue() == NARROW);
            }
        } finally {
            browser.setPageWidth(0);
            robotLab.call("sear", "stopSimulation");
        }
    }

    @Test
    public void twoBrowsersShowTheSameWorld() throws IOException {
        try (Browser other = new Browser(1000, 800)) {
            TABS.open(other, "sear");
            tab.start();
            other.seeText(".sear-status", "running at ");
            other.click(".sear-forward");
            browser.until("movement", () -> tab.number("world.running.robots[0].speed") > 0.1);
            browser.click(".sear-stop");
            other.seeText(".sear-status", "no simulation runs");
            assertEquals(List.of(), other.errors());
        }
    }

    /** All tests of pages rely on this check. */
    @Test
    public void errorsOfThePageAreSeen() {
        browser.script("console.error('first'); setTimeout(function() { throw new Error('second') })");
        List<String> errors = new ArrayList<>();
        browser.until("both errors", () -> errors.addAll(browser.errors()) && errors.size() == 2);
        assertTrue(errors.toString(), errors.get(0).contains("first") && errors.get(1).contains("second"));
        browser.expectErrors("third");
        browser.script("console.error('third')");
        assertEquals(List.of(), browser.errors());
    }
}
