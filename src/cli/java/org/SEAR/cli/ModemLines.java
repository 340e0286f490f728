// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The library that adds modem lines to pseudo-terminals. It is compiled on demand in a private folder and deleted on
 * close. One thread.
 */
final class ModemLines implements AutoCloseable {
    private static final String SOURCE = "modem_lines.c";

    private final Path folder;
    private final Path library;

    private ModemLines(Path folder) {
        this.folder = folder;
        this.library = folder.resolve("modem_lines.so");
    }

    /**
     * Compiles the library.
     *
     * @param compiler the C compiler, {@code cc}
     * @throws IOException if the compiler or a header is missing
     */
    static ModemLines compile(String compiler) throws IOException, InterruptedException {
        ModemLines lines = new ModemLines(Files.createTempDirectory("sear-modem-lines"));
        boolean done = false;
        try (InputStream source = ModemLines.class.getResourceAsStream(SOURCE)) {
            Files.copy(source, lines.folder.resolve(SOURCE));
            lines.run(compiler);
            done = true;
        } finally {
            if (!done) {
                lines.close();
            }
        }
        return lines;
    }

    private void run(String compiler) throws IOException, InterruptedException {
        Process process;
        try {
            process = new ProcessBuilder(compiler, "-shared", "-fPIC", "-O1", "-o", library.toString(),
                folder.resolve(SOURCE).toString(), "-ldl").redirectErrorStream(true).start();
        } catch (IOException e) {
            throw new IOException("there is no C compiler (" + compiler + "), which modem-lines needs. On Debian "
                + "and Ubuntu: sudo apt-get install gcc libc6-dev. "
                + "Programs that take addresses can use sear.exportRfc2217 and rfc2217://localhost:PORT instead", e);
        }
        process.getOutputStream().close();
        String said = new String(process.getInputStream().readAllBytes(), Charset.defaultCharset()).trim();
        if (process.waitFor() != 0) {
            throw new IOException("the C compiler (" + compiler + ") could not compile modem-lines; on Debian and "
                + "Ubuntu it needs libc6-dev. Its output: " + said);
        }
    }

    /** Returns the library for LD_PRELOAD. */
    Path getLibrary() {
        return library;
    }

    @Override
    public void close() throws IOException {
        Files.deleteIfExists(folder.resolve(SOURCE));
        Files.deleteIfExists(library);
        Files.delete(folder);
    }
}
