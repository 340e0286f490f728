// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.build;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.project.ProjectRule;
import org.SEAR.web.Browser;
import org.SEAR.web.SearTab;
import org.SEAR.web.Tabs;
import org.junit.After;
import org.junit.Before;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.interactions.Actions;

/** Worlds and robots built in the SEAR tab by mouse and keys equal those of a script. */
public class BuildingTest {
    @ClassRule
    public static final Tabs TABS = new Tabs("sear = Runtime.start('sear', 'SEAR')");
    private static final String TYPES = "from org.SEAR.POJOs import Box, Compass, Cone, Cylinder, Distance, Floor, "
        + "LIDAR, Robots, Sphere";
    /**
     * A floor with objects in the middle of its quarters, a tower on the north-eastern one, and others east of the
     * middle.
     */
    private static final String THINGS = String.join("\n",
        "Floor('floor1', 10, 10)",
        "for name, x, z in ((1, 2, 2), (2, 2, -2), (3, -2, 2), (4, -2, -2)): Box('box%d' % name, 0.25, 0.25, "
        + "0.25).move(x, 0.125, z)", "Cylinder('cylinder1', 0.1, 0.25).move(3, 0.125, 0)",
        "Cone('cone1', 0.1, 0.25).move(3, 0.125, 1)",
        "Sphere('sphere1', 0.1).move(3, 0.1, -1)",
        "tower = Box('box5', 0.25, 0.25, 0.25)",
        "tower.move(2, 0.375, 2)");
    private static final String COPY_OF_THE_TOWER = String.join("\n",
        "copy = Box('box6', 0.25, 0.25, 0.25, 4)",
        "copy.move(2.05, 0.375, 2.5)",
        "copy.rotate(0, 15, 0)");
    private static final String ROBOT = "robot = Robots.create2('create2')\nrobot.move(0, 0, 1)";
    private static final String SENSORS = String.join("\n",
        "robot.addComponent(Compass('compass1'))",
        "lidar = LIDAR('lidar1')",
        "lidar.move(0, 0.0365, 0.1)",
        "robot.addComponent(lidar)",
        "eye = Distance('eye', 'PING)))')",
        "eye.move(0.1, 0.0365, 0)",
        "eye.rotate(-20, 0, 0)",
        "robot.addComponent(eye)");

    @Rule
    public final TestRule page = TABS.page("sear");
    private final Browser browser = TABS.browser();
    private final SearTab tab = new SearTab(TABS);

    @Before
    public void beginWithAnEmptyProject() {
        browser.until("no simulation",
            () -> tab.isTrue("service && !service.simulating && world.preview !== null && edits.grammar !== null"));
        TABS.robotLab().run("sear.newProject()");
        browser.until("an empty project",
            () -> tab.isTrue("world.shown() && !world.shown().objects.length && !world.shown().robots.length"));
    }

    @After
    public void stop() {
        if (TABS.robotLab().call("sear", "isSimulating").asBoolean()) {
            TABS.robotLab().call("sear", "stopSimulation");
        }
    }

    /** Returns the project's files without the undo journal. */
    private Map<String, String> files() throws IOException {
        Map<String, String> files = ProjectRule.files(TABS.robotLab().file("SEARproject"));
        files.keySet().removeIf(file -> file.startsWith(".edits/"));
        return files;
    }

    private void build(String mode) {
        if (!tab.isTrue("view.building")) {
            browser.click(tab.isTrue("welcome.isShown()") ? "[data-tile='build']" : ".sear-build");
        }
        browser.click(mode);
        browser.see(".sear-palette");
    }

    /** Moves the mouse to a point of the ground on the map. */
    private Actions onMap(double x, double z) {
        double[] at = tab.toScreen(x, z);
        return moveTo(browser.see(".sear-view"), at);
    }

    private Actions moveTo(WebElement view, double[] at) {
        Dimension size = view.getSize();
        return new Actions(browser.driver()).moveToElement(view, (int) Math.round(at[0]) - size.getWidth() / 2,
            (int) Math.round(at[1]) - size.getHeight() / 2);
    }

