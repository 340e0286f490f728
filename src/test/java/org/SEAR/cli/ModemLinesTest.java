// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.SearProcess;
import org.junit.Test;

/** A program that sets DTR works at a pseudo-terminal. */
public class ModemLinesTest {
    private static final String DTR = String.join("\n", "import fcntl, os, struct, sys, termios",
        "master, slave = os.openpty()",
        "def lines(request, value=0):",
        "    return struct.unpack('i', fcntl.ioctl(slave, request, struct.pack('i', value)))[0]",
        "fcntl.ioctl(slave, termios.TIOCMBIC, struct.pack('i', termios.TIOCM_DTR))",
        "assert lines(termios.TIOCMGET) & termios.TIOCM_DTR == 0",
        "lines(termios.TIOCMBIS, termios.TIOCM_DTR)",
        "assert lines(termios.TIOCMGET) & termios.TIOCM_DTR and lines(termios.TIOCMGET) & termios.TIOCM_CTS",
        "lines(termios.TIOCMSET, termios.TIOCM_RTS)",
        "assert lines(termios.TIOCMGET) & termios.TIOCM_DTR == 0",
        "try:",
        "    fcntl.ioctl(os.open('/dev/null', os.O_RDWR), termios.TIOCMGET, b'0000')",
        "    sys.exit('a file has no modem lines')",
        "except OSError:",
        "    sys.exit(int(sys.argv[2]))");

    private static Process sear(String... arguments) throws IOException {
        List<String> command = SearProcess.command();
        command.add("modem-lines");
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command).redirectErrorStream(true).start();
    }

    private static String said(Process process) throws IOException {
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }

    @Test
    public void aProgramSetsAndReadsThem() throws Exception {
        for (String[] before : new String[][] {{"--"}, {}}) {
            List<String> command = new ArrayList<>(List.of(before));
            command.addAll(List.of("python3", "-c", DTR, "--", "7"));
            Process process = sear(command.toArray(new String[0]));
            assertEquals("", said(process));
            assertEquals("the program's own status", 7, process.waitFor());
        }
    }

    @Test
    public void missingRequirementsAreReported() throws Exception {
        Process process = sear("--", "there-is-no-such-program");
        String said = said(process);
        assertTrue(said, said.startsWith("sear: the program can't be started: ")
            && said.contains("there-is-no-such-program"));
        assertEquals(2, process.waitFor());
        IOException none = assertThrows(IOException.class, () -> ModemLines.compile("no-such-cc"));
        assertTrue(none.getMessage(), none.getMessage().startsWith("there is no C compiler (no-such-cc)")
            && none.getMessage().contains("gcc"));
        IOException broken = assertThrows(IOException.class, () -> ModemLines.compile("false"));
        assertTrue(broken.getMessage(), broken.getMessage().startsWith("the C compiler (false) could not compile"));
    }

    @Test
    public void itLeavesNothing() throws Exception {
        Path library;
        try (ModemLines lines = ModemLines.compile("cc")) {
            library = lines.getLibrary();
            assertTrue(Files.isRegularFile(library));
            assertEquals("rwx------", PosixFilePermissions.toString(
                Files.getPosixFilePermissions(library.getParent())));
        }
        assertFalse(Files.exists(library.getParent()));
    }
}
