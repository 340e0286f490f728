// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.Needs;
import org.SEAR.Slow;
import org.SEAR.cli.ScriptProcess;
import org.junit.After;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** A SLAM program that undoes the motion within scans follows a robot by scans of {@code setScanTime}. */
@Category(Slow.class)
@Needs("kissIcp")
public class ThirdPartySlamTest {
    private static final double MILLIMETRE = 0.001;
    /** Error after 24 m with the scans that the program assumes, metres and degrees. */
    private static final double[] MOST = {0.02, 0.2};
    /** Error with the other kind of scans. */
    private static final double[] LEAST = {0.03, 0.5};

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    private final Programs programs = new Programs(folder);

    @After
    public void stop() {
        programs.end();
    }

    @Test
    public void kissIcpNeedsTheScansThatItAssumes() throws Exception {
        Path root = folder.getRoot().toPath();
        ScriptProcess.run(root, Path.of(System.getProperty("sear.root", "."), "src/test/drivers/slam_drive.py")
            .toAbsolutePath());
        ProcessBuilder builder = WithPrograms.python("slam_drift.py", root.resolve("run.txt"));
        builder.environment().put("PYTHONPATH", System.getProperty("sear.kissIcp"));
        List<String> lines = programs.run(builder, new ArrayList<>());
        String all = String.join("; ", lines);
        assertEquals(all, 5, lines.size());
        assertTrue(all, Double.parseDouble(lines.get(0)) < MILLIMETRE);
        for (int i = 0; i < MOST.length; i++) {
            assertTrue("rolling, undone: " + all, drift(lines.get(1))[i] < MOST[i]);
            assertTrue("rolling, ignored: " + all, drift(lines.get(2))[i] > LEAST[i]);
            assertTrue("instant, undone: " + all, drift(lines.get(3))[i] > LEAST[i]);
            assertTrue("instant, ignored: " + all, drift(lines.get(4))[i] < MOST[i]);
        }
    }

    private static double[] drift(String line) {
        return Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray();
    }
}
