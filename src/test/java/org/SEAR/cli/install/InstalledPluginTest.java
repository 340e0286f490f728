// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.net.ConnectException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import org.SEAR.FreePort;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.SEAR.Needs;

/**
 * The plug-in in a folder laid out as MyRobotLab's, with the embedded MyRobotLab as myrobotlab.jar. It starts with
 * MyRobotLab's class path order and command line and is used over its WebGui only.
 */
@Needs("distZip")
public class InstalledPluginTest {
    private static final int PATIENCE = 240;
    private static final String THREADS = "from java.lang import Thread\n"
        + "print 'threads:' + ','.join([t.getName() for t in Thread.getAllStackTraces().keySet()])\n";

    /** Expected nearest reading and GPS position of the robot of examples/sensors.py. */
    private static final String NEAREST = "(?s).*\\b181 readings, the nearest at 21[45]\\d mm\\R.*";
    private static final String POSITION = "(?s).*\\blatitude 33\\.6100\\d\\d, longitude -80\\.8650\\d\\d, altitude "
        + "182\\.[56] m\\R.*";

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private final HttpClient client = HttpClient.newHttpClient();
    private Path mrl;
    private Path log;
    private Process process;
    private int port;

    @Before
    public void installAndStart() throws Exception {
        Distribution distribution = new Distribution(folder.newFolder("distribution").toPath());
        mrl = folder.newFolder("my robot lab").toPath();
        distribution.layOut(mrl);
        new Installer(mrl).install(distribution.home().resolve("plugin"), false).apply();
        assertFalse("the installer leaves MyRobotLab's first start alone", Files.exists(mrl.resolve("resource")));
        Files.createDirectories(mrl.resolve("resource/WebGui/app/service/js"));
        port = FreePort.find();
        Path config = Files.createDirectories(mrl.resolve("data/config/default"));
        Files.writeString(config.resolve("webgui.yml"), "!!org.myrobotlab.service.config.WebGuiConfig\nport: " + port
            + "\ntype: WebGui\n");
        log = folder.getRoot().toPath().resolve("log.txt");
        process = new ProcessBuilder(Distribution.java().toString(), "-Xmx400m", "-Dsear.headless=true",
            "-Dsear.speed=max", "-cp",
            "libraries/jar/*:myrobotlab.jar", "org.myrobotlab.service.Runtime", "-s", "webgui", "WebGui", "python",
            "Python", "sear", "SEAR", "lidar", "LIDAR", "gps", "GPS").directory(mrl.toFile()).redirectErrorStream(true)
            .redirectOutput(log.toFile()).start();
        await("gps", () -> get("/api/service").contains("gps@"));
    }

    @After
    public void end() {
        process.destroyForcibly();
    }

    /** A condition to wait for. */
    private interface Condition {
        boolean holds() throws IOException, InterruptedException;
    }

    private void await(String what, Condition condition) throws IOException, InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE);
        while (true) {
            try {
                if (condition.holds()) {
                    return;
                }
            } catch (ConnectException e) {
                assertTrue("MyRobotLab ended\n" + log(), process.isAlive());
            }
            assertTrue("waited in vain for " + what + "\n" + log(), System.nanoTime() < end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(100));
        }
    }

    private String log() throws IOException {
        return Files.readString(log);
    }

    private String get(String path) throws IOException, InterruptedException {
        HttpRequest request = HttpRequest.newBuilder(URI.create("http://localhost:" + port + path)).build();
        return client.send(request, HttpResponse.BodyHandlers.ofString()).body();
    }

    private HttpRequest request(String path, String json) {
        URI uri = URI.create("http://localhost:" + port + "/api/service/" + path);
        return HttpRequest.newBuilder(uri).header("Content-Type", "application/json")
            .POST(HttpRequest.BodyPublishers.ofString(json)).build();
    }

    private void call(String path, String json) throws IOException, InterruptedException {
        HttpResponse<String> answer = client.send(request(path, json), HttpResponse.BodyHandlers.ofString());
        assertEquals(path + " " + answer.body() + log(), 200, answer.statusCode());
    }

    @Test
    public void itRunsAndLeavesNothingBehind() throws Exception {
        isLeftAloneByTheInstaller();
        panelsComeFromTheResourceRoot();
        call("python/execFile", "[\"resource/SEAR/SEAR.py\"]");
        await("the script's output", () -> log().split(" m to the wall", -1).length == 6);
        assertTrue(Files.isDirectory(mrl.resolve("SEARproject")));
        theExamplesOfLidarAndGpsPrintTheirMeasurements();
        for (String service : new String[] {"sear", "lidar", "gps"}) {
            call("runtime/release", "[\"" + service + "\"]");
        }
        Path script = mrl.resolve("threads.py");
        Files.writeString(script, THREADS);
        await("the plug-in's threads to end", () -> {
            call("python/execFile", "[\"threads.py\"]");
            List<String> lines = log().lines().filter(line -> line.startsWith("threads:")).collect(Collectors.toList());
            return !lines.isEmpty() && !lines.get(lines.size() - 1)
                .matches(".*(SEAR|/dev/|serial time-outs|[:,](sear|lidar|gps)[@_,]).*");
        });
        // the server may end before it answers
        client.sendAsync(request("runtime/shutdown", "[]"), HttpResponse.BodyHandlers.discarding());
        assertTrue("a thread keeps MyRobotLab alive\n" + log(), process.waitFor(PATIENCE, TimeUnit.SECONDS));
        assertEquals(log(), 0, process.exitValue());
        assertFalse(log(), log().contains("ERROR") || log().contains("Exception"));
    }

    private void theExamplesOfLidarAndGpsPrintTheirMeasurements() throws Exception {
        call("sear/loadProject", "[\"resource/SEAR/sensors.sear\"]");
        call("sear/startSimulation", "[]");
        call("sear/simSleep", "[1]");
        call("python/execFile", "[\"resource/LIDAR/LIDAR.py\"]");
        call("sear/simSleep", "[5]");
        await("the scan", () -> log().matches(NEAREST));
        call("python/execFile", "[\"resource/GPS/GPS.py\"]");
        call("sear/simSleep", "[3]");
        await("the position", () -> log().matches(POSITION));
    }

    private void isLeftAloneByTheInstaller() throws IOException {
        try {
            new Installer(mrl).install(mrl.resolve("libraries/jar"), false);
            throw new AssertionError("was not refused");
        } catch (InstallException e) {
            assertEquals("MyRobotLab is running from " + mrl + " (process " + process.pid()
                + "). Shut it down and try again.", e.getMessage());
        }
    }

    private void panelsComeFromTheResourceRoot() throws Exception {
        for (String service : new String[] {"SEAR", "LIDAR", "GPS"}) {
            for (String file : new String[] {"WebGui/app/service/js/%sGui.js", "WebGui/app/service/views/%sGui.html",
                "%s.png", "%s/%s.py"}) {
                Path copy = mrl.resolve("resource").resolve(file.replace("%s", service));
                assertTrue(copy + " was not copied", Files.size(copy) > 0);
            }
            Path panel = mrl.resolve("resource/WebGui/app/service/js/" + service + "Gui.js");
            assertEquals(Files.readString(panel), get("/service/js/" + service + "Gui.js"));
            Files.writeString(panel, "// mine\n");
            assertEquals("// mine\n", get("/service/js/" + service + "Gui.js"));
        }
    }
}
