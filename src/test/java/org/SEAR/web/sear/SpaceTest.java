// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import javax.imageio.ImageIO;
import org.SEAR.web.SearPage;
import org.SEAR.web.SearTab;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** The view in space of the SEAR tab: objects, places and looks. */
public class SpaceTest extends SearPage {
    private static final String WORLD = String.join("\n",
        "from org.SEAR.POJOs import Box, Bumper, Cylinder, Distance, Floor, Led, LIDAR, Robots, Servo, Sphere",
        "sear.newProject()",
        "Floor('floor', 8, 8).setColor('#808080')",
        "box = Box('box', 1, 1, 1, 0)",
        "box.move(1, 0.5, 2)",
        "box.setColor('#cc2020')",
        "Box('wall', 2, 0.2, 0.5, 0).move(0, 0.25, 3)",
        "ball = Sphere('ball', 0.5)",
        "ball.move(1, 0.5, -2)",
        "ball.setColor('#2020cc')",
        "robot = Robots.create2('roomba')",
        "scanner = LIDAR('scanner', 4, 180, 1, 0, 0.15, 0.1)",
        "robot.addComponent(scanner)",
        "robot.addComponent(Distance('ping', 'PING)))'))",
        "robot.addComponent(Bumper('bumper'))",
        "lamp = Led('lamp', '#00ff00', 0, 0.2, 0.1)",
        "neck = Servo('neck')",
        "neck.mount(lamp)",
        "robot.addComponent(lamp)",
        "robot.addComponent(neck)");


    @Before
    public void showTheWorld() {
        browser.until("no simulation", () -> tab.isTrue("service && !service.simulating"));
        robotLab.run(WORLD);
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().robots.length == 1"));
        browser.click(".sear-space");
        browser.until("all of it", () -> Boolean.TRUE.equals(
            inScene("Object.keys(scene.looks.wanted).length === 0 && scene.robots.length === 1"
            + " && scene.objects.concat(scene.robots[0].parts).every(function(item) { return item.dressed && "
                + "item.holder.visible })")));
        browser.until("a view that will not turn by itself to show all", () -> tab.isTrue("view.fitted"));
    }

    @After
    public void stop() {
        if (robotLab.call("sear", "isSimulating").asBoolean()) {
            robotLab.call("sear", "stopSimulation");
        }
    }

    private Object inScene(String expression) {
        return browser.script("var scene = angular.element(document.querySelector('.sear-main')).scope().view.scene();"
            + "return scene && (" + expression + ")");
    }

    private double[] place(double x, double y, double z) {
        @SuppressWarnings("unchecked")
        Map<String, Object> at = (Map<String, Object>) inScene("scene.toScreen(" + x + ", " + y + ", " + z + ")");
        return new double[] {((Number) at.get("x")).doubleValue(), ((Number) at.get("y")).doubleValue()};
    }

