// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.net.ConnectException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpTimeoutException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.SEAR.FreePort;

/** A running MyRobotLab with WebGui, Python and SEAR, controlled over HTTP. */
final class RealMrl {
    private static final long PATIENCE_SECONDS = 240;
    private static final Path JAVA = Path.of(System.getProperty("sear.mrlJava", System.getProperty("java.home")),
        "bin", "java");
    /**
     * Runs a script and writes its output to a file. The pending space of "print a, b" is tracked per thread, because
     * MyRobotLab's Python service executes a line of its own after each service start, which would end another thread's
     * line.
     */
    private static final String WRAPPER = "import os, sys, threading, traceback\nclass _Output(object):\n"
        + "    def __init__(self, name):\n"
        + "        self.__dict__.update(file=open(name, 'w', 0), owed=threading.local())\n"
        + "    def __getattr__(self, name):\n"
        + "        return getattr(self.owed, name, 0) if name == 'softspace' else getattr(self.file, name)\n"
        + "    def __setattr__(self, name, value):\n        setattr(self.owed, name, value)\n"
        + "_console = sys.stdout, sys.stderr\nsys.stdout = sys.stderr = _Output(%1$s)\ntry:\n    try:\n"
        + "        execfile(%2$s, globals())\n    except:\n        traceback.print_exc(None, sys.stdout)\nfinally:\n"
        + "    _file = sys.stdout\n"
        + "    sys.stdout, sys.stderr = _console\n"    // a callback that ends now must not find the file closed
        + "    _file.close()\n    os.rename(%1$s, %3$s)\n";
    private static RealMrl shared;
    private static int runs;

    /** HTTP/1.1: this WebGui takes an HTTP/2 upgrade for a web socket request and rejects it. */
    private final HttpClient client = HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
    private final Path folder;
    private final Path log;
    private final int port;
    private final Process process;
    private final List<String> firstServices;

    /**
     * Starts MyRobotLab as its own start script does, but without a browser and without the optimizing compiler, which
     * does not pay off within minutes. Waits until the web server answers.
     * @param folder of the copy
     * @param config the configuration's name
     */
    RealMrl(Path folder, String config) throws IOException, InterruptedException {
        this.folder = folder;
        log = RealMrlCopy.BUILD.resolve("logs").resolve(folder.getFileName() + "-" + config + "-" + ++runs + ".log");
        Files.createDirectories(log.getParent());
        port = FreePort.find();
        Path web = folder.resolve("data/config").resolve(config).resolve("webgui.yml");
        Files.createDirectories(web.getParent());
        Files.writeString(web, "!!org.myrobotlab.service.config.WebGuiConfig\nautoStartBrowser: false\nport: " + port
            + "\ntype: WebGui\n");
        process = new ProcessBuilder(JAVA.toString(), "-Xmx1200m", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC",
            "-Djava.library.path=libraries/native", "-Djna.library.path=libraries/native", "-Dfile.encoding=UTF-8",
            "-Dsear.headless=true",
            "-cp", "libraries/jar/*:myrobotlab.jar", "org.myrobotlab.service.Runtime", "--log-level", "warn",
            "-c", config,
            "-s", "webgui", "WebGui", "python", "Python").directory(folder.toFile()).redirectErrorStream(true)
            .redirectOutput(log.toFile()).start();
        try {
            await("MyRobotLab's Python", () -> "true".equals(get("/api/service/python/isRunning"))
                && python("print 'ready'").equals("ready\n"));
            firstServices = services();
        } catch (IOException | InterruptedException | AssertionError e) {
            process.destroyForcibly();
            throw e;
        }
    }

    static synchronized RealMrl shared() throws IOException, InterruptedException {
        if (shared == null || !shared.process.isAlive()) {
            RealMrlCopy copy = new RealMrlCopy("mrl");
            copy.install();
            share(new RealMrl(copy.folder(), "tests"));
        }
        return shared;
    }

