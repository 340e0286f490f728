// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.SEAR.web.SearPage;
import org.SEAR.web.SearTab;
import org.junit.Test;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** The SEAR tab while a world runs: view, driving, run control, tables. */
public class SearTabTest extends SearPage {
    private static final long BALL = 0x9b6fb0ffL;

    private double[] pose(String name) {
        JsonNode pose = robotLab.call("sear", "getPose", name);
        return new double[] {pose.get(0).asDouble(), pose.get(1).asDouble(), pose.get(2).asDouble()};
    }

    @Test
    public void anExampleIsOpenedStartedAndDrivenAndTheViewShowsIt() {
        tab.openExample("office");
        tab.start();
        tab.waitForStatus("running at ");
        double[] before = {tab.number("world.running.robots[0].pose[0]"),
            tab.number("world.running.robots[0].pose[2]")};
        long robot = tab.colour(before[0] - 0.1, before[1] + 0.05);
        assertNotEquals("the robot is drawn where it stands", tab.colour(before[0] - 0.5, before[1] + 0.05), robot);
        browser.click(".sear-forward");
        browser.until("half a metre to the north", () -> tab.number("world.running.robots[0].pose[0]")
            > before[0] + 0.5);
        browser.click(".sear-halt");
        browser.until("the robot stands", () -> tab.number("world.running.robots[0].speed") == 0);
        double[] truth = pose("office Roomba");
        browser.until("the pose in the tab is the robot's",
            () -> Math.abs(tab.number("world.running.robots[0].pose[0]") - truth[0]) < 0.001);
        double[] now = tab.toScreen(tab.number("world.running.robots[0].pose[0]"),
            tab.number("world.running.robots[0].pose[2]"));
        double[] expected = tab.toScreen(truth[0], truth[2]);
        assertEquals(expected[0], now[0], SearTab.NEAR);
        assertEquals(expected[1], now[1], SearTab.NEAR);
        assertEquals("north is up", tab.toScreen(before[0], before[1])[1] - (truth[0] - before[0]) * tab.number(
            "view.scale"), now[1], SearTab.NEAR);
        assertEquals("east is to the right", now[0] + tab.number("view.scale"), tab.toScreen(truth[0], truth[2] + 1)[0],
            SearTab.NEAR);
        browser.until("the robot is no longer drawn where it was",
            () -> tab.colour(before[0] - 0.1, before[1] + 0.05) != robot);
        assertTrue("its path is kept", tab.number("world.running.robots[0].path.length") > 10);
        browser.click(".sear-stop");
        tab.waitForStatus("no simulation runs");
    }

    private boolean isCircleNamed() {
        return Boolean.TRUE.equals(browser.script(
            "return angular.element(document.querySelector('.sear-main')).scope().messages.list"
            + ".some(function(message) { return message.text.indexOf('circle') >= 0 })"));
    }

    /** A servo steers the car, which prevents circles by command; a straight drive is not a circle. */
    @Test
    public void forwardIsNotACircle() {
        tab.openExample("car");
        tab.start();
        browser.click(".sear-forward");
        browser.until("the car drives", () -> tab.number("world.running.robots[0].speed") > 0.1);
        browser.click(".sear-halt");
        browser.until("the car stands", () -> tab.number("world.running.robots[0].speed") == 0);
        browser.click(".sear-left");
        browser.until("its servo steers it to the left", () -> tab.number("world.running.robots[0].turnRate") > 0.1);
        assertFalse("neither is what it steers to", isCircleNamed());
        browser.click(".sear-stop");
    }

    @Test
    public void modelsAreDrawnWithTheirOutline() {
        tab.openExample("office");
        tab.start();
        browser.click(".sear-beams");
        int plant = -1;
        for (int i = 0; i < tab.number("world.running.objects.length"); i++) {
            plant = tab.isTrue("world.running.objects[" + i + "].name === 'plant'") ? i : plant;
        }
        String object = "world.running.objects[" + plant + "]";
        assertTrue(tab.number(object + ".corners.length") > 8);
        double x = tab.number(object + ".pose[0]");
        double z = tab.number(object + ".pose[2]");
        browser.until("a green tree", () -> tab.colour(x + 0.05, z + 0.05) == 0x6b8e23ffL);
        assertNotEquals("a metre beside it", 0x6b8e23ffL, tab.colour(x - 1, z));
    }

