// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.SEAR.project.bundle.Bundle;

/** The example projects. */
final class Examples {
    private Examples() {
    }

    /**
     * Unpacks an example.
     * @return its SEARproject folder
     */
    static Path folder(String name) throws Exception {
        Path folder = Files.createTempDirectory("example").resolve("SEARproject");
        Bundle.load(Paths.get(System.getProperty("sear.root", "."), "examples", name + ".sear"), folder);
        return folder;
    }
}