    /** Returns red, green and blue of the page at a place. */
    private int[] colour(double[] place) throws IOException {
        WebElement view = browser.see(".sear-scene");
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(view.getScreenshotAs(OutputType.BYTES)));
        int pixel = picture.getRGB((int) Math.round(place[0]) + 1, (int) Math.round(place[1]) + 1);
        return new int[] {pixel >> 16 & 0xff, pixel >> 8 & 0xff, pixel & 0xff};
    }

    private String pointedAt(double[] place) {
        WebElement view = browser.see(".sear-scene");
        Dimension size = view.getSize();
        new Actions(browser.driver()).moveToElement(view, (int) place[0] - size.getWidth() / 2,
            (int) place[1] - size.getHeight() / 2).perform();
        return browser.text(".sear-pointed");
    }

    /** Points until the text appears; the view may be fitted again meanwhile. */
    private void seeAt(String text, double x, double y, double z) {
        browser.until(text, () -> pointedAt(place(x, y, z)).contains(text));
    }

    @Test
    public void thingsAreWhereTheyAreAndHaveTheirColours() throws IOException {
        int[] box = colour(place(1, 0.9, 2));
        assertTrue("red: " + box[0] + " " + box[1] + " " + box[2], box[0] > 2 * box[1] && box[0] > 2 * box[2]);
        int[] ball = colour(place(1, 0.7, -2));
        assertTrue("blue: " + ball[0] + " " + ball[1] + " " + ball[2], ball[2] > 2 * ball[0] && ball[2] > 2 * ball[1]);
        seeAt("box, Box", 1, 0.5, 2);
        seeAt("ball, Sphere", 1, 0.5, -2);
    }

    @Test
    public void theRobotDrivesItsWheelsTurnAndTheCameraFollows() {
        seeAt("body, Cylinder", 0, 0.05, 0);
        tab.start();
        browser.click(".sear-follow");
        double before = ((Number) inScene("scene.robots[0].parts[1].holder.quaternion.x")).doubleValue();
        double wide = number("scene.canvas.clientWidth");
        browser.click(".sear-forward");
        browser.until("at most a pixel for each of the page, while it moves",
            () -> number("scene.canvas.width") <= wide);
        browser.until("the robot half a metre ahead", () -> tab.number("world.running.robots[0].pose[2]") > 0.5);
        browser.click(".sear-halt");
        browser.until("the robot stands, in the view, too", () -> tab.number("world.running.robots[0].speed") == 0
            && Math.abs(number("scene.robots[0].holder.position.z") - tab.number("world.running.robots[0].pose[2]"))
                < 0.002);
        assertNotEquals("the first wheel has turned", before,
            ((Number) inScene("scene.robots[0].parts[1].holder.quaternion.x")).doubleValue(), 1e-3);
        assertEquals("the camera's target", tab.number("world.running.robots[0].pose[2]"),
            number("scene.orbit.target.z"), 0.002);
        assertTrue("beams that met something",
            ((Number) inScene("[].filter.call(scene.sensors[0].fan.geometry.attributes.position.array,"
            + " function(value) { return value !== 0 }).length")).intValue() > 50);
        browser.until("more pixels of what rests", () -> number("scene.canvas.width") > wide);
        browser.click(".sear-follow");
    }

    @Test
    public void aLightIsDarkThenLitAndABumperIsFree() {
        browser.seeText("[data-led=lamp]", "lamp: 0 %");
        assertEquals("dark", 0.2, ((Number) inScene("scene.robots[0].lights[0].bulb.material.color.g"))
            .doubleValue(), 1e-6);
        tab.start();
        robotLab.run("sear.setLed('lamp', 0.5)");
        browser.seeText("[data-led=lamp]", "lamp: 50 %");
        browser.until("lit", () -> Math.abs(((Number) inScene("scene.robots[0].lights[0].bulb.material.color.g"))
            .doubleValue() - 0.6) < 1e-6);
        assertEquals(0.2, ((Number) inScene("scene.robots[0].lights[0].holder.position.y")).doubleValue(), 1e-6);
        robotLab.run("sear.setServo('neck', 90)");
        browser.until("turned to the left",
            () -> Math.abs(((Number) inScene("scene.robots[0].lights[0].holder.position.x")).doubleValue()
                - 0.1) < 1e-3);
        browser.seeText("[data-sensor=bumper] .sear-reading", "not pressed");
    }

    @Test
    public void mouseAndKeysTurnMoveAndZoom() {
        WebElement view = browser.see(".sear-scene");
        double[] target = {number("scene.orbit.target.x"), number("scene.orbit.target.z")};
        double azimuth = number("scene.orbit.azimuth");
        new Actions(browser.driver()).moveToElement(view).clickAndHold().moveByOffset(100, 0).release().perform();
        browser.until("a turned view", () -> Math.abs(number("scene.orbit.azimuth") - azimuth - 0.8) < 1e-6);
        assertEquals(target[0], number("scene.orbit.target.x"), 0);
        new Actions(browser.driver()).keyDown(Keys.SHIFT).moveToElement(view).clickAndHold().moveByOffset(0, 60)
            .release().keyUp(Keys.SHIFT).perform();
        browser.until("a moved view", () -> Math.hypot(number("scene.orbit.target.x") - target[0],
            number("scene.orbit.target.z") - target[1]) > 0.1);
        double distance = number("scene.orbit.distance");
        view.sendKeys("+");
        browser.until("a nearer view", () -> Math.abs(number("scene.orbit.distance") - distance / 1.3) < 1e-6);
        double elevation = number("scene.orbit.elevation");
        view.sendKeys(Keys.ARROW_UP);
        browser.until("a view from higher up", () -> number("scene.orbit.elevation") > elevation + 0.1);
        browser.click(".sear-fit");
        browser.until("the first view", () -> Math.abs(number("scene.orbit.elevation") - 0.65) < 1e-6);
    }

    @Test
    public void fitShowsHighAndNearObjectsWhole() {
        robotLab.run("from org.SEAR.POJOs import Box\nBox('tower', 0.5, 0.5, 4).move(-2, 2, -2)");
        browser.until("the tower", () -> tab.isTrue("(world.shown().objects | filter:{name: 'tower'}).length == 1"));
        browser.click(".sear-fit");
        Dimension size = browser.see(".sear-scene").getSize();
        for (double[] corner : new double[][] {{-2.25, 4, -2.25}, {-2.25, 0, -2.25}, {1, 1, -2}, {1, 1, 3}}) {
            browser.until(Arrays.toString(corner) + " in the view", () -> {
                double[] at = place(corner[0], corner[1], corner[2]);
                return at[0] >= 0 && at[0] <= size.getWidth() && at[1] >= 0 && at[1] <= size.getHeight();
            });
        }
    }

    @Test
    public void theCameraStaysAboveTheGround() {
        WebElement view = browser.see(".sear-scene");
        double elevation = number("scene.orbit.elevation");
        new Actions(browser.driver()).moveToElement(view).clickAndHold().moveByOffset(0, -250).release().perform();
        browser.until("a flat view", () -> number("scene.orbit.elevation") < elevation - 0.3
            && number("scene.camera.position.y") < 0.1);
        assertTrue("above the floor", number("scene.camera.position.y") > 0);
        new Actions(browser.driver()).keyDown(Keys.SHIFT).moveToElement(view).clickAndHold().moveByOffset(0, -200)
            .release().keyUp(Keys.SHIFT).perform();
        assertTrue("moved down, too", number("scene.position().y") > 0);
    }

    @Test
    public void oneLooksThroughASensor() throws IOException {
        browser.choose(".sear-eye", "scanner");
        browser.until("the camera in the scanner",
            () -> Math.abs(number("scene.camera.position.y") - tab.number("world.shown().sensors[0].pose[1]")) < 1e-3);
        double[] ahead = place(0, 0.15, 5);
        assertEquals(browser.see(".sear-scene").getSize().getWidth() / 2.0, ahead[0], 1);
        double[] left = place(2, 0.15, 2);
        assertTrue("+x, north, is on the left of who looks east", left[0] < ahead[0] - 100);
        browser.scope(SearTab.ROOT, "edits.select('roomba/scanner')");
        browser.until("the lines around what it sees",
            () -> Boolean.TRUE.equals(inScene("scene.handles && scene.handles.eye.visible")));
        String corner = "scene.handles.eye.localToWorld(new THREE.Vector3(-1, 1, 1)).project(scene.camera)";
        browser.until("their end in the view's corner",
            () -> Math.abs(number(corner + ".x") - 1) < 0.01 && Math.abs(number(corner + ".y") - 1) < 0.01);
        browser.scope(SearTab.ROOT, "edits.select('roomba/body')");
        browser.until("no such lines of what is no sensor",
            () -> Boolean.TRUE.equals(inScene("!scene.handles.eye.visible")));
        browser.scope(SearTab.ROOT, "edits.select(null)");
        browser.choose(".sear-eye", "from outside");
        browser.until("the camera outside", () -> number("scene.camera.position.y") > 1);
    }

    @Test
    public void theMapStaysAndThePageRemembersTheChoice() {
        browser.until("a view of everything", () -> number("scene.orbit.distance") > 5.5);
        browser.click(".sear-map");
        browser.see(".sear-view");
        browser.until("the map", () -> browser.all(".sear-scene").stream().noneMatch(WebElement::isDisplayed));
        browser.until("all of it on the map", () -> tab.toScreen(1.5, 0)[1] > 0
            && tab.toScreen(0, 2.5)[0] > browser.see(".sear-view").getSize().width / 2.0);
        TABS.open("sear");
        browser.see(".sear-view");
        browser.click(".sear-space");
        TABS.open("sear");
        browser.see(".sear-scene");
    }

    @Test
    public void withoutWebGlThePageReportsItAndShowsTheMap() {
        browser.script("HTMLCanvasElement.prototype.getContext = (function(original) { return function(kind) {"
            + " return kind.indexOf('webgl') >= 0 ? null : original.apply(this, arguments) } "
                + "})(HTMLCanvasElement.prototype.getContext)");
        browser.click(".sear-map");
        browser.click(".sear-space");
        browser.seeText(".sear-pointed", "This browser has no WebGL and shows only the map");
        browser.see(".sear-view");
    }

    private long told() {
        return ((Number) browser.script(
            "var now = angular.element(document.querySelector('.sear-main')).scope().world.running;"
            + "return now ? now.number : 0")).longValue();
    }

    /** Pictures and shadows are counted, not timed, while the service sends unchanged states. */
    @Test
    public void restingScenesAreDrawnOnceAndShadowsOnlyAfterMoves() {
        robotLab.call("sear", "startSimulation");
        browser.until("the running world", () -> told() > 2);
        browser.until("no more pictures of a world at rest, while its time goes on", () -> {
            double pictures = number("scene.pictures");
            long before = told();
            browser.until("more messages", () -> told() > before + 5);
            return number("scene.pictures") == pictures;
        });
        double pictures = number("scene.pictures");
        double shadings = number("scene.shadings");
        browser.script("angular.element(document.querySelector('.sear-main')).scope().view.drag(40, 0, false)");
        browser.until("a picture from another side", () -> number("scene.pictures") > pictures);
        assertEquals("with the same shadows", shadings, number("scene.shadings"), 0);
        robotLab.run("sear.driveStraight(0.2)");
        browser.until("pictures of what moves, with its shadow", () -> number("scene.shadings") > shadings + 5);
    }

    /** Software rendering, which is too slow for smooth edges and soft shadows at thirty pictures a second. */
    @Test
    public void withoutGpuMovingScenesHaveFewerPixels() {
        assertEquals(true, inScene("scene.byProcessor && scene.renderer.shadowMap.type === THREE.BasicShadowMap"));
        assertEquals("what moves, by the time that pictures take; what rests, in a small view and in a large one",
            "0.5 0.5 1 1 1.5 1",
            inScene("[200, 24, 15, 24].map(millis => { for (var i = 0; i < 99; i++) { scene.took(millis) }"
                + "return scene.ratio(1000, true, Date.now()) })"
                + ".concat([1000, 9e6].map(area => scene.ratio(area, false, scene.movedAt + 1000))).join(' ')"));
    }

    private double number(String expression) {
        return ((Number) inScene(expression)).doubleValue();
    }
}
