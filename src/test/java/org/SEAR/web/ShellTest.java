package org.SEAR.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;

/** The page around the tabs. */
public class ShellTest {
    @ClassRule
    public static final Tabs TABS = new Tabs("Runtime.start('sear', 'SEAR')");
    @Rule
    public final TestRule page = TABS.page("sear");
    private final Browser browser = TABS.browser();
    private final MyRobotLab robotLab = TABS.robotLab();

    @Test
    public void everyServiceHasATab() {
        browser.seeText("#tab-python", "Python");
        browser.click("#tab-python");
        browser.see(".python-run");
        browser.click("#tab-sear");
        assertEquals("no simulation runs", browser.text(".sear-status"));
        assertEquals("sear", robotLab.call("sear", "getName").asText());
    }

    /** What all these tests lean on. */
    @Test
    public void errorsOfThePageAreSeen() {
        browser.script("console.error('first'); setTimeout(function() { throw new Error('second') })");
        List<String> errors = new ArrayList<>();
        browser.until("both errors", () -> errors.addAll(browser.errors()) && errors.size() == 2);
        assertTrue(errors.toString(), errors.get(0).contains("first") && errors.get(1).contains("second"));
        browser.expectErrors("third");
        browser.script("console.error('third')");
        assertEquals(List.of(), browser.errors());
    }
}