    @SuppressWarnings("unchecked")
    private double[] inSpace(double x, double y, double z) {
        Map<String, Object> at = (Map<String, Object>) browser.scope(SearTab.ROOT, "view.scene().toScreen(" + x + ", "
            + y + ", " + z + ")");
        return new double[] {((Number) at.get("x")).doubleValue(), ((Number) at.get("y")).doubleValue()};
    }

    private void arm(String type) {
        browser.click(".sear-palette [data-make='" + type + "']");
        browser.until(type + " to place", () -> tab.isTrue("palette.armed && palette.armed.name == '" + type + "'"));
    }

    private void waitForSelected(String object) {
        browser.until(object + " selected",
            () -> tab.isTrue("edits.object && edits.object.object == '" + object + "'"));
        browser.until(object + " in the view",
            () -> tab.isTrue("edits.selected == '" + object + "' && building.found() !== null"));
    }

    private void placeOnMap(String type, double x, double z, String name) {
        arm(type);
        onMap(x, z).click().perform();
        waitForSelected(name);
    }

    private void set(String field, String value) {
        String css = "[data-field='" + field + "'] .form-control";
        WebElement input = browser.see(css);
        input.sendKeys(Keys.chord(Keys.CONTROL, "a"));
        input.sendKeys(value, Keys.ENTER);
        browser.until(field + " to be " + value,
            () -> tab.isTrue("edits.object && edits.object.values." + field + " == '" + value + "'"));
    }

    /** Makes a world by a script and returns when the page shows this number of objects and robots. */
    private void make(int things, int robots, String... parts) {
        TABS.robotLab().run(TYPES + "\nsear.newProject()\n" + String.join("\n", parts));
        browser.until("what the script makes",
            () -> tab.isTrue("world.shown() && world.shown().objects.length == " + things
            + " && world.shown().robots.length == " + robots));
        if (robots > 0) {    // without its parts it can't be clicked
            browser.until("all parts of the robot", () -> tab.isTrue("world.shown().robots[0].parts.length > 4"));
        }
    }

    /** Returns the files that a script makes, then starts an empty project. */
    private Map<String, String> filesOf(int things, int robots, String... parts) throws IOException {
        make(things, robots, parts);
        Map<String, String> files = files();
        beginWithAnEmptyProject();
        return files;
    }

    /** Shows a map of 10 m around the middle in building mode. */
    private void buildOnTheMap() {
        build(".sear-map");
        browser.script("var scope = angular.element(document.querySelector('.sear-main')).scope();"
            + "angular.extend(scope.view, {x: 0, z: 0, scale: 50, chosen: true}); scope.view.redraw()");
        browser.until("all places in the view",
            () -> Math.abs(tab.toScreen(1, 0)[1] - tab.toScreen(0, 0)[1] + 50) < 0.1);
    }

    /** Undoes all edits one by one. */
    private void undoAll() {
        while (tab.isTrue("edits.undoable !== null")) {
            Object last = browser.scope(SearTab.ROOT, "messages.list[0].id + ' ' + messages.list[0].times");
            browser.click(".sear-undo");
            browser.until("an edit undone", () ->
                !last.equals(browser.scope(SearTab.ROOT, "messages.list[0].id + ' ' + messages.list[0].times")));
        }
    }

    @Test
    public void objectsPlacedByClicksEqualThoseOfAScriptAndUndoRemovesThem() throws Exception {
        Map<String, String> wanted = filesOf(9, 0, THINGS);
        buildOnTheMap();
        placeOnMap("Floor", 0, 0, "floor1");
        int box = 1;
        for (double[] at : new double[][] {{2, 2}, {2, -2}, {-2, 2}, {-2, -2}}) {
            placeOnMap("Box", at[0], at[1], "box" + box++);
        }
        placeOnMap("Cylinder", 3, 0, "cylinder1");
        placeOnMap("Cone", 3, 1, "cone1");
        placeOnMap("Sphere", 3, -1, "sphere1");
        placeOnMap("Box", 2, 2, "box5");
        assertEquals(wanted, files());
        undoAll();
        assertEquals(Map.of(), files());
        browser.until("an empty view", () ->
            tab.isTrue("!world.shown().objects.length && !world.shown().robots.length && edits.selected === null"));
    }

