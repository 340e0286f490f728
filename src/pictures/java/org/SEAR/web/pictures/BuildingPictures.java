// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.pictures;

import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import org.SEAR.web.Browser;
import org.SEAR.web.MyRobotLab;
import org.SEAR.web.SearTab;
import org.openqa.selenium.WebElement;

/** A rover is built by mouse and driven: an animation of it, a picture of the tab and one of a plot of the drive. */
final class BuildingPictures {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    private static final String ROBOT = "rover";
    /** Times after a new object appears and at the end, hundredths of a second. */
    private static final int LOOK = 70;
    private static final int END = 250;
    private static final int GLANCE = 8;
    private static final double DRIVE_SECONDS = 8;
    private static final double TURN_SECONDS = 2;
    /** Steps between two pictures of the drive. */
    private static final int STEPS = 9;
    private static final double STEP_SECONDS = 1 / 60.0;
    /** Folder of {@link LayoutTest} and other tests for visual checks. */
    private static final Path LOOKED_AT = Paths.get(System.getProperty("sear.root", "."), "build/reports/web");

    private final Browser browser;
    private final MyRobotLab robotLab;
    private final SearTab tab;
    private final Path folder;
    private Film film;

    private BuildingPictures(Browser browser, MyRobotLab robotLab, Path folder) {
        this.browser = browser;
        this.robotLab = robotLab;
        this.folder = folder;
        tab = new SearTab(browser, robotLab);
    }

    /** @param folder for the pictures */
    static void take(Path folder) throws Exception {
        try (Browser browser = new Browser(WIDTH, HEIGHT); MyRobotLab robotLab =
            new MyRobotLab("sear = Runtime.start('sear', 'SEAR')")) {
            browser.driver().get(robotLab.url() + "#/sear");
            browser.setPageSize(WIDTH, HEIGHT);
            BuildingPictures pictures = new BuildingPictures(browser, robotLab, folder);
            pictures.build();
            pictures.drive();
            pictures.plot();
        }
    }

    private void build() throws IOException {
        browser.see(SearTab.ROOT);
        browser.until("the panel", () -> tab.isTrue("service && world.preview !== null && edits.grammar !== null"));
        film = new Film(browser);
        film.shoot(LOOK);
        film.click("[data-tile='build']");
        browser.see(".sear-palette");
        browser.click(".sear-space");
        browser.until("the view in space", () -> tab.isTrue("view.scene() !== null && view.fitted"));
        browser.scope(SearTab.ROOT, "view.zoom(0.8)");
        film.shoot(LOOK);
        place("Floor", 0, 0, 0, "floor1");
        String template = (String) browser.script(
            "var all = angular.element(document.querySelector('.sear-main')).scope().edits.grammar.templates;"
            + "return all.filter(function(one) { return /rover/i.test(one) })[0] || all[all.length - 1]");
        place(template, 0, 0, -1.5, null);
        film.type("#sear-p-name", ROBOT);
        waitForSelected(ROBOT);
        film.shoot(LOOK);
        double top = ((Number) browser.module("world/pointing.js", "return module.extent("
            + "angular.element(document.querySelector('.sear-main')).scope().world.shown().robots[0])[1][1]"))
            .doubleValue();
        place("LIDAR", 0, top, -1.5, ROBOT + "/lidar1");
        place("Box", 0.3, 0, 1.3, "box1");
        film.type("[data-field='color'] .form-control", "orange");
        browser.until("its colour", () -> tab.isTrue("edits.object.values.color == 'orange'"));
        settle();
        film.drag(inSpace(0.175, 0.06, 1.26), inSpace(-0.7, 0.06, 1.6));
        browser.until("its place", () -> tab.isTrue("edits.object.values.z != '1.3'"));
        film.shoot(LOOK);
        place("Cylinder", 1.2, 0, 0.5, "cylinder1");
        settle();
        picture("tab-building");
    }

    /** Takes a picture for the documentation, and a dark one for visual checks. */
    private void picture(String name) throws IOException {
        browser.setTheme("dark");
        browser.picture(LOOKED_AT.resolve(name + "-dark.png"));
        browser.setTheme("light");
        browser.picture(folder.resolve(name + ".png"));
        System.out.println(folder.resolve(name + ".png"));
    }

