// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import java.util.List;
import org.SEAR.SearProcess;

/** Runs scripts with {@code sear} in a separate process: headless, in lock-step, without tabs. */
public final class ScriptProcess {
    private static final long PATIENCE_SECONDS = 300;

    private ScriptProcess() {
    }

    /**
     * Runs a script file, which must end with status 0.
     * @param folder working directory
     * @return its output
     */
    public static String run(Path folder, Path script, String... arguments) throws IOException, InterruptedException {
        List<String> command = SearProcess.command("-Xmx512m");
        command.addAll(List.of(script.toString(), "--headless", "--speed", "max", "--port", "none"));
        command.addAll(Arrays.asList(arguments));
        Path output = Files.createTempFile("script", ".txt");
        Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true)
            .redirectOutput(output.toFile()).start();
        try {
            assertTrue(script + " has not ended:\n" + Files.readString(output),
                process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
            String text = Files.readString(output, StandardCharsets.UTF_8);
            assertEquals(text, 0, process.exitValue());
            return text;
        } finally {
            process.destroyForcibly();
            Files.deleteIfExists(output);
        }
    }
}
