// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.files;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.grammar.ScriptFolder;
import org.SEAR.project.problems.ProjectException;

/**
 * The example bundles in the jar, by paths such as {@code examples/office.sear}, valid in every working folder. Any
 * thread.
 */
public final class ExampleBundles {
    private static final String FOLDER = "examples/";
    private static final String ENDING = ".sear";
    private static final String IN_JAR = "/resource/SEAR/";
    /** Names of the examples, one per line, written by the build. */
    private static final String LIST = "/org/SEAR/examples.txt";

    /** An action on a bundle's file. */
    public interface Work<T> {
        /** @throws ProjectException with every problem of the bundle */
        T on(Path bundle) throws IOException, ProjectException;
    }

    private ExampleBundles() {
    }

    /** Returns the paths of all example bundles. */
    static List<String> paths() throws IOException {
        return list().stream().filter(name -> name.endsWith(ENDING)).map(name -> FOLDER + name)
            .collect(Collectors.toList());
    }

    /** Returns the names below {@code examples} that the build put into the jar. */
    static List<String> list() throws IOException {
        try (InputStream in = ExampleBundles.class.getResourceAsStream(LIST)) {
            return in == null ? List.of() : Arrays.asList(new String(in.readAllBytes(), StandardCharsets.UTF_8)
                .split("\n"));
        }
    }

    /**
     * Returns whether a bundle is an example of SEAR.
     *
     * @param bundle the file
     * @param path requested path
     */
    static boolean isOne(Path bundle, Path path) throws IOException {
        String name = path.getFileName() == null ? "" : path.getFileName().toString();
        if (!paths().contains(FOLDER + name) || !Files.isRegularFile(bundle)) {
            return false;
        }
        try (InputStream in = ExampleBundles.class.getResourceAsStream(IN_JAR + name)) {
            return in != null && Arrays.equals(in.readAllBytes(), Files.readAllBytes(bundle));
        }
    }

    /** Returns whether a path means an example in the jar: no such file exists, but such an example does. */
    public static boolean isMeant(Path path) throws IOException {
        return !Files.exists(path) && paths().contains(name(path));
    }

    private static String name(Path path) {
        return ScriptFolder.shorten(path).toString().replace('\\', '/');
    }

    /** Runs an action on the bundle file of a path, or on the example of this path if no file exists. */
    public static <T> T with(Path path, Work<T> work) throws IOException, ProjectException {
        if (!isMeant(path)) {
            return work.on(path);
        }
        Path file = Files.createTempFile("sear", ".sear");
        try (InputStream in = ExampleBundles.class.getResourceAsStream(
            IN_JAR + name(path).substring(FOLDER.length()))) {
            Files.write(file, in.readAllBytes());
            return work.on(file);
        } finally {
            Files.deleteIfExists(file);
        }
    }
}
