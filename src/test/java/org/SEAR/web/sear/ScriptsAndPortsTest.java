// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import org.SEAR.web.Browser;
import org.SEAR.web.MyRobotLab;
import org.SEAR.web.PythonTab;
import org.SEAR.web.Tabs;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;
import org.openqa.selenium.Keys;

/** The Python tab and the Serial tab of the embedded MyRobotLab with a simulated Roomba. */
public class ScriptsAndPortsTest {
    @ClassRule
    public static final Tabs TABS =
        new Tabs("sear = Runtime.start('sear', 'SEAR')\nsear.loadProject('examples/sensors.sear')\n"
        + "sear.startSimulation()\nRuntime.start('line', 'Serial')");
    @Rule
    public final TestRule page = TABS.page("python");
    private final Browser browser = TABS.browser();
    private final MyRobotLab robotLab = TABS.robotLab();
    private final PythonTab python = new PythonTab(browser);

    private void code(String text) {
        python.replace(text);
    }

    // ---- Python
    // --------------------------------------------------------------------------------------------------------

    @Test
    public void theConsoleShowsTheOutputOfAScript() {
        code("for name in sear.getSensorNames(): print 'I have', name");
        browser.click(".python-run");
        browser.seeText(".mrl-console", "I have compass");
        browser.seeText(".mrl-console", "I have rightEZ0");
        browser.seeText(".python-status", "ready");
        code("print 6 * 7");
        python.type(Keys.chord(Keys.CONTROL, Keys.ENTER));
        browser.seeText(".mrl-console", "42");
    }

    @Test
    public void theConsoleShowsAnErrorWithItsLine() {
        code("print 'first'\nnonsense()");
        browser.click(".python-run");
        browser.seeText(".mrl-console .err", "line 2");
        browser.seeText(".mrl-console .err", "NameError: name 'nonsense' is not defined");
        browser.seeText(".python-status", "ready");
        assertEquals("once", 2, browser.text(".mrl-console").split("NameError").length);
        assertFalse(browser.text("footer").contains("NameError"));
        browser.click("#tab-sear");
        browser.seeText("#shell-statuses", "NameError");
        browser.click("#tab-python");
        assertEquals("the wrong line is marked", List.of("2"), browser.value("a mark", () -> {
            List<String> marked = browser.texts(".ace_gutter-cell.ace_error");
            return marked.isEmpty() ? null : marked;
        }));
        python.type(" ");
        browser.until("no longer, once something is typed", () -> browser.all(".ace_gutter-cell.ace_error").isEmpty());
    }

    @Test
    public void completionOffersTheMethodsOfAService() {
        code("");
        python.type("if True:", Keys.ENTER, "sear.");
        browser.until("the calls of the page scripting.md", () -> isOffered("drive(speed, radius)"));
        python.type("simSl");
        browser.until("one is left", () -> browser.all(".ace_autocomplete .ace_line").size() == 1
            && isOffered("simSleep(seconds)"));
        python.type(Keys.ENTER);
        python.type("0.25");
        browser.until("typed over its parameter, and indented", () -> python.text()
            .equals("if True:\n    sear.simSleep(0.25)"));
        code("eyes = Runtime.start('eyes', 'LIDAR')\n");
        python.type("eyes.single");
        browser.until("of a variable of the script, too", () -> isOffered("singleScan()"));
        python.type(Keys.ESCAPE);
    }

    /** Returns whether a call is offered; the typed part of its line is a separate element. */
    private boolean isOffered(String call) {
        return browser.texts(".ace_autocomplete .ace_line").stream()
            .anyMatch(line -> line.replace("\n", "").contains(call));
    }

    @Test
    public void anEndlessScriptIsStopped() {
        code("print 'on and on'\nwhile True: sleep(0.05)");
        browser.click(".python-run");
        browser.seeText(".python-status", "running");
        browser.seeText(".mrl-console", "on and on");
        assertTrue("one script at a time", !browser.see(".python-run").isEnabled());
        browser.click(".python-stop");
        browser.seeText(".python-status", "ready");
    }

