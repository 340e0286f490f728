// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.pictures;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.List;
import org.SEAR.web.Browser;
import org.SEAR.web.build.FirstRobot;
import org.SEAR.web.MyRobotLab;
import org.SEAR.web.SearTab;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.interactions.Actions;

/**
 * Takes the pictures of the tabs for the documentation while a robot with every sensor drives in a yard:
 * {@code scripts/screenshots}.
 */
public final class TabPictures {
    private static final String SCRIPT = "sear = Runtime.start('sear', "
        + "'SEAR')\nsear.loadProject('examples/sensors.sear')\nsear.startSimulation()\n"
        + "lidar = Runtime.start('lidar', 'LIDAR')\nlidar.connect('/dev/SEAR_LIDAR_01')\n"
        + "gps = Runtime.start('gps', 'GPS')\ngps.connect('/dev/SEAR_GPS_01')\n";
    private static final String TERRAIN = "terrain-tab";
    private static final int WIDTH = 1180;
    /** Duration of the drive at SPEED m/s on a circle of RADIUS metres to the left, seconds. */
    private static final double DRIVE = 22;
    private static final double SPEED = 0.3;
    private static final double RADIUS = 1.2;
    private static final double FACTOR = 4;

    private TabPictures() {
    }

    /**
     * @param arguments the folder for the pictures and, for a selection, some of {@code tabs}, {@code terrain-tab},
     *     {@code building}, {@code cameras}, {@code tiles}, {@code palette} and {@code first}
     */
    public static void main(String[] arguments) throws Exception {
        Path folder = Paths.get(arguments[0]);
        List<String> wanted = Arrays.asList(arguments).subList(1, arguments.length);
        if (wanted.isEmpty() || wanted.contains("tabs")) {
            drive(folder);
        }
        if (wanted.isEmpty() || wanted.contains(TERRAIN)) {
            terrain(folder);
        }
        if (wanted.isEmpty() || wanted.contains("building")) {
            BuildingPictures.take(folder);
        }
        if (wanted.isEmpty() || wanted.contains("cameras")) {
            CameraPictures.take(folder);
        }
        if (wanted.isEmpty() || wanted.contains("tiles")) {
            TilePictures.take();
        }
        if (wanted.isEmpty() || wanted.contains("palette")) {
            PalettePictures.take();
        }
        if (wanted.isEmpty() || wanted.contains("first")) {
            first(folder);
        }
        System.exit(0);
    }

    /** Takes the pictures of the tutorial, whose script draws the third itself. */
    private static void first(Path folder) throws Exception {
        Path here = Files.createTempDirectory("sear-first");
        try (Browser browser = new Browser(WIDTH, 800); FirstRobot tutorial =
            new FirstRobot(browser, here, (shown, name) -> {
            try {
                shown.picture(folder.resolve(name + ".png"));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        })) {
            tutorial.walk();
            Files.copy(here.resolve("first.png"), folder.resolve("first-3.png"), StandardCopyOption.REPLACE_EXISTING);
        } finally {
            MyRobotLab.deleteFolder(here);
        }
    }

    /** Takes the tabs of a driving robot. */
    private static void drive(Path folder) throws Exception {
        try (Browser browser = new Browser(WIDTH, 900); MyRobotLab robotLab = new MyRobotLab(SCRIPT)) {
            browser.driver().get(robotLab.url() + "#/sear");
            browser.see("#tab-gps");
            browser.until("all panels", () -> browser.all("mrl-panel[name='gps'] > *").size() > 0);
            robotLab.call("sear", "setSpeed", FACTOR);
            robotLab.call("sear", "drive", SPEED, RADIUS);
            browser.until("the drive", () ->
                browser.number(SearTab.ROOT, "world.running ? world.running.time : -1") > DRIVE);
            robotLab.call("sear", "drive", 0, 0);
            browser.until("the robot stands", () -> browser.number(SearTab.ROOT, "world.running.robots[0].speed") == 0);
            robotLab.call("sear", "setSpeed", 1);
            browser.click("#tab-lidar");
            browser.until("a scan in the tab", () -> {
                robotLab.call("lidar", "singleScan");
                return browser.texts("mrl-panel[name='lidar']").stream()
                    .anyMatch(text -> text.contains("181 ") || text.contains("361 "));
            });
            browser.script("document.querySelectorAll('footer .btn-link, .sear-clear, .lidar-clear, .gps-clear')"
                + ".forEach(function(clear) { clear.click() })");
            for (String tab : new String[] {"sear", "lidar", "gps"}) {
                browser.click("#tab-" + tab);
                browser.see("mrl-panel[name='" + tab + "'] > *");
                if (tab.equals("sear")) {
                    showInSpace(browser);
                }
                browser.script("document.activeElement.blur()");
                take(browser, folder.resolve("tab-" + tab + ".png"));
            }
        }
    }

    private static void showInSpace(Browser browser) {
        browser.click(".sear-space");
        browser.until("all that is to be seen",
            () -> Boolean.TRUE.equals(browser.scope(SearTab.ROOT, "view.scene() !== null")) && Boolean.TRUE.equals(
            browser.script("var scene = angular.element(document.querySelector('.sear-main')).scope().view.scene();"
                + "return Object.keys(scene.looks.wanted).length === 0 && scene.objects.every(function(item) { return "
                    + "item.dressed })")));
    }

    /** Takes the mountains of an example with the pointer on them. */
    private static void terrain(Path folder) throws Exception {
        try (Browser browser = new Browser(WIDTH, 900); MyRobotLab robotLab =
            new MyRobotLab("Runtime.start('sear', 'SEAR')")) {
            browser.driver().get(robotLab.url() + "#/sear");
            terrain(browser, robotLab, folder);
        }
    }

    private static void terrain(Browser browser, MyRobotLab robotLab, Path folder) throws Exception {
        browser.see("mrl-panel[name='sear'] > *");
        robotLab.run(Files.readString(Paths.get("examples/mountain.py")));
        browser.until("the ground",
            () -> Boolean.TRUE.equals(browser.scope(
                SearTab.ROOT, "ground.terrain !== null && ground.terrain.picture.complete")));
        browser.script("document.querySelectorAll('footer .btn-link, .sear-clear').forEach(function(clear) { "
            + "clear.click() })");
        browser.script("angular.element(document.querySelector('.sear-main')).scope().view.zoom(0.3)");
        new Actions(browser.driver()).moveToElement(browser.see(".sear-view"), 120, -90).perform();
        browser.seeText(".sear-pointed", "above the geoid");
        take(browser, folder.resolve(TERRAIN + ".png"));
    }

    /** Takes exactly the whole page. */
    private static void take(Browser browser, Path file) throws Exception {
        Number height = (Number) browser.script(
            "return document.querySelector('.container-fluid').getBoundingClientRect().bottom"
            + " + window.outerHeight - window.innerHeight + 10");
        browser.driver().manage().window().setSize(new Dimension(WIDTH, height.intValue()));
        browser.script("window.dispatchEvent(new Event('resize'))");
        browser.driver().executeAsyncScript("var done = arguments[0]; requestAnimationFrame(function() { "
            + "requestAnimationFrame(done) })");
        browser.picture(file);
        System.out.println(file);
    }
}
