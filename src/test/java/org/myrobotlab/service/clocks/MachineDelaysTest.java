// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.clocks;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.SEAR.Slow;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;

/** In lock-step random delays of the computer between calls, and within callbacks, change no byte. */
@Category(Slow.class)
public class MachineDelaysTest {
    private static final String SCRIPT = String.join("\n",
        "import random, time",
        "delays = random.Random(seed)",
        "def wait():",
        "    if seed:",
        "        time.sleep(delays.choice((0, 0, 0.001, 0.01, 0.1)))",
        "sear = Runtime.start('sear', 'SEAR')",
        "sear.startSimulation()",
        "sear.recordRun(record)",
        "seen = []",
        "def onReading(reading):",
        "    wait()",
        "    seen.append('%s %.4f %s' % (reading.name, reading.time, reading.value))",
        "def onScan(data):",
        "    wait()",
        "    seen.append(str(sum(data)))",
        "    for b in (142, 0): line.write(b)",
        "sear.addListener('publishReading', python.getName(), 'onReading')",
        "line = Runtime.start('delayedLine', 'Serial')",
        "line.connect('" + TestWorld.ROOMBA_PORT + "', 57600, 8, 1, 0)",
        "lidar = Runtime.start('delayedLidar', 'LIDAR')",
        "lidar.connect('" + TestWorld.LIDAR_PORT + "', 38400)",
        "lidar.addListener('publishLidarData', python.getName(), 'onScan')",
        "sear.startPublishing('ping', 7)",
        "sear.startPublishing('gyro', 25)",
        "wait()",
        "for b in (128, 131, 137, 0, 200, 128, 0): line.write(b)",
        "wait()",
        "sear.hold('roomba', [0.1, 0.3, 0.2])",
        "time.sleep(1.7 if seed else 0)", // longer than a drag spring's timeout
        "for i in range(12):",
        "    wait()",
        "    if i % 4 == 0: lidar.singleScan()",
        "    wait()",
        "    if i == 9: sear.hold('roomba', [0, 0.2, 0])",
        "    wait()",
        "    sear.simSleep(0.21)",
        "    wait()",
        "    seen.append(str(list(sear.getPose('roomba'))))",
        "sear.endRecord()",
        "sear.stopSimulation()",
        "result = '\\n'.join(seen)");

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private Python python;

    @Before
    public void start() {
        TestWorld.build(temporary.getRoot().toPath());
        python = (Python) Runtime.start("python", "Python");
    }

    /** @param seed of the delays; 0 for none */
    private String run(int seed, Path record) throws Exception {
        Path script = temporary.newFile("delays" + seed + ".py").toPath();
        Files.write(script, ("seed = " + seed + "\nrecord = '" + record + "'\n" + SCRIPT)
            .getBytes(StandardCharsets.UTF_8));
        assertTrue(python.execFile(script.toString()));
        for (String name : new String[] {"delayedLidar", "delayedLine", "sear"}) {
            Runtime.releaseService(name);
        }
        return String.valueOf(python.get("result"));
    }

    @Test
    public void theSameReadingsAndTheSameRecord() throws Exception {
        Path record = temporary.getRoot().toPath().resolve("run0.searlog");
        String seen = run(0, record);
        assertTrue(seen, seen.split("\n").length > 60);
        for (int seed = 1; seed <= 2; seed++) {
            Path other = temporary.getRoot().toPath().resolve("run" + seed + ".searlog");
            assertEquals("delays of seed " + seed, seen, run(seed, other));
            assertArrayEquals("record with delays of seed " + seed, Files.readAllBytes(record),
                Files.readAllBytes(other));
        }
    }
}
