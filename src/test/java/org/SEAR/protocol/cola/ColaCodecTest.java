// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.cola;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.SEAR.Bytes;
import org.SEAR.Fuzz;
import org.SEAR.Golden;
import org.junit.Test;

/** Telegrams of CoLa A and B compared with recordings and with examples of SICK's drivers. */
public class ColaCodecTest {
    private static final Golden COLA = Golden.of("cola");
    /** Scan of a real LMS1xx: 21 beams from 10 degrees on. */
    private static final String REAL_SCAN = "sRA LMDscandata 1 1 89A27F 0 0 343 347 27477BA9 2747813B 0 0 7 0 0 1388 "
        + "168 0 1 DIST1 3F800000 00000000 "
        + "186A0 1388 15 8A1 8A5 8AB 8AC 8A6 8AC 8B6 8C8 8C2 8C9 8CB 8C4 8E4 8E1 8EB 8E0 8F5 908 8FC 907 "
        + "906 0 0 0 0 0 0";
    /** Lengths of the fields 2 to 19 of the real scan in CoLa B, bytes. */
    private static final int[] HEAD = {2, 2, 4, 1, 1, 2, 2, 4, 4, 1, 1, 1, 1, 2, 4, 4, 2, 2};
    private static final int BEAMS = 21;

    private static List<ColaTelegram> read(byte[] bytes) {
        List<ColaTelegram> found = new ArrayList<>();
        new ColaReader(16384, found::add).accept(bytes);
        return found;
    }

    private static byte[] text(String telegram) {
        return ("\u0002" + telegram + "\u0003").getBytes(StandardCharsets.ISO_8859_1);
    }

    private static void golden(String hex, ColaPayload made) {
        assertEquals(hex, Bytes.hex(made.toTelegram()));
        List<ColaTelegram> found = read(Bytes.bytes(hex));
        assertEquals(hex, 1, found.size());
        assertEquals(ColaDialect.B, found.get(0).getDialect());
    }

    private static ColaPayload b(String verb, String name) {
        return new ColaPayload(ColaDialect.B).begin(verb, name);
    }

    @Test
    public void binaryTelegramsOfTheListing() {
        golden(COLA.get("CoLa B: logged in"), b("sAN", "SetAccessMode").u1(1));
        golden(COLA.get("CoLa B: log in"),
            b("sMN", "SetAccessMode").u1(3).i4(0xF4724744));
        golden(COLA.get("CoLa B: it speaks CoLa B"), b("sWA", "EIHstCola"));
        golden(COLA.get("CoLa B: speak CoLa B"), b("sWN", "EIHstCola").u1(1));
        golden("02 02 02 02 00 00 00 13 73 52 41 20 53 43 64 65 76 69 63 65 73 74 61 74 65 20 01 1E",
            b("sRA", "SCdevicestate").u1(1));
        golden(COLA.get("CoLa B: stream scans"), b("sEN", "LMDscandata").u1(1));
        golden(COLA.get("CoLa B: scans are streamed"), b("sEA", "LMDscandata").u1(1));
        golden("02 02 02 02 00 00 00 25 73 4D 4E 20 6D 4C 4D 50 73 65 74 73 63 61 6E 63 66 67 20 "
            + "00 00 13 88 00 01 00 00 13 88 FF F9 22 30 00 22 55 10 21",
            b("sMN", "mLMPsetscancfg").i4(5000).u2(1).i4(5000).i4(-450000).i4(2250000));
    }

    @Test
    public void binaryRequestsWithoutValues() {
        for (String[] row : new String[][] {{"02 02 02 02 00 00 00 09 73 52 4E 20 53 54 6C 6D 73 3A", "sRN", "STlms"},
            {"02 02 02 02 00 00 00 0E 73 52 4E 20 4C 4D 50 73 63 61 6E 63 66 67 63", "sRN", "LMPscancfg"},
            {"02 02 02 02 00 00 00 07 73 4D 4E 20 52 75 6E 19", "sMN", "Run"},
            {"02 02 02 02 00 00 00 10 73 4D 4E 20 4C 4D 43 73 74 61 72 74 6D 65 61 73 68", "sMN", "LMCstartmeas"}}) {
            ColaTelegram found = read(Bytes.bytes(row[0])).get(0);
            assertEquals(row[1], found.getVerb());
            assertEquals(row[2], found.getName());
            assertFalse(found.hasMore());
            assertEquals(row[0], Bytes.hex(
                ColaDialect.B.frame((row[1] + " " + row[2]).getBytes(StandardCharsets.ISO_8859_1))));
        }
    }

    @Test
    public void numbersOfTextHaveASignOrAreHexadecimal() throws Exception {
        for (String form : new String[] {"+5000 +1 +5000 -450000 +2250000", "1388 1 1388 FFF92230 225510",
            "1388 +1 1388 fff92230 225510"}) {
            ColaTelegram found = read(text("sMN mLMPsetscancfg " + form)).get(0);
            assertEquals(ColaDialect.A, found.getDialect());
            assertEquals(form, "5000 1 5000 -450000 2250000",
                found.i4() + " " + found.u2() + " " + found.i4() + " " + found.i4() + " " + found.i4());
        }
        assertEquals(COLA.get("50 Hz, half a degree"),
            read(new ColaPayload(ColaDialect.A).begin("sMN", "mLMPsetscancfg")
            .i4(5000).u2(1).i4(5000).i4(-450000).i4(2250000).toTelegram()).get(0).toString());
    }

