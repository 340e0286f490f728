// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.build;

import static org.junit.Assert.assertEquals;

import java.util.List;
import org.SEAR.web.SearPage;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** A robot made from nothing by mouse: a chassis, wheels beside it and motors for them. It stands and drives. */
public class OwnRobotTest extends SearPage {
    @Before
    public void beginWithAnEmptyGround() {
        robotLab.run("sear.newProject()");
        browser.until("an empty project",
            () -> tab.isTrue("world.shown() && world.isEmpty() && edits.grammar !== null"));
        browser.click("[data-tile='build']");
        browser.click(".sear-map");
        browser.see(".sear-palette");
    }

    @After
    public void stop() {
        tab.stopAll();
    }

    private void arm(String kind) {
        browser.click(".sear-palette [data-make='" + kind + "']");
        browser.until(kind + " to place", () -> tab.isTrue("palette.armed && palette.armed.name == '" + kind + "'"));
    }

    private void clickMap(double x, double z) {
        WebElement view = browser.see(".sear-view");
        double[] at = tab.toScreen(x, z);
        Dimension size = view.getSize();
        new Actions(browser.driver()).moveToElement(view, (int) Math.round(at[0]) - size.getWidth() / 2,
            (int) Math.round(at[1]) - size.getHeight() / 2).click().perform();
    }

    private void waitForSelected(String object) {
        browser.until(object + " selected", () -> tab.isTrue("edits.object && edits.object.object == '" + object + "'"
            + " && (edits.object.type == 'Motor' || building.found() !== null)"));
    }

    private double value(String field) {
        return Double.parseDouble(tab.text("edits.object.values." + field));
    }

    private void middle(String kind, String object) {
        arm(kind);
        browser.click(".sear-middle");
        waitForSelected(object);
    }

    @Test
    public void twoWheelsACasterAndTwoMotorsMakeARobotThatStandsAndDrives() {
        browser.seeText(".sear-note", "the project is empty: choose an object in the palette, then click "
            + "where to place it");
        arm("Wheel");
        browser.click(".sear-middle");
        browser.seeText(".sear-last", "a Wheel is a robot part: place a robot first, for example Chassis from the "
            + "group Robots");
        arm("chassis");
        clickMap(0, 0);
        waitForSelected("chassis1");
        for (int i = 0; i < 3; i++) {
            browser.script("angular.element(document.querySelector('.sear-main')).scope().view.zoom(1.3)");
        }
        arm("Wheel");
        clickMap(0.08, 0);
        waitForSelected("chassis1/wheel1");
        assertEquals("beside the body", 0.12, value("x"), 1e-3);
        assertEquals("it reaches the ground", 0, value("y"), 1e-3);
        assertEquals(0, value("z"), 0.03);
        arm("Wheel");
        clickMap(-0.08, 0);
        waitForSelected("chassis1/wheel2");
        assertEquals(-0.12, value("x"), 1e-3);
        arm("Wheel");
        clickMap(0, -0.16);
        waitForSelected("chassis1/wheel3");
        assertEquals("behind the body", -0.255, value("z"), 1e-3);
        assertEquals(0, value("x"), 0.03);
        assertEquals("as low as the others", 0, value("y"), 1e-3);
        assertEquals(List.of("0 idler", "1 driven", "2 free"), browser.texts("[data-field='type'] option"));
        browser.choose("[data-field='type'] select", "0 idler");
        browser.until("a caster", () -> tab.isTrue("edits.object.values.type == '0'"));
        arm("Motor");
        assertEquals(List.of("the first without a motor", "wheel1", "wheel2"),
            browser.texts("#sear-armed-wheel option"));
        clickMap(0, -0.05);
        waitForSelected("chassis1/motor1");
        assertEquals("wheel1", tab.text("edits.object.values.wheel[0]"));
        middle("Motor", "chassis1/motor2");
        assertEquals("wheel2", tab.text("edits.object.values.wheel[0]"));
        assertEquals(List.of("wheel1", "wheel2"), browser.texts("[data-field='wheel'] option"));
        arm("Motor");
        browser.click(".sear-middle");
        browser.seeText(".sear-last", "a Motor needs a driven wheel without a motor, and chassis1 has none");
        browser.click(".sear-disarm");
        drive();
    }

    /** Checks that the robot stands level, then drives straight. */
    private void drive() {
        browser.click(".sear-test-drive");
        browser.until("a run", () -> tab.isTrue("world.running !== null && world.running.robots.length == 1"));
        tab.waitForTime(0.5);
        double height = tab.number("world.running.robots[0].pose[1]");
        assertEquals("on its wheels", 0.068, height, 0.004);
        browser.click(".sear-forward");
        browser.until("half a metre", () -> tab.number("world.running.robots[0].pose[2]") > 0.5);
        assertEquals("straight on", 0, tab.number("world.running.robots[0].pose[0]"), 0.05);
        assertEquals("level", 0, tab.number("world.running.robots[0].pose[3]"), 3);
        assertEquals(List.of(), browser.texts(".sear-log .alert-warning"));
    }

    @Test
    public void putInTheMiddleWheelsGoToTheFreeSides() {
        middle("chassis", "chassis1");
        double[][] places = {{0.12, 0}, {-0.12, 0}, {0, -0.255}, {0, 0.155}};
        for (int i = 0; i < places.length; i++) {
            middle("Wheel", "chassis1/wheel" + (i + 1));
            assertEquals(places[i][0], value("x"), 1e-3);
            assertEquals(places[i][1], value("z"), 1e-3);
            assertEquals(0, value("y"), 1e-3);
        }
    }
}
