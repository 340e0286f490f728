// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Comparator;
import java.util.concurrent.TimeUnit;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.FreePort;
import org.SEAR.SearProcess;

/**
 * The embedded MyRobotLab as users start it, {@code sear start.py --headless --keep}: a separate process in its own
 * folder, with tabs on a free port. Tests call its services over HTTP.
 */
public final class MyRobotLab implements AutoCloseable {
    private static final int START_SECONDS = 120;
    private static final int STOP_SECONDS = 30;
    private static final int LOOK_MILLIS = 100;
    private static final String START = "start.py";
    private static final String STARTED = "started.txt";
    private static final String RELEASE_ALL = String.join("\n",
        "for _name in Runtime.getServiceNames():",
        "    if _name.split('@')[0] not in ('runtime', 'python', 'webgui', 'security'): Runtime.release(_name)");
    private static final String TAKEN = "is in use by another program";
    private static final ObjectMapper JSON = new ObjectMapper();

    static {
        // Seconds, far below the server's timeout of idle connections, because a call may hit that moment.
        System.setProperty("jdk.httpclient.keepalive.timeout", "5");
    }

    /** See {@link #shared(String)}; null until it is first used. */
    private static MyRobotLab shared;

    /** A new client per process: connections kept to a killed process are useless afterwards. */
    private HttpClient client;
    private final Path folder;
    private final String moreClasses;
    private final List<String> options;
    private Process process;
    private int port;

    /**
     * Starts MyRobotLab and returns when the script has ended.
     * @param script Jython code that starts services
     */
    public MyRobotLab(String script) throws IOException, InterruptedException {
        this(script, "");
    }

    /**
     * Starts MyRobotLab with a longer class path.
     * @param moreClasses a folder on its class path; empty for none
     * @param options more options of {@code sear}; with {@code --token}, {@link #call} fails
     */
    public MyRobotLab(String script, String moreClasses, String... options) throws IOException, InterruptedException {
        this.moreClasses = moreClasses;
        this.options = List.of(options);
        folder = Files.createTempDirectory("sear-web").toRealPath();
        write(script);
        while (process == null || log().contains(TAKEN)) {
            if (process != null) {
                stop();
            }
            port = FreePort.find();
            startProcess();
        }
    }

    private void write(String script) throws IOException {
        Files.writeString(folder.resolve(START), "# coding: utf-8\n" + script + "\nopen('" + STARTED
            + "', 'w').close()\n");
    }

    /**
     * Returns the MyRobotLab that all tests of this process share; it ends with the process. It has only its first
     * services, an empty folder, and the services of the script. A new one starts if the old one can't be reset, for
     * example if the script needs a name that a former one left.
     */
    static synchronized MyRobotLab shared(String script) throws IOException, InterruptedException {
        if (shared == null) {
            shared = new MyRobotLab(script);
            Runtime.getRuntime().addShutdownHook(new Thread(() -> shared.close()));
        } else if (!shared.renew(script)) {
            shared.close();
            shared = new MyRobotLab(script);
        }
        return shared;
    }

    /** @return false if the process has ended or does not answer */
    private boolean renew(String script) throws IOException {
        try {
            run(RELEASE_ALL);
            for (Path file : contents()) {
                deleteFolder(file);
            }
            write(script);
            run("execfile('" + START + "', globals())");
        } catch (IllegalStateException | AssertionError e) {
            System.err.println("MyRobotLab is started anew: " + e);
            return false;
        }
        return true;
    }