    @Test
    public void aCopyIsMovedAndTurnedByKeysAndGetsAMassByItsField() throws Exception {
        Map<String, String> wanted = filesOf(10, 0, THINGS, COPY_OF_THE_TOWER);
        make(9, 0, THINGS);
        Map<String, String> before = files();
        buildOnTheMap();
        onMap(2, 2).click().perform();
        waitForSelected("box5");
        browser.click(".sear-duplicate");
        waitForSelected("box6");
        browser.see(".sear-view").sendKeys(Keys.ARROW_UP);
        browser.until("5 cm to the north", () -> tab.isTrue("edits.object.values.x == '2.05'"));
        browser.see(".sear-view").sendKeys("[");
        browser.until("a turn", () -> tab.isTrue("edits.object.values.ry == '15'"));
        set("mass", "4");
        assertEquals(wanted, files());
        undoAll();
        assertEquals(before, files());
    }

    /** A button puts a sensor into the robot's middle, or a click to its point. */
    @Test
    public void aRobotBuiltByClicksEqualsThatOfAScript() throws Exception {
        Map<String, String> wanted = filesOf(9, 1, THINGS, ROBOT, SENSORS);
        make(9, 0, THINGS);
        Map<String, String> before = files();
        buildOnTheMap();
        placeOnMap("create2", 0, 1, "create2");
        for (String type : List.of("Compass", "LIDAR", "Distance")) {
            arm(type);
            if (type.equals("Distance")) {
                onMap(0.1, 1).click().perform();
            } else {
                browser.click(".sear-middle");
            }
            waitForSelected("create2/" + type.toLowerCase(Locale.ROOT) + "1");
            if (type.equals("Compass")) {
                set("y", "0");
            }
        }
        WebElement name = browser.see("#sear-p-name");
        name.sendKeys(Keys.chord(Keys.CONTROL, "a"));
        name.sendKeys("eye", Keys.ENTER);
        waitForSelected("create2/eye");
        set("beam", "PING)))");
        TABS.robotLab().run("sear.edit({'do': 'set', 'object': 'lidar1', 'set': {'z': 0.1}})");
        assertEquals(wanted, files());
        tab.start();
        browser.until("readings of all three sensors", () -> tab.number("world.shown().sensors.length") == 3);
        TABS.robotLab().call("sear", "stopSimulation");
        browser.until("no simulation", () -> tab.isTrue("service && !service.simulating"));
        undoAll();
        assertEquals(before, files());
    }

    @Test
    public void aSensorIsSelectedInTheListOfParts() {
        make(9, 1, THINGS, ROBOT, SENSORS);
        buildOnTheMap();
        onMap(0, 1).click().perform();
        waitForSelected("create2");
        browser.click(".sear-tree button[ng-click*='sensor']");
        browser.until("a sensor of the list", () -> tab.isTrue("edits.object && edits.object.robot == 'create2'"));
    }

    /** Script that returns required cells of the image file that are empty or equal another cell. */
    private static final String PICTURES =
        String.join("\n", "var done = arguments[0], kinds = angular.element(document.querySelector('.sear-main'))"
        + ".scope().palette.groups().flatMap(group => group.kinds)", "var image = new Image()",
        "image.onload = () => {",
        "    var pen = Object.assign(document.createElement('canvas'), {width: image.width, height: "
        + "image.height}).getContext('2d')", "    pen.drawImage(image, 0, 0)",
        "    var seen = {}, wrong = []",
        "    kinds.forEach(kind => {",
        "        var at = kind.style['background-position'].split(' ').map(parseFloat)",
        "        var size = kind.style['background-size'].split(' ').map(parseFloat)",
        "        var cell = [100 * image.width / size[0], 100 * image.height / size[1]]",
        "        var data = pen.getImageData(Math.round(at[0] / 100 * (image.width - cell[0])), Math.round(at[1] / 100 "
        + "* (image.height - cell[1])),", "            cell[0], cell[1]).data",
        "        var drawn = data.filter((value, i) => i % 4 === 3 && value > 128).length / cell[0] / cell[1]",
        "        if (cell[0] !== cell[1] || drawn < 0.05 || drawn > 0.9 || seen[at]) {",
        "            wrong.push(kind.make + ' ' + cell + ' ' + drawn)",
        "        }", "        seen[at] = true", "    })", "    done(kinds.length + ' pictures ' + wrong.join())", "}",
        "image.src = kinds[0].style['background-image'].slice(5, -2)");

