// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.stream.Stream;
import org.junit.rules.TemporaryFolder;

/** A folder for a project of services, which run without a window at full speed; a test's services end with it. */
public final class ServiceFolder extends TemporaryFolder {
    @Override
    protected void before() throws Throwable {
        super.before();
        System.setProperty("sear.headless", "true");
        System.setProperty("sear.speed", "max");
        System.setProperty("sear.project", getRoot().toPath().resolve("SEARproject").toString());
    }

    @Override
    protected void after() {
        Runtime.releaseAll(false, true);
        System.clearProperty("sear.project");
        System.clearProperty("sear.speed");
        super.after();
    }

    /** Releases all services and deletes a configuration that the test may have stored. */
    public static void forgetConfig(String set) throws IOException {
        Runtime.releaseAll(false, true);
        Runtime.setConfig("default");
        Path folder = Paths.get(Runtime.ROOT_CONFIG_DIR, set);
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path file : (Iterable<Path>) files::iterator) {
                    Files.delete(file);
                }
            }
            Files.delete(folder);
        }
    }
}
