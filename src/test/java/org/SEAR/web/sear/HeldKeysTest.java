// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.web.SearPage;
import org.junit.Test;
import org.openqa.selenium.Keys;
import org.openqa.selenium.interactions.Actions;

/** Held keys steer robots with steered wheels, directly or through their servo. Without steering the page says so. */
public class HeldKeysTest extends SearPage {
    private static final String ROBOT = "world.running.robots[0].";
    /** The page's messages about steering and the service's about circles that it can't drive. */
    private static final String SAID_ONES = "(messages.list | filter:{text: 'steer'})";
    private static final String SAID = SAID_ONES + ".";
    private static final double EPSILON = 0.5;
    private static final String WHEELS = String.join("\n", "from org.SEAR.POJOs import *", "sear.newProject()",
        "Floor('floor', 40, 40)", "robot = SEARrobot('robot')", "robot.addComponent(Dynamics('drive', 4))",
        "robot.move(0, 0.1, 0)", "body = Box('body', 0.2, 0.4, 0.06, 4)", "body.move(0, 0.05, 0)",
        "robot.addComponent(body)", "def wheel(name, kind, x, z):", "    one = Wheel(name, 0.05, 0.03, kind, x, 0, z)",
        "    robot.addWheel(one)", "    return one", "");
    /** A motor at the rear, and front wheels steered by a servo, both on pins of an Arduino. */
    private static final String CAR = WHEELS
        + String.join("\n", "engine = Motor('engine', wheel('left', 1, 0.12, -0.15), 0.6, 40)",
        "engine.addWheel(wheel('right', 1, -0.12, -0.15))", "robot.addComponent(engine)",
        "steering = Servo('steering', 0, 0.05, 0.15)",
        "robot.addComponent(steering)", "for x in (-0.12, 0.12): wheel('front%d' % (100 * x), 2, x, "
        + "0.15).setSteering(steering)",
        "uno = Arduino('uno')", "uno.setPorts('/dev/my_uno', '/dev/SEAR_uno')", "uno.wire(9, 'steering')",
        "uno.wire(5, 'engine', 'pwm')", "robot.addComponent(uno)", "");
    /** A motor wheel in the middle and three free supporting wheels. */
    private static final String MONOCYCLE = WHEELS + String.join("\n", "wheel('middle', 1, 0, 0)",
        "for number, (x, z) in enumerate(((0.1, -0.15), (-0.1, -0.15), (0, 0.15))): wheel('caster%d' % "
            + "number, 0, x, z)", "");


    private void begin(String script, String robot) {
        robotLab.run(script);
        browser.until("the robot", () -> tab.isTrue(
            "world.shown() && world.shown().robots.length == 1 && world.shown().robots[0].name == '" + robot + "'"));
        tab.start();
        new Actions(browser.driver()).moveToElement(browser.see(".sear-view"), 0, 0).click().perform();
    }

    private void hold(CharSequence... keys) {
        Actions actions = new Actions(browser.driver());
        for (CharSequence key : keys) {
            actions.keyDown(key);
        }
        actions.perform();
    }

    private void letGo(CharSequence... keys) {
        Actions actions = new Actions(browser.driver());
        for (CharSequence key : keys) {
            actions.keyUp(key);
        }
        actions.perform();
    }

    private double servo() {
        return robotLab.call("sear", "getServo", "steering").asDouble();
    }

    private double turning() {
        return tab.number(ROBOT + "turnRate");
    }

    @Test
    public void aServoSteersTheCarThatItBelongsTo() {
        begin(CAR, "robot");
        hold("a");
        browser.until("the wheels to the left", () -> Math.abs(servo() - 30) < EPSILON);
        hold("w");
        browser.until("an arc to the left", () -> turning() > 0.1 && tab.number(ROBOT + "speed") > 0.1);
        letGo("a");
        browser.until("straight ahead", () -> Math.abs(servo()) < EPSILON && Math.abs(turning()) < 0.02);
        hold(Keys.ARROW_RIGHT);
        browser.until("an arc to the right", () -> Math.abs(servo() + 30) < EPSILON && turning() < -0.1);
        letGo("w", Keys.ARROW_RIGHT);
        browser.until("it stands, its wheels ahead", () -> tab.number(ROBOT + "speed") == 0
            && Math.abs(servo()) < EPSILON);
        browser.click(".sear-left");
        browser.until("the button, too, drives it to the left", () -> Math.abs(servo() - 30) < EPSILON
            && turning() > 0.1);
        browser.click(".sear-forward");
        browser.until("and straight on", () -> Math.abs(servo()) < EPSILON && Math.abs(turning()) < 0.02
            && tab.number(ROBOT + "speed") > 0.1);
        assertTrue("nothing is complained about", tab.isTrue(SAID + "length == 0"));
    }

    @Test
    public void aReadyCarIsSteeredAsFarAsItsWheelsTurn() {
        begin("from org.SEAR.POJOs import Floor, Robots\nsear.newProject()\nFloor('floor', 40, "
            + "40)\nRobots.car('car')\n", "car");
        hold("w", Keys.ARROW_LEFT);
        browser.until("an arc to the left", () -> turning() > 0.1 && tab.number(ROBOT + "speed") > 0.1);
        letGo(Keys.ARROW_LEFT);
        browser.until("straight ahead", () -> Math.abs(turning()) < 0.02 && tab.number(ROBOT + "speed") > 0.1);
        hold("d");
        browser.until("an arc to the right", () -> turning() < -0.1);
        letGo("w", "d");
        browser.until("it stands", () -> tab.number(ROBOT + "speed") == 0);
        browser.click(".sear-right");
        browser.until("the button drives it to the right", () -> turning() < -0.1 && tab.number(ROBOT + "speed") > 0.1);
        browser.click(".sear-forward");
        browser.until("and straight on", () -> Math.abs(turning()) < 0.02 && tab.number(ROBOT + "speed") > 0.1);
        assertTrue("nothing is complained about", tab.isTrue(SAID + "length == 0"));
    }

    @Test
    public void anUnsteeredRobotIsReportedOnceAndDrivesOn() {
        begin(MONOCYCLE, "robot");
        hold("w");
        browser.until("ahead", () -> tab.number(ROBOT + "speed") > 0.1);
        for (int i = 0; i < 2; i++) {
            hold("a");
            letGo("a");
            browser.until("a word about it",
                () -> tab.isTrue(SAID + "length == 1 && " + SAID_ONES + "[0].text.indexOf('robot can') == 0"));
        }
        assertEquals("once", 1, tab.number(SAID_ONES + "[0].times || 1"), 0);
        browser.until("still ahead", () -> tab.number(ROBOT + "speed") > 0.1);
        letGo("w");
        browser.until("it stands", () -> tab.number(ROBOT + "speed") == 0);
    }
}
