// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import org.myrobotlab.service.config.ServiceConfig;

/** Configuration files of services: {@code data/config/SET/NAME.yml} below the working folder. */
public final class Configs {
    /** Folder of all sets. */
    public static final String ROOT = Paths.get("data", "config").toString();

    private Configs() {
    }

    /**
     * Reads the configuration of a service; null without a file.
     *
     * @throws IllegalArgumentException if the file is not a valid configuration
     */
    public static ServiceConfig read(String set, String name) {
        Path file = file(set, name);
        if (!Files.isRegularFile(file)) {
            return null;
        }
        try {
            return Yaml.read(Files.readString(file, StandardCharsets.UTF_8), ServiceConfig.class);
        } catch (IOException | IllegalArgumentException e) {
            throw new IllegalArgumentException("configuration file " + file + ": " + e.getMessage()
                + "; correct or delete it", e);
        }
    }

    public static void write(String set, String name, ServiceConfig config) throws IOException {
        Path file = file(set, name);
        Files.createDirectories(file.getParent());
        Path part = file.resolveSibling(file.getFileName() + ".part");
        Files.writeString(part, Yaml.write(config), StandardCharsets.UTF_8);
        Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
    }

    private static Path file(String set, String name) {
        if (!name.equals(Paths.get(name).getFileName().toString())) {
            throw new IllegalArgumentException("service name \"" + name + "\" can't be a file name");
        }
        return Paths.get(ROOT, set, name + ".yml");
    }
}
