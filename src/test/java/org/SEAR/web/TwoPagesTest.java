// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Map;
import org.junit.Test;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

/**
 * Two pages build one project: each shows the other's changes, nothing is lost, and neither overwrites a change that it
 * has not shown.
 */
public class TwoPagesTest extends SearPage {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 1000;


    /** One of the pages. */
    private static final class Page {
        private final Browser browser;
        private final SearTab tab;

        Page(Browser browser) {
            this.browser = browser;
            tab = new SearTab(browser, TABS.robotLab());
        }

        void select(String object) {
            browser.until(object + " in the world",
                () -> tab.isTrue("edits.grammar !== null && world.shown() && world.shown().objects.length > 0"));
            browser.scope(SearTab.ROOT, "edits.select('" + object + "')");
            browser.until(object + " selected",
                () -> tab.isTrue("edits.object && edits.object.object == '" + object + "'"));
        }

        void type(String field, String value) {
            WebElement input = browser.see("[data-field='" + field + "'] .form-control");
            input.sendKeys(Keys.chord(Keys.CONTROL, "a"));
            input.sendKeys(value, Keys.ENTER);
        }

        /** Waits until both the page's data and the field have a value. */
        void waitFor(String field, String value) {
            browser.until(field + " to be " + value,
                () -> tab.isTrue("edits.object && edits.object.values." + field + " == '" + value + "'")
                && value.equals(browser.see("[data-field='" + field + "'] .form-control").getAttribute("value")));
        }

        void build() {
            if (!tab.isTrue("view.building")) {
                browser.click(".sear-build");
            }
        }
    }

    private static String crate() throws IOException {
        return Files.readString(TABS.robotLab().file("SEARproject/environment/crate.xml"));
    }

    @Test
    public void eachShowsTheOthersChangesAndNothingIsLost() throws Exception {
        robotLab.run("sear.newProject()\nsear.edit({'do': 'add', 'type': 'Box', 'name': 'crate'})");
        Page one = new Page(TABS.browser());
        try (Browser second = new Browser(WIDTH, HEIGHT)) {
            TABS.open(second, "sear");
            Page two = new Page(second);
            one.select("crate");
            two.select("crate");
            one.type("x", "1");
            two.waitFor("x", "1");
            two.type("z", "2");
            one.waitFor("z", "2");
            editsOfBothCount(one, two);
            aStaleOneIsRefused(one, two);
            whatOneMakesAndTakesBackTheOtherShows(one, two);
            assertEquals("errors in the other browser's console", List.of(), second.errors());
        }
    }

    /** Neither page waits for the other. */
    private static void editsOfBothCount(Page one, Page two) throws IOException {
        Map<String, String> ofOne = Map.of("mass", "4", "length", "0.5", "friction", "0.3");
        Map<String, String> ofTwo = Map.of("width", "0.7", "height", "0.9", "color", "red");
        List<String> fields = List.of("mass", "width", "length", "height", "friction", "color");
        for (String field : fields) {
            if (ofOne.containsKey(field)) {
                one.type(field, ofOne.get(field));
            } else {
                two.type(field, ofTwo.get(field));
            }
        }
        for (String field : fields) {
            String value = ofOne.getOrDefault(field, ofTwo.get(field));
            one.waitFor(field, value);
            two.waitFor(field, value);
            assertTrue(crate(), crate().contains("<" + field + ">" + value + "</" + field + ">"));
        }
    }

    /** Two people press Enter at the same time: the second page does not yet know the first one's edit. */
    private static void aStaleOneIsRefused(Page one, Page two) throws IOException {
        one.type("x", "3");
        two.waitFor("x", "3");
        two.browser.script("var rows = "
            + "angular.element(document.querySelector(\"[data-field='x']\")).scope().inspector.rows;"
            + "rows.filter(function(row) { return row.p.name === 'x' })[0].was = '1'");
        two.type("x", "5");
        two.browser.seeText("[data-field='x'] .sear-wrong", "a value based on the present one, 3, since another page");
        assertTrue(crate(), crate().contains("<x>3</x>"));
        two.type("x", "6");
        one.waitFor("x", "6");
    }

    private static void whatOneMakesAndTakesBackTheOtherShows(Page one, Page two) throws IOException {
        one.build();
        one.browser.click(".sear-palette [data-make='Sphere']");
        one.browser.click(".sear-middle");
        two.browser.until("what the other one has made", () -> two.tab.isTrue("world.shown().objects.length == 2"));
        two.build();
        two.browser.until("its edit", () -> two.tab.isTrue("edits.undoable == 'add sphere1'"));
        two.browser.click(".sear-undo");
        one.browser.until("that it was taken back",
            () -> one.tab.isTrue("world.shown().objects.length == 1 && edits.redoable == 'add sphere1'"));
        assertTrue(Files.notExists(TABS.robotLab().file("SEARproject/environment/sphere1.xml")));
        assertTrue(crate(), crate().contains("<x>6</x>") && crate().contains("<color>red</color>"));
    }
}
