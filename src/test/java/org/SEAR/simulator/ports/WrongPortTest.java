// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ports;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.Bytes;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.IMU;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SerialObject;
import org.SEAR.devices.SerialLine;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/**
 * SEAR warns once about a program at the wrong port or at a baud rate that its device has left, and never about one at
 * the right port.
 */
public class WrongPortTest {
    /** First bytes of a driver of each device. */
    private static final Map<String, byte[]> FIRST_WORDS = new LinkedHashMap<>();

    static {
        FIRST_WORDS.put("drive", Bytes.bytes("80 83 8C 00 01 40 00 8D 00 91 00 64 00 64 95 01 13 91 00 C8 00 C8"));
        FIRST_WORDS.put("LMS200", Bytes.bytes("02 00 01 00 31 15 12 02 00 01 00 31 15 12"));
        FIRST_WORDS.put("URG-04LX", "QT\nBM\nPP\nVV\n".getBytes(StandardCharsets.US_ASCII));
        FIRST_WORDS.put("RPLIDAR-A1", Bytes.bytes("A5 25 A5 50 A5 52 A5 25 A5 50 A5 52"));
        FIRST_WORDS.put("LMS111", "\u0002sRN DeviceIdent\u0003".getBytes(StandardCharsets.US_ASCII));
        FIRST_WORDS.put("MT3301", "$PMTK605*31\r\n".getBytes(StandardCharsets.US_ASCII));
        FIRST_WORDS.put("NEO-M8N", Bytes.bytes("B5 62 0A 04 00 00 0E 34 B5 62 0A 04 00 00 0E 34"));
        FIRST_WORDS.put("compass", Bytes.bytes("8E 2F 8E 2F 8E 2F 8E 2F 8E 2F"));
        FIRST_WORDS.put("imu", "#s00#o1#ob#f#ot".getBytes(StandardCharsets.US_ASCII));
        FIRST_WORDS.put("StandardFirmata", Bytes.bytes("F9 F0 79 F7 F0 6B F7 F4 0D 01"));
        FIRST_WORDS.put("MrlComm", Bytes.bytes("AA 01 01 AA 02 08 01 AA 01 01 AA 01 01"));
    }

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Simulation world() throws Exception {
        new Floor("floor", 40, 40);
        SEARrobot robot = Robots.create2("robot", "driveUart", "driveUser");
        for (String name : FIRST_WORDS.keySet()) {
            SerialObject part = part(name);
            if (part != null) {
                part.setPorts(name + "Uart", name + "User");
                robot.addComponent((SearObject) part);
            }
        }
        return Worlds.start(project);
    }

    private static SerialObject part(String name) {
        switch (name) {
            case "drive":
                return null;
            case "MT3301":
            case "NEO-M8N":
                GPS gps = new GPS(name, 33.6, 180, -80.8);
                gps.setModel(name);
                return gps;
            case "compass":
                return new Compass(name);
            case "imu":
                return new IMU(name);
            case "StandardFirmata":
            case "MrlComm":
                Arduino board = new Arduino(name, "uno");
                board.setFirmware(name);
                return board;
            default:
                LIDAR lidar = new LIDAR(name);
                lidar.setModel(name);
                return lidar;
        }
    }

    private static List<String> complaints(Simulation simulation, SerialLine line) {
        return simulation.snapshot().warnings.stream().filter(one -> one.startsWith(line.getObjectName() + ": ")
            && one.contains("bytes came")).collect(Collectors.toList());
    }

    @Test
    public void bytesForAnotherDeviceAreReportedOnceAndRightOnesNever() throws Exception {
        Simulation simulation = world();
        assertEquals(FIRST_WORDS.size(), simulation.getLines().size());
        for (SerialLine line : simulation.getLines()) {
            for (String speaker : FIRST_WORDS.keySet()) {
                simulation.reset();
                byte[] words = FIRST_WORDS.get(speaker);
                for (int i = 0; i < 3; i++) {
                    line.write(words);
                    Worlds.run(simulation, 3);
                }
                List<String> told = complaints(simulation, line);
                String where = speaker + " to " + line.getObjectName();
                assertEquals(where + " " + told, line.getObjectName().equals(speaker) ? 0 : 1, told.size());
                if (!told.isEmpty()) {
                    String first = String.format("(first: %02X %02X): is it the right port?", words[0], words[1]);
                    assertTrue(where + " " + told, told.get(0).endsWith(first));
                }
            }
        }
    }

    @Test
    public void aProgramAtTheDevicesFormerRateIsReported() throws Exception {
        Simulation simulation = world();
        SerialLine line = simulation.getLines().stream().filter(one -> one.getObjectName().equals("LMS200"))
            .findFirst().get();
        line.setHostBaud(9600);
        line.write(Bytes.bytes("02 00 02 00 20 48 58 08"));
        Worlds.run(simulation, 1);
        assertEquals(500000, line.getDeviceBaud());
        assertEquals(List.of(), complaints(simulation, line));
        line.write(FIRST_WORDS.get("LMS200"));
        Worlds.run(simulation, 1);
        assertEquals(List.of("LMS200: 14 bytes came at 9600 baud, but an LMS200 is at 500000 baud now: change the "
            + "program's rate, too"), complaints(simulation, line));
    }
}
