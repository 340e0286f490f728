// SPDX-License-Identifier: Apache-2.0
package org.example;

import java.io.File;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * The sensors of this package as another jar would bring them: a folder with the compiled classes and their registry
 * line.
 */
public final class OtherJar {
    private OtherJar() {
    }

    /**
     * Writes the folder.
     * @param folder new or empty
     * @param types names of classes of this package, such as {@code ThermometerSensor$Type}
     */
    public static void at(Path folder, String... types) throws IOException {
        Path registry = Files.createDirectories(folder.resolve("META-INF/services"))
            .resolve("org.SEAR.sensors.SensorType");
        StringBuilder lines = new StringBuilder();
        for (String type : types) {
            lines.append("org.example.").append(type).append('\n');
        }
        Files.write(registry, lines.toString().getBytes(StandardCharsets.UTF_8));
        Path classes = Files.createDirectories(folder.resolve("org/example"));
        for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
            if (Files.isDirectory(Path.of(entry).resolve("org/example"))) {
                copy(Path.of(entry).resolve("org/example"), classes);
            }
        }
    }

    private static void copy(Path from, Path to) throws IOException {
        try (Stream<Path> files = Files.list(from)) {
            for (Path file : (Iterable<Path>) files::iterator) {
                Files.copy(file, to.resolve(file.getFileName().toString()));
            }
        }
    }

    /** Returns a class loader that prefers the classes of the folder to those of the tests. */
    public static URLClassLoader loader(Path folder) throws IOException {
        return new URLClassLoader(new URL[] {folder.toUri().toURL()}, OtherJar.class.getClassLoader()) {
            @Override
            protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
                if (!name.startsWith("org.example.")) {
                    return super.loadClass(name, resolve);
                }
                Class<?> own = findLoadedClass(name);
                return own != null ? own : findClass(name);
            }
        };
    }
}
