// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.ubx;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.Bytes;
import org.SEAR.Fuzz;
import org.SEAR.Golden;
import org.junit.Test;

/** Frames and their reader compared with frames of real receivers and of gpsd. */
public class UbxTest {
    private static final Golden UBX = Golden.of("ubx");
    /** From gpsd's log of a NEO-M8N, 2017-07-19. */
    public static final String PVT = UBX.get("position, velocity and time of a NEO-M8N, from gpsd's log of 2017-07-19");
    private static final String[] FRAMES = UBX.each("ask for the version", "ask for the settings of UART 1",
        "message rate acknowledged", "key and value refused", "a solution each second", "no GLL",
        "key and value, which a generation 8 does not know",
        "dilutions of precision of a real receiver", "UBX, NMEA and RTCM both ways, 9600 baud",
        "position, velocity and time of a NEO-M8N, from gpsd's log of 2017-07-19");

    private final List<UbxFrame> found = new ArrayList<>();
    private final ByteArrayOutputStream others = new ByteArrayOutputStream();
    private final UbxReader reader = new UbxReader(found::add, others::write);

    @Test
    public void framesBothWays() {
        for (String frame : FRAMES) {
            reader.feed(Bytes.bytes(frame));
            assertEquals(frame, Bytes.hex(found.remove(0).toBytes()));
        }
        assertEquals(0, reader.getDamaged());
        assertEquals(0, others.size());
    }

    @Test
    public void theSolutionOfARealReceiver() {
        reader.feed(Bytes.bytes(PVT));
        byte[] payload = found.get(0).getPayload();
        assertEquals(UbxMessage.NAV_PVT, found.get(0).getMessage());
        assertEquals(2017, NavPvt.YEAR.get(payload));
        assertEquals(799899687, NavPvt.NANO.get(payload));
        assertEquals(138.6081197, NavPvt.LONGITUDE.get(payload) / 1e7, 1e-12);
        assertEquals(-34.9062263, NavPvt.LATITUDE.get(payload) / 1e7, 1e-12);
        assertEquals(28895, NavPvt.ALTITUDE.get(payload));
        assertEquals(14, NavPvt.SATELLITES.get(payload));
        assertEquals(145, NavPvt.PDOP.get(payload));
        assertEquals(291018800, NavPvt.TIME_OF_WEEK.get(payload));
        assertEquals(-10, NavPvt.NORTHWARD.get(payload));
        byte[] again = new byte[NavPvt.SIZE];
        for (NavPvt field : NavPvt.values()) {
            field.put(again, field.get(payload));
        }
        assertArrayEquals(java.util.Arrays.copyOf(payload, 80), java.util.Arrays.copyOf(again, 80));
    }

    @Test
    public void sentencesBetweenFramesGoOn() {
        reader.feed("$GPGGA,1*00\r\n".getBytes());
        reader.feed(Bytes.bytes(FRAMES[0]));
        reader.feed("$GP".getBytes());
        assertEquals("$GPGGA,1*00\r\n$GP", others.toString());
        assertEquals(1, found.size());
    }

    /** A false frame start in noise covers parts of good frames or claims 60000 bytes; a lone byte is not a frame. */
    @Test
    public void aDamagedFrameCostsNoGoodOne() {
        String wrongSum = FRAMES[2].substring(0, FRAMES[2].length() - 2) + "39";
        for (String noise : new String[] {"B5", "B5 B5 62", "B5 62 01 07 0A 00", "B5 62 01 07 60 EA", wrongSum}) {
            found.clear();
            reader.feed(Bytes.bytes(noise + FRAMES[0] + FRAMES[4]));
            assertEquals(noise, 2, found.size());
        }
        assertEquals(4, reader.getDamaged());
    }

    @Test
    public void unknownMessagesAreFramesToo() {
        reader.feed(new UbxFrame(0x21, 0x0E, new byte[] {1, 2, 3}).toBytes());
        assertNull(found.get(0).getMessage());
        assertEquals(3, found.get(0).getLength());
        assertEquals(UbxMessage.MON_VER, UbxMessage.of(0x0A, 0x04));
    }

    @Test
    public void randomBytesNeverStopIt() {
        Random random = new Random(Fuzz.SEED);
        for (int i = 0; i < Fuzz.BYTES; i++) {
            reader.accept(random.nextInt(4) == 0 ? (random.nextBoolean() ? 0xB5 : 0x62) : random.nextInt(6) == 0 ? 0
                : random.nextInt(256));
            if (i % 50000 == 0) {
                reader.feed(new byte[UbxFrame.MOST + UbxFrame.OVERHEAD]);
                found.clear();
                others.reset();
                reader.feed(Bytes.bytes(FRAMES[0]));
                assertEquals("seed " + Fuzz.SEED + " after " + i, 1, found.size());
            }
        }
        assertTrue(reader.getDamaged() > 0);
    }
}
