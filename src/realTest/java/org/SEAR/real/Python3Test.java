// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.Test;

/**
 * A Python 3 program connects to SEAR in MyRobotLab: calls, readings, errors and callbacks, twice with the same
 * numbers.
 */
public class Python3Test extends InRealMrl {
    private static final int PATIENCE_SECONDS = 300;

    @Test
    public void aPython3ProgramHasTheCallsOfScripts() throws Exception {
        String port = mrl.python("print Runtime.start('sear', 'SEAR').startPython3(0)").trim();
        String first = run(port);
        assertTrue(first, first.endsWith("False\n"));
        assertEquals(first, run(port));
        assertEquals("", mrl.python("Runtime.getService('sear').stopPython3()"));
    }

    private String run(String port) throws Exception {
        Path output = Files.createTempFile(mrl.folder(), "python3", ".txt");
        ProcessBuilder builder = new ProcessBuilder(
            List.of("python3", "-m", "sear", ROOT.resolve("src/test/python3/calls.py").toString()));
        builder.environment().put("PYTHONPATH", ROOT.resolve("python/src") + File.pathSeparator
            + System.getProperty("sear.python3"));
        builder.environment().put("SEAR_GATEWAY", port);
        Process program = builder.redirectErrorStream(true).redirectOutput(output.toFile()).start();
        boolean ended = program.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        program.destroyForcibly();
        String text = Files.readString(output);
        assertTrue("it has not ended: " + text, ended);
        assertEquals(text, 0, program.exitValue());
        assertEquals("", mrl.python("Runtime.release('robots')"));
        return text;
    }
}