    @Test
    public void aSphereIsDrawnAsLargeAsItIs() {
        robotLab.run("from org.SEAR.POJOs import Floor, Sphere\nsear.newProject()\nFloor('floor', 8, 8, False)\n"
            + "Sphere('ball', 0.5, 0, 1, 0.5, -1)\nSphere('egg', 0.5, 0, -2, 0.5, 1).scale(1, 1, 2)\n");
        tab.start();
        browser.seeText(".sear-tree", "ball Sphere");
        browser.until("the ball", () -> tab.colour(1, -1) == BALL && tab.colour(1.4, -1) == BALL
            && tab.colour(1, -0.6) == BALL);
        assertNotEquals("beside the ball", BALL, tab.colour(1.42, -0.58));
        assertEquals("the end of the egg", BALL, tab.colour(-2, 1.9));
        assertNotEquals("beside the egg", BALL, tab.colour(-1.4, 1));
    }

    @Test
    public void pauseStepResumeResetAndSpeed() {
        tab.openExample("maze");
        tab.start();
        browser.click(".sear-pause");
        tab.waitForStatus("paused");
        double paused = robotLab.call("sear", "getTime").asDouble();
        browser.click(".sear-step");
        browser.until("a step of 1/60 s",
            () -> Math.abs(robotLab.call("sear", "getTime").asDouble() - paused - 1 / 60.0) < 1e-6);
        tab.waitForStatus("paused at ");
        browser.click(".sear-resume");
        tab.waitForStatus("running at ");
        tab.waitForTime(paused + 0.2);
        browser.click(".sear-pause");
        browser.click(".sear-reset");
        browser.until("time 0", () -> tab.time() == 0);
        browser.click(".sear-resume");
        browser.choose(".sear-speed", "5 ×");
        browser.until("five times real time", () -> tab.number("world.running.speed") > 1.5);
        TABS.open("sear");
        browser.until("a page that comes later shows the speed",
            () -> "5".equals(browser.see(".sear-speed").getAttribute("value")));
    }

    @Test
    public void inLockStepTheTabShowsThatTimeWaitsAndCanRunIt() {
        tab.openExample("maze");
        robotLab.call("sear", "setLockStep", true);
        tab.start();
        tab.waitForStatus("time waits for a script");
        browser.click(".sear-run");
        tab.waitForTime(0.2);
        tab.waitForStatus("running at ");
        assertTrue("offered no more", browser.all(".sear-run").isEmpty());
    }

    @Test
    public void theKeysOfTheWindowDriveWhenTheViewHasTheFocus() {
        tab.openExample("maze");
        tab.start();
        WebElement view = browser.see(".sear-view");
        new Actions(browser.driver()).moveToElement(view, 0, 0).click().sendKeys("u").perform();
        browser.until("forward", () -> tab.number("world.running.robots[0].speed") > 0.1);
        view.sendKeys("j");
        browser.until("backward", () -> tab.number("world.running.robots[0].speed") < -0.1);
        view.sendKeys("h");
        browser.until("to the left", () -> tab.number("world.running.robots[0].turnRate") > 0.1);
        view.sendKeys("k");
        browser.until("to the right", () -> tab.number("world.running.robots[0].turnRate") < -0.1);
        view.sendKeys(";");
        browser.until("halt", () -> Math.abs(tab.number("world.running.robots[0].turnRate")) < 0.001);
        double before = tab.time();
        view.sendKeys(Keys.ENTER);
        browser.until("reset", () -> tab.time() < before);
    }

    private void key(Keys key, boolean down) {
        Actions actions = new Actions(browser.driver());
        (down ? actions.keyDown(key) : actions.keyUp(key)).perform();
    }

