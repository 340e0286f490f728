// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.myrobotlab.service.Runtime;

/**
 * Example scripts that drive a robot, from {@code examples/drive} in the working folder and from the jar. Any thread.
 */
public final class ExampleScripts {
    private static final String PYTHON = "python";
    private static final String FOLDER = "drive/";
    private static final Path ON_DISK = Paths.get("examples", "drive");
    private static final String IN_JAR = "/resource/SEAR/";

    private ExampleScripts() {
    }

    /** Returns their names, such as {@code maze_solver.py}, sorted. */
    public static List<String> names() throws IOException {
        TreeSet<String> names = new TreeSet<>();
        if (Files.isDirectory(ON_DISK)) {
            try (DirectoryStream<Path> scripts = Files.newDirectoryStream(ON_DISK, "*.py")) {
                scripts.forEach(script -> names.add(script.getFileName().toString()));
            }
        }
        ExampleBundles.list().stream().filter(name -> name.startsWith(FOLDER))
            .forEach(name -> names.add(name.substring(FOLDER.length())));
        return new ArrayList<>(names);
    }

    /**
     * Returns the text of a script.
     *
     * @throws IllegalArgumentException with the available names
     */
    public static String text(String name) throws IOException {
        if (!names().contains(name)) {
            throw new IllegalArgumentException("there is no example script \"" + name
                + "\"; example scripts: " + names());
        }
        if (Files.isRegularFile(ON_DISK.resolve(name))) {
            return Files.readString(ON_DISK.resolve(name));
        }
        try (InputStream in = ExampleScripts.class.getResourceAsStream(IN_JAR + FOLDER + name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /**
     * Returns the name of the service that runs scripts for tabs.
     *
     * @throws IllegalStateException if there is no such service
     */
    public static String runner() {
        if (Runtime.getService(PYTHON) == null) {
            throw new IllegalStateException(
                "no service named " + PYTHON + " runs scripts: call Runtime.start(\"" + PYTHON + "\", \"Python\")");
        }
        return PYTHON;
    }
}
