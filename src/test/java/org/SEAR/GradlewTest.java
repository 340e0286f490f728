// SPDX-License-Identifier: Apache-2.0
package org.SEAR;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import org.junit.Assume;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/**
 * {@code ./gradlew} on a machine without a JDK while another program uses apt, such as the updates of a fresh Ubuntu.
 */
public class GradlewTest {
    private static final List<String> TOOLS = List.of("cat", "dirname", "grep", "mktemp", "rm");

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private Path tools;
    private Path calls;

    private void program(String name, String... lines) throws IOException {
        Path file = tools.resolve(name);
        Files.writeString(file, "#!/bin/sh\n" + String.join("\n", lines) + "\n");
        assertTrue(file.toFile().setExecutable(true));
    }

    /** @param failing how many times apt-get prints this message and fails */
    private String run(int failing, String message, String... variables) throws Exception {
        Assume.assumeTrue("a POSIX shell", Files.exists(Paths.get("/bin/sh")));
        tools = temporary.newFolder().toPath();
        calls = tools.resolve("calls");
        Files.writeString(calls, "");
        for (String tool : TOOLS) {
            program(tool, "PATH=/usr/bin:/bin exec " + tool + " \"$@\"");
        }
        program("env", "shift", "exec \"$@\"");
        program("id", "echo 0");
        program("sleep", "echo slept $1 >>" + calls);
        program("gradle", "echo gradle \"$@\"");
        program("apt-get", "echo apt-get \"$@\" >>" + calls, "[ $(grep -c ^apt-get " + calls + ") -gt " + failing
            + " ] && exit 0", "echo '" + message + "'", "exit 100");
        ProcessBuilder builder = new ProcessBuilder("/bin/sh", Paths.get(System.getProperty("sear.root", "."))
            .resolve("gradlew").toString(), "help");
        builder.environment().put("PATH", tools.toString());
        builder.environment().remove("SEAR_INSTALL");
        for (int i = 0; i < variables.length; i += 2) {
            builder.environment().put(variables[i], variables[i + 1]);
        }
        Process process = builder.redirectErrorStream(true).start();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return process.waitFor() + " " + output;
    }

    @Test
    public void itWaitsForAptAndReportsIt() throws Exception {
        String output = run(3, "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 1234 (apt-get)");
        assertEquals(output, 2, output.split("another program is installing or updating packages", -1).length);
        assertTrue(output, output.startsWith("0 ") && output.contains("gradle help"));
        String done = Files.readString(calls);
        assertEquals(done, 4, done.split("slept 5", -1).length);
        assertTrue(done, done.contains("DPkg::Lock::Timeout=600 update")
            && done.contains("install -y --no-install-recommends default-jdk-headless"));
    }

    @Test
    public void anotherFailureEndsItWithTheMessageOfApt() throws Exception {
        String output = run(Integer.MAX_VALUE, "E: Temporary failure resolving");
        assertTrue(output, output.startsWith("1 ") && output.contains("E: Temporary failure resolving")
            && output.contains("could not install"));
        assertTrue(output, !output.contains("gradle help"));
    }

    @Test
    public void itNamesWhatItInstallsAndInstallsNothingIfToldSo() throws Exception {
        String installed = run(0, "");
        assertTrue(installed, installed.contains("installing with apt-get")
            && installed.contains("default-jdk-headless"));
        String refused = run(0, "", "SEAR_INSTALL", "no");
        assertTrue(refused, refused.startsWith("1 ") && refused.contains("default-jdk-headless"));
        assertEquals("", Files.readString(calls));
    }
}
