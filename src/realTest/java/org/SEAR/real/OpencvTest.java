// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.Test;

/**
 * A Python 3 program reads a camera with OpenCV, as exported by SEAR in MyRobotLab, and drives the robot through the
 * web server.
 */
public class OpencvTest extends InRealMrl {
    private static final int PATIENCE_SECONDS = 900;
    /** Docked position in examples/dock.py: the dock's front minus half the robot's length, metres. */
    private static final double DOCKED = 2.997 - 0.17;

    @Test
    public void theRobotDocks() throws Exception {
        Path output = Files.createTempFile(mrl.folder(), "docking", ".txt");
        ProcessBuilder builder = new ProcessBuilder(
            List.of("python3", "-u", ROOT.resolve("examples/python3/docking.py").toString(), "--fast",
            "--server", "http://localhost:" + mrl.port()));
        builder.environment().put("PYTHONPATH", System.getProperty("sear.opencv"));
        Process program = builder.redirectErrorStream(true).redirectOutput(output.toFile()).start();
        boolean ended = program.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        program.destroyForcibly();
        String text = Files.readString(output);
        assertTrue("it has not ended: " + text, ended);
        assertEquals(text, 0, program.exitValue());
        assertTrue(text, text.contains("\nDocked: "));
        double gap = DOCKED - Double.parseDouble(mrl.python("print sear.getPose('docker')[0]"));
        assertEquals(text, 0.04, gap, 0.02);
        assertEquals("", mrl.python("sear.stopExportCamera('eye')"));
    }
}
