// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.serial;

import java.io.FileNotFoundException;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.function.Consumer;

/** Writes bytes to a file while it is open. Any thread. */
public final class ByteRecord {
    private final Consumer<String> complaint;
    private OutputStream file;

    /** @param complaint gets a message when the file can't be written */
    public ByteRecord(Consumer<String> complaint) {
        this.complaint = complaint;
    }

    public synchronized void open(String name) throws FileNotFoundException {
        file = new FileOutputStream(name);
    }

    public synchronized boolean isOpen() {
        return file != null;
    }

    public synchronized void write(byte[] bytes) {
        if (file != null) {
            try {
                file.write(bytes);
            } catch (IOException e) {
                complaint.accept("recording stopped: " + e.getMessage());
                close();
            }
        }
    }

    public synchronized void close() {
        if (file != null) {
            try {
                file.close();
            } catch (IOException e) {
                complaint.accept("the recording may be incomplete: " + e.getMessage());
            }
            file = null;
        }
    }
}