    @Test
    public void aScriptIsSavedAndOpenedAgainInColours() throws IOException {
        String text = "# comment\nif True:\n    print \"text\", 12";
        robotLab.call("python", "saveScript", "mine.py", text);
        browser.type(".python-file", "mine.py");
        code("");
        browser.click(".python-open");
        browser.until("the script", () -> text.equals(python.text()));
        browser.seeText(".python-code .ace_comment", "# comment");
        assertEquals(List.of("if", "print"), browser.texts(".python-code .ace_keyword").subList(0, 2));
        assertEquals(List.of("\"text\""), browser.texts(".python-code .ace_string"));
        assertEquals(List.of("12"), browser.texts(".python-code .ace_numeric"));
        assertEquals(List.of("1", "2", "3"), browser.texts(".python-code .ace_gutter-cell"));
        python.type(Keys.chord(Keys.CONTROL, Keys.END), "\n", "x = 1", "\n", Keys.TAB, "# deeper");
        browser.click(".python-save");
        browser.until("the saved script", () -> read("mine.py").endsWith("12\n    x = 1\n        # deeper"));
        browser.until("it in the list of scripts", () -> browser.all(".mrl-python datalist option").stream()
            .anyMatch(option -> "mine.py".equals(option.getAttribute("value"))));
    }

    @Test
    public void unsavedTextOutlivesAReloadAndAMissingFile() {
        code("print 'not saved yet'");
        browser.seeText(".python-unsaved", "not saved");
        browser.until("the text is kept",
            () -> String.valueOf(browser.script("return localStorage.getItem('python.draft.python')"))
            .contains("not saved yet"));
        TABS.open("python");
        assertEquals("print 'not saved yet'", python.text());
        browser.type(".python-file", "mispelt.py");
        browser.click(".python-open");
        browser.seeText(".python-question", "The text below is not saved.");
        browser.click(".python-go");
        browser.seeText(".python-problem", "mispelt.py can't be opened: no such file");
        assertEquals("print 'not saved yet'", python.text());
        browser.type(".python-file", "no/such/folder/x.py");
        browser.click(".python-save");
        browser.click(".python-go");
        browser.seeText(".python-problem", "was not saved");
        assertTrue(Files.notExists(robotLab.file("no")));
    }

    @Test
    public void aForeignScriptIsOnlyOverwrittenOnRequest() throws IOException {
        Files.writeString(robotLab.file("foreign.py"), "print 'foreign'");
        code("print 'mine'");
        browser.type(".python-file", "foreign.py");
        browser.click(".python-save");
        browser.seeText(".python-question", "foreign.py already exists");
        browser.click(".python-cancel");
        assertEquals("print 'foreign'", read("foreign.py"));
        browser.click(".python-save");
        browser.click(".python-go");
        browser.until("the new text", () -> read("foreign.py").equals("print 'mine'"));
        python.type(Keys.chord(Keys.CONTROL, Keys.END), "  # more");
        browser.click(".python-save");
        browser.until("its own text is overwritten without a question", () -> read("foreign.py").endsWith("# more"));
    }

    private String read(String file) {
        try {
            return Files.readString(robotLab.file(file));
        } catch (IOException e) {
            return e.toString();
        }
    }

    // ---- Serial
    // --------------------------------------------------------------------------------------------------------

    @Test
    public void bytesGoOutAndComeBackInHex() {
        TABS.show("line");
        String panel = "mrl-panel[name='line'] ";
        browser.until("the ports of the simulated devices", () -> browser.all(panel + "datalist option").stream()
            .anyMatch(option -> "/dev/SEAR_Robot_01".equals(option.getAttribute("value"))));
        browser.type(panel + ".serial-port", "/dev/SEAR_Robot_01");
        browser.choose(panel + ".serial-baud", "57600");
        browser.click(panel + ".serial-connect");
        browser.seeText(panel + ".label-success", "/dev/SEAR_Robot_01");
        browser.type(panel + ".serial-data", "80 84 8E 2");
        browser.click(panel + ".serial-send");
        browser.seeText(panel + ".text-danger", "pairs of digits");
        browser.type(panel + ".serial-data", "80 84 8E 23");
        browser.click(panel + ".serial-send");
        browser.seeText(panel + ".serial-out", "80 84 8E 23");
        browser.seeText(panel + ".serial-in", "03");        // packet 35: the mode is "full"
        browser.click(panel + ".serial-disconnect");
        browser.see(panel + ".serial-connect");
    }

