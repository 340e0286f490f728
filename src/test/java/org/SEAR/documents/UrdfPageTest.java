// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.SEAR.Slow;
import org.SEAR.cli.ScriptProcess;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** Runs the script of docs/urdf.md with the example's arm. */
@Category(Slow.class)
public class UrdfPageTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", "."));

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @Test
    public void theScriptOfThePageRuns() throws Exception {
        Path here = folder.getRoot().toPath();
        Files.copy(ROOT.resolve("examples/arm.urdf"), here.resolve("arm.urdf"));
        Path script = here.resolve("page.py");
        Files.writeString(script, "sear = Runtime.start('sear', 'SEAR')\n" + String.join("\n",
            DocBlock.of("docs/urdf.md", "python")));
        String output = ScriptProcess.run(here, script);
        assertTrue(output, output.contains("lift at 4") && output.contains("grip_right at 0.03"));
    }
}