    @Test
    public void wrongNumbersAreRefused() {
        refused("sWN x", ColaError.TOO_FEW_VALUES);
        refused("sWN x 1G", ColaError.INVALID_CHARACTER);
        refused("sWN x +1F", ColaError.INVALID_CHARACTER);
        refused("sWN x 10000", ColaError.VALUE_OVERFLOW);
        refused("sWN x -1", ColaError.VALUE_OVERFLOW);
        refused("sWN x +99999999999", ColaError.VALUE_OVERFLOW);
        refused("sWN x 123456789012345", ColaError.INVALID_CHARACTER);
    }

    private static void refused(String telegram, ColaError error) {
        ColaError got = null;
        try {
            read(text(telegram)).get(0).u2();
        } catch (ColaException e) {
            got = e.getError();
        }
        assertEquals(telegram, error, got);
    }

    @Test
    public void errorsInBothDialects() {
        assertEquals("02 73 46 41 20 33 03", Bytes.hex(ColaError.UNKNOWN_VARIABLE.telegram(ColaDialect.A)));
        assertEquals("a real one's answer to an output range off its grid", "02 02 02 02 00 00 00 05 73 46 41 00 0A 7E",
            Bytes.hex(ColaError.WRITE_ACCESS_DENIED.telegram(ColaDialect.B)));
    }

    @Test
    public void aRealScanIsReadAndWrittenWithTheSameBytes() throws Exception {
        ColaTelegram scan = read(text(REAL_SCAN)).get(0);
        byte[] again = copy(scan, ColaDialect.A);
        assertEquals(REAL_SCAN, read(again).get(0).toString());
        byte[] binary = copy(read(again).get(0), ColaDialect.B);
        assertEquals("DIST1", new String(binary, 64, 5, StandardCharsets.US_ASCII));
        assertEquals("start angle, step, count and the first value", "00 01 86 A0 13 88 00 15 08 A1",
            Bytes.hex(Arrays.copyOfRange(binary, 77, 87)));
        assertEquals(REAL_SCAN, read(copy(read(binary).get(0), ColaDialect.A)).get(0).toString());
    }

    /** Copies a telegram value by value. */
    private static byte[] copy(ColaTelegram from, ColaDialect dialect) throws ColaException {
        ColaPayload to = new ColaPayload(dialect).begin(from.getVerb(), from.getName());
        for (int size : HEAD) {
            copy(from, to, size);
        }
        to.fixed(from.fixed(5)).real(Float.intBitsToFloat(from.i4())).real(Float.intBitsToFloat(from.i4()))
            .i4(from.i4()).u2(from.u2());
        int beams = from.u2();
        assertEquals(BEAMS, beams);
        to.u2(beams);
        for (int i = 0; i < beams + 6; i++) {
            copy(from, to, 2);
        }
        assertFalse(from.hasMore());
        return to.toTelegram();
    }

    private static void copy(ColaTelegram from, ColaPayload to, int size) throws ColaException {
        if (size == 1) {
            to.u1(from.u1());
        } else if (size == 2) {
            to.u2(from.u2());
        } else {
            to.i4(from.i4());
        }
    }

    @Test
    public void textsWithALength() throws Exception {
        assertEquals(COLA.get("no name"),
            read(new ColaPayload(ColaDialect.A).begin("sRA", "LocationName").text("not defined")
            .toTelegram()).get(0).toString());
        ColaTelegram ident = read(text(COLA.get("an LMS111"))).get(0);
        assertEquals("LMS10x_FieldEval", ident.text());
        assertEquals("V1.36-21.10.2010", ident.text());
        assertEquals("0", read(text(COLA.get("ask for the device by its number"))).get(0).getName());
    }

    @Test
    public void garbageBetweenTelegramsIsSkipped() {
        byte[] noise = Bytes.bytes("00 FF 03 41 00 02 73 02 73 52 4E 20 61 03 00 "
            + "02 02 02 02 00 00 00 02 41 42 00 02 02 02 02 7F 00 00 00 02 73 52 4E 20 62 03");
        StringBuilder names = new StringBuilder();
        read(noise).forEach(one -> names.append(one).append(';'));
        assertEquals("broken off, wrong checksum and too long are left out", "sRN a;sRN b;", names.toString());
    }

    /** Random bytes to a driver and to a device. */
    @Test
    public void randomBytesNeverStopAReader() {
        Random random = new Random(Fuzz.SEED);
        int[] likely = Bytes.ints("02 02 02 02 03 00 00 08 73 52 4E 20 2B 31");
        List<ColaTelegram> found = new ArrayList<>();
        ColaReader reader = new ColaReader(1024, found::add);
        for (int i = 0; i < Fuzz.BYTES; i++) {
            reader.accept(random.nextBoolean() ? likely[random.nextInt(likely.length)] : random.nextInt(256));
            found.forEach(ColaCodecTest::readWhole);
            found.clear();
        }
        reader.clear();
        reader.accept(text(COLA.get("ask for the state")));
        assertEquals("seed " + Fuzz.SEED, COLA.get("ask for the state"), found.get(found.size() - 1).toString());
    }

    private static void readWhole(ColaTelegram telegram) {
        try {
            for (int i = 0; i < 4 && telegram.hasMore(); i++) {
                telegram.u1();
                telegram.i4();
                telegram.text();
            }
        } catch (ColaException e) {
            assertTrue(e.getError().getCode() > 0);
        }
    }
}