    private void untilItStands() {
        browser.until("it stands", () -> tab.number("world.running.robots[0].speed") == 0
            && Math.abs(tab.number("world.running.robots[0].turnRate")) < 0.001);
    }

    @Test
    public void keysThatAreHeldDriveAndStopWhenTheyAreLetGoAsAGamepadDoes() {
        tab.openExample("maze");
        tab.start();
        WebElement view = browser.see(".sear-view");
        new Actions(browser.driver()).moveToElement(view, 0, 0).click().keyDown("w").perform();
        browser.until("forward", () -> tab.number("world.running.robots[0].speed") > 0.15);
        new Actions(browser.driver()).keyDown("a").perform();
        browser.until("an arc to the left", () -> tab.number("world.running.robots[0].turnRate") > 0.1
            && tab.number("world.running.robots[0].speed") > 0.1);
        new Actions(browser.driver()).keyUp("w").keyUp("a").perform();
        untilItStands();
        key(Keys.ARROW_DOWN, true);
        browser.until("backward", () -> tab.number("world.running.robots[0].speed") < -0.15);
        key(Keys.ARROW_DOWN, false);
        untilItStands();
        key(Keys.ARROW_RIGHT, true);
        browser.until("to the right", () -> tab.number("world.running.robots[0].turnRate") < -0.1);
        browser.script("window.dispatchEvent(new Event('blur'))");
        untilItStands();
        key(Keys.ARROW_RIGHT, false);
        browser.script("var cross = []; for (var i = 0; i < 17; i++) { cross.push({pressed: false}) }"
            + "window.pad = {axes: [0, -1], buttons: cross};"
            + "Object.defineProperty(navigator, 'getGamepads', {configurable: true, value: function() { return [null, "
                + "window.pad] }})");
        browser.until("the stick's speed", () -> tab.number("world.running.robots[0].speed") > 0.3);
        browser.script("window.pad.axes = [0.1, 0.05]");
        untilItStands();
        browser.script("window.pad.buttons[14].pressed = true");
        browser.until("the cross, to the left", () -> tab.number("world.running.robots[0].turnRate") > 0.1);
        browser.script("window.pad.buttons[14].pressed = false");
        untilItStands();
        browser.script("delete navigator.getGamepads");
    }

    @Test
    public void withShiftTheMouseDragsLooseObjects() {
        robotLab.run("from org.SEAR.POJOs import Box, Floor\nsear.newProject()\nFloor('floor', 10, 10)\n"
            + "Box('crate', 0.5, 0.5, 0.5, 2).move(1, 0.25, -1)\nBox('wall', 0.5, 0.5, 0.5, 0).move(-1, 0.25, -1)\n");
        browser.until("the world", () ->
            tab.isTrue("world.shown() && (world.shown().objects | filter:{name: 'crate'}).length == 1"
            + " && world.shown().objects.length == 3 && !world.shown().robots.length"));
        assertFalse("there is nothing to drive", tab.isTrue("run.whyNoDrive() === ''"));
        tab.start();
        String crate = "(world.running.objects | filter:{name: 'crate'})[0].pose";
        dragWithShift(1, -1, 1, 1, () -> browser.until("pulled to the east", () -> tab.number(crate + "[2]") > 0.7
            && browser.all(".sear-spring").stream().anyMatch(WebElement::isDisplayed)));
        browser.until("the spring is gone", () -> browser.all(".sear-spring").stream()
            .noneMatch(WebElement::isDisplayed));
        browser.until("it rests", () -> robotLab.call("sear", "getPose", "crate").get(1).asDouble() < 0.26);
        double x = tab.number("view.x");
        dragWithShift(-1, -1, 0, -1, () -> browser.until("what is fixed stays, and the view moves",
            () -> tab.number("view.x") < x - 0.5));
        browser.click(".sear-fit");
        dragWithShift(1, tab.number(crate + "[2]"), 1, -1, () -> {
            browser.until("pulled to the west", () -> tab.number(crate + "[2]") < 0);
            TABS.open("sear");
        });
        browser.until("the page that went away holds it no longer", () -> robotLab.call("sear", "getPose", "crate")
            .get(1).asDouble() < 0.26);
    }