    @Test
    public void eachPaletteItemHasItsOwnRenderedPicture() throws Exception {
        build(".sear-map");
        int count = browser.all(".sear-make .sear-symbol").size();
        assertTrue(String.valueOf(count), count >= 30);
        browser.until("pictures", () -> browser.all(".sear-symbol").get(0).getCssValue("background-image")
            .contains("palette.png"));
        assertEquals(count + " pictures ", browser.driver().executeAsyncScript(PICTURES));
        long bytes = Files.size(Paths.get(System.getProperty("sear.root", "."),
            "resources/resource/WebGui/app/service/js/sear/tiles/palette.png"));
        assertTrue(String.valueOf(bytes), bytes < 200_000);
    }

    @Test
    public void thePaletteIsSearchedAndOneTabStopWithArrowKeys() {
        build(".sear-map");
        List<String> groups = browser.texts(".sear-palette .sear-title");
        assertEquals(List.of("THINGS", "ROBOTS", "DRIVES", "JOINTS", "SENSORS", "BOARDS"), groups);
        assertEquals(1, browser.all(".sear-make[tabindex='0']").size());
        WebElement first = browser.see(".sear-make[tabindex='0']");
        assertEquals("Box", first.getAttribute("data-make"));
        first.sendKeys(Keys.ARROW_DOWN);
        WebElement second = browser.driver().switchTo().activeElement();
        assertEquals("Cylinder", second.getAttribute("data-make"));
        assertEquals("0", second.getAttribute("tabindex"));
        second.sendKeys(Keys.END);
        assertEquals("the last one", browser.all(".sear-make").size() - 1, browser.all(".sear-make").indexOf(
            browser.driver().switchTo().activeElement()));
        browser.type(".sear-sought", "laser");
        browser.until("what is looked for", () -> browser.texts(".sear-make").equals(List.of("Laser scanner")));
        browser.type(".sear-sought", "xyz");
        browser.seeText(".sear-palette", "Nothing found.");
    }

    @Test
    public void theInspectorHasGroupsAChooserOfColoursAndBoxesForTrueAndFalse() {
        make(9, 0, THINGS);
        buildOnTheMap();
        onMap(-2, -2).click().perform();
        waitForSelected("box4");
        assertEquals(List.of("SIZE", "PLACE", "SETTINGS", "LOOK", "PHYSICS", "EARTH"),
            browser.texts(".sear-group > .sear-title"));
        browser.seeText(".sear-about", "A box: length along x");
        browser.script("arguments[0].value = '#00ff80'; arguments[0].dispatchEvent(new Event('change'))",
            browser.see(".sear-color"));
        browser.until("its colour", () -> tab.isTrue("edits.object && edits.object.values.color == '#00ff80'"));
        WebElement seen = browser.see("[data-field='visibleToSensors'] input[type=checkbox]");
        assertTrue("as without a value", seen.isSelected());
        browser.script("arguments[0].scrollIntoView()", seen);
        seen.click();
        browser.until("it is not seen",
            () -> tab.isTrue("edits.object && edits.object.values.visibleToSensors == 'false'"));
    }

