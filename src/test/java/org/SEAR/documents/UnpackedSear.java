// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.spi.ToolProvider;

/** SEAR as its unpacked zip, made from the compiled classes. */
public final class UnpackedSear {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();

    private UnpackedSear() {
    }

    /**
     * Lays SEAR out in a folder, which may exist: {@code bin/sear} and the jars, with the libraries as links.
     * @throws AssertionError if a jar can't be made
     */
    public static void at(Path sear) throws IOException {
        Files.createDirectories(sear.resolve("bin"));
        Files.createDirectories(sear.resolve("lib"));
        Path plugin = Files.createDirectories(sear.resolve("plugin"));
        Path launcher = Files.copy(ROOT.resolve("src/dist/bin/sear"), sear.resolve("bin/sear"));
        boolean done = launcher.toFile().setExecutable(true);
        ToolProvider jar = ToolProvider.findFirst("jar").orElseThrow();
        int number = 0;
        for (String entry : System.getProperty("sear.cliClasspath").split(File.pathSeparator)) {
            Path path = Path.of(entry);
            if (Files.isDirectory(path)) {
                Path target = sear.resolve(entry.contains("/main") ? "plugin" : "lib")
                    .resolve("sear-" + number++ + ".jar");
                done &= jar.run(System.out, System.err, "--create", "--no-compress", "--file", target.toString(), "-C",
                    path.toString(), ".") == 0;
            } else if (Files.isRegularFile(path)) {
                Files.createSymbolicLink(plugin.resolve(path.getFileName()), path);
            }
        }
        if (!done) {
            throw new AssertionError("SEAR could not be laid out in " + sear);
        }
    }
}