    private void dragWithShift(double x, double z, double toX, double toZ, Runnable meanwhile) {
        WebElement view = browser.see(".sear-view");
        double[] from = tab.toScreen(x, z);
        double[] to = tab.toScreen(toX, toZ);
        int width = view.getSize().width / 2;
        int height = view.getSize().height / 2;
        new Actions(browser.driver()).keyDown(Keys.SHIFT)
            .moveToElement(view, (int) from[0] - width, (int) from[1] - height).clickAndHold()
            .moveByOffset((int) (to[0] - from[0]) / 2, (int) (to[1] - from[1]) / 2)
            .moveByOffset((int) (to[0] - from[0]) / 2, (int) (to[1] - from[1]) / 2).perform();
        try {
            meanwhile.run();
        } finally {
            new Actions(browser.driver()).release().keyUp(Keys.SHIFT).perform();
        }
    }

    @Test
    public void aDoubleClickStartsAndStopsOnceAndNothingIsComplainedAbout() {
        tab.openExample("maze");
        browser.until("something to start", () -> browser.see(".sear-start").isEnabled());
        new Actions(browser.driver()).doubleClick(browser.see(".sear-start")).perform();
        tab.waitForStatus("running");
        new Actions(browser.driver()).doubleClick(browser.see(".sear-stop")).perform();
        tab.waitForStatus("no simulation runs");
        browser.click(".sear-check");
        browser.seeText(".sear-main .alert-info", "the project has no problems");
        assertEquals(List.of(), browser.all(".sear-main .alert-danger"));
    }

    /** A state sent before a click does not confirm the click's request. */
    @Test
    public void anOlderStateDoesNotOfferTheStartAgain() {
        tab.openExample("maze");
        String scope = "angular.element(document.querySelector('" + SearTab.ROOT + "')).scope()";
        browser.script(scope + ".$apply(function(s) { s.run.pending = 'starting'; s.service.older = true })");
        robotLab.call("sear", "broadcastState");
        browser.until("a state that came after", () -> tab.isTrue("service.older === undefined"));
        tab.waitForStatus("starting");
        assertFalse("can't be clicked", browser.see(".sear-start").isEnabled());
        robotLab.call("sear", "startSimulation");
        tab.waitForStatus("running");
        browser.script(scope + ".$apply(function(s) { s.run.pending = 'stopping'; s.service.older = true })");
        robotLab.call("sear", "broadcastState");
        browser.until("a state that came after", () -> tab.isTrue("service.older === undefined"));
        tab.waitForStatus("stopping");
        robotLab.call("sear", "stopSimulation");
        tab.waitForStatus("no simulation runs");
    }

    @Test
    public void theWorldIsFittedAgainWhenThePageGetsNarrower() {
        tab.openExample("maze");
        tab.start();
        browser.click(".sear-pause");
        double wide = tab.number("view.scale");
        try {
            browser.setPageWidth(390);
            browser.until("a smaller world", () -> tab.number("view.scale") < wide * 0.9);
            browser.click("button[aria-label='Zoom in']");
            double chosen = tab.number("view.scale");
            browser.setPageWidth(500);
            browser.until("drawn anew", () -> tab.number("view.size.split(' ')[0] * 1") > 390);
            assertEquals("what the user has chosen stays", chosen, tab.number("view.scale"), 1e-9);
        } finally {
            browser.setPageWidth(0);
        }
    }

    @Test
    public void keysThatTheBrowserWantsAreLeftToIt() {
        tab.openExample("maze");
        tab.start();
        WebElement view = browser.see(".sear-view");
        view.sendKeys(Keys.chord(Keys.CONTROL, Keys.ALT, "k"));
        view.sendKeys("u");
        browser.until("forward, and no turn before", () -> tab.number("world.running.robots[0].speed") > 0.1);
        assertEquals(0, tab.number("world.running.robots[0].turnRate"), 0.1);
    }

