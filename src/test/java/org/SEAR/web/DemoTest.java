// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import static org.junit.Assert.assertEquals;

import java.nio.file.Paths;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.ClassRule;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TestRule;

/** The demo in the state that {@code sear --keep --port N scripts/demo.py} leaves. */
public class DemoTest {
    private static final String DEMO = Paths.get(System.getProperty("sear.root", "."), "scripts", "demo.py").toString()
        .replace("\\", "\\\\");
    @ClassRule
    public static final Tabs TABS = Tabs.alone("from java.lang import System\nSystem.setProperty('sear.speed', '5')\n"
        + "execfile('" + DEMO + "')");
    @Rule
    public final TestRule page = TABS.page("SEAR");
    private final Browser browser = TABS.browser();
    private final MyRobotLab robotLab = TABS.robotLab();

    @Test
    public void itNamesTheAddressOfItsTabs() {
        String address = robotLab.url().replaceAll("/$", "");
        List<String> told = robotLab.log().lines().filter(line -> line.contains("http://"))
            .collect(Collectors.toList());
        assertEquals(List.of(address + "/", "The simulation goes on; see its tabs at " + address + ". Ctrl+C ends it."),
            told);
        browser.driver().get(address);
        browser.see("#tab-SEAR");
        browser.seeText(".sear-robots", "demoRoomba");
        browser.seeText(".sear-status", "running at ");
    }
}
