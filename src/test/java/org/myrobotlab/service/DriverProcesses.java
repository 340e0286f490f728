package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;

import java.io.File;
import java.io.IOException;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.rules.ExternalResource;
import org.junit.rules.TemporaryFolder;

/** Programs of others that a test starts, with an empty project's folder for what they are to drive; what still runs at the end is ended. */
final class DriverProcesses extends ExternalResource {
    /** Seconds that a driver runs at least: {@code -Dsear.driverSeconds}. */
    static final int SECONDS = Integer.getInteger("sear.driverSeconds", 8);
    private static final Path SCRIPTS = Paths.get(System.getProperty("sear.root", "."), "src/test/drivers").toAbsolutePath();
    private static final int PATIENCE = 60;

    private final TemporaryFolder folder = new TemporaryFolder();
    private final List<Process> processes = new ArrayList<>();
    private final List<File> outputs = new ArrayList<>();

    @Override
    protected void before() throws IOException {
        folder.create();
        System.setProperty("sear.project", path("SEARproject"));
        System.setProperty("sear.headless", "true");
    }

    @Override
    protected void after() {
        processes.forEach(Process::destroyForcibly);
        System.clearProperty("sear.project");
        System.clearProperty("sear.headless");
        folder.delete();
    }

    /** A path of that name in a folder that is deleted afterwards. */
    String path(String name) {
        return folder.getRoot().toPath().resolve(name).toString();
    }

    static int freePort() throws IOException {
        try (ServerSocket socket = new ServerSocket(0)) {
            return socket.getLocalPort();
        }
    }

    /** The lines that a Python script of this project has printed when it has ended well. */
    List<String> python(String script, String... arguments) throws Exception {
        List<String> command = new ArrayList<>(Arrays.asList("python3", SCRIPTS.resolve(script).toString()));
        command.addAll(Arrays.asList(arguments));
        ProcessBuilder builder = new ProcessBuilder(command);
        builder.environment().put("PYTHONPATH", System.getProperty("sear.drivers"));
        Process process = start(builder);
        List<String> output = read(process, SECONDS + PATIENCE);
        assertEquals(String.join("\n", output), 0, process.waitFor());
        return output;
    }

    Process start(ProcessBuilder builder) throws IOException {
        builder.environment().merge("PATH", "/usr/sbin:/sbin", (path, more) -> path + File.pathSeparator + more);
        Process process = builder.redirectErrorStream(true).redirectOutput(folder.newFile()).directory(folder.getRoot()).start();
        processes.add(process);
        outputs.add(builder.redirectOutput().file());
        return process;
    }

    /** All that a process has said when it ends, or after some seconds. */
    List<String> read(Process process, int seconds) throws Exception {
        process.waitFor(seconds, TimeUnit.SECONDS);
        File file = outputs.get(processes.indexOf(process));
        return Arrays.stream(new String(Files.readAllBytes(file.toPath()), StandardCharsets.ISO_8859_1).split("\r?\n|\r"))
            .collect(Collectors.toList());
    }
}
