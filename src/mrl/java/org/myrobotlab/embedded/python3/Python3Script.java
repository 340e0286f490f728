// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python3;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Runtime;

/**
 * Runs scripts whose first line asks for Python 3, {@code #!/usr/bin/env python3}, with the package {@code sear}. Any
 * thread.
 */
public final class Python3Script {
    /** System property: true runs every file as Python 3, whatever its first line. */
    public static final String ALWAYS = "sear.python3";
    private static final Pattern FIRST_LINE = Pattern.compile("\\A(?:\\xEF\\xBB\\xBF)?#!.*python3.*");
    private static final int NOT_FOUND = 127;

    private final OutputStream out;
    private final OutputStream err;
    private final List<Process> running = new ArrayList<>();

    /**
     * @param out gets what scripts print
     * @param err gets their error output
     */
    public Python3Script(OutputStream out, OutputStream err) {
        this.out = out;
        this.err = err;
    }

    /** Returns whether the code is a Python 3 script. */
    public static boolean is(byte[] code) {
        return Boolean.getBoolean(ALWAYS) || FIRST_LINE.matcher(new String(code, StandardCharsets.ISO_8859_1))
            .lookingAt();
    }

    /**
     * Runs a script and waits for its end.
     *
     * @return its exit status
     */
    public int run(Path script, List<String> arguments) throws IOException, InterruptedException {
        ServiceInterface sear = Runtime.start("sear", "SEAR");
        Object port = sear == null ? null : sear.invoke("startPython3", 0);
        if (port == null) {
            throw new IOException("SEAR can't open its port for Python 3");
        }
        String python = System.getenv().getOrDefault("SEAR_PYTHON", isWindows() ? "python" : "python3");
        List<String> command = new ArrayList<>(List.of(python, "-u", "-m", "sear", script.toString()));
        command.addAll(arguments);
        ProcessBuilder builder = new ProcessBuilder(command).redirectInput(ProcessBuilder.Redirect.INHERIT);
        Map<String, String> environment = builder.environment();
        environment.put("SEAR_GATEWAY", port.toString());
        Path modules = Path.of(System.getProperty("sear.home", "."), "python");
        environment.merge("PYTHONPATH", modules.toString(), (old, own) -> old + File.pathSeparator + own);
        Process process;
        try {
            process = builder.start();
        } catch (IOException e) {
            err.write(("sear: " + script + " is Python 3, but there is no " + python + " to run it: install Python 3.9 "
                + "or newer, or set SEAR_PYTHON to it\n").getBytes(StandardCharsets.UTF_8));
            return NOT_FOUND;
        }
        return waitFor(process);
    }

    private int waitFor(Process process) throws IOException, InterruptedException {
        synchronized (running) {
            running.add(process);
        }
        Thread errors = new Thread(() -> pass(process.getErrorStream(), err), "python3 errors");
        errors.setDaemon(true);
        errors.start();
        try {
            pass(process.getInputStream(), out);
            errors.join();
            return process.waitFor();
        } finally {
            process.destroy();
            synchronized (running) {
                running.remove(process);
            }
        }
    }

    private static void pass(InputStream from, OutputStream to) {
        try {
            from.transferTo(to);
        } catch (IOException e) {
            // the reader has closed the stream, or the script was stopped
        }
    }

    private static boolean isWindows() {
        return System.getProperty("os.name").toLowerCase(Locale.ROOT).startsWith("windows");
    }

    /**
     * Ends all running scripts.
     *
     * @return whether any was running
     */
    public boolean stop() {
        synchronized (running) {
            running.forEach(Process::destroy);
            return !running.isEmpty();
        }
    }
}
