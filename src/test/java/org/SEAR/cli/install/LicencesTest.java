// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.install;

import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.Test;

/** The distribution names the licence of every library that it ships. */
public class LicencesTest {
    @Test
    public void everyLibraryIsListed() throws IOException {
        String list = Files.readString(Path.of(System.getProperty("sear.root", "."), "src/dist/LICENSES.md"));
        for (String jar : System.getProperty("sear.shipped").split(" ")) {
            String artifact = new JarName(Path.of(jar)).artifact.replaceAll("-natives-.*", "");
            assertTrue(jar + " is shipped, and src/dist/LICENSES.md does not name it",
                list.matches("(?s).*\\b" + artifact + "\\b.*"));
        }
    }
}