    @Test
    public void theOtherButtonsDriveToo() {
        tab.openExample("maze");
        tab.start();
        browser.click(".sear-left");
        browser.until("to the left", () -> tab.number("world.running.robots[0].turnRate") > 0.1);
        browser.click(".sear-right");
        browser.until("to the right", () -> tab.number("world.running.robots[0].turnRate") < -0.1);
        browser.click(".sear-backward");
        browser.until("backward", () -> tab.number("world.running.robots[0].speed") < -0.1);
    }

    @Test
    public void theTablesShowEverySensorAndTheWorldAsATree() {
        tab.openExample("sensors");
        tab.start();
        List<String> names = new ArrayList<>();
        robotLab.call("sear", "getSensorNames").forEach(name -> names.add(name.asText()));
        for (String name : names) {
            browser.seeText(".sear-sensors tr", name);
        }
        browser.click(".sear-forward");
        browser.until("the compass as the service answers it", () -> {
            String shown = browser.text(".sear-sensors tr[data-sensor='compass'] .sear-reading");
            double truth = robotLab.call("sear", "getCompassResult", "compass").asDouble();
            return shown.endsWith(" deg") && Math.abs(Double.parseDouble(shown.replace(" deg", "")) - truth) < 1;
        });
        browser.seeText(".sear-sensors tr[data-sensor='myLidar'] .sear-reading", " of 361 beams hit");
        browser.seeText(".sear-tree", "container Box");
        browser.seeText(".sear-tree", "myRoomba robot");
        browser.seeText(".sear-tree", "body Cylinder");
        browser.seeText(".sear-robot-status", "battery");
        String position = browser.text(".sear-robot-position");
        assertTrue(position, position.matches("-?\\d+\\.\\d{3}, -?\\d+\\.\\d{3}"));
    }

    @Test
    public void aButtonSwitchesThePowerOfADevice() {
        tab.openExample("sensors");
        tab.start();
        browser.until("all on", () -> browser.text(".sear-power").equals("on"));
        browser.click(".sear-power");
        browser.until("it is off", () -> browser.text(".sear-power").equals("off"));
        browser.seeText(".sear-robot-status div", ": off");
        browser.click(".sear-power");
        browser.until("it is on again", () -> browser.text(".sear-power").equals("on"));
    }

    /** The square at a beam's end marks a hit; a beam without a hit has none. */
    @Test
    public void aSonarThatMeetsNothingHasNoHit() {
        robotLab.run("from org.SEAR.POJOs import Box, Cylinder, Distance, Dynamics, Floor, SEARrobot, "
            + "Wheel\nsear.newProject()\n"
            + "Floor('floor', 20, 20, False)\nwall = Box('wall', 4, 0.2, 1, 0)\nwall.move(0, 0.5, 2)\n"
            + "robot = SEARrobot('bot')\nrobot.addComponent(Dynamics('d', 4, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, "
            + "0, 0, 0, 0))\nrobot.addComponent(Cylinder('body', 0.17, 0.08, 4))\n"
            + "for i, x, z in ((0, 0, 0.16), (1, -0.16, 0), (1, 0.16, 0), (0, 0, -0.16)):\n"
            + "    robot.addWheel(Wheel('w%d' % (x * 100 + z * 10), 0.0381, 0.03, i, x, 0, z))\n"
            + "robot.addComponent(Distance('ahead', 'PING)))', 0, 0.1, 0.15, 0, 0, 0))\n"
            + "robot.addComponent(Distance('behind', 'PING)))', 0, 0.1, -0.15, 0, 180, 0))\n");
        tab.start();
        browser.seeText(".sear-sensors tr[data-sensor='behind'] .sear-reading", "nothing within 3 m");
        String ahead = "world.running.sensors[0].name === 'ahead' ? world.running.sensors[0] : "
            + "world.running.sensors[1]";
        assertEquals(2 - 0.1, tab.number("(" + ahead + ").hit[2]"), 0.01);
        String behind = "world.running.sensors[0].name === 'ahead' ? world.running.sensors[1] : "
            + "world.running.sensors[0]";
        assertTrue(tab.isTrue("(" + behind + ").hit === null"));
        assertNotEquals("no square at the end of the beam that met nothing", 0xd9534fffL, tab.colour(0, -0.15 - 3));
        double z = tab.number("(" + ahead + ").hit[2]");
        double x = tab.number("(" + ahead + ").hit[0]");
        browser.until("a square at the wall", () -> tab.colour(x, z) == 0xd9534fffL);
    }

