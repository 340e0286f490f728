// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.Collectors;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** The release zip, unpacked for a test. */
final class Distribution {
    private static final int PATIENCE = 240;
    private static int runs;

    private final Path home;

    /** @param folder where to unpack */
    Distribution(Path folder) throws IOException {
        try (ZipFile zip = new ZipFile(System.getProperty("sear.zip"))) {
            for (ZipEntry entry : Collections.list(zip.entries())) {
                Path file = folder.resolve(entry.getName());
                if (entry.isDirectory()) {
                    Files.createDirectories(file);
                } else {
                    Files.createDirectories(file.getParent());
                    try (InputStream in = zip.getInputStream(entry)) {
                        Files.copy(in, file);
                    }
                }
            }
            home = folder.resolve(zip.stream().findFirst().orElseThrow().getName().replaceAll("/.*", ""));
        }
        assertTrue(home.resolve("bin/sear").toFile().setExecutable(true, false));
    }

    Path home() {
        return home;
    }

    Path launcher() {
        return home.resolve("bin/sear");
    }

    static final class Result {
        final int status;
        final String out;
        final String err;

        Result(int status, String out, String err) {
            this.status = status;
            this.out = out;
            this.err = err;
        }

        @Override
        public String toString() {
            return "status " + status + "\n" + out + err;
        }
    }

    /** Runs a command with this JVM's Java. */
    static Result run(Path folder, Path logs, List<String> command) throws IOException, InterruptedException {
        return run(folder, logs, command, PATIENCE);
    }

    static Result run(Path folder, Path logs, List<String> command, int seconds)
        throws IOException, InterruptedException {
        File out = logs.resolve("out" + ++runs + ".txt").toFile();
        File err = logs.resolve("err" + runs + ".txt").toFile();
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).redirectOutput(out)
            .redirectError(err);
        builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
        Process process = builder.start();
        try {
            assertTrue(command + " hangs", process.waitFor(seconds, TimeUnit.SECONDS));
        } finally {
            process.destroyForcibly();
        }
        return new Result(process.exitValue(), Files.readString(out.toPath()), Files.readString(err.toPath()));
    }

    /** Returns all jars of a folder of the distribution. */
    Path[] jars(String folder) throws IOException {
        try (java.util.stream.Stream<Path> files = Files.list(home.resolve(folder))) {
            return files.filter(file -> file.toString().endsWith(".jar")).sorted().toArray(Path[]::new);
        }
    }

    /**
     * Makes a folder look like a MyRobotLab, with the embedded one. MyRobotLab's jar contains its libraries; here its
     * manifest names them.
     */
    void layOut(Path mrl) throws IOException {
        Files.createDirectories(mrl.resolve("libraries/jar"));
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.CLASS_PATH, Arrays.stream(jars("lib"))
            .map(jar -> jar.toUri().toString())
            .filter(jar -> !jar.endsWith("sear-cli.jar")).collect(Collectors.joining(" ")));
        try (OutputStream out = Files.newOutputStream(mrl.resolve("myrobotlab.jar"))) {
            new JarOutputStream(out, manifest).close();
        }
    }

    static Path java() {
        return Paths.get(System.getProperty("java.home"), "bin", "java");
    }
}
