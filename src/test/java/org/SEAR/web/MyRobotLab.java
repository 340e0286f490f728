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
 * The embedded MyRobotLab as users start it, {@code sear start.py --headless --keep}: a process of its own, in a folder of its own, with tabs on a
 * free port. Its services are asked over HTTP.
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
        // Seconds: far less than after which the server closes an idle connection, since a call may meet that.
        System.setProperty("jdk.httpclient.keepalive.timeout", "5");
    }

    /** See {@link #shared(String)}; null until it is asked for. */
    private static MyRobotLab shared;

    /** One for each process: connections that it keeps to a killed one are of no use at the next. */
    private HttpClient client;
    private final Path folder;
    private final String moreClasses;
    private final List<String> options;
    private Process process;
    private int port;

    /**
     * Starts it; returns when the script has ended.
     *
     * @param script Jython code that starts services
     */
    public MyRobotLab(String script) throws IOException, InterruptedException {
        this(script, "");
    }

    /**
     * The same with more than what comes with SEAR.
     *
     * @param moreClasses a folder on its class path; empty for none
     * @param options more options of {@code sear}; with {@code --token}, {@link #call} is refused
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
        Files.writeString(folder.resolve(START), "# coding: utf-8\n" + script + "\nopen('" + STARTED + "', 'w').close()\n");
    }

    /**
     * The one for all who share it in this process, with which it ends: no services but the first, an empty folder, and then what a script starts. A
     * new one where that can't be done, as where a script takes a name that another has left.
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

    /** @return false if it has ended or does not answer */
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

    /** What is in the folder, but for what it writes always. */
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
        process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).redirectOutput(logFile().toFile()).start();
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(START_SECONDS);
        while (Files.notExists(folder.resolve(STARTED))) {
            if (process.waitFor(LOOK_MILLIS, TimeUnit.MILLISECONDS) || System.nanoTime() > end) {
                String log = log();
                close();
                throw new IllegalStateException("MyRobotLab did not start:\n" + log);
            }
        }
    }

    /** The address of its tabs. */
    public String url() {
        return "http://localhost:" + port + "/";
    }

    /** Its working folder, with {@code SEARproject} and what services write. */
    public Path folder() {
        return folder;
    }

    /** A file in the working folder. */
    public Path file(String name) {
        return folder.resolve(name);
    }

    /** Path of an example that comes with SEAR, as {@code example("office")}. */
    public static Path example(String name) {
        return Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath().resolve("examples").resolve(name + ".sear");
    }

    /** The same for a script: a Python literal. */
    public static String exampleForScript(String name) {
        return "'" + example(name).toString().replace("\\", "\\\\") + "'";
    }

    /**
     * Calls a method of a service and waits for its answer.
     *
     * @throws AssertionError with what it says, if it fails
     */
    public JsonNode call(String service, String method, Object... arguments) {
        URI uri = URI.create(url() + "api/service/" + service + "/" + method);
        try {
            HttpResponse<String> answer = client.send(HttpRequest.newBuilder(uri).header("Content-Type", "application/json")
                .POST(HttpRequest.BodyPublishers.ofString(JSON.writeValueAsString(arguments))).build(), HttpResponse.BodyHandlers.ofString());
            if (answer.statusCode() != 200) {
                throw new AssertionError(service + "." + method + " answered " + answer.statusCode() + ": " + answer.body());
            }
            return JSON.readTree(answer.body());
        } catch (IOException e) {
            throw new AssertionError(service + "." + method + ": " + e + ", the process " + (process.isAlive() ? "runs" : "has ended") + ":\n"
                + log(), e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError(e);
        }
    }

    /**
     * Runs Jython code in it and waits for its end.
     *
     * @throws AssertionError if it raises
     */
    public void run(String code) {
        if (!call("python", "exec", code).asBoolean()) {
            throw new AssertionError("this raised:\n" + code + "\n" + log());
        }
    }

    /** Ends the process, as Ctrl+C does; the folder stays. */
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

    /** Ends the process as {@code kill -9} does, wherever it is just then; the folder stays. */
    public void kill() throws InterruptedException {
        process.destroyForcibly().waitFor();
    }

    /** Starts a stopped or killed one again, in the same folder and on the same port. */
    public void startAgain() throws IOException, InterruptedException {
        startProcess();
    }

    private Path logFile() {
        return folder.resolve("mrl.log");
    }

    /** All that it has printed since it was started. */
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
