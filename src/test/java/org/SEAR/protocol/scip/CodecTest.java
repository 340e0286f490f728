// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.scip;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.CRC32;
import org.SEAR.Golden;
import org.junit.Test;

/** Examples of the specification and answers of real sensors; {@code |} is a line feed. */
public class CodecTest {
    private static final Golden SCIP = Golden.of("scip");
    private static String encode(int value, int characters) {
        StringBuilder out = new StringBuilder();
        Encoding.append(out, value, characters);
        return out.toString();
    }

    private static String text(ReplyWriter reply) {
        return new String(reply.toBytes(), StandardCharsets.ISO_8859_1).replace('\n', '|');
    }

    @Test
    public void numbersAsTheSpecificationHasThem() {
        Object[][] examples = {{1234, 2, "CB"}, {5432, 3, "1Dh"}, {16000000, 4, "m2@0"}, {0, 2, "00"}, {4095, 2, "oo"},
            {1000, 2, "?X"},
            {1000, 3, "0?X"}, {1000, 4, "00?X"}, {19, 3, "00C"}, {5600, 3, "1GP"}, {30000, 3, "7D`"}, {60000, 3, ">YP"},
                {262143, 3, "ooo"}};
        for (Object[] example : examples) {
            assertEquals(example[2], encode((int) example[0], (int) example[1]));
            assertEquals(example[0], Encoding.decode((String) example[2], 0, (int) example[1]));
        }
    }

    @Test
    public void invalidNumbersAreReportedWithTheLegalRange() {
        try {
            Encoding.decode("0p", 0, 2);
            fail("decoded");
        } catch (IllegalArgumentException e) {
            assertEquals("character 112 is no encoded number, legal: 48 to 111", e.getMessage());
        }
    }

    @Test
    public void checksumsOfRealAnswers() {
        String lines = "00P 99b 0Aa 0Bb 0Ee 10Q DMIN:20;4 DMAX:5600;_ ARES:1024;\\ AMIN:44;7 AMAX:725;o AFRT:384;6 "
            + "SCAN:600;e DMIN:23;7 DMAX:60000;J "
            + "ARES:1440;^ AMIN:0;? AMAX:1080;Z AFRT:540;0 SCAN:2400;U PROT:SCIP_2.0;" + Checksum.of("PROT:SCIP_2.0")
            + " SERI:H0614967;V LASR:OFF;7";
        for (String line : lines.split(" ")) {
            String expected = line.substring(0, line.length() - 1).replace(";", "");
            assertEquals(expected, Checksum.strip(line));
            assertNull(line, Checksum.strip(line.substring(0, line.length() - 1)
                + (char) (line.charAt(line.length() - 1) ^ 1)));
        }
        assertEquals("VEND:Hokuyo Automatic Co.,Ltd.", Checksum.strip("VEND:Hokuyo Automatic Co.,Ltd.;["));
        assertEquals("FIRM:3.1.00(18/Jan./2007)", Checksum.strip("FIRM:3.1.00(18/Jan./2007);`"));
        assertEquals("MODL:URG-04LX(Hokuyo Automatic Co.,Ltd.)",
            Checksum.strip("MODL:URG-04LX(Hokuyo Automatic Co.,Ltd.);N"));
    }

    @Test
    public void wholeRepliesByteByByte() {
        assertEquals(SCIP.get("three values of three characters by GD"),
            text(new ReplyWriter("GD0384038601", ScipStatus.OK).time(1000)
                .values(new int[] {1000, 1001, 1002}, Encoding.LONG)));
        assertEquals(SCIP.get("a value of three characters by MD"),
            text(new ReplyWriter("MD0384038401000", ScipStatus.SCAN).time(1000)
                .values(new int[] {1000}, Encoding.LONG)));
        assertEquals(SCIP.get("two values of two characters by MS"),
            text(new ReplyWriter("MS0384038501000", ScipStatus.SCAN).time(1000)
                .values(new int[] {1000, 19}, Encoding.SHORT)));
    }

    @Test
    public void wholeScansHaveTheLengthAndSumOfTheSheet() {
        assertScan("MD0044072501000", 682, Encoding.LONG, 2137, 0x32924D24L);
        assertScan("MD0000108001000", 1081, Encoding.LONG, 3372, 0xA3B7AAE9L);
        assertEquals(1435, scan("MS0044072501000", 682, Encoding.SHORT).length);
        assertEquals(2257, scan("MS0000108001000", 1081, Encoding.SHORT).length);
    }

    private static byte[] scan(String echo, int values, int characters) {
        int[] all = new int[values];
        Arrays.fill(all, 1000);
        return new ReplyWriter(echo, ScipStatus.SCAN).time(1000).values(all, characters).toBytes();
    }

    private static void assertScan(String echo, int values, int characters, int length, long crc) {
        byte[] bytes = scan(echo, values, characters);
        CRC32 sum = new CRC32();
        sum.update(bytes);
        assertEquals(length, bytes.length);
        assertEquals(crc, sum.getValue());
        List<Reply> replies = new ArrayList<>();
        new ReplyReader(replies::add, () -> fail("broken")).accept(bytes);
        assertTrue(replies.get(0).isScan());
        assertEquals(1000, replies.get(0).time());
        int[] expected = new int[values];
        Arrays.fill(expected, 1000);
        assertArrayEquals(expected, replies.get(0).values(characters));
    }

    @Test
    public void scanCommandsAreReadAsTheyAreWritten() {
        for (String line : new String[] {"MD0044072501000", "MS0000076804399", "GD0384038601", "GS0044072500;name",
            "MD0044072501005;x"}) {
            assertNull(line, ScanCommand.fault(line, 768));
            assertEquals(line, ScanCommand.of(line).toString());
        }
        assertEquals("MD0044072501007;x", ScanCommand.of("MD0044072501005;x").withCount(7).toString());
        assertEquals(682, ScanCommand.of("MD0044072500000").getValues());
        assertEquals(227, ScanCommand.of("MD0044072503000").getValues());
    }

    @Test
    public void wrongParametersHaveTheirStatus() {
        String[][] faults = {{"MD00x4072501000", "01"}, {"MD0044 72501000", "02"}, {"MD00440725x1000", "03"},
            {"MD0044076901000", "04"},
            {"MD0100009901000", "05"}, {"MD0044072501x00", "06"}, {"MD00440725010x0", "07"}, {"GD0044072x01", "02"}};
        for (String[] fault : faults) {
            assertEquals(fault[0], fault[1], ScanCommand.fault(fault[0], 768));
        }
    }

    @Test
    public void brokenRepliesAreReportedAndTheNextIsRead() {
        List<String> seen = new ArrayList<>();
        ReplyReader reader = new ReplyReader(reply -> seen.add(reply.getEcho()), () -> seen.add("broken"));
        reader.accept("QT\n00Q\n\nBM\n00P\n\n\nnoise without end\n\nQT\n00P\n\n".getBytes(StandardCharsets.ISO_8859_1));
        reader.accept((new String(new char[500]).replace("\0", "x") + "\n\nRS\n00P\n\n")
            .getBytes(StandardCharsets.ISO_8859_1));
        assertEquals("[broken, BM, broken, QT, broken, RS]", seen.toString());
    }
}