    /** Makes a MyRobotLab the shared one. */
    static synchronized void share(RealMrl running) {
        if (shared == null) {
            Runtime.getRuntime().addShutdownHook(new Thread(() -> shared.process.destroyForcibly()));
        }
        shared = running;
    }

    Path folder() {
        return folder;
    }

    int port() {
        return port;
    }

    String log() throws IOException {
        return Files.readString(log);
    }

    /** A condition to wait for. */
    interface Condition {
        boolean holds() throws IOException, InterruptedException;
    }

    void await(String what, Condition condition) throws IOException, InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (true) {
            try {
                if (condition.holds()) {
                    return;
                }
            } catch (ConnectException | HttpTimeoutException e) {
                assertTrue("MyRobotLab ended\n" + tail(), process.isAlive());
            }
            assertTrue("waited in vain for " + what + "\n" + tail(), System.nanoTime() < end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(50));
        }
    }

    /** Returns the last lines of the log. */
    String tail() throws IOException {
        List<String> lines = Files.readAllLines(log);
        return log + ":\n" + String.join("\n", lines.subList(Math.max(0, lines.size() - 30), lines.size()));
    }

    String get(String path) throws IOException, InterruptedException {
        return client.send(request(path).build(), HttpResponse.BodyHandlers.ofString()).body();
    }

    private HttpRequest.Builder request(String path) {
        return HttpRequest.newBuilder(URI.create("http://localhost:" + port + path))
            .timeout(Duration.ofSeconds(PATIENCE_SECONDS));
    }

    /** Calls a method of a service; {@code json} is the list of its arguments. */
    String call(String serviceAndMethod, String json) throws IOException, InterruptedException {
        HttpResponse<String> answer = client.send(request("/api/service/" + serviceAndMethod)
            .header("Content-Type", "application/json")
            .POST(HttpRequest.BodyPublishers.ofString(json)).build(), HttpResponse.BodyHandlers.ofString());
        assertEquals(serviceAndMethod + " " + answer.body() + "\n" + tail(), 200, answer.statusCode());
        return answer.body();
    }

    String python(String... lines) throws IOException, InterruptedException {
        return run(write("lines", String.join("\n", Arrays.asList(lines)) + "\n"));
    }

    private static Path write(String name, String text) throws IOException {
        Path file = RealMrlCopy.BUILD.resolve("scripts").resolve(++runs + "-" + name + ".py");
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    /**
     * Runs a script file in the Python service.
     * @return its output, with the traceback if it raised
     */
    String run(Path script) throws IOException, InterruptedException {
        Path wrapper = write("run", "");
        Path output = Path.of(wrapper + ".out");
        Files.writeString(wrapper, String.format(WRAPPER, literal(output + ".part"), literal(script.toString()),
            literal(output.toString())));
        call("python/execFile", "[\"" + wrapper + "\"]");
        await("the end of " + script, () -> Files.exists(output));
        return Files.readString(output);
    }

    /** Returns a text as a Python literal. */
    static String literal(String text) {
        return "'" + text.replace("\\", "\\\\").replace("'", "\\'").replace("\n", "\\n") + "'";
    }

    /** Returns the names of all services in the registry, without MyRobotLab's id. */
    List<String> services() throws IOException, InterruptedException {
        List<String> names = new ArrayList<>();
        for (String name : python("for name in sorted(Runtime.getServiceNames()): print name").split("\n")) {
            names.add(name.replaceAll("@.*", ""));
        }
        return names;
    }

    List<String> firstServices() {
        return firstServices;
    }

    /** Shuts MyRobotLab down as its shut-down button does; the process may end before it answers. */
    void close() throws IOException, InterruptedException {
        client.sendAsync(request("/api/service/runtime/shutdown").build(), HttpResponse.BodyHandlers.discarding());
        boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        process.destroyForcibly();
        assertTrue("MyRobotLab does not end\n" + tail(), ended);
    }
}