    @Test
    public void keysThatTurnAddUpHoweverFastTheyArePressed() {
        make(9, 0, THINGS);
        buildOnTheMap();
        onMap(-2, -2).click().perform();
        waitForSelected("box4");
        browser.see(".sear-view").sendKeys("[[[[", "]");
        browser.until("three turns", () -> tab.isTrue("edits.object && edits.object.values.ry == '45'"));
        undoAll();
    }

    /** Selects box4 in the south-west, 0.25 m in size, on the map. */
    private WebElement boxWithHandles() throws IOException {
        make(9, 1, THINGS, ROBOT);
        buildOnTheMap();
        onMap(-2, -2).click().perform();
        waitForSelected("box4");
        picture("map");
        return browser.see(".sear-view");
    }

    @Test
    public void aHandleOnTheMapLengthensAnObjectAndTheOtherSideStays() throws IOException {
        WebElement view = boxWithHandles();
        Map<String, String> before = files();
        drag(view, onMapOf("x"), tab.toScreen(-1.275, -2));
        browser.until("it is longer", () ->
            tab.isTrue("edits.object.values.length == '0.85' && edits.object.values.x == '-1.7'"));
        browser.until("in the view, too", () -> Math.abs(place("x").get(0).doubleValue() + 1.275) < 1e-3);
        assertTrue("what one looks along has no handle", tab.isTrue("building.handle('y') === null"));
        undoAll();
        assertEquals(before, files());
    }

    @Test
    public void aHandleOnTheMapRotatesAnObject() throws IOException {
        WebElement view = boxWithHandles();
        drag(view, onMapOf("x"), tab.toScreen(-1.275, -2));
        browser.until("it is longer", () -> Math.abs(place("x").get(0).doubleValue() + 1.275) < 1e-3);
        drag(view, onMapOf("turn"), tab.toScreen(-1, -2.02));
        browser.until("it looks north", () -> tab.isTrue("edits.object.values.ry == '90'"));
    }

    @Test
    public void aRobotHasAHandleToTurnItAndNoneForItsSize() {
        make(9, 1, THINGS, ROBOT);
        buildOnTheMap();
        onMap(0, 1).click().perform();
        waitForSelected("create2");
        assertTrue("a robot can be turned, its parts have sizes",
            tab.isTrue("building.handle('x') === null && building.handle('turn') !== null"));
    }

    /** Starts a robot with sensors and selects it on the map. */
    private void runSelected() {
        make(9, 1, THINGS, ROBOT, SENSORS);
        buildOnTheMap();
        onMap(0, 1).click().perform();
        waitForSelected("create2");
        tab.start();
        browser.until("readings of all three sensors", () -> tab.number("world.shown().sensors.length") == 3);
    }

    @Test
    public void aRunningRobotIsDraggedItsSensorsGoWithItAndUndoPutsItBack() throws IOException {
        runSelected();
        Map<String, String> before = files();
        double x = tab.number("world.running.robots[0].pose[0]");
        drag(browser.see(".sear-view"), tab.toScreen(x, 1), tab.toScreen(x - 1, -1));
        browser.until("its new place in its file",
            () -> tab.isTrue("edits.object.object == 'create2' && edits.object.values.z == '-1' && "
                + "edits.object.values.x != '0'"));
        double put = tab.number("1 * edits.object.values.x");
        assertEquals(x - 1, put, 0.03);
        browser.until("it stands there", () -> Math.abs(tab.number("world.running.robots[0].pose[2]") + 1) < 0.01
            && Math.abs(tab.number("world.running.robots[0].pose[0]") - put) < 0.01);
        browser.until("its sensors with it", () -> tab.number("world.running.sensors[0].pose[2]") < -0.5);
        assertNothingWaitsForTheNextStart();
        browser.see(".sear-view").sendKeys(Keys.chord(Keys.CONTROL, "z"));
        backWhereItWas();
        assertEquals(before, files());
    }

