// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A copy of the user's MyRobotLab in a folder of the build: jar and libraries, as before the first start and without
 * SEAR.
 */
final class RealMrlCopy {
    /** Folder of copies, logs and pictures. */
    static final Path BUILD = Path.of(System.getProperty("sear.realMrl"));
    private static final Path ORIGINAL = Path.of(System.getProperty("sear.myRobotLab"));
    static final Path SEAR = Path.of(System.getProperty("sear.home"), "bin", "sear");
    private static final int PATIENCE_SECONDS = 300;

    private final Path folder;

    /** @param name of the folder in {@link #BUILD}, whose previous content is deleted */
    RealMrlCopy(String name) throws IOException, InterruptedException {
        folder = BUILD.resolve(name);
        delete(folder);
        Files.createDirectories(folder);
        Files.copy(ORIGINAL.resolve("myrobotlab.jar"), folder.resolve("myrobotlab.jar"));
        copy(ORIGINAL.resolve("libraries"), folder.resolve("libraries"));
        if (Files.exists(folder.resolve("libraries/sear-install.json"))) {
            install("--remove");
        }
    }

    /** Runs SEAR's own installer on this copy. */
    void install(String... options) throws IOException, InterruptedException {
        install(SEAR, folder, options);
    }

    /** Runs the installer of a distribution on a folder. */
    static void install(Path sear, Path folder, String... options) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(sear.toString(), "install"));
        command.addAll(Arrays.asList(options));
        command.add(folder.toString());
        output(BUILD, command);
    }

    static void copy(Path from, Path to) throws IOException {
        for (Path path : tree(from)) {
            Files.copy(path, to.resolve(from.relativize(path).toString()), StandardCopyOption.COPY_ATTRIBUTES);
        }
    }

    /** Returns a folder and everything below it, parents first. */
    static List<Path> tree(Path folder) throws IOException {
        try (Stream<Path> paths = Files.walk(folder)) {
            return paths.sorted().collect(Collectors.toList());
        }
    }

    static void delete(Path folder) throws IOException {
        if (Files.exists(folder)) {
            List<Path> paths = new ArrayList<>(tree(folder));
            paths.sort(Comparator.reverseOrder());
            for (Path path : paths) {
                Files.delete(path);
            }
        }
    }

    Path folder() {
        return folder;
    }

    /**
     * Runs SEAR's own program, for example {@code sear install}, and expects status 0.
     * @return its output
     */
    static String sear(Path folder, String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(SEAR.toString()));
        command.addAll(Arrays.asList(arguments));
        return output(folder, command);
    }

    /** @return the output of a program, which must end with status 0 */
    static String output(Path folder, List<String> command) throws IOException, InterruptedException {
        File output = File.createTempFile("output", ".txt", BUILD.toFile());
        File errors = File.createTempFile("errors", ".txt", BUILD.toFile());
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).redirectError(errors)
            .redirectOutput(output);
        builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
        Process process = builder.start();
        try {
            boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
            String text = Files.readString(output.toPath());
            assertEquals(command + "\n" + text + Files.readString(errors.toPath()), "0", ended
                ? "" + process.exitValue() : "it hangs");
            return text;
        } finally {
            process.destroyForcibly();
            Files.delete(output.toPath());
            Files.delete(errors.toPath());
        }
    }
}