    private void place(String what, double x, double y, double z, String name) throws IOException {
        film.click(".sear-palette [data-make='" + what + "']");
        browser.until(what + " to place", () -> tab.isTrue("palette.armed !== null"));
        film.shoot(GLANCE);
        double[] at = inSpace(x, y, z);
        film.click(at[0], at[1]);
        browser.until(what + " to be made", () -> tab.isTrue("palette.armed === null && edits.object !== null"));
        if (name != null) {
            waitForSelected(name);
        }
        settle();
        film.shoot(LOOK);
    }

    private void waitForSelected(String name) {
        browser.until(name + " selected", () -> tab.isTrue("edits.object && edits.object.object == '" + name + "'"));
    }

    /** Waits until the view has received all requested data. */
    private void settle() {
        browser.until("all that is to be seen", () -> Boolean.TRUE.equals(browser.script("var scope = angular.element("
            + "document.querySelector('.sear-main')).scope(), scene = scope.view.scene();"
            + "return Object.keys(scene.looks.wanted).length === 0 && scope.edits.selected !== null"
            + " && scope.building.found() !== null && scene.objects.every(function(item) { return item.dressed })"
            + " && scene.robots.every(function(robot) { return robot.parts.every(function(item) { return "
                + "item.dressed }) })")));
    }

    /** Returns the page position of a point of the world. */
    @SuppressWarnings("unchecked")
    private double[] inSpace(double x, double y, double z) {
        WebElement canvas = browser.see(".sear-scene");
        List<Number> at = (List<Number>) browser.script("var box = arguments[0].getBoundingClientRect();"
            + "var at = angular.element(arguments[0]).scope().view.scene().toScreen(arguments[1], arguments[2], "
            + "arguments[3]);return [box.left + at.x, box.top + at.y]", canvas, x, y, z);
        return new double[] {at.get(0).doubleValue(), at.get(1).doubleValue()};
    }

    private void drive() throws IOException {
        browser.scope(SearTab.ROOT, "edits.select(null)");
        film.click(".sear-start");
        browser.until("a running simulation", () -> tab.isTrue("world.running !== null && service.simulating"));
        robotLab.call("sear", "recordRun", "drive.searlog");
        film.shoot(LOOK);
        robotLab.call("sear", "pause");
        browser.until("a pause", () -> tab.isTrue("service.paused"));
        film.click(".sear-forward");
        shootFor(DRIVE_SECONDS);
        film.click(".sear-left");
        shootFor(TURN_SECONDS);
        film.click(".sear-halt");
        film.shoot(END);
        film.end();
        film.write(folder.resolve("building.gif"));
        System.out.println(folder.resolve("building.gif"));
        robotLab.call("sear", "stopSimulation");
        browser.until("no simulation", () -> tab.isTrue("!service.simulating"));
    }

    /** Films step by step, so that a slow machine makes the same film. */
    private void shootFor(double seconds) throws IOException {
        for (double shown = 0; shown < seconds; shown += STEPS * STEP_SECONDS) {
            double next = tab.time() + (STEPS - 0.5) * STEP_SECONDS;
            robotLab.call("sear", "step", STEPS);
            tab.waitForTime(next);
            film.shoot((int) Math.round(100 * STEPS * STEP_SECONDS));
        }
    }

    private void plot() throws IOException {
        if (tab.isTrue("view.building")) {
            browser.click(".sear-build");
        }
        if (browser.all(".sear-source").stream().noneMatch(WebElement::isDisplayed)) {
            browser.click(".sear-plots");
        }
        browser.choose(".sear-source", "drive.searlog");
        browser.until("the record", () -> tab.isTrue("replay.shown !== null && plot.names.length > 5"));
        for (String value : List.of(ROBOT + ".z", ROBOT + ".speed", "lidar1")) {
            browser.choose(".sear-add", value);
        }
        browser.until("three lines", () -> tab.isTrue("plot.chart() && plot.chart().lines.length == 3"));
        browser.script("var s = document.querySelector('.sear-slider'); s.value = Math.round(s.max / 2);"
            + "['input', 'change'].forEach(function(one) { s.dispatchEvent(new Event(one, {bubbles: true})) })");
        browser.until("the middle of the drive", () -> tab.isTrue("replay.shown.index > 0"));
        browser.script("document.activeElement.blur(); "
            + "document.querySelector('.sear-plot').scrollIntoView({block: 'nearest'})");
        picture("tab-plot");
    }
}
