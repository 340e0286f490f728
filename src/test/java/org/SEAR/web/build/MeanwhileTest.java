// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.build;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Map;
import org.SEAR.web.SearPage;
import org.SEAR.web.SearTab;
import org.junit.Before;
import org.junit.Test;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** Typing, dragging and keys while an edit of another page, the next edit of this page or no answer arrives. */
public class MeanwhileTest extends SearPage {
    private static final String CRATE = "(world.shown().objects | filter:{name: 'crate'})[0].pose";


    /** Selects a crate of 1 m in the middle of a map. */
    @Before
    public void selectACrate() {
        robotLab.run("sear.newProject()\nsear.edit({'do': 'add', 'type': 'Box', 'name': 'crate',"
            + " 'set': {'length': 1, 'width': 1, 'height': 1}})");
        browser.until("the crate", () -> tab.isTrue(
            "edits.grammar !== null && world.shown() && world.shown().objects.length == 1 && view.fitted"));
        browser.script("var scope = angular.element(document.querySelector('.sear-main')).scope(); "
            + "scope.view.setMode('map');scope.view.fitted = false; scope.view.redraw(); scope.edits.select('crate')");
        browser.until("it is selected, on a map that was drawn",
            () -> tab.isTrue("view.fitted && edits.object && edits.object.object == 'crate'"
            + " && building.found() !== null"));
        browser.script("var view = angular.element(document.querySelector('.sear-main')).scope().view;"
            + "angular.extend(view, {x: 0, z: 0, scale: 50, chosen: true}); view.redraw()");
        browser.until("the map", () -> Math.abs(tab.toScreen(1, 0)[1] - tab.toScreen(0, 0)[1] + 50) < 0.1);
    }

    private void another(Object... edit) {
        robotLab.call("sear", "edit", edit.length == 2 ? Map.of("do", edit[0], "object", edit[1])
            : Map.of("do", edit[0], "object", edit[1], "set", Map.of(edit[2], edit[3])));
    }

    private Object written(String field) {
        return robotLab.call("sear", "getProjectObject", "crate").get("values").get(field).asText();
    }

    private WebElement type(String field, CharSequence... keys) {
        WebElement input = browser.see("[data-field='" + field + "'] .form-control");
        input.sendKeys(Keys.chord(Keys.CONTROL, "a"));
        input.sendKeys(keys);
        return input;
    }

    /** Moves the mouse to a place of the view in metres north and east. */
    private Actions at(double x, double z) {
        WebElement view = browser.see(".sear-view");
        Dimension size = view.getSize();
        double[] pixel = tab.toScreen(x, z);
        return new Actions(browser.driver()).moveToElement(view, (int) Math.round(pixel[0]) - size.getWidth() / 2,
            (int) Math.round(pixel[1]) - size.getHeight() / 2);
    }

    private void waitForX(String value) {
        browser.until("x " + value, () -> value.equals(written("x"))
            && tab.isTrue("edits.object && edits.object.values.x == '" + value + "'"));
    }

    @Test
    public void typedTextStaysAndIsRejectedIfAnotherPageSetTheField() {
        WebElement x = type("x", "7");
        another("set", "crate", "x", 5);
        browser.until("the other one's edit", () -> tab.isTrue("edits.object.values.x == '5'"));
        assertEquals("7", x.getAttribute("value"));
        x.sendKeys("1", Keys.ENTER);
        browser.seeText("[data-field='x'] .sear-wrong", "since another page or a script has changed it meanwhile");
        browser.until("what is there", () -> "5".equals(x.getAttribute("value")));
        type("x", "7");
        another("set", "crate", "x", 6);
        browser.until("the next one", () -> tab.isTrue("edits.object.values.x == '6'"));
        type("x", "5");
        browser.see("[data-field='mass'] .form-control").click();
        browser.until("what is there, in a field that was left as it was", () -> "6".equals(x.getAttribute("value")));
        type("x", "8", Keys.ENTER);
        waitForX("8");
    }

