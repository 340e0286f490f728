package org.SEAR.web;

import java.nio.file.Path;
import java.nio.file.Paths;
import org.openqa.selenium.Dimension;

/** Takes the pictures of the tabs for the documentation, while a robot with every sensor drives in a yard: {@code scripts/screenshots}. */
public final class TabPictures {
    private static final String SCRIPT = "sear = Runtime.start('sear', 'SEAR')\nsear.loadProject('examples/sensors.sear')\nsear.startSimulation()\n"
        + "lidar = Runtime.start('lidar', 'LIDAR')\nlidar.connect('/dev/SEAR_LIDAR_01')\n"
        + "gps = Runtime.start('gps', 'GPS')\ngps.connect('/dev/SEAR_GPS_01')\n";
    private static final int WIDTH = 1180;
    /** Seconds at SPEED m/s on a circle of RADIUS metres to the left. */
    private static final double DRIVE = 22;
    private static final double SPEED = 0.3;
    private static final double RADIUS = 1.2;
    private static final double FACTOR = 4;

    private TabPictures() {
    }

    /** @param arguments the folder for the pictures */
    public static void main(String[] arguments) throws Exception {
        Path folder = Paths.get(arguments[0]);
        try (Browser browser = new Browser(WIDTH, 900); MyRobotLab robotLab = new MyRobotLab(SCRIPT)) {
            browser.driver().get(robotLab.url() + "#/sear");
            browser.see("#tab-gps");
            browser.until("all panels", () -> browser.all("mrl-panel[name='gps'] > *").size() > 0);
            robotLab.call("sear", "setSpeed", FACTOR);
            robotLab.call("sear", "drive", SPEED, RADIUS);
            browser.until("the drive", () -> browser.number(SearTab.ROOT, "state ? state.time : -1") > DRIVE);
            robotLab.call("sear", "drive", 0, 0);
            browser.until("the robot stands", () -> browser.number(SearTab.ROOT, "state.robots[0].speed") == 0);
            robotLab.call("sear", "setSpeed", 1);
            browser.click("#tab-lidar");
            browser.until("a scan in the tab", () -> {
                robotLab.call("lidar", "singleScan");
                return browser.texts("mrl-panel[name='lidar']").stream().anyMatch(text -> text.contains("181 ") || text.contains("361 "));
            });
            browser.script("document.querySelectorAll('footer .btn-link, .sear-clear, .lidar-clear, .gps-clear')"
                + ".forEach(function(clear) { clear.click() })");
            for (String tab : new String[] {"sear", "lidar", "gps"}) {
                browser.click("#tab-" + tab);
                browser.see("mrl-panel[name='" + tab + "'] > *");
                browser.script("document.activeElement.blur()");
                take(browser, folder.resolve("tab-" + tab + ".png"));
            }
        }
        System.exit(0);
    }

    /** The whole page, not more and not less. */
    private static void take(Browser browser, Path file) throws Exception {
        Number height = (Number) browser.script("return document.querySelector('.container-fluid').getBoundingClientRect().bottom"
            + " + window.outerHeight - window.innerHeight + 10");
        browser.driver().manage().window().setSize(new Dimension(WIDTH, height.intValue()));
        browser.script("window.dispatchEvent(new Event('resize'))");
        browser.driver().executeAsyncScript("var done = arguments[0]; requestAnimationFrame(function() { requestAnimationFrame(done) })");
        browser.picture(file);
        System.out.println(file);
    }
}
