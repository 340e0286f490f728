// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.Test;

/**
 * In lock-step the callbacks of six services always come in the same order. Each run in one session of the real
 * MyRobotLab ends with the log and the poses of the embedded one. {@code -Dsear.orderRuns=200} sets the number of runs.
 */
public class OneOrderTest extends InRealMrl {
    private static final int RUNS = Integer.getInteger("sear.orderRuns", 5);
    private static final Path SCRIPT =
        ROOT.resolve("src/test/resources/org/myrobotlab/service/clocks/four_services.py");

    @Test
    public void eachRunEndsWithTheLogOfTheEmbeddedMyRobotLab() throws Exception {
        String text = Files.readString(SCRIPT) + "print result\n";
        Path folder = Files.createDirectories(RealMrlCopy.BUILD.resolve("embedded").resolve("order"));
        Path script = Files.writeString(folder.resolve("order.py"), text);
        String expected = RealMrlCopy.sear(folder, script.toString(), "--headless", "--speed", "max", "--port", "none");
        for (String kind : new String[] {"scan of first", "scan of second", "fix", "uno", "eye", "script"}) {
            assertTrue(kind + " in " + expected, expected.split(kind, -1).length > 20);
        }
        for (int i = 0; i < RUNS; i++) {
            assertEquals("run " + (i + 1), expected, mrl.run(script));
        }
    }
}
