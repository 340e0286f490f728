// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assume.assumeTrue;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
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

    /** Its line in /proc begins with process id, name, state, parent, process group and session. */
    @Test(timeout = 120_000)
    public void aProgramHasAParentAGroupAndASessionOfItsOwn() throws Exception {
        assumeTrue(Files.isReadable(Path.of("/proc/self/stat")));
        ProcessFamily family = new ProcessFamily();
        Process program = family.start(new ProcessBuilder("cat", "/proc/self/stat"));
        String[] stat = new String(program.getInputStream().readAllBytes(), StandardCharsets.UTF_8).split(" ");
        assertEquals(0, program.waitFor());
        assertEquals("the parent", String.valueOf(program.pid()), stat[3]);
        assertEquals("the process group", stat[0], stat[4]);
        assertEquals("the session", stat[0], stat[5]);
    }

    @Test(timeout = 120_000)
    public void theStatusIsThatOfTheProgram() throws Exception {
        ProcessFamily family = new ProcessFamily();
        assertEquals(7, family.start(new ProcessBuilder("sh", "-c", "exit 7")).waitFor());
        family.end();
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
