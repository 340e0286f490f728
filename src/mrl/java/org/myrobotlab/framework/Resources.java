// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;

/** Resource and data folders of services, below the working folder. */
final class Resources {
    private static final String ROOT = "resource";
    private static final String DATA = "data";

    private Resources() {
    }

    static String root() {
        return ROOT;
    }

    static String data() {
        return DATA;
    }

    static String of(String typeName, String file) {
        Path folder = Paths.get(ROOT, typeName);
        return (file == null ? folder : folder.resolve(file)).toString();
    }

    /** Returns a file's bytes; null if there is no such file. */
    static byte[] read(String typeName, String file) {
        Path path = Paths.get(of(typeName, file));
        if (!Files.isRegularFile(path)) {
            return null;
        }
        try {
            return Files.readAllBytes(path);
        } catch (IOException e) {
            throw new UncheckedIOException(path + " can't be read: " + e.getMessage(), e);
        }
    }
}
