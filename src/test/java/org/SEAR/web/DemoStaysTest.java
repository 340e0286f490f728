// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.SEAR.FreePort;
import org.SEAR.SearProcess;

/**
 * The demo without a terminal, {@code sear scripts/demo.py}: it stays while a browser has its tabs open and ends with
 * them.
 */
public class DemoStaysTest {
    private static final int WIDTH = 1000;
    private static final int HEIGHT = 700;
    private static final int PATIENCE_SECONDS = 120;
    /** Script that waits for an open page before the demo, so that the demo cannot end first. */
    private static final String OPENED = String.join("\n", "from java.lang import System",
        "from java.util.concurrent.locks import LockSupport", "from org.myrobotlab.embedded.web import OpenPages",
        "while OpenPages.count() == 0:", "    LockSupport.parkNanos(20000000)",
            "execfile(System.getProperty('sear.root') + '/scripts/demo.py')", "");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    private Process process;
    private Path log;

    @Before
    public void makeALog() throws IOException {
        log = folder.newFile("log.txt").toPath();
    }

    @After
    public void end() {
        process.destroyForcibly();
    }

    private String log() {
        try {
            return Files.readString(log);
        } catch (IOException e) {
            return e.toString();
        }
    }

    private List<String> lastLines(int number) {
        List<String> lines = log().lines().collect(Collectors.toList());
        return lines.subList(Math.max(0, lines.size() - number), lines.size());
    }

    private void sear(int port) throws IOException {
        Path script = folder.newFile("opened.py").toPath();
        Files.writeString(script, OPENED);
        String root = Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath().toString();
        List<String> command = SearProcess.command("-Xmx384m", "-Dfile.encoding=UTF-8", "-Dsear.root=" + root);
        command.addAll(List.of(script.toString(), "--headless", "--speed", "max", "--port", String.valueOf(port)));
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.newFolder("work"))
            .redirectErrorStream(true).redirectOutput(log.toFile()).redirectInput(folder.newFile("nothing"));
        builder.environment().remove("SEAR_TERMINAL");
        process = builder.start();
    }

    @Test
    public void itStaysWhileABrowserHasItsTabsOpen() throws Exception {
        int port = FreePort.find();
        String address = "http://localhost:" + port;
        sear(port);
        try (Browser browser = new Browser(WIDTH, HEIGHT)) {
            browser.until("an address", () -> log().contains(address + "/"));
            browser.driver().get(address + "/#/SEAR");
            browser.until("the end of what the demo does", () -> log().contains("The simulation goes on while"));
            assertEquals(List.of("The simulation goes on while a browser has its tabs open at " + address
                + ". Ctrl+C ends it, too."), lastLines(1));
            browser.seeText(".sear-robots", "demoRoomba");
            assertTrue("it stays", process.isAlive());
            browser.driver().get("about:blank");
            assertTrue("it goes on: " + log(), process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        }
        assertEquals(log(), 0, process.exitValue());
        assertEquals("Done.", lastLines(1).get(0));
    }
}