    /** Returns the content of the folder without the files that MyRobotLab always writes. */
    private List<Path> contents() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> !file.equals(logFile()) && !file.endsWith("data")).collect(Collectors.toList());
        }
    }

    private void startProcess() throws IOException, InterruptedException {
        client = HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
        Files.deleteIfExists(folder.resolve(STARTED));
        List<String> command = SearProcess.command(moreClasses, new String[] {"-Xmx384m", "-Dfile.encoding=UTF-8"});
        command.addAll(List.of(START, "--headless", "--keep", "--port", String.valueOf(port)));
        command.addAll(options);
        process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true)
            .redirectOutput(logFile().toFile()).start();
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(START_SECONDS);
        while (Files.notExists(folder.resolve(STARTED))) {
            if (process.waitFor(LOOK_MILLIS, TimeUnit.MILLISECONDS) || System.nanoTime() > end) {
                String log = log();
                close();
                throw new IllegalStateException("MyRobotLab did not start:\n" + log);
            }
        }
    }

    /** Returns the address of the tabs. */
    public String url() {
        return "http://localhost:" + port + "/";
    }

    /** Returns the working folder, with {@code SEARproject} and files of services. */
    public Path folder() {
        return folder;
    }

    public Path file(String name) {
        return folder.resolve(name);
    }

    /** Returns the path of an example that comes with SEAR, such as {@code example("office")}. */
    public static Path example(String name) {
        return Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath().resolve("examples")
            .resolve(name + ".sear");
    }

    /** Returns the path of an example as a Python literal. */
    public static String exampleForScript(String name) {
        return "'" + example(name).toString().replace("\\", "\\\\") + "'";
    }

    /**
     * Calls a method of a service and waits for its answer.
     * @throws AssertionError with the answer if the call fails
     */
    public JsonNode call(String service, String method, Object... arguments) {
        URI uri = URI.create(url() + "api/service/" + service + "/" + method);
        try {
            HttpResponse<String> answer = client.send(
                HttpRequest.newBuilder(uri).header("Content-Type", "application/json")
                .POST(HttpRequest.BodyPublishers.ofString(JSON.writeValueAsString(arguments))).build(),
                    HttpResponse.BodyHandlers.ofString());
            if (answer.statusCode() != 200) {
                throw new AssertionError(service + "." + method + " answered " + answer.statusCode() + ": "
                    + answer.body());
            }
            return JSON.readTree(answer.body());
        } catch (IOException e) {
            throw new AssertionError(service + "." + method + ": " + e + ", the process "
                + (process.isAlive() ? "runs" : "has ended") + ":\n" + log(), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError(e);
        }
    }

    /**
     * Runs Jython code and waits for its end.
     * @throws AssertionError if it raises
     */
    public void run(String code) {
        if (!call("python", "exec", code).asBoolean()) {
            throw new AssertionError("this raised:\n" + code + "\n" + log());
        }
    }

    /** Ends the process like Ctrl+C; the folder stays. */
    public void stop() {
        process.destroy();
        try {
            if (!process.waitFor(STOP_SECONDS, TimeUnit.SECONDS)) {
                process.destroyForcibly().waitFor();
            }
        } catch (InterruptedException e) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
    }

    /** Ends the process like {@code kill -9} at any moment; the folder stays. */
    public void kill() throws InterruptedException {
        process.destroyForcibly().waitFor();
    }

    /** Starts a stopped or killed MyRobotLab again, in the same folder and on the same port. */
    public void startAgain() throws IOException, InterruptedException {
        startProcess();
    }

    private Path logFile() {
        return folder.resolve("mrl.log");
    }

    /** Returns everything printed since the start. */
    public String log() {
        try {
            return Files.exists(logFile()) ? new String(Files.readAllBytes(logFile()), StandardCharsets.UTF_8) : "";
        } catch (IOException e) {
            return e.toString();
        }
    }

    /** Ends the process and deletes the folder. */
    @Override
    public void close() {
        stop();
        deleteFolder(folder);
    }

    public static void deleteFolder(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            List<Path> deepestFirst = files.sorted(Comparator.reverseOrder()).collect(Collectors.toList());
            for (Path file : deepestFirst) {
                Files.deleteIfExists(file);
            }
        } catch (IOException | java.io.UncheckedIOException e) {
            System.err.println(folder + " could not be deleted: " + e);
        }
    }
}
