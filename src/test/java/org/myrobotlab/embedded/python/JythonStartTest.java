// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import static org.junit.Assert.assertEquals;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.Test;

/** A program that ends during Python's start, for example because its script is missing, prints no error about it. */
public class JythonStartTest {
    /** Starts Python while the program is ending. */
    public static void main(String[] none) {
        Runtime.getRuntime().addShutdownHook(new Thread(() -> {
            JythonStart.begin();
            Thread.getAllStackTraces().keySet().stream().filter(thread -> thread.getName().equals("jython start"))
                .forEach(thread -> {
                try {
                    thread.join();
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            });
        }));
    }

    @Test
    public void theEndOfTheProgramIsNoError() throws Exception {
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1", "-cp",
            System.getProperty("java.class.path"), JythonStartTest.class.getName()).redirectErrorStream(true).start();
        assertEquals("", new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
        assertEquals(0, process.waitFor());
    }
}