    @Test
    public void readingsHaveTheirUnitAndAsManyDigitsAsMakeSense() {
        tab.openExample("sensors");
        tab.start();
        String readings = String.join("\n", browser.texts(".sear-reading"));
        for (String pattern : new String[] {"-?\\d+\\.\\d deg",
            "-?\\d+\\.\\d{3}, -?\\d+\\.\\d{3}, -?\\d+\\.\\d{3} m/s2",
            "-?\\d+\\.\\d{3}, -?\\d+\\.\\d{3}, -?\\d+\\.\\d{3} rad/s", "-?\\d+\\.\\d{7}, -?\\d+\\.\\d{7} deg, "
                + "-?\\d+\\.\\d\\d m"}) {
            assertTrue(pattern + " in\n" + readings, Pattern.compile("^" + pattern + "$", Pattern.MULTILINE)
                .matcher(readings).find());
        }
    }

    private static final String PING = "robot.addComponent(Distance('ping', 'PING)))', 0, 0.1, 0.15, 0, 0, 0))\n";

    private static String robot(String name, double x) {
        return "robot = SEARrobot('" + name + "')\nrobot.addComponent(Dynamics('drive', 4, 60, 0.3, 0.4, "
            + "10000, 0.1, " + x + ", 0.1, 0, 0, 0, 0))\nrobot.addComponent(Cylinder('body', 0.17, 0.08, 4))\n"
            + "for i, x, z in ((0, 0, 0.16), (1, -0.16, 0), (1, 0.16, 0), (0, 0, -0.16)):\n"
            + "    robot.addWheel(Wheel('w%d' % (x * 100 + z * 10), 0.0381, 0.03, i, x, 0, z))\n";
    }

    @Test
    public void oneOfSeveralRobotsIsChosenToDriveAndFollow() {
        robotLab.run("from org.SEAR.POJOs import Cylinder, Distance, Dynamics, Floor, SEARrobot, "
            + "Wheel\nsear.newProject()\n"
            + "Floor('floor', 20, 20, False)\n" + robot("anna", 0) + PING + robot("bert", 2) + PING);
        tab.start();
        int bert = tab.isTrue("world.running.robots[0].name === 'bert'") ? 0 : 1;
        String driven = "world.running.robots[" + bert + "]";
        String other = "world.running.robots[" + (1 - bert) + "]";
        browser.choose(".sear-robot", "bert");
        browser.click(".sear-follow");
        browser.click(".sear-forward");
        browser.until("bert drives", () -> tab.number(driven + ".speed") > 0.1);
        assertEquals("anna stands", 0, tab.number(other + ".speed"), 0.01);
        browser.until("the view follows bert",
            () -> tab.isTrue("view.x === " + driven + ".pose[0] && view.z === " + driven + ".pose[2]"));
        browser.choose(".sear-robot", "anna");
        browser.see(".sear-view").sendKeys("j");
        browser.until("anna drives backward", () -> tab.number(other + ".speed") < -0.1);
        browser.until("the view follows anna",
            () -> tab.isTrue("view.x === " + other + ".pose[0] && view.z === " + other + ".pose[2]"));
        assertTrue("and bert goes on", tab.number(driven + ".speed") > 0.1);
        for (String sensor : new String[] {"anna/ping", "bert/ping"}) {
            browser.seeText("[data-sensor='" + sensor + "']", sensor + " Distance");
            browser.seeText(".sear-tree", sensor);
        }
        assertTrue(robotLab.call("sear", "getReading", "bert/ping").asDouble() > 0);
    }