    @Test
    public void aRunningRobotIsMovedAndTurnedByKeysAndUndoPutsItBack() throws IOException {
        runSelected();
        Map<String, String> before = files();
        browser.see(".sear-view").sendKeys(Keys.ARROW_RIGHT);
        browser.until("5 cm to the east", () -> tab.isTrue("edits.object.values.z == '1.05'")
            && Math.abs(tab.number("world.running.robots[0].pose[2]") - 1.05) < 0.01);
        browser.see(".sear-view").sendKeys("[");
        browser.until("turned",
            () -> tab.isTrue("edits.object.values.ry == '15'")
                && Math.abs(tab.number("world.running.robots[0].pose[4]") - 15) < 1);
        assertNothingWaitsForTheNextStart();
        browser.see(".sear-view").sendKeys(Keys.chord(Keys.CONTROL, "z"), Keys.chord(Keys.CONTROL, "z"));
        backWhereItWas();
        assertEquals(before, files());
    }

    private void assertNothingWaitsForTheNextStart() {
        String said = String.valueOf(browser.scope(SearTab.ROOT, "messages.list"));
        assertFalse("nothing waits: " + said, said.contains("next start"));
    }

    private void backWhereItWas() {
        browser.until("back where it was",
            () -> tab.isTrue("edits.object.values.z == '1' && edits.object.values.x == '0'")
            && Math.abs(tab.number("world.running.robots[0].pose[2]") - 1) < 0.01);
    }

    @Test
    public void inSpaceTheMouseSelectsMovesSizesAndTurns() throws IOException {
        TABS.robotLab().run("from org.SEAR.POJOs import Box, Floor, Robots\nFloor('floor', 10, 10)\nBox('crate', 1, 1, "
            + "1).move(0, 0.5, 0)\nRobots.create2('rosie').move(0, 0, 2)");
        browser.until("the world", () -> tab.isTrue("world.shown() && world.shown().robots.length == 1"));
        build(".sear-space");
        browser.until("all of it", () ->
            tab.isTrue("view.fitted && view.scene().objects[0].dressed && view.scene().objects[1].dressed"));
        WebElement view = browser.see(".sear-scene");
        moveTo(view, inSpace(0, 0.1, 2)).click().perform();
        waitForSelected("rosie");
        moveTo(view, inSpace(0, 0.1, 2)).click().perform();
        waitForSelected("rosie/body");
        moveTo(view, inSpace(0, 0.9, 0)).click().perform();
        waitForSelected("crate");
        drag(inSpace(-0.3, 1, 0.3), inSpace(0.72, 1, -0.71));
        browser.until("it moved", () -> tab.isTrue("edits.object.values.x != '0' && edits.object.values.z != '0'"));
        double x = tab.number("1 * edits.object.values.x");
        double z = tab.number("1 * edits.object.values.z");
        assertEquals("as far as the mouse", 1, x, 0.11);
        assertEquals(-1, z, 0.11);
        assertEquals("to the grid", Math.rint(x / 0.05), x / 0.05, 1e-6);
        waitForSelected("crate");
        browser.until("its new place in the view", () -> Math.abs(place("x").get(0).doubleValue() - x - 0.5) < 1e-3);
        drag(handle("x"), inSpace(x + 1, 0.5, z));
        browser.until("it grew", () -> tab.isTrue("edits.object.values.length != '1'"));
        double length = tab.number("1 * edits.object.values.length");
        assertEquals(1.5, length, 0.11);
        assertEquals("to the grid", Math.rint(length / 0.05), length / 0.05, 1e-6);
        assertEquals("the other side stays", x - 0.5, tab.number("1 * edits.object.values.x") - length / 2, 1e-4);
        browser.until("the new size in the view", () ->
            Math.abs(place("x").get(0).doubleValue() - tab.number("1 * edits.object.values.x") - length / 2) < 1e-3);
        double[] handle = handle("turn");
        drag(handle, new double[] {handle[0] - 20, handle[1] - 60});
        browser.until("it turned by 15 degrees or more",
            () -> tab.isTrue("edits.object.values.ry != '0' && edits.object.values.ry % 15 == 0"));
        browser.see(".sear-scene").sendKeys(Keys.chord(Keys.CONTROL, "z"));
        browser.until("undone", () -> tab.isTrue("edits.object.values.ry == '0'"));
        picture("light");
        set("mass", "7");
        WebElement mass = browser.see("[data-field='mass'] .form-control");
        mass.sendKeys(Keys.chord(Keys.CONTROL, "a"), "-7", Keys.ENTER);
        browser.seeText("[data-field='mass'] .sear-wrong", "legal: 0, or a number from 0.000001 to 1000000 kg");
        assertTrue(files().get("environment/crate.xml").contains("<mass>7</mass>"));
        TABS.robotLab().run("sear.edit({'do': 'set', 'object': 'crate', 'set': {'color': 'red'}})");
        browser.until("what another one has changed", () -> tab.isTrue("edits.object.values.color == 'red'"));
        view.sendKeys(Keys.DELETE);
        browser.until("it is gone", () -> tab.isTrue("edits.selected === null && edits.undoable == 'delete crate'"));
        assertFalse(files().containsKey("environment/crate.xml"));
        view.sendKeys(Keys.chord(Keys.CONTROL, "z"));
        browser.until("it is back", () -> tab.isTrue("edits.redoable == 'delete crate'"));
        assertTrue(files().containsKey("environment/crate.xml"));
    }

