// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ports;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Arduino;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** A compiled sketch drives the rover of examples/avoider.py. */
public class SketchDriveTest {
    private static final Path EXAMPLE = Paths.get(System.getProperty("sear.root", "."), "examples/avoider.sear");

    @Rule
    public final ProjectRule project = new ProjectRule();

    private final ByteArrayOutputStream heard = new ByteArrayOutputStream();

    private Simulation start() throws Exception {
        heard.reset();
        Simulation simulation = Simulation.load(project.folder(), 1);
        SerialLine line = simulation.getLines().get(0);
        line.setSink((bytes, starts) -> heard.write(bytes, 0, bytes.length));
        return simulation;
    }

    private String text() {
        return new String(heard.toByteArray(), StandardCharsets.US_ASCII);
    }

    @Test
    public void theRoverAvoidsWallsAndCrates() throws Exception {
        Bundle.load(EXAMPLE, project.folder());
        try (Simulation simulation = start()) {
            double path = 0;
            Pose last = simulation.getPose("rover");
            for (int i = 0; i < 60; i++) {
                Worlds.run(simulation, 0.5);
                Pose now = simulation.getPose("rover");
                path += Math.hypot(now.x - last.x, now.z - last.z);
                last = now;
            }
            String[] lines = text().split("\r\n");
            assertEquals("avoider", lines[0]);
            assertTrue(text(), lines.length > 5);
            for (int i = 1; i < lines.length - 1; i++) {
                assertTrue(lines[i], lines[i].matches("\\d+ cm ahead, left \\d+, right \\d+"));
            }
            assertTrue("drove " + path + " m: " + text(), path > 2);
            assertEquals("Uno, avoider.hex: running, 9615 baud",
                simulation.snapshot().robots.get(0).devices.get(0).status);
            assertTrue(simulation.snapshot().warnings.toString(),
                simulation.snapshot().warnings.stream().noneMatch(each -> each.contains("uno")));
        }
    }

    @Test
    public void twoRunsAreEqualAndOtherRatesGiveGarbage() throws Exception {
        Bundle.load(EXAMPLE, project.folder());
        List<String> runs = new ArrayList<>();
        for (int baud : new int[] {9600, 9600, 9984, 19200}) {
            try (Simulation simulation = start()) {
                simulation.getLines().get(0).setHostBaud(baud);
                Worlds.run(simulation, 4);
                runs.add(text() + simulation.getPose("rover"));
            }
        }
        assertEquals(runs.get(0), runs.get(1));
        assertEquals("3.8 % fit", runs.get(0), runs.get(2));
        assertTrue(runs.get(0).startsWith("avoider\r\n"));
        assertTrue(!runs.get(3).startsWith("avoider"));
    }

    @Test
    public void aProgramAtAnotherRateIsWarnedOf() throws Exception {
        Bundle.load(EXAMPLE, project.folder());
        try (Simulation simulation = start()) {
            SerialLine line = simulation.getLines().get(0);
            line.open();
            line.setHostBaud(115200);
            Worlds.run(simulation, 1.5);
            line.write(new byte[20]);
            Worlds.run(simulation, 0.5);
            String warnings = simulation.snapshot().warnings.toString();
            assertTrue(warnings, warnings.contains("bytes came at 115200 baud, but an Arduino Uno, avoider.hex is at "
                + "9615 baud now"));
        }
    }

    /** A reset erases nothing of the sketch; another reset gives the same bytes. */
    @Test
    public void aResetStartsTheSketchAgain() throws Exception {
        Bundle.load(EXAMPLE, project.folder());
        try (Simulation simulation = start()) {
            Worlds.run(simulation, 3);
            String first = text();
            Pose pose = simulation.getPose("rover");
            heard.reset();
            simulation.reset();
            Worlds.run(simulation, 3);
            assertEquals(first, text());
            assertEquals(pose.z, simulation.getPose("rover").z, 1e-6);
        }
    }

    @Test
    public void brokenFilesAreRefusedWithTheirLine() throws Exception {
        Bundle.load(EXAMPLE, project.folder());
        byte[] good = Files.readAllBytes(Paths.get(System.getProperty("sear.root", "."),
            "resources/org/SEAR/assets/sketches/avoider.hex"));
        byte[] bad = good.clone();
        bad[50] = (byte) (bad[50] == '0' ? '1' : '0');
        Path own = Files.createDirectories(project.folder().resolve("assets/sketches")).resolve("avoider.hex");
        Files.write(own, bad);
        try {
            Project.read(project.folder());
            fail("a changed digit");
        } catch (ProjectException e) {
            String message = e.getProblems().get(0).toString();
            assertTrue(message, message.contains("sketch is \"sketches/avoider.hex\", legal: a sketch compiled for an "
                + "Arduino Uno (line 2 has the checksum "));
        }
        Files.write(own, good);
        assertEquals(List.of(), Project.read(project.folder()).getWarnings());
    }

    @Test
    public void onlyCompiledSketchesOfAnUnoAreAccepted() {
        String[] files = {"blink.ino", "blink.bin", "../blink.hex"};
        for (String file : files) {
            try {
                new Arduino("uno").setSketch(file);
                fail(file);
            } catch (IllegalArgumentException e) {
                assertTrue(e.getMessage(), e.getMessage().startsWith("Arduino \"uno\": sketch is \"" + file + "\""));
            }
        }
        try {
            new Arduino("mega", "mega").setSketch("blink.hex");
            fail("a Mega");
        } catch (IllegalArgumentException e) {
            assertEquals("Arduino \"mega\": sketch is \"blink.hex\", legal: none for a mega; SEAR simulates the "
                + "microcontroller of an uno", e.getMessage());
        }
    }
}
