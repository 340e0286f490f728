// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.Bytes;
import org.SEAR.Digests;
import org.SEAR.devices.SerialLine;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.bundle.Bundle;
import org.junit.Rule;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.junit.runners.Parameterized;

/** Each example project with the same drive and queries: every port and sensor produces the listed checksums. */
@RunWith(Parameterized.class)
public class ProjectDigestsTest {
    private static final Path EXAMPLES = Path.of(System.getProperty("sear.root", "."), "examples");
    /** Five seconds. */
    private static final int STEPS = 300;
    private static final int ASKED = 10;
    private static final int TURNED = 150;
    /** Steps between two readings of all sensors. */
    private static final int LOOK = 20;
    /** Open Interface: start, safe, stream bumps, distance and angle. */
    private static final byte[] STREAM = Bytes.bytes("80 83 94 03 07 13 14");
    /** Requests scans from any scanner: LMS200, CoLa, SCIP, RPLIDAR. */
    private static final List<byte[]> SCANS = List.of(Bytes.bytes("02 00 02 00 20 24 34 08"),
        ascii("\2sEN LMDscandata 1\3"), ascii("BM\nMS0044072501000\n"), Bytes.bytes("A5 20"));

    @Rule
    public final ProjectRule project = new ProjectRule();
    @Parameterized.Parameter
    public String name;

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    @Parameterized.Parameters(name = "{0}")
    public static Collection<String> bundles() throws IOException {
        try (Stream<Path> files = Files.list(EXAMPLES)) {
            return files.map(file -> file.getFileName().toString()).filter(file -> file.endsWith(".sear")).sorted()
                .collect(Collectors.toList());
        }
    }

    private static void ask(SerialLine line) {
        if (line.getObjectType().equals("Dynamics")) {
            line.write(STREAM);
        } else if (line.getObjectType().equals("LIDAR")) {
            SCANS.forEach(line::write);
        }
    }

    /** Drives and queries an example with a seed. */
    private static String run(Project example, long seed) throws Exception {
        MessageDigest all = Digests.sha256();
        try (Simulation simulation = Simulation.of(example, seed)) {
            List<MessageDigest> lines = new ArrayList<>();
            for (SerialLine line : simulation.getLines()) {
                MessageDigest digest = Digests.sha256();
                lines.add(digest);
                line.setSink((bytes, starts) -> digest.update(bytes));
            }
            for (int step = 0; step < STEPS; step++) {
                if (step == ASKED) {
                    simulation.getLines().forEach(ProjectDigestsTest::ask);
                    simulation.post(world -> world.getRobots()
                        .forEach(robot -> robot.drive(0.3, Double.POSITIVE_INFINITY)));
                } else if (step == TURNED) {
                    simulation.post(world -> world.getRobots().forEach(robot -> robot.drive(-0.2, 1)));
                }
                simulation.step();
                if (step % LOOK == 0) {
                    simulation.read(simulation.getSensorNames()).forEach(reading -> Digests.put(all, reading));
                    simulation.snapshot().robots.forEach(robot -> all.update(ascii(robot.pose.toString())));
                }
            }
            lines.forEach(line -> all.update(line.digest()));
        }
        return Digests.hex(all);
    }

    @Test
    public void bytesAndReadingsAreThoseOfTheList() throws Exception {
        Project example = Bundle.load(EXAMPLES.resolve(name), project.folder());
        String first = run(example, 1);
        assertEquals("the same again", first, run(example, 1));
        Digests.assertSame(name, first + "/" + run(example, 2));
    }
}
