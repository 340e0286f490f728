// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.SEAR.web.Browser;
import org.SEAR.web.MyRobotLab;
import org.example.OtherJar;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** A sensor from another jar with its own reading, in the SEAR tab. */
public class OwnSensorTabTest {
    private static final String SCRIPT = String.join("\n",
        "from org.SEAR.POJOs import Box, Bumper, Floor, Robots",
        "from org.example import ThermalGrid",
        "sear = Runtime.start('sear', 'SEAR')",
        "sear.newProject()",
        "Floor('floor', 20, 20)",
        "Box('box', 2, 0.2, 0.2, 0).move(0, 0.1, 1.1)",
        "rover = Robots.create2('rover')",
        "eye = ThermalGrid('eye')",
        "eye.move(0, 0.2, 0)",
        "rover.addComponent(eye)",
        "rover.addComponent(Bumper('touch'))",
        "sear.recordRun('eye.searlog')",
        "sear.startSimulation()",
        "pixels = sear.getReading('eye')",
        "with open('read.txt', 'w') as file:",
        "    file.write('%d %s' % (len(pixels), sear.getSensorUnit('eye')))");
    private static final String EYE = "[data-sensor='eye'] ";

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private static int of(Browser browser, String property) {
        return ((Number) browser.script("return document.querySelector(arguments[0])[arguments[1]]",
            EYE + ".sear-picture", property)).intValue();
    }

    @Test
    public void itsTextItsPictureAndItsNumbersAreShown() throws Exception {
        Path jar = temporary.newFolder("jar").toPath();
        OtherJar.at(jar, "ThermalGridSensor$Type");
        try (MyRobotLab robotLab = new MyRobotLab(SCRIPT, jar.toString()); Browser browser = new Browser(1280, 1000)) {
            assertEquals("what the script got", "64 degC", Files.readString(robotLab.file("read.txt")));
            browser.driver().get(robotLab.url() + "#/sear");
            browser.seeText(EYE + ".sear-reading", "20.0 to 34.0 degC");
            browser.seeText("[data-sensor='touch'] .sear-reading", "not pressed");
            browser.see(EYE + ".sear-picture");
            browser.until("its 8 x 8 pixels", () -> of(browser, "naturalWidth") == 8
                && of(browser, "naturalHeight") == 8);
            assertTrue("it is enlarged", of(browser, "clientWidth") >= 64);
            browser.click(".sear-plots");
            browser.until("its numbers to plot", () -> browser.all(".sear-add option").stream()
                .anyMatch(option -> "eye.warmest".equals(option.getAttribute("textContent").trim())));
            assertEquals(List.of(), browser.errors());
        }
    }
}
