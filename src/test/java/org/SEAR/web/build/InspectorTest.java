// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.build;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import org.SEAR.web.SearPage;
import org.junit.Before;
import org.junit.Test;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

/** Numbers typed in the inspector, and the palette's search and keys. */
public class InspectorTest extends SearPage {
    private static final String THINGS = String.join("\n", "from org.SEAR.POJOs import Box, Floor, Sphere",
        "Floor('floor', 10, 10)",
        "Box('box', 0.25, 0.25, 0.25).move(2, 0.125, 2)", "Sphere('ball', 0.1).move(0, 0.1, 2)",
        "leaning = Box('leaning', 0.25, 0.25, 0.25)", "leaning.move(-2, 0.125, 2)", "leaning.rotate(20, 0, 0)");

    @Before
    public void beginWithThings() {
        robotLab.run("sear.newProject()");
        browser.until("an empty project",
            () -> tab.isTrue("world.shown() && world.isEmpty() && edits.grammar !== null"));
        robotLab.run(THINGS);
        browser.until("the things", () -> tab.isTrue("world.shown().objects.length == 4"));
    }

    private void select(String name) {
        browser.script("var scope = angular.element(document.querySelector('.sear-main')).scope();"
            + "scope.edits.select(arguments[0]); scope.$apply()", name);
        browser.until(name + " selected", () -> tab.isTrue("edits.object && edits.object.name == '" + name + "'"));
    }

    private void type(String field, String text) {
        WebElement input = browser.see("[data-field='" + field + "'] .form-control");
        input.sendKeys(Keys.chord(Keys.CONTROL, "a"));
        input.sendKeys(text, Keys.ENTER);
    }

    private void waitForValue(String field, String value) {
        browser.until(field + " to be " + value, () -> tab.text("edits.object.values." + field).equals(value));
    }

    @Test
    public void aGrowingObjectStaysOnTheGround() {
        select("box");
        type("height", "0.5");
        waitForValue("height", "0.5");
        waitForValue("y", "0.25");
        assertEquals("and nowhere else", "2", tab.text("edits.object.values.x"));
        browser.script("angular.element(document.querySelector('.sear-main')).scope().edits.undo()");
        waitForValue("y", "0.125");
        select("ball");
        type("radius", "0.3");
        waitForValue("y", "0.3");
        select("leaning");
        type("height", "0.5");
        waitForValue("height", "0.5");
        assertEquals("what leans has no underside to keep", "0.125", tab.text("edits.object.values.y"));
    }

    @Test
    public void aCommaOrAUnitIsReportedWithTheExpectedNumber() {
        select("box");
        String[][] typed = {{"0,3", "write 0.3"}, {"30cm", "write 0.3"}, {"1,5 m", "write 1.5"}};
        for (String[] one : typed) {
            type("height", one[0]);
            browser.seeText("[data-field='height'] .sear-wrong", one[1]);
        }
        type("mass", "250 g");
        browser.seeText("[data-field='mass'] .sear-wrong", "write 0.25");
        type("height", "abc");
        browser.seeText("[data-field='height'] .sear-wrong", "legal: ");
        assertEquals("0.25", tab.text("edits.object.values.height"));
    }

    @Test
    public void escapeRestoresAField() {
        select("box");
        type("height", "30cm");
        browser.seeText("[data-field='height'] .sear-wrong", "write 0.3");
        String[] fields = {"#sear-p-height", "#sear-p-x", "#sear-p-name"};
        String[] values = {"0.25", "2", "box"};
        for (int i = 0; i < fields.length; i++) {
            WebElement field = browser.see(fields[i]);
            field.sendKeys(Keys.chord(Keys.CONTROL, "a"));
            field.sendKeys("7", Keys.ESCAPE);
            assertEquals(fields[i], values[i], field.getAttribute("value"));
            field.sendKeys(Keys.TAB);
        }
        assertEquals(List.of(), browser.texts("[data-field='height'] .sear-wrong"));
        type("width", "0.5");       // by now a value from an earlier edit is set
        waitForValue("width", "0.5");
        assertEquals("box 0.25 2", tab.text("edits.object.name + ' ' + edits.object.values.height + ' ' + "
            + "edits.object.values.x"));
    }

    @Test
    public void theDrawingOfAMazeIsEditedAsText() {
        robotLab.run("from org.SEAR.POJOs import Maze\nMaze('maze', ' _ _\\n|_|_|', 1)");
        browser.until("the maze", () -> tab.isTrue("world.shown().objects.length == 5"));
        select("maze");
        WebElement drawing = browser.see("[data-field='line'] textarea");
        assertEquals(" _ _\n|_|_|", drawing.getAttribute("value"));
        String change = "arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('change'))";
        browser.script(change, drawing, " _ _\n|  _|\n|_|_|\n");
        browser.until("three lines", () -> tab.text("edits.object.values.line.join('/')").equals(" _ _/|  _|/|_|_|"));
        browser.script(change, drawing, "|#|");
        browser.seeText("[data-field='line'] .sear-wrong", "legal: ");
        browser.until("areas on the map", () -> Boolean.TRUE.equals(browser.script("return angular.element("
            + "document.querySelector('.sear-main')).scope().world.shown().objects.some(one => one.areas && "
            + "one.areas.length > 3)")));
    }

    @Test
    public void thePaletteKnowsSynonyms() {
        browser.click(".sear-build");
        String[][] words = {{"sonar", "Distance sensor"}, {"ultrasonic", "Distance sensor"}, {"wall", "Box"},
            {"ball", "Sphere"},
            {"ground", "Floor"}, {"encoder", "Odometer"}, {"gps", "GPS receiver"}, {"laser", "Laser scanner"},
                {"robot", "Chassis"}};
        for (String[] one : words) {
            browser.type(".sear-sought", one[0]);
            browser.until(one[1] + " as a " + one[0], () -> browser.texts(".sear-make").contains(one[1])
                && browser.texts(".sear-make").size() < 8);
        }
        assertEquals("all robots", 7, browser.all(".sear-make").size());
    }

    @Test
    public void afterPuttingItInTheMiddleTheKeysMoveIt() {
        browser.click(".sear-build");
        browser.click("[data-make='Cone']");
        WebElement middle = browser.see(".sear-middle");
        middle.sendKeys(Keys.ENTER);
        browser.until("a cone", () -> tab.isTrue(
            "edits.object && edits.object.type == 'Cone' && building.found() !== null"));
        String before = tab.text("edits.object.values.z");
        WebElement focused = browser.driver().switchTo().activeElement();
        assertTrue(focused.getAttribute("class"), List.of(focused.getAttribute("class").split(" "))
            .contains("sear-view"));
        focused.sendKeys(Keys.ARROW_RIGHT);
        browser.until("another place", () -> !tab.text("edits.object.values.z").equals(before));
    }
}
