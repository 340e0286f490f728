// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assume.assumeTrue;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.Test;

/** Processes that a script leaves behind. */
public class ProcessFamilyTest {
    /** The process left behind holds the pipe open until its end. */
    @Test(timeout = 120_000)
    public void aProcessWhoseParentsHaveEndedBeforeAnySearchIsEnded() throws Exception {
        assumeTrue(Files.isReadable(Path.of("/proc/self/environ")));
        ProcessFamily family = new ProcessFamily();
        Process program = family.start(new ProcessBuilder("sh", "-c", "(setsid sleep 100000 & echo $!)"));
        try (BufferedReader reader = new BufferedReader(new InputStreamReader(program.getInputStream()))) {
            long left = Long.parseLong(reader.readLine());
            assertEquals(0, program.waitFor());
            assertTrue(ProcessHandle.of(left).isPresent());
            family.end();
            assertNull(reader.readLine());
        }
    }

    @Test
    public void otherProcessesAreNoMembers() throws Exception {
        Process other = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-version").start();
        try {
            ProcessFamily family = new ProcessFamily();
            family.look();
            assertEquals(0, family.kilobytes());
            assertEquals(0, family.seconds(), 0);
        } finally {
            other.destroyForcibly();
        }
    }
}
