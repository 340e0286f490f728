// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;

/** An open page while its MyRobotLab is away, and afterwards. */
public class ReconnectTest {
    @ClassRule
    public static final Tabs TABS = new Tabs("sear = Runtime.start('sear', 'SEAR')");
    @Rule
    public final TestRule page = TABS.page("sear");
    private final Browser browser = TABS.browser();
    private final MyRobotLab robotLab = TABS.robotLab();
    private final SearTab tab = new SearTab(TABS);

    private void expectLostConnection() {
        browser.expectErrors("WebSocket connection to");
        browser.expectErrors("ERR_CONNECTION_REFUSED");
    }

    @Test
    public void afterARestartOnTheSamePortThePageContinues() throws Exception {
        expectLostConnection();
        tab.openExample("maze");
        tab.start();
        robotLab.stop();
        browser.see("#shell-offline");
        robotLab.startAgain();
        browser.until("a connection", () -> browser.all("#shell-offline").isEmpty());
        browser.see(".sear-start");
        tab.waitForStatus("no simulation runs");
        tab.start();
        tab.waitForTime(0.2);
        browser.seeText(".sear-robots", "maze Roomba");
        browser.click(".sear-stop");
        tab.waitForStatus("no simulation runs");
    }

    @Test
    public void aLostConnectionIsMadeAgainAndTheStateIsTheNewOne() {
        expectLostConnection();
        tab.openExample("maze");
        tab.start();
        robotLab.run("import threading\ndef away():\n    webgui.stop()\n    sear.stopSimulation()\n    webgui.start()\n"
            + "threading.Timer(0.5, away).start()");
        tab.waitForStatus("no simulation runs");
        browser.until("a connection", () -> browser.all("#shell-offline").isEmpty());
        tab.start();
        tab.waitForTime(0.1);
        robotLab.call("sear", "stopSimulation");
    }

    @Test
    public void anInactivePageContinuesWhenTheUserReturns() {
        tab.openExample("maze");
        tab.start();
        browser.driver().get("about:blank");
        browser.driver().navigate().back();
        tab.waitForStatus("running at ");
        tab.waitForTime(tab.time() + 0.2);
        robotLab.call("sear", "stopSimulation");
        browser.seeText(".sear-note", "Not running");
    }

    @Test
    public void aPageThatComesBeforeTheServiceStartsFillsItself() {
        robotLab.call("runtime", "release", "sear");
        browser.until("no tab", () -> browser.all("#tab-sear").isEmpty());
        robotLab.run("sear = Runtime.create('sear', 'SEAR')");
        TABS.open("sear");
        tab.waitForStatus("sear is starting");
        robotLab.run("sear.startService()");
        tab.waitForStatus("no simulation runs");
        browser.until("all examples", () -> tab.isTrue("project.examples.length > 10 && edits.grammar !== null"));
        tab.openExample("maze");
    }

    @Test
    public void aServiceThatIsReleasedAndStartedAgainHasItsTabAgain() {
        robotLab.call("runtime", "release", "sear");
        browser.until("no tab", () -> browser.all("#tab-sear").isEmpty());
        assertFalse("another tab is shown", browser.all(".nav-tabs li.active").isEmpty());
        browser.seeText("#shell-missing", "There is no service sear yet. Its tab appears as soon as it starts.");
        robotLab.run("sear = Runtime.start('sear', 'SEAR')");
        browser.see(".sear-main");
        assertTrue("no word of waiting", browser.all("#shell-missing").isEmpty());
        tab.openExample("maze");
        tab.start();
        tab.waitForTime(0.1);
        robotLab.call("sear", "stopSimulation");
    }
}
