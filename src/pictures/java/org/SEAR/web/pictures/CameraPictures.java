// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.pictures;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.SEAR.web.Browser;
import org.SEAR.web.MyRobotLab;
import org.SEAR.web.SearTab;

/** The tab with live pictures of the three cameras of examples/ball.py. */
final class CameraPictures {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 800;
    /** Folder for visual checks. */
    private static final Path LOOKED_AT = Paths.get(System.getProperty("sear.root", "."), "build/reports/web");

    private CameraPictures() {
    }

    /** @param folder for the picture */
    static void take(Path folder) throws Exception {
        try (Browser browser = new Browser(WIDTH, HEIGHT); MyRobotLab robotLab =
            new MyRobotLab("sear = Runtime.start('sear', 'SEAR')")) {
            SearTab tab = new SearTab(browser, robotLab);
            robotLab.run("sear.loadProject('examples/ball.sear')\nsear.startSimulation()");
            browser.driver().get(robotLab.url() + "#/sear");
            browser.setPageSize(WIDTH, HEIGHT);
            browser.see(SearTab.ROOT);
            browser.until("the simulation", () -> tab.isTrue("world.running !== null && view.fitted"));
            browser.click(".sear-space");
            browser.click(".sear-fold-inspector");
            browser.until("pictures", () -> browser.all("[data-eye] img").size() >= 1);
            browser.script("document.querySelector(\"[data-eye='kinect']\").scrollIntoView()");
            browser.until("that of depths", () -> browser.all("[data-eye='kinect'] img").size() == 1);
            browser.script("var button = document.querySelector(\"[data-eye='kinect'] button\"), box = "
                + "button.getBoundingClientRect();"
                + "button.dispatchEvent(new MouseEvent('click', {detail: 1, bubbles: true, clientX: box.left + 0.9 "
                + "* box.width, clientY: box.top + 0.5 * box.height}))");
            browser.seeText("[data-eye='kinect'] .sear-eye-words", "ahead");
            browser.click("[data-eye='eye']:not([data-large]) .sear-enlarge");
            browser.see(".sear-eye-large img");
            browser.script("document.activeElement.blur()");
            browser.script("document.querySelector(\"[data-sensor='kinect']\").scrollIntoView()");
            browser.until("everything is drawn", () -> Boolean.TRUE.equals(
                browser.script("var scene = angular.element(document.querySelector('.sear-main')).scope().view.scene();"
                    + "return Object.keys(scene.looks.wanted).length === 0 && scene.objects.every(function(item) { "
                        + "return item.dressed })")));
            browser.script("angular.element(document.querySelector('.sear-main')).scope().view.zoom(2.2)");
            take(browser, folder.resolve("tab-cameras.png"));
            browser.setTheme("dark");
            take(browser, LOOKED_AT.resolve("cameras-dark.png"));
            browser.setTheme("light");
            browser.driver().get(robotLab.url() + "?layout=myrobotlab#/sear");
            browser.setPageSize(1024, HEIGHT);
            browser.until("a picture", () -> browser.all("[data-eye] img").size() >= 1);
            take(browser, LOOKED_AT.resolve("cameras-1024.png"));
        }
    }

    private static void take(Browser browser, Path file) throws Exception {
        Files.createDirectories(file.toAbsolutePath().getParent());
        browser.driver().executeAsyncScript("var done = arguments[0]; requestAnimationFrame(function() { "
            + "requestAnimationFrame(done) })");
        browser.picture(file);
        System.out.println(file);
    }
}
