// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.build;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
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

/** Joints made by clicks in the SEAR tab, explained when they can't move, and moved by their sliders. */
public class JointsTabTest {
    @ClassRule
    public static final Tabs TABS = new Tabs("sear = Runtime.start('sear', 'SEAR')");
    private static final String DOOR = String.join("\n",
        "from org.SEAR.POJOs import Box, Floor",
        "sear.newProject()",
        "Floor('floor', 6, 6)",
        "Box('frame', 0.2, 0.2, 2.2).move(-0.2, 1.1, 0)",
        "door = Box('door', 0.8, 0.1, 2, 20)",
        "door.move(0.4, 1.1, 0)",
        "Box('wall', 0.2, 0.2, 2).move(0, 1, 2)");
    private static final String CRANE = String.join("\n",
        "from org.SEAR.POJOs import Box, Dynamics, Floor, SEARrobot",
        "sear.newProject()",
        "Floor('floor', 6, 6)",
        "crane = SEARrobot('crane')",
        "crane.addComponent(Dynamics('mass', 30))",
        "crane.addComponent(Box('base', 0.6, 0.6, 0.4, 29, 0, 0.2, 0, 0, 0, 0))",
        "crane.addComponent(Box('boom', 0.1, 0.8, 0.1, 1, 0, 0.5, 0, 0, 0, 0))");

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

    private void set(String field, String value) {
        WebElement input = browser.see("[data-field='" + field + "'] .form-control");
        input.sendKeys(Keys.chord(Keys.CONTROL, "a"));
        input.sendKeys(value, Keys.ENTER);
        browser.until(field, () -> tab.isTrue("edits.object && edits.object.values." + field + " == '" + value + "'"));
    }

    @Test
    public void aJointWithinARobotIsMadeOfItsPartsByName() {
        browser.until("no simulation", () -> tab.isTrue("service && !service.simulating && edits.grammar !== null"));
        TABS.robotLab().run(CRANE);
        browser.until("the crane", () -> tab.isTrue("world.shown() && world.shown().robots.length == 1"));
        browser.click(tab.isTrue("welcome.isShown()") ? "[data-tile='build']" : ".sear-build");
        browser.click(".sear-palette [data-make='Hinge']");
        choose("#sear-join-first", "crane");
        choose("#sear-join-second", "crane/boom");
        browser.click(".sear-join");
        browser.until("the hinge", () -> tab.isTrue("edits.object && edits.object.object == 'crane/hinge1'"));
        assertEquals("boom 0 0.5", tab.text("edits.object.values.second + ' ' + edits.object.values.x + ' ' "
            + "+ edits.object.values.y"));
        browser.seeText("[data-field='first'] option:checked", "the robot's body");
        browser.click(".sear-axis button:nth-child(2)");
        browser.until("north", () -> tab.isTrue("edits.object.values.rz == '-90'"));
        browser.until("its mark", () -> tab.isTrue("world.shown().joints.length == 1 "
            + "&& world.shown().joints[0].robot == 'crane'"));
        browser.until("its words in the list", () -> browser.texts(".sear-tree small").contains(
            "Hinge of crane and boom"));
        set("stallForce", "50");
        set("noLoadSpeed", "90");
        set("lower", "-90");
        set("upper", "90");
        tab.start();
        browser.script("arguments[0].value = 750; arguments[0].dispatchEvent(new Event('input'));"
            + "arguments[0].dispatchEvent(new Event('change'))", browser.see(".sear-joints .sear-slider"));
        browser.until("45 degrees", () -> tab.number("world.running.joints[0].numbers[0]") > 44);
        TABS.robotLab().call("sear", "stopSimulation");
        browser.until("no simulation", () -> tab.isTrue("service && !service.simulating"));
    }

    private void choose(String select, String name) {
        browser.script("arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('change'))",
            browser.see(select), name);
    }

    @Test
    public void aHingeMadeByClicksIsExplainedDrivenAndRead() {
        browser.until("no simulation", () -> tab.isTrue("service && !service.simulating && edits.grammar !== null"));
        TABS.robotLab().run(DOOR);
        browser.until("the door", () -> tab.isTrue("world.shown() && world.shown().objects.length == 4"));
        browser.click(tab.isTrue("welcome.isShown()") ? "[data-tile='build']" : ".sear-build");
        browser.click(".sear-map");
        browser.script("var scope = angular.element(document.querySelector('.sear-main')).scope();"
            + "angular.extend(scope.view, {x: 0, z: 0, scale: 60, chosen: true}); scope.view.redraw()");
        browser.until("the map", () -> Math.abs(tab.toScreen(1, 0)[1] - tab.toScreen(0, 0)[1] + 60) < 0.1);

        browser.click(".sear-palette [data-make='Hinge']");
        browser.seeText(".sear-armed", "Click the first object; the ground stands for the world");
        clickOnMap(-0.2, 0);
        browser.seeText(".sear-armed", "it joins to frame");
        clickOnMap(0, 2);
        browser.seeText(".sear-last", "frame and wall are both fixed. Give one of them a mass");
        clickOnMap(-0.2, 0);
        browser.until("the frame", () -> tab.isTrue("palette.armed.joining.first == 'frame'"));
        clickOnMap(0.05, 0);
        browser.until("the hinge", () -> tab.isTrue("edits.object && edits.object.object == 'hinge1'"));
        assertEquals("frame door 0.05", tab.text("edits.object.values.first + ' ' + edits.object.values.second + ' ' "
            + "+ edits.object.values.x"));
        assertEquals(List.of("OBJECTS", "PLACE", "LIMITS", "MOTOR", "SPRING AND LOSSES"),
            browser.texts(".sear-group > .sear-title"));
        browser.seeText("[data-field='stallForce']", "motor force");
        browser.seeText("[data-field='stallForce']", "N m");

        set("lower", "5");
        set("upper", "5");
        browser.seeText(".sear-still", "its lower and its upper limit are both 5");
        set("lower", "-10");
        set("upper", "90");
        set("stallForce", "50");
        set("noLoadSpeed", "90");
        browser.until("it can move", () -> browser.all(".sear-still").isEmpty());
        tab.start();
        browser.script("arguments[0].value = 110; arguments[0].dispatchEvent(new Event('input'));"
            + "arguments[0].dispatchEvent(new Event('change'))", browser.see(".sear-joints .sear-slider"));
        browser.until("45 degrees", () -> tab.number("world.running.joints[0].numbers[0]") > 44);
        assertTrue(tab.text("world.running.joints[0].words").startsWith("4"));
        TABS.robotLab().call("sear", "stopSimulation");
        browser.until("no simulation", () -> tab.isTrue("service && !service.simulating"));
        browser.click(".sear-delete");
        browser.until("no joint", () -> tab.isTrue("world.shown() && !world.shown().joints.length"));
        browser.click(".sear-undo");
        browser.until("the joint again", () -> tab.isTrue("world.shown() && world.shown().joints.length == 1"));
    }
}
