// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;

/** Output of scripts: passes bytes on immediately, and complete lines to a reader. Any thread. */
public final class ConsoleStream extends OutputStream {
    private final OutputStream console;
    private final Consumer<String> lines;
    private final ByteArrayOutputStream line = new ByteArrayOutputStream();

    /**
     * @param console gets each byte
     * @param lines gets each line with its line end
     */
    public ConsoleStream(OutputStream console, Consumer<String> lines) {
        this.console = console;
        this.lines = lines;
    }

    @Override
    public void write(int value) throws IOException {
        write(new byte[] {(byte) value}, 0, 1);
    }

    @Override
    public synchronized void write(byte[] bytes, int offset, int length) throws IOException {
        console.write(bytes, offset, length);
        console.flush();
        for (int i = offset; i < offset + length; i++) {
            line.write(bytes[i]);
            if (bytes[i] == '\n') {
                lines.accept(line.toString(StandardCharsets.UTF_8));
                line.reset();
            }
        }
    }

    @Override
    public void flush() throws IOException {
        console.flush();
    }
}
