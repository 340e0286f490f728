// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.SEAR.Needs;
import org.SEAR.Slow;
import org.SEAR.terrain.format.AsciiGridTest;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** Coordinate systems of the EPSG register, chosen at random, compared with PROJ. */
@Category(Slow.class)
@Needs("pyproj")
public class ProjTest {
    private static final int SYSTEMS = Boolean.getBoolean("sear.full") ? 2000 : 300;
    private static final long SEED = Long.getLong("sear.fuzzSeed", 1);

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @Test
    public void placesAreWithinTwoMetresOrTheSystemIsRefused() throws IOException, InterruptedException {
        Path places = folder.getRoot().toPath().resolve("places");
        File log = folder.newFile("log");
        Path script = Paths.get(System.getProperty("sear.root", "."), "src/test/pyproj/write_places.py");
        Process python = new ProcessBuilder("python3", script.toString(),
            System.getProperty("sear.pyproj", "build/pyproj"), places.toString(),
            Integer.toString(SYSTEMS), Long.toString(SEED)).redirectErrorStream(true).redirectOutput(log).start();
        assertTrue("PROJ takes long", python.waitFor(10, TimeUnit.MINUTES));
        assertEquals(Files.readString(log.toPath(), StandardCharsets.UTF_8), 0, python.exitValue());
        Set<String> all = new HashSet<>();
        Set<String> refused = new HashSet<>();
        List<String> wrong = new ArrayList<>();
        for (String line : Files.readAllLines(places)) {
            all.add(line.split(" ")[0]);
            String[] parts = line.split("\t");
            try {
                double error = MapSystemTest.error(parts[0]);
                if (!(error < 2)) {
                    wrong.add("EPSG:" + line + " is off by " + error + " m");
                }
                error = parts.length == 1 ? 0 : MapSystemTest.error(AsciiGridTest.prj(parts[1]), parts[0]);
                if (!(error < 2)) {
                    wrong.add(line + " is off by " + error + " m by its name");
                }
            } catch (IOException e) {
                refused.add(line.split(" ")[0]);
                if (!e.getMessage().contains("gdalwarp -t_srs EPSG:4326")) {
                    wrong.add(e.getMessage());
                }
            }
        }
        assertEquals("seed " + SEED, SYSTEMS, all.size());
        assertEquals("seed " + SEED + "\n" + String.join("\n", wrong), 0, wrong.size());
        assertTrue("seed " + SEED + " refused " + refused.size(), refused.size() < 0.3 * SYSTEMS);
    }
}
