package org.myrobotlab.service.lidar;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.Test;

/** Scans mean what the telegram listing says. */
public class LmsRepliesTest {
    private static final int SIXTEEN_METRES = 4;

    private static List<byte[]> telegrams(String hex) {
        List<byte[]> found = new ArrayList<>();
        new LmsFramer().feed(Hex.bytes(hex), new LmsFramer.Sink() {
            @Override
            public void acknowledged() {
                found.add(new byte[0]);
            }

            @Override
            public void refused() {
                found.add(new byte[0]);
            }

            @Override
            public void telegram(byte[] body) {
                found.add(body);
            }
        });
        return found;
    }

    private static LmsScan scan(String hex, int mode) {
        return LmsReplies.scan(telegrams(hex).get(0), mode, 1, 0);
    }

    @Test
    public void flagBitsAreNoDistanceAndOverflowsAreNoReturn() {
        LmsScan scan = scan("02 80 0E 00 B0 05 40 00 00 01 00 E8 83 F7 1F FF 1F 10 D4 58", 0);
        assertArrayEquals(new int[] {0, 1, 1000, 8183, 8191}, scan.raw);
        assertEquals("mm", scan.unit);
        assertEquals(1.0, scan.metres[2], 0);
        assertNull(scan.metres[3]);
        assertNull(scan.metres[4]);
    }

    @Test
    public void centimetresAreHundredthsOfMetres() {
        LmsScan scan = scan("02 80 0A 00 B0 03 00 64 00 C8 00 2C 01 10 BE 64", 0);
        assertArrayEquals(new int[] {100, 200, 300}, scan.raw);
        assertEquals("cm", scan.unit);
        assertEquals(3.0, scan.metres[2], 1e-12);
    }

    @Test
    public void aFieldFlagDoesNotChangeTheDistance() {
        assertArrayEquals(new int[] {1234}, scan("02 80 06 00 B0 01 40 D2 24 10 B0 99", 0).raw);
    }

    @Test
    public void theFirstValueIsTheRightmostBeam() {
        StringBuilder hex = new StringBuilder("02 80 6E 01 B0 B5 00");
        for (int i = 0; i <= 180; i++) {
            hex.append(String.format(" %02X 00", i));
        }
        LmsScan wide = scan(hex + " 10 D5 D8", 0);
        assertEquals(0, wide.angles[0], 0);
        assertEquals(180, wide.angles[180], 0);
        assertEquals(180, wide.raw[180]);
        String narrow = "02 80 CE 00 B0 65 00" + " FF 1F".repeat(101) + " 10 60 E9";
        assertEquals(40, scan(narrow, 0).angles[0], 0);
        assertEquals(140, scan(narrow, 0).angles[100], 0);
        String fine = "02 80 26 03 B0 91 01" + " FF 1F".repeat(401) + " 10 04 B1";
        assertEquals(0.25, scan(fine, 0).resolution, 0);
    }

    @Test
    public void telegramsOfARealDeviceAreAllFound() throws IOException {
        List<byte[]> found = telegrams(realFrames());
        List<byte[]> scans = found.stream().filter(body -> (body[0] & 0xFF) == LmsTelegram.SCAN_REPLY).collect(Collectors.toList());
        assertEquals(realTelegrams(), found.size());
        assertTrue(scans.size() >= 2);
        LmsScan scan = LmsReplies.scan(scans.get(0), SIXTEEN_METRES, 0.5, 0);
        assertEquals(361, scan.raw.length);
        assertEquals(0.205, scan.metres[0], 1e-12);
        assertEquals(0.208, scan.metres[1], 1e-12);
        assertEquals("mm", scan.unit);
        assertEquals(1, java.util.Arrays.stream(scan.raw).filter(value -> value == 0x3FFB).count());
    }

    private static List<String> lines() throws IOException {
        try (BufferedReader in = new BufferedReader(new InputStreamReader(LmsRepliesTest.class.getResourceAsStream("real-frames.txt"),
                StandardCharsets.US_ASCII))) {
            return in.lines().filter(line -> line.startsWith("02 ") || line.matches("[0-9A-F]{2}( [0-9A-F]{2})*")).collect(Collectors.toList());
        }
    }

    private static String realFrames() throws IOException {
        return String.join(" ", lines());
    }

    private static long realTelegrams() throws IOException {
        return lines().stream().filter(line -> line.startsWith("02 80")).count();
    }
}
