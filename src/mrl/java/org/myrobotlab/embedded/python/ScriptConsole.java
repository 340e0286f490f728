// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import org.python.core.PyObject;
import org.python.core.PyUnicode;

/**
 * sys.stdout and sys.stderr of scripts. Unlike Jython's own files, it takes output of several threads, because
 * callbacks print while the script does. Bytes pass unchanged, Unicode as UTF-8. Its public members are those that
 * Python expects of a file.
 */
public final class ScriptConsole {
    /** State of Python's print: whether a space is due. */
    public volatile int softspace;
    public final String encoding = "UTF-8";

    private final OutputStream stream;

    /** @param stream must take writes from any thread */
    ScriptConsole(OutputStream stream) {
        this.stream = stream;
    }

    public void write(PyObject text) {
        String characters = text.toString();
        try {
            stream.write(characters.getBytes(text instanceof PyUnicode ? StandardCharsets.UTF_8
                : StandardCharsets.ISO_8859_1));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public void writelines(PyObject lines) {
        lines.asIterable().forEach(this::write);
    }

    public void flush() {
        try {
            stream.flush();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public boolean isatty() {
        return false;
    }
}
