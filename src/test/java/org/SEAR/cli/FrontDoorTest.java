// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.TimeUnit;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.rules.TemporaryFolder;
import org.junit.Test;
import org.SEAR.FreePort;
import org.SEAR.SearProcess;

/** {@code sear} without a script: tabs, browser, the requested project and the end of the program. */
public class FrontDoorTest {
    private static final int PATIENCE_SECONDS = 240;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    private Path root;
    private Path opened;
    private Process process;
    private int port;

    @Before
    public void makeABrowser() throws IOException {
        root = folder.newFolder("work").toPath().toRealPath();
        Path bin = folder.newFolder("bin").toPath().toRealPath();
        opened = bin.resolve("opened");
        Path browser = bin.resolve("xdg-open");
        Files.writeString(browser, "#!/bin/sh\necho \"$1\" > " + opened + ".part && mv " + opened + ".part "
            + opened + "\n");
        assertTrue(browser.toFile().setExecutable(true));
        port = FreePort.find();
    }

    @After
    public void end() {
        if (process != null) {
            process.destroyForcibly();
        }
    }

    private void sear(String... arguments) throws IOException {
        List<String> command = SearProcess.command("-Xmx256m", "-Dfile.encoding=UTF-8", "-Dsear.headless=true");
        command.addAll(Arrays.asList(arguments));
        command.addAll(List.of("--port", String.valueOf(port)));
        ProcessBuilder builder = new ProcessBuilder(command).directory(root.toFile()).redirectOutput(log("out"))
            .redirectError(log("err"));
        builder.environment().put("PATH", opened.getParent() + File.pathSeparator + System.getenv("PATH"));
        builder.environment().put("DISPLAY", ":none");
        process = builder.start();
    }

    private File log(String name) {
        return folder.getRoot().toPath().resolve(name + ".txt").toFile();
    }

    private String read(String name) throws IOException {
        return Files.readString(log(name).toPath());
    }

    private void await(String what, Path file) throws IOException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (Files.notExists(file)) {
            assertTrue(what + "\n" + read("out") + read("err"), process.isAlive() && System.nanoTime() < end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(100));
        }
    }

    private void isOpen() throws IOException {
        await("no browser", opened);
        assertEquals("http://localhost:" + port + "/#/sear\n", Files.readString(opened));
        assertTrue(read("err"), read("err").startsWith("Open this in a browser:\nhttp://localhost:" + port + "/\n"));
    }

    private String call(String path) throws IOException, InterruptedException {
        HttpRequest request = HttpRequest.newBuilder(URI.create("http://localhost:" + port + "/api/service/" + path))
            .header("Content-Type", "application/json").POST(HttpRequest.BodyPublishers.ofString("[]")).build();
        return HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofString()).body();
    }

    /** Ends the program with Ctrl+C; only the prompt appears. */
    private void endsQuietly() throws Exception {
        process.destroy();
        assertTrue("it goes on", process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        String printed = read("out") + read("err");
        assertFalse(printed, Pattern.compile("Exception|Traceback|\tat |ERROR").matcher(printed).find());
    }

    private static Path example() {
        return Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath().resolve("examples/maze.sear");
    }

    @Test
    public void withoutArgumentsTheTabsOpenOnAnEmptyProjectWithExamples() throws Exception {
        sear();
        isOpen();
        assertTrue(call("sear/getExamples").contains("maze"));
        assertFalse("no folder is made unasked", Files.exists(root.resolve("SEARproject")));
        endsQuietly();
    }

    @Test
    public void aBundleIsOpened() throws Exception {
        sear(example().toString());
        isOpen();
        assertTrue(Files.exists(root.resolve("SEARproject/robot")));
        endsQuietly();
    }

    @Test
    public void aFolderIsOpened() throws Exception {
        Path project = Files.createDirectories(root.resolve("mine/SEARproject/environment"));
        Files.writeString(project.resolve("b.xml"),
            "<Box><name>b</name><length>1</length><width>1</width><height>1</height><mass>0</mass></Box>");
        sear("mine");
        isOpen();
        assertEquals("[]\n", call("sear/getProblems"));
        call("sear/startSimulation");
        assertEquals("true\n", call("sear/isSimulating"));
        endsQuietly();
    }

    @Test
    public void ctrlCEndsASleepingScriptWithoutAStackTrace() throws Exception {
        Files.writeString(root.resolve("s.py"), "sear = Runtime.start('sear', 'SEAR')\nsear.loadProject('"
            + example() + "')\nsear.startSimulation()\nopen('asleep', 'w').close()\nwhile True: sear.simSleep(1)\n");
        sear("s.py");
        await("the script", root.resolve("asleep"));
        endsQuietly();
    }
}