    private boolean isListenedTo(String topic) {
        for (JsonNode listener : robotLab.call("line", "getNotifyList", topic)) {
            if (listener.get("callbackName").asText().startsWith("webgui")) {
                return true;
            }
        }
        return false;
    }

    @Test
    public void bytesOnlyComeToAPageThatShowsThem() {
        String panel = "mrl-panel[name='line'] ";
        browser.until("a panel", () -> !browser.all(panel + ".serial-port").isEmpty());
        browser.until("nobody listens", () -> !isListenedTo("publishTX") && !isListenedTo("publishBytes"));
        TABS.show("line");
        browser.until("the page listens", () -> isListenedTo("publishTX") && isListenedTo("publishBytes"));
        robotLab.call("line", "connect", "/dev/SEAR_Robot_01", 57600, 8, 1, 0);
        try {
            robotLab.call("line", "write", 0x80);
            browser.seeText(panel + ".serial-out", "80");
            browser.click("#tab-python");
            browser.until("nobody listens any more", () -> !isListenedTo("publishTX") && !isListenedTo("publishBytes"));
            robotLab.call("line", "write", 0x83);
            TABS.show("line");
            browser.until("the page listens again", () -> isListenedTo("publishTX"));
            robotLab.call("line", "write", 0x84);
            browser.seeText(panel + ".serial-out", "84");
            assertEquals("80\n(not shown: bytes while another tab was in front)\n84",
                browser.text(panel + ".serial-out").replaceAll(" *(\n|$)", "$1"));
            browser.seeText(panel, "Out: 2 bytes");
        } finally {
            robotLab.call("line", "disconnect");
        }
        browser.driver().get("about:blank");
        browser.until("nobody listens without a page", () -> !isListenedTo("publishTX")
            && !isListenedTo("publishState"));
    }

    @Test
    public void serialPortsAndServicesWithoutPanelStandInTheMenu() {
        browser.until("tabs of those with a panel", () -> List.of("sear SEAR", "python Python")
            .equals(browser.texts(".shell-lists > .nav-tabs a")));
        browser.click("#shell-more");
        browser.until("all others", () -> List.of("runtime Runtime", "webgui WebGui")
            .equals(browser.texts(".shell-bare a")));
        List<String> ports = browser.texts(".shell-ports a");
        assertTrue(ports.toString(), ports.contains("line") && ports.contains("myLidar_LIDARsimulator_Serial_Service"));
    }

    @Test
    public void theRoombasTabHasItsModeItsButtonsAndItsSensors() {
        robotLab.run("Runtime.start('rosie', 'Roomba')");
        TABS.show("rosie");
        String panel = "mrl-panel[name='rosie'] ";
        browser.type(panel + ".roomba-port", "/dev/SEAR_Robot_01");
        browser.click(panel + ".roomba-connect");
        browser.seeText(panel + ".label-success", "/dev/SEAR_Robot_01");
        browser.click(panel + ".roomba-full");
        browser.click(panel + ".roomba-read");
        browser.seeText(panel + ".roomba-mode", "full");
        browser.seeText(panel + "[data-sensor='Battery']", "mAh");
        browser.click(panel + ".roomba-forward");
        browser.until("a way that it has driven", () -> browser.text(panel + "[data-sensor='Distance'] td + td")
            .matches("[1-9]\\d* mm"));
        browser.click(panel + ".roomba-stop");
        browser.click(panel + ".roomba-disconnect");
        browser.see(panel + ".roomba-connect");
        robotLab.call("runtime", "release", "rosie");
        browser.until("no tab", () -> browser.all("#tab-rosie").isEmpty());
    }
}
