// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import java.nio.file.Files;
import java.util.Map;
import org.openqa.selenium.WebElement;

/** Drives the SEAR tab as a user does. */
public final class SearTab {
    public static final String ROOT = ".sear-main";
    /** Tolerance of positions, pixels. */
    public static final double NEAR = 2;

    private final Browser browser;
    private final MyRobotLab robotLab;

    public SearTab(Tabs tabs) {
        this(tabs.browser(), tabs.robotLab());
    }

    public SearTab(Browser browser, MyRobotLab robotLab) {
        this.browser = browser;
        this.robotLab = robotLab;
    }

    /** Stops the simulation of an earlier test. */
    public void stopAll() {
        if (robotLab.call("sear", "isSimulating").asBoolean()) {
            robotLab.call("sear", "stopSimulation");
        }
        robotLab.call("sear", "setSpeed", 1);
        waitForStatus("no simulation runs");
    }

    /** Shows the list of projects. */
    public void showProjects() {
        if (!isTrue("welcome.isShown()")) {
            browser.click(".sear-open");
        }
        browser.see(".sear-welcome");
    }

    /** Opens a project by its path. */
    public void openPath(String path) {
        showProjects();
        browser.type(".sear-other-path", path);
        browser.click(".sear-load");
    }

    /** Opens an example by the list. */
    public void openExample(String name) {
        String path = "examples/" + name + ".sear";
        showProjects();
        browser.click("[data-tile='" + name + "']");
        browser.seeText(".sear-main .alert-info", "opened " + path);
    }

    /** Waits until the project has a robot. */
    public void waitForRobot(String name) {
        browser.until("the robot " + name, () -> Files.exists(robotLab.file("SEARproject/robot/" + name + ".xml")));
    }

    /** Starts the simulation and returns when its first picture is shown. */
    public void start() {
        browser.click(".sear-start");
        browser.until("a running simulation", () -> isTrue("world.running !== null && view.fitted"));
    }

    public void waitForStatus(String part) {
        browser.seeText(".sear-status", part);
    }

    public boolean isTrue(String expression) {
        return Boolean.TRUE.equals(browser.scope(ROOT, expression));
    }

    public double number(String expression) {
        return browser.number(ROOT, expression);
    }

    /** Returns the value of an expression as text. */
    public String text(String expression) {
        return String.valueOf(browser.scope(ROOT, expression));
    }

    /** Returns the simulated time of the panel, seconds; -1 if none. */
    public double time() {
        return number("world.running ? world.running.time : -1");
    }

    /** Waits until the panel shows this simulated time, seconds. */
    public void waitForTime(double seconds) {
        browser.until("simulated second " + seconds, () -> time() >= seconds);
    }

    /** Returns the colour of a point of the ground in the view: red, green, blue, alpha as 0xRRGGBBAA. */
    public long colour(double x, double z) {
        WebElement view = browser.see(".sear-view");
        Object value = browser.script("var at = angular.element(arguments[0]).scope().view.toScreen(arguments[1], "
            + "arguments[2]);"
            + "var ratio = window.devicePixelRatio || 1;"
            + "var c = arguments[0].getContext('2d').getImageData(Math.round(at.x * ratio), Math.round(at.y * "
            + "ratio), 1, 1).data;"
            + "return ((c[0] * 256 + c[1]) * 256 + c[2]) * 256 + c[3]", view, x, z);
        return ((Number) value).longValue();
    }

    /** Returns the canvas position of a point of the ground, pixels. */
    @SuppressWarnings("unchecked")
    public double[] toScreen(double x, double z) {
        Map<String, Number> at = (Map<String, Number>) browser.scope(ROOT, "view.toScreen(" + x + ", " + z + ")");
        return new double[] {at.get("x").doubleValue(), at.get("y").doubleValue()};
    }
}