    @Test
    public void valuesThatArePutInOneAfterAnotherAreNotTakenForAnothers() {
        type("mass", "1", Keys.ENTER, "2", Keys.ENTER, "3", Keys.ENTER);
        browser.until("the last one", () -> "123".equals(written("mass")));
        assertTrue(browser.texts(".sear-wrong").toString(), browser.all(".sear-wrong").isEmpty());
    }

    @Test
    public void aDragIsRejectedIfAnotherPageMovedTheObject() {
        at(0.3, 0.3).clickAndHold().perform();
        at(1.3, 0.3).perform();
        another("set", "crate", "x", 3);
        browser.until("the other one's edit", () -> tab.isTrue("edits.object.values.x == '3'"));
        at(2.3, 0.3).release().perform();
        browser.seeText(".sear-last", "since another page or a script has changed it meanwhile");
        assertEquals("3", written("x"));
        browser.until("it is shown where it is", () -> tab.number(CRATE + "[0]") == 3);
    }

    @Test
    public void aDragEndsWithAMessageWhenAnotherPageDeletesTheObject() {
        for (String handle : new String[] {"", "x"}) {
            double x = handle.isEmpty() ? 0.3 : tab.number("building.handle('x')[0]");
            at(x, 0).clickAndHold().perform();
            at(x + 0.5, 0).perform();
            another("delete", "crate");
            browser.seeText(".sear-last", "crate was deleted or renamed by another page or a script. Its last edit: "
                + "delete crate");
            at(1, 1).release().perform();
            assertTrue("nothing was complained about",
                tab.isTrue("(messages.list | filter:{level: 'error'}).length == 0"));
            selectACrate();
        }
    }

    @Test
    public void movesByKeysAreWrittenBeforeOtherActions() {
        WebElement view = browser.see(".sear-view");
        view.sendKeys(Keys.ARROW_UP, Keys.chord(Keys.CONTROL, "z"));
        browser.until("that it was undone",
            () -> tab.isTrue("edits.redoable == 'move crate' && edits.undoable == 'add crate'"));
        assertEquals("0", written("x"));
        view.sendKeys(Keys.ARROW_UP, Keys.chord(Keys.CONTROL, "d"));
        browser.until("a copy", () -> tab.isTrue("world.shown().objects.length == 2"));
        assertEquals("0.05", written("x"));
        assertEquals("0.05", robotLab.call("sear", "getProjectObject", "crate1").get("values")
            .get("x").asText());
        browser.scope(SearTab.ROOT, "edits.select('crate')");
        browser.until("the crate again", () -> tab.isTrue("edits.object && edits.object.object == 'crate'"));
        view.sendKeys(Keys.ARROW_UP, "[", Keys.ESCAPE);
        browser.until("nothing selected, and all of it written", () -> tab.isTrue("edits.selected === null")
            && "0.1".equals(written("x")));
        assertEquals("15", written("ry"));
    }

    @Test
    public void anUnansweredEditIsUndoneWithAMessageAndCanBeRepeated() {
        browser.script("var msg = angular.element(document.querySelector('.sear-main')).scope().msg; msg.own = "
            + "msg.send; msg.send = () => {}");
        type("mass", "9", Keys.ENTER);
        at(0.3, 0.3).clickAndHold().perform();
        at(1.3, 0.3).release().perform();
        browser.seeText("[data-field='mass'] .sear-wrong", "no answer to an edit");
        browser.seeText(".sear-last", "no answer to an edit");
        browser.until("it is shown where it is", () -> tab.number(CRATE + "[0]") == 0
            && !tab.isTrue("building.isBusy()"));
        browser.script("var msg = angular.element(document.querySelector('.sear-main')).scope().msg; "
            + "msg.send = msg.own");
        type("mass", "9", Keys.ENTER);
        browser.until("the same again", () -> "9".equals(written("mass")));
    }
}