    /** A page that opens during a run gets the whole world, resting objects included, and keeps up with it. */
    @Test
    public void aPageThatOpensLaterHasTheWholeWorldAndKeepsUp() {
        robotLab.call("sear", "newProject");
        robotLab.run("from org.SEAR.POJOs import Box, Cylinder, Dynamics, Floor, SEARrobot, Wheel\nFloor('floor', 20, "
            + "20, False)\nfaller = Box('faller', 0.3, 0.3, 0.3, 1)\nfaller.move(3, 1, 3)\nwall = Box('wall', 1, 1, 1, "
            + "0)\nwall.move(-3, 0.5, 0)\n" + robot("anna", 0));
        tab.start();
        browser.until("the box has fallen", () -> robotLab.call("sear", "getPose", "faller").get(1).asDouble() < 0.16);
        robotLab.call("sear", "drive", 0.2, 1e6);
        TABS.open("sear");
        browser.until("the world", () -> tab.isTrue("world.running.objects.length === 3"));
        double height = robotLab.call("sear", "getPose", "faller").get(1).asDouble();
        assertEquals("it lies where it fell", height,
            tab.number("(world.running.objects | filter:{name: 'faller'})[0].pose[1]"), 0.001);
        double before = tab.number("world.running.robots[0].pose[2]");
        browser.until("the robot drives on", () -> tab.number("world.running.robots[0].pose[2]") > before + 0.1);
        assertTrue("its path grows", tab.number("world.running.robots[0].path.length") > 3);
        double time = tab.time();
        browser.script("angular.element(document.querySelector('.sear-main')).scope().world.running.number -= 2");
        tab.waitForTime(time + 0.3);
        browser.until("a page that has missed something asks for the whole",
            () -> Math.abs(tab.number("world.running.robots[0].pose[2]")
            - robotLab.call("sear", "getPose", "anna").get(2).asDouble()) < 0.2);
    }

    @Test
    public void aPageOpenedLaterKnowsObjectsThatFellOutOfTheWorld() {
        robotLab.call("sear", "newProject");
        robotLab.run("from org.SEAR.POJOs import Box, Floor\nFloor('floor', 2, 2)\nlost = Box('lost', 0.3, 0.3, 0.3, "
            + "1)\nlost.move(3, 1, 3)\n");
        tab.start();
        browser.until("the box has fallen", () -> robotLab.call("sear", "getPose", "lost").get(1).asDouble() < -12);
        TABS.open("sear");
        browser.until("the warning", () ->
            tab.isTrue("(messages.list | filter:{text: 'lost has fallen out of the world'}).length === 1"));
    }

    @Test
    public void theViewZoomsPansFitsAndFollows() {
        tab.openExample("maze");
        tab.start();
        browser.click(".sear-pause");
        double scale = tab.number("view.scale");
        browser.click("button[aria-label='Zoom in']");
        browser.until("closer", () -> tab.number("view.scale") > scale);
        WebElement view = browser.see(".sear-view");
        browser.script("arguments[0].dispatchEvent(new WheelEvent('wheel', {deltaY: 100, cancelable: true}))", view);
        browser.script("arguments[0].dispatchEvent(new WheelEvent('wheel', {deltaY: 100, cancelable: true}))", view);
        browser.until("farther", () -> tab.number("view.scale") < scale);
        double before = tab.number("view.z");
        new Actions(browser.driver()).moveToElement(view).clickAndHold().moveByOffset(60, 0).release().perform();
        browser.until("panned", () -> tab.number("view.z") < before);
        browser.click(".sear-fit");
        browser.until("fitted", () -> Math.abs(tab.number("view.scale") - scale) < 1e-6);
        browser.click(".sear-follow");
        browser.until("the robot in the middle",
            () -> tab.isTrue("view.x === world.running.robots[0].pose[0] && view.z === "
                + "world.running.robots[0].pose[2]"));
        assertFalse(tab.isTrue("view.scale === 0"));
    }
}
