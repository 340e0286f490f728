// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.pictures;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.SEAR.web.Browser;
import org.SEAR.web.MyRobotLab;
import org.SEAR.web.SearTab;
import org.openqa.selenium.OutputType;

/** Takes the pictures of the tiles in an empty view: each example, and an object under construction. */
final class TilePictures {
    private static final Path FOLDER = Paths.get("resources/resource/WebGui/app/service/js/sear/tiles");
    /** Style that shows the view alone at the size of a tile's picture. */
    private static final String FRAME = String.join("\n",
        "var style = document.createElement('style')",
        "style.textContent = '.sear-canvas { position: fixed !important; left: 0; top: 0; width: 480px; height: 300px "
        + "!important; min-height: 0;'", "    + ' z-index: 9999; border: 0 !important; border-radius: 0 !important }'",
        "    + ' .sear-over, .sear-note, .sear-welcome { display: none !important }'",
        "document.head.appendChild(style)");
    private static final String BUILT = String.join("\n",
        "from org.SEAR.POJOs import Box, Cone, Cylinder, Floor, Robots, Sphere",
        "sear.newProject()",
        "Floor('floor', 6, 6)",
        "Robots.rover('rover')",
        "for name, color, x, z in (('a', 'red', 0.9, -0.5), ('b', 'orange', 0.9, 0.1), ('c', 'teal', 0.6, 0.8)):",
        "    box = Box(name, 0.25, 0.25, 0.25)",
        "    box.move(x, 0.125, z)",
        "    box.setColor(color)",
        "cone = Cone('cone', 0.15, 0.4)",
        "cone.move(-0.3, 0.2, 0.8)",
        "cone.setColor('gold')");

    private static final String FIRST = String.join("\n",
        "from org.SEAR.POJOs import Box, Distance, Floor, Robots",
        "sear.newProject()",
        "Floor('floor', 6, 6)",
        "robot = Robots.rover('rover')",
        "eye = Distance('eye', 'ultrasonic')",
        "eye.move(0, 0.045, 0)",
        "eye.rotate(-20, 0, 0)",
        "robot.addComponent(eye)",
        "wall = Box('wall', 0.8, 0.1, 0.25)",
        "wall.move(0, 0.125, 1)");

    private TilePictures() {
    }

    static void take() throws IOException, InterruptedException {
        try (Browser browser = new Browser(1000, 800); MyRobotLab robotLab =
            new MyRobotLab("sear = Runtime.start('sear', 'SEAR')")) {
            browser.driver().get(robotLab.url() + "#/sear");
            browser.see(SearTab.ROOT);
            browser.script("localStorage.setItem('sear.view', 'space')");
            browser.driver().navigate().refresh();
            browser.see(SearTab.ROOT);
            browser.script(FRAME);
            try (Stream<Path> examples = Files.list(Paths.get("examples"))) {
                for (Path example : examples.filter(path -> path.toString().endsWith(".sear")).sorted()
                    .collect(Collectors.toList())) {
                    String name = example.getFileName().toString().replace(".sear", "");
                    robotLab.call("sear", "loadProject", "examples/" + name + ".sear");
                    robotLab.call("sear", "startSimulation");
                    browser.until("a run of " + name,
                        () -> browser.number(SearTab.ROOT, "world.running ? world.running.time : -1") > 1);
                    take(browser, name);
                    robotLab.call("sear", "stopSimulation");
                    browser.until("the end of " + name,
                        () -> Boolean.TRUE.equals(browser.scope(SearTab.ROOT, "service.simulating === false")));
                }
            }
            robotLab.run(BUILT);
            browser.until("what is built",
                () -> browser.number(SearTab.ROOT, "world.shown() ? world.shown().objects.length : 0") > 4);
            browser.script("angular.element(document.querySelector('.sear-main')).scope().view.build(true)");
            take(browser, "build");
            robotLab.run(FIRST);
            browser.until("a rover with an eye",
                () -> browser.number(SearTab.ROOT, "world.shown() ? world.shown().sensors.length : 0") == 1);
            take(browser, "tour");
        }
    }

    private static void take(Browser browser, String name) throws IOException {
        browser.script("var view = angular.element(document.querySelector('.sear-main')).scope().view; view.fit()");
        browser.until("a view of all", () -> Boolean.TRUE.equals(browser.scope(SearTab.ROOT, "view.fitted")));
        browser.script("angular.element(document.querySelector('.sear-main')).scope().view.zoom(1.25)");
        browser.until("all looks", () -> Boolean.TRUE.equals(
            browser.script("return angular.element(document.querySelector('.sear-main')).scope()"
            + ".view.scene().objects.every(function(item) { return item.dressed })")));
        BufferedImage shot = ImageIO.read(
            new ByteArrayInputStream(browser.see(".sear-canvas").getScreenshotAs(OutputType.BYTES)));
        BufferedImage picture = new BufferedImage(shot.getWidth(), shot.getHeight(), BufferedImage.TYPE_INT_RGB);
        picture.createGraphics().drawImage(shot, 0, 0, null);
        Files.createDirectories(FOLDER);
        ImageIO.write(picture, "jpg", FOLDER.resolve(name + ".jpg").toFile());
    }
}