    /**
     * In an empty project: a robot, the ground that it needs, a sensor dragged onto its side, and a drive. A warning
     * reports a top-heavy robot.
     */
    @Test
    public void aRobotIsMadeFromATemplateAndDriven() throws IOException {
        build(".sear-space");
        WebElement view = browser.see(".sear-scene");
        lookAt(view, 0);
        arm("rover");
        moveTo(view, inSpace(0, 0, 0)).click().perform();
        waitForSelected("rover1");
        assertTrue(tab.isTrue("world.shown().objects.length == 1 && world.shown().objects[0].type == 'Floor'"));
        browser.seeText(".sear-balance", "tips over");
        browser.until("its parts", () -> tab.isTrue("view.scene().robots[0].parts[0].dressed"));
        Dimension size = view.getSize();
        double[] side = inSpace(-0.07, 0.09, -0.1);
        new Actions(browser.driver()).moveToElement(browser.see(".sear-palette [data-make='Distance']")).clickAndHold()
            .moveToElement(view,
            (int) Math.round(side[0]) - size.getWidth() / 2, (int) Math.round(side[1]) - size.getHeight() / 2)
            .release().perform();
        waitForSelected("rover1/distance1");
        assertTrue("it looks to the right, from the side",
            tab.isTrue("edits.object.values.ry == '-90' && edits.object.values.z == '-0.1'"));
        assertEquals(-0.07, tab.number("1 * edits.object.values.x"), 1e-3);
        browser.until("the sensor in the view",
            () -> tab.isTrue("view.scene().sensors.length == 1 && !!view.scene().sensors[0].marker"));
        drag(inSpace(-0.07, 0.068 + tab.number("1 * edits.object.values.y"), -0.1), inSpace(0, 0.113, -0.1));
        browser.until("on top", () -> tab.isTrue("edits.object.values.x == '0' && edits.object.values.z == '-0.1'"));
        assertEquals("on the surface", 0.045, tab.number("1 * edits.object.values.y"), 1e-3);
        browser.click(".sear-test-drive");
        browser.until("the drive", () -> tab.isTrue("service.simulating && world.running !== null"));
        browser.until("keys for the view", () -> view.equals(browser.driver().switchTo().activeElement()));
        assertTrue("the view goes with it", tab.isTrue("view.follow"));
        view.sendKeys("u");
        browser.until("it drives", () -> tab.number("world.shown().robots[0].pose[2]") > 0.2);
        view.sendKeys(";", Keys.ESCAPE);
        browser.until("it stands", () -> tab.isTrue("edits.selected === null && world.running.robots[0].speed == 0"));
        double there = tab.number("world.running.robots[0].pose[2]");
        lookAt(view, there);
        moveTo(view, inSpace(0, 0.05, there)).click().perform();
        waitForSelected("rover1");
        drag(inSpace(0, 0.05, there), inSpace(0.2, 0.05, there - 0.3));
        browser.until("it was put elsewhere",
            () -> tab.isTrue("edits.object.object == 'rover1' && edits.object.values.x != '0'"));
        double put = tab.number("1 * edits.object.values.z");
        assertEquals(there - 0.3, put, 0.06);
        assertEquals("it stands on the ground", 0, tab.number("1 * edits.object.values.y"), 0.001);
        browser.until("in the running world",
            () -> Math.abs(tab.number("world.running.robots[0].pose[2]") - put) < 0.01);
        browser.click(".sear-test-drive");
        browser.until("no simulation, and a view as before",
            () -> tab.isTrue("service && !service.simulating && !view.follow"));
        TABS.robotLab().run("sear.edit({'do': 'add', 'type': 'Box', 'name': 'mast', 'to': 'rover1', 'set': {'length': "
            + "0.04, 'width': 0.04, 'height': 0.3, 'y': 0.2, 'z': -0.05, 'mass': 3}})");
        browser.seeText(".sear-balance .sear-wrong", "Warning: centre of mass at");
        picture("robot");
        browser.scope(SearTab.ROOT, "$apply(\"edits.select('rover1/left')\")");
        browser.until("the wheel", () -> tab.isTrue("edits.object && edits.object.object == 'rover1/left'"));
        view.sendKeys(Keys.DELETE);
        browser.seeText(".sear-last", "motor leftMotor was deleted with wheel left; Undo brings back both");
        assertFalse(files().containsKey("robot/leftMotor.xml"));
        view.sendKeys(Keys.chord(Keys.CONTROL, "z"));
        browser.until("both are back", () -> tab.isTrue("edits.redoable == 'delete left with motor leftMotor'"));
        assertTrue(files().containsKey("robot/leftMotor.xml"));
    }

