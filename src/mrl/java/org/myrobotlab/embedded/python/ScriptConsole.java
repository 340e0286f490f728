package org.myrobotlab.embedded.python;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import org.python.core.PyObject;
import org.python.core.PyUnicode;

/**
 * sys.stdout and sys.stderr of scripts. Jython's own files must not be written to by two threads at the same time; this may, for callbacks print
 * while the script does. Bytes go out as they are, Unicode as UTF-8. Its public members are what Python expects of a file.
 */
public final class ScriptConsole {
    /** Python's print keeps here whether a blank is due. */
    public volatile int softspace;
    public final String encoding = "UTF-8";

    private final OutputStream stream;

    /** @param stream may be written to by any thread */
    ScriptConsole(OutputStream stream) {
        this.stream = stream;
    }

    public void write(PyObject text) {
        String characters = text.toString();
        try {
            stream.write(characters.getBytes(text instanceof PyUnicode ? StandardCharsets.UTF_8 : StandardCharsets.ISO_8859_1));
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
