// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ports;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import org.SEAR.Bytes;
import org.SEAR.Fuzz;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.Slow;
import org.SEAR.devices.SerialLine;
import org.SEAR.devices.oi.Opcode;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Queries faster than the line, and garbage: the simulation continues, queues are bounded, and a few warnings report
 * it.
 */
@Category(Slow.class)
public class FloodTest {
    private static final double FLOOD = 60;
    /** The longest reply, besides 4096 waiting bytes: a scan telegram, a Create's group 6, an NMEA sentence. */
    private static final int LONGEST = 1024;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Simulation world() throws Exception {
        new Floor("floor", 50, 50);
        SEARrobot robot = Worlds.roomba("roomba", 0, 0, 0);
        robot.getComponents().stream().filter(part -> part instanceof Dynamics)
            .forEach(part -> ((Dynamics) part).setPorts("oiUart", "oiUser"));
        LIDAR lidar = new LIDAR("lidar", 8, 180, 0.5, 0, 0.1, 0.1);
        lidar.setPorts("lidarUart", "lidarUser");
        robot.addComponent(lidar);
        GPS gps = new GPS("gps", 33.6, 180, -80.8);
        gps.setPorts("gpsUart", "gpsUser");
        gps.setBaud(4800);
        robot.addComponent(gps);
        return Worlds.start(project);
    }

    private static byte[] query(SerialLine line) {
        switch (line.getObjectType()) {
            case "LIDAR":
                return Bytes.bytes("02 00 01 00 31 15 12");
            case "GPS":
                return "$PMTK605*31\r\n".getBytes(StandardCharsets.US_ASCII);
            default:
                return Bytes.bytes("8E 06");
        }
    }

    private static long tellsOf(Simulation simulation, String what) {
        return simulation.snapshot().warnings.stream()
            .filter(warning -> warning.contains(what) && !warning.endsWith("so far)")).count();
    }

    @Test
    public void queriesFasterThanTheLineEndSoonAfterTheyStop() throws Exception {
        Simulation simulation = world();
        List<SerialLine> lines = simulation.getLines();
        lines.forEach(line -> line.setSink((bytes, starts) -> { }));
        lines.stream().filter(line -> line.getObjectType().equals("Dynamics"))
            .forEach(line -> line.write(Bytes.bytes("80")));
        while (simulation.getTime() < FLOOD) {
            for (SerialLine line : lines) {
                if (line.getWaiting() < 100) {
                    byte[] query = query(line);
                    for (int i = 0; i < 100; i++) {
                        line.write(query);
                    }
                }
            }
            simulation.step();
        }
        for (SerialLine line : lines) {
            double most = line.getDeviceBaud() / 10.0 * simulation.getTime();
            assertTrue(line.getObjectName() + " sent " + line.getDelivered(), line.getDelivered() <= most
                && line.getDelivered() > most / 4);
        }
        assertEquals("one for each, beside how many there were: " + simulation.snapshot().warnings, 1,
            tellsOf(simulation, "roombaDynamics"));
        SerialLine drive = lines.stream().filter(line -> line.getObjectType().equals("Dynamics")).findFirst().get();
        long sent = drive.getDelivered();
        Worlds.run(simulation, 5);
        assertTrue("what waited was " + (drive.getDelivered() - sent), drive.getDelivered() - sent <= 4096 + LONGEST
            + 200 * 52);
        long all = drive.getDelivered();
        Worlds.run(simulation, 1);
        assertEquals("silent again", all, drive.getDelivered());
    }

    @Test
    public void garbageGivesAFewWarningsForEachCommand() throws Exception {
        Random random = new Random(Fuzz.SEED);
        Simulation simulation = world();
        List<SerialLine> lines = simulation.getLines();
        lines.forEach(line -> line.setSink((bytes, starts) -> { }));
        byte[] garbage = new byte[500];
        while (simulation.getTime() < FLOOD) {
            for (SerialLine line : lines) {
                if (line.getWaiting() < garbage.length) {
                    random.nextBytes(garbage);
                    line.write(line.getObjectType().equals("Dynamics") ? commands(garbage) : garbage);
                }
            }
            simulation.step();
        }
        List<String> warnings = simulation.snapshot().warnings;
        assertTrue("seed " + Fuzz.SEED + ": " + warnings, warnings.size() <= 4 * Opcode.values().length
            && !warnings.isEmpty());
        String counted = warnings.stream().filter(warning -> warning.contains("times so far"))
            .collect(Collectors.joining());
        assertTrue("seed " + Fuzz.SEED + ": " + warnings, counted.contains("opcode"));
    }

    @Test
    public void aBurstWithinOneStepShowsTheFirstAndHowMany() throws Exception {
        Simulation simulation = world();
        SerialLine drive = simulation.getLines().stream().filter(line -> line.getObjectType().equals("Dynamics"))
            .findFirst().get();
        drive.write(Bytes.bytes("80"));
        Worlds.run(simulation, 0.1);
        byte[] unknown = new byte[50];
        Arrays.fill(unknown, (byte) 3);
        unknown[0] = 2;
        drive.write(unknown);
        simulation.step();
        List<String> warnings = simulation.snapshot().warnings;
        List<String> told = warnings.stream().filter(warning -> warning.contains("opcode"))
            .collect(Collectors.toList());
        assertEquals(warnings.toString(), 2, told.size());
        assertTrue(told.get(0), told.get(0).contains("opcode 2") && !told.get(0).contains("so far"));
        assertTrue(told.get(1), told.get(1).endsWith("(10 times so far)"));
    }

    /** Returns garbage with commands, without those that change the speed or wait. */
    private static byte[] commands(byte[] garbage) {
        byte[] bytes = Arrays.copyOf(garbage, garbage.length);
        for (int i = 0; i < bytes.length; i++) {
            int value = bytes[i] & 0xFF;
            bytes[i] = value == 129 || value >= 152 && value <= 158 ? (byte) 128 : bytes[i];
        }
        return bytes;
    }
}