    /** Looks from a near camera at a point z metres to the east. */
    private void lookAt(WebElement view, double z) {
        browser.script("var scope = angular.element(document.querySelector('.sear-main')).scope(); var orbit = "
            + "scope.view.scene().orbit;"
            + "orbit.target.set(0, 0, arguments[0]); orbit.distance = 0.9; orbit.azimuth = Math.PI; orbit.elevation = "
                + "0.6; scope.view.redraw()", z);
        browser.until("a near view", () -> inSpace(0, 0, z + 0.1)[0] - inSpace(0, 0, z)[0] > 25
            && Math.abs(inSpace(0, 0, z)[0] - view.getSize().getWidth() / 2.0) < 2);
    }

    /** Saves a screenshot for visual checks. */
    private void picture(String theme) throws IOException {
        browser.picture(Paths.get(System.getProperty("sear.root", "."), "build/reports/web/building-"
            + theme + ".png"));
    }

    @SuppressWarnings("unchecked")
    private List<Number> place(String handle) {
        return (List<Number>) browser.scope(SearTab.ROOT, "building.handle('" + handle + "')");
    }

    private double[] onMapOf(String handle) {
        List<Number> at = place(handle);
        return tab.toScreen(at.get(0).doubleValue(), at.get(2).doubleValue());
    }

    private double[] handle(String name) {
        List<Number> at = place(name);
        return inSpace(at.get(0).doubleValue(), at.get(1).doubleValue(), at.get(2).doubleValue());
    }

    private void drag(double[] from, double[] to) {
        drag(browser.see(".sear-scene"), from, to);
    }

    private void drag(WebElement view, double[] from, double[] to) {
        Dimension size = view.getSize();
        moveTo(view, from).clickAndHold()
            .moveToElement(view, (int) Math.round((from[0] + to[0]) / 2) - size.getWidth() / 2,
            (int) Math.round((from[1] + to[1]) / 2) - size.getHeight() / 2)
            .moveToElement(view, (int) Math.round(to[0]) - size.getWidth() / 2,
            (int) Math.round(to[1]) - size.getHeight() / 2).release().perform();
    }
}
