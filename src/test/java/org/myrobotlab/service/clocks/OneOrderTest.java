// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.clocks;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.SEAR.HowMany;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;

/**
 * In lock-step the callbacks of several services always come in the same order, with the same effect on robots.
 * {@code -Dsear.orderRuns=200} sets the number of runs of a script.
 */
@Category(Slow.class)
public class OneOrderTest {
    private static final int RUNS = HowMany.of("sear.orderRuns", 25);

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private Python python;

    @Before
    public void start() {
        System.setProperty("sear.headless", "true");
        System.setProperty("sear.project", temporary.getRoot().toPath().resolve("SEARproject").toString());
        python = (Python) Runtime.start("python", "Python");
    }

    @After
    public void release() {
        for (String name : new String[] {"firstScanner", "secondScanner", "receiver", "board", "firstWheels",
            "secondWheels", "sear", "python"}) {
            Runtime.releaseService(name);
        }
        System.clearProperty("sear.project");
    }

    private String run(Path script) throws Exception {
        boolean ran = python.execFile(script.toString());
        assertTrue(String.valueOf(python.getLastError()), ran);
        return String.valueOf(python.get("result"));
    }

    private Path script(String name) throws Exception {
        Path file = temporary.getRoot().toPath().resolve(name);
        try (InputStream in = OneOrderTest.class.getResourceAsStream(name)) {
            Files.write(file, in.readAllBytes());
        }
        return file;
    }

    @Test
    public void twoRobotsWithScannersReceiverAndArduinoGiveTheSameLogEachTime() throws Exception {
        Path script = script("four_services.py");
        String first = run(script);
        for (String kind : new String[] {"scan of first", "scan of second", "fix", "uno", "eye", "script"}) {
            assertTrue(kind + " in " + first, first.split(kind, -1).length > 20);
        }
        for (int i = 1; i < RUNS; i++) {
            assertEquals("run " + (i + 1), first, run(script));
        }
    }
}
