package org.SEAR.devices.lms;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import org.SEAR.Bytes;
import org.SEAR.devices.FakeContext;
import org.SEAR.devices.FakeScanner;
import org.SEAR.protocol.lms.Baud;
import org.SEAR.protocol.lms.Identity;
import org.SEAR.protocol.lms.Telegram;
import org.SEAR.protocol.lms.Variant;
import org.junit.Before;
import org.junit.Test;

/** The LMS200 against SICK's telegrams and recordings of a real one. */
public class Lms200Test {
    private static final String ON_REQUEST = "02 00 02 00 20 25 35 08";
    private static final String INSTALLATION = "02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5";
    private static final String MODE_OK = "06 02 80 03 00 A0 00 10 16 0A";
    private static final String NOT_PERMITTED = "06 02 80 02 00 92 10 7F 33";
    private static final String ZEROS = new String(new char[21]).replace("\0", " 00");
    private static final String REAL_STATUS = "02 80 9A 00 B1 56 30 32 2E 31 39 20 25 00 30 35 32 37 30 34 39 37 00 92 01 00 00 1A 01 00 00 DF 01 00 "
        + "00 9B 02 00 00 77 01 11 01 C1 01 46 01 B0 01 52 02 67 01 EE 01 D8 01 D8 01 94 02 8B 03 65 01 65 01 B2 01 B2 01 94 00 01 00 01 00 02 00 "
        + "00 00 01 00 00 00 00 00 A1 00 25 01 0C 0B 26 01 80 0A 99 03 99 03 99 03 99 03 08 04 00 03 00 02 B4 00 32 00 02 00 00 00 01 19 80 02 00 "
        + "00 01 01 01 56 30 32 2E 30 32 20 0B 9E 07 00 E3 C4 1E 00 54 A3 07 00 35 CC 1E 00 52 06 8E 06 58 02 10 5E 6F";
    static final Identity REAL = new Identity("LMS200;S18063;V02.19 ", "05270497", 0);

    private FakeContext line;
    private FakeScanner scanner;
    private Lms200 lms;

    @Before
    public void power() {
        power(Variant.V180_1, 9600, false, Identity.LMS200_30106);
    }

    private void power(Variant variant, int baud, boolean lenient, Identity identity) {
        line = new FakeContext();
        scanner = new FakeScanner();
        line.sensor = scanner;
        lms = line.attach(new Lms200(new PowerOnSettings(variant, baud, lenient, identity), line));
    }

    private String ask(String hex) {
        line.pass(0.1);
        line.take();
        line.host(hex);
        line.pass(2);
        return line.takeHex();
    }

    @Test
    public void baudTelegramsChangeTheSpeed() {
        String[][] rates = {{"02 00 02 00 20 41 51 08", "19200"}, {"02 00 02 00 20 40 50 08", "38400"}, {"02 00 02 00 20 48 58 08", "500000"},
            {"02 00 02 00 20 42 52 08", "9600"}};
        for (String[] rate : rates) {
            assertEquals(MODE_OK, ask(rate[0]));
            assertEquals(Integer.parseInt(rate[1]), lms.getBaud());
        }
    }

    @Test
    public void wrongBaudTelegramsOfTheOldDriverAreObeyedOnlyIfLenient() {
        assertEquals("15", ask("02 00 02 00 20 41 52 08"));
        assertEquals("15", ask("02 00 02 00 20 40 52 08"));
        assertEquals(9600, lms.getBaud());
        power(Variant.V180_1, 9600, true, Identity.LMS200_30106);
        assertEquals(MODE_OK, ask("02 00 02 00 20 40 52 08"));
        assertEquals(38400, lms.getBaud());
        assertEquals("15", ask("02 00 02 00 30 01 31 19"));
    }

    @Test
    public void variantsAreSwitchedOrRefused() {
        String[][] variants = {
            {"02 00 05 00 3B 64 00 64 00 1D 0F", "02 80 07 00 BB 01 64 00 64 00 10 4F BD", "02 80 07 00 BB 00 64 00 64 00 10 6F AD", "101"},
            {"02 00 05 00 3B 64 00 32 00 B1 59", "02 80 07 00 BB 01 64 00 32 00 10 17 10", "02 80 07 00 BB 00 64 00 32 00 10 37 00", "201"},
            {"02 00 05 00 3B 64 00 19 00 E7 72", "02 80 07 00 BB 01 64 00 19 00 10 BB 46", "02 80 07 00 BB 00 64 00 19 00 10 9B 56", "401"},
            {"02 00 05 00 3B B4 00 64 00 97 49", "02 80 07 00 BB 01 B4 00 64 00 10 5B 30", "02 80 07 00 BB 00 B4 00 64 00 10 7B 20", "181"},
            {"02 00 05 00 3B B4 00 32 00 3B 1F", "02 80 07 00 BB 01 B4 00 32 00 10 03 9D", "02 80 07 00 BB 00 B4 00 32 00 10 23 8D", "361"}};
        for (String[] variant : variants) {
            assertEquals("06 " + variant[1], ask(variant[0]));
            assertEquals("06 " + variant[2], ask("02 00 05 00 3B B4 00 19 00 6D 34"));
            line.host("02 00 02 00 30 01 31 18");
            line.pass(1);
            assertEquals(Integer.parseInt(variant[3]) * 2 + 11, line.take().length);
        }
    }

    @Test
    public void typeErrorsAndPermanentBaud() {
        assertEquals("06 02 80 17 00 BA 4C 4D 53 32 30 30 3B 33 30 31 30 36 33 3B 56 30 32 2E 31 30 20 10 22 61", ask("02 00 01 00 3A 1E 12"));
        assertEquals("06 02 80 02 00 B2 10 3F 13", ask("02 00 01 00 32 16 12"));
        assertEquals("06 02 80 04 00 E6 01 00 10 CD FC", ask("02 00 02 00 66 01 9D 4E"));
        assertTrue(ask("02 00 02 00 66 00 9C 4E").startsWith("06 02 80 04 00 E6 00 00 10"));
        power(Variant.V180_1, 9600, false, REAL);
        assertEquals("06 02 80 17 00 BA 4C 4D 53 32 30 30 3B 53 31 38 30 36 33 3B 56 30 32 2E 31 39 20 10 85 6A", ask("02 00 01 00 3A 1E 12"));
    }

    @Test
    public void resetGreetsAtTheSpeedOfPowerOn() {
        ask("02 00 02 00 20 40 50 08");
        line.host("02 00 01 00 10 34 12");
        line.pass(1);
        assertEquals("06 02 80 02 00 91 10 79 30", line.takeHex());
        assertEquals(9600, lms.getBaud());
        line.pass(10);
        assertEquals("02 80 17 00 90 4C 4D 53 32 30 30 3B 33 30 31 30 36 33 3B 56 30 32 2E 31 30 20 10 63 5E", line.takeHex());
        ask("02 00 02 00 20 40 50 08");
        ask("02 00 02 00 66 01 9D 4E");
        ask("02 00 01 00 10 34 12");
        assertEquals(38400, lms.getBaud());
    }

    @Test
    public void powerOnTelegramOfTheRealDevice() {
        power(Variant.V180_1, 9600, false, REAL);
        line.host("02 00 01 00 10 34 12");
        line.pass(10);
        assertTrue(line.takeHex().endsWith("02 80 17 00 90 4C 4D 53 32 30 30 3B 53 31 38 30 36 33 3B 56 30 32 2E 31 39 20 10 C4 55"));
    }

    @Test
    public void configurationIsReadAndWritten() {
        assertEquals("06 02 80 24 00 F4 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 10 3C FB", ask("02 00 01 00 74 50 12"));
        String centimetres = "02 00 23 00 77 00 00 70 00 00 00 00 00 00 02 02" + ZEROS + " 02 00 41 B8";
        assertEquals(NOT_PERMITTED, ask(centimetres));
        assertEquals(MODE_OK, ask(INSTALLATION));
        assertEquals("06 02 80 25 00 F7 01 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 10 C5 7A",
            ask("02 00 23 00 77 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 11 88"));
        assertTrue(ask(centimetres).endsWith("65 1A"));
        assertEquals("06 02 80 24 00 F4 00 00 70 00 00 00 00 00 00 02 02" + ZEROS + " 02 00 10 9C 9B", ask("02 00 01 00 74 50 12"));
        assertTrue(ask("02 00 23 00 77 00 00 70 00 00 04 01 00 00 02 02" + ZEROS + " 02 00 94 8A").endsWith("CF 7F"));
        assertTrue(ask("02 00 01 00 74 50 12").endsWith("36 FE"));
        assertTrue(ask("02 00 23 00 77 00 00 70 00 00 06 01 00 00 02 02" + ZEROS + " 02 00 D4 4B").startsWith("06 02 80 25 00 F7 01"));
        String full = "02 00 23 00 77 00 00 46 00 00 00 01 00 00 02 02 02 00 00 0A 0A 50 64 00 0A 0A 50 80 00 0A 0A 50 64 00 00 00 00 02 00 7B 4B";
        assertTrue(ask(full).startsWith("06 02 80 25 00 F7 01 00 00 46"));
        assertTrue(ask("02 00 05 00 7C 00 00 00 00 8F C4").startsWith("06 02 80 03 00 FC 01 10"));
        assertEquals(MODE_OK, ask(ON_REQUEST));
    }

    /** CARMEN, ARIA, OpenDLV and scripts for the LMS291 write 32 bytes; the telegrams are those of SICK's quick manual and its mode 4. */
    @Test
    public void thirtyTwoBytesOfConfigurationAreTakenAndTheRestStays() {
        ask(INSTALLATION);
        assertTrue(ask("02 00 23 00 77 00 00 46 00 00 00 01 00 00 02 02 02 00 00 0A 0A 50 64 00 0A 0A 50 80 00 0A 0A 50 64 00 00 00 00 02 00 7B 4B")
            .startsWith("06 02 80 25 00 F7 01"));
        String answer = ask("02 00 21 00 77 00 00 00 00 00 00 01 00 00 02 02" + ZEROS + " FC 7E");
        assertTrue(answer, answer.startsWith("06 02 80 25 00 F7 01 00 00 00 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 10"));
        assertTrue(ask("02 00 21 00 77 00 00 70 00 00 04 01 00 00 02 02" + ZEROS + " 84 72").startsWith("06 02 80 25 00 F7 01 00 00 70 00 00 04"));
        assertTrue(ask("02 00 01 00 74 50 12").endsWith("36 FE"));
        assertEquals(MODE_OK, ask(ON_REQUEST));
        scanner.world = beam -> beam == 90 ? 11.75 : Double.POSITIVE_INFINITY;
        byte[] scan = Bytes.bytes(ask("02 00 02 00 30 01 31 18"));
        assertEquals(11750, scan[8 + 180] & 0xFF | (scan[8 + 181] & 0xFF) << 8);
        assertEquals("nothing hit in 16 m", 16383, scan[8] & 0xFF | (scan[9] & 0xFF) << 8);
    }

    @Test
    public void otherLengthsOfConfigurationAreRefused() {
        ask(INSTALLATION);
        String before = ask("02 00 01 00 74 50 12");
        for (int size : new int[] {0, 31, 33, 35}) {
            byte[] payload = new byte[size + 1];
            payload[0] = 0x77;
            String answer = ask(Bytes.hex(new Telegram(0, payload).toBytes()));
            assertTrue(size + ": " + answer, answer.startsWith("06 02 80 25 00 F7 00"));
        }
        assertEquals(before, ask("02 00 01 00 74 50 12"));
    }

    @Test
    public void aWrongPasswordIsRefused() {
        assertEquals("06 02 80 03 00 A0 01 10 14 0B", ask("02 00 0A 00 20 00 53 49 43 4B 5F 50 4C 53 CC FC"));
        assertEquals(MODE_OK, ask("02 00 02 00 20 10 00 08"));
        assertEquals("scans are not for diagnostic mode", NOT_PERMITTED, ask("02 00 02 00 30 01 31 18"));
    }

    @Test
    public void statusIsThatOfTheRealDevice() {
        power(Variant.V180_HALF, 38400, false, REAL);
        ask(INSTALLATION);
        ask("02 00 23 00 77 00 00 70 00 00 04 01 00 00 02 02" + ZEROS + " 02 00 94 8A");
        ask(ON_REQUEST);
        assertEquals("06 " + REAL_STATUS, ask("02 00 01 00 31 15 12"));
    }

    @Test
    public void scansAreRightToLeftInMillimetres() {
        scanner.world = beam -> beam == 0 ? 0 : beam == 1 ? 0.001 : beam == 2 ? 8.183 : beam == 3 ? 100
            : beam == 4 ? 8.182 : Double.POSITIVE_INFINITY;
        byte[] scan = Bytes.bytes(ask("02 00 02 00 30 01 31 18"));
        assertEquals("06 02 80 6E 01 B0 B5 40 00 00 01 00 F7 1F F7 1F F6 1F FF 1F", Bytes.hex(Arrays.copyOf(scan, 20)));
    }

    @Test
    public void fullFramesAsComputedByHand() {
        scanner.world = beam -> Double.POSITIVE_INFINITY;
        assertTrue(ask("02 00 02 00 30 01 31 18").endsWith("FF 1F 10 B9 E2"));
        power(Variant.V180_HALF, 9600, false, Identity.LMS200_30106);
        assertTrue(ask("02 00 02 00 30 01 31 18").endsWith("FF 1F 10 24 3E"));
        scanner.world = beam -> 1;
        assertTrue(ask("02 00 02 00 30 01 31 18").endsWith("E8 03 10 55 F1"));
        scanner.world = beam -> beam / 1000.0;
        assertTrue(ask("02 00 02 00 30 01 31 18").endsWith("68 01 10 31 93"));
        centimetres(Variant.V100_1, "60 E9", Double.POSITIVE_INFINITY);
        centimetres(Variant.V180_1, "8C 7E", Double.POSITIVE_INFINITY);
        centimetres(Variant.V100_HALF, "CA AD", Double.POSITIVE_INFINITY);
        centimetres(Variant.V100_QUARTER, "04 B1", Double.POSITIVE_INFINITY);
        centimetres(Variant.V180_1, "A0 F1", 10);
        scanner.world = beam -> beam / 100.0;
        assertTrue(ask("02 00 02 00 30 01 31 18").endsWith("B4 00 10 D5 D8"));
    }

    private void centimetres(Variant variant, String crc, double metres) {
        power(variant, 9600, false, Identity.LMS200_30106);
        scanner.world = beam -> metres;
        ask(INSTALLATION);
        ask("02 00 23 00 77 00 00 70 00 00 00 00 00 00 02 02" + ZEROS + " 02 00 41 B8");
        ask(ON_REQUEST);
        String answer = ask("02 00 02 00 30 01 31 18");
        assertTrue(answer, answer.endsWith("10 " + crc));
    }

    @Test
    public void partsOfAScan() {
        scanner.world = beam -> (beam + 1) / 1000.0;
        assertTrue(ask("02 00 02 00 30 06 36 18").startsWith("06 02 80 BA 00 B0 5B 40 01 00 03 00 05 00"));
        assertTrue(ask("02 00 02 00 30 07 37 18").startsWith("06 02 80 18 00 B0 0A 40 01 00 15 00"));
        assertTrue(ask("02 00 02 00 30 02 32 18").startsWith("06 02 80 06 00 B0 01 40"));
        assertTrue(ask("02 00 02 00 30 03 33 18").startsWith("06 02 80 6E 01 B0 B5 40 FF 1F"));
        assertTrue(ask("02 00 02 00 30 08 38 18").startsWith("06 02 80 6E 01 B0 B5 60 01 00"));
        assertTrue(ask("02 00 02 00 36 02 3E 1E").startsWith("06 02 80 6F 01 B6 02 B5 40 01 00"));
        assertEquals("values 1 to 361 are not there with one degree", NOT_PERMITTED, ask("02 00 05 00 37 01 00 69 01 EB 75"));
        ask("02 00 05 00 3B B4 00 32 00 3B 1F");
        assertTrue(ask("02 00 05 00 37 01 00 69 01 EB 75").startsWith("06 02 80 DA 02 B7 01 00 69 01 69 41 01 00 02 00"));
        assertTrue(ask("02 00 02 00 30 08 38 18").contains(" B0 B4 70 02 00 04 00"));
    }

    @Test
    public void indicesFollowTheValuesIfAskedFor() {
        ask(INSTALLATION);
        ask("02 00 23 00 77 00 00 70 00 07 00 01 00 00 02 02" + ZEROS + " 02 00 DE 4E");
        ask(ON_REQUEST);
        byte[] first = Bytes.bytes(ask("02 00 02 00 30 01 31 18"));
        byte[] second = Bytes.bytes(ask("02 00 02 00 30 01 31 18"));
        assertEquals(375, first.length);
        assertEquals(first[first.length - 4] + 1, second[second.length - 4]);
    }

    @Test
    public void anOwnAddressIsHeardBesideTheBroadcast() {
        power(Variant.V180_1, 9600, false, new Identity("LMS200;301063;V02.06 ", "00000000", 1));
        assertEquals("06 02 81 03 00 A0 00 10 36 1A", ask(ON_REQUEST));
        line.host(Bytes.hex(new Telegram(1, new byte[] {0x32}).toBytes()));
        line.pass(1);
        assertTrue(line.takeHex().startsWith("06 02 81 02 00 B2 10"));
        line.host(Bytes.hex(new Telegram(2, new byte[] {0x32}).toBytes()));
        line.pass(1);
        assertArrayEquals(new byte[0], line.take());
    }

    @Test
    public void aPauseEndsATelegramAndTheNextIsAnswered() {
        line.host("02 00 02 00 30");
        line.pass(0.1);
        line.host("01 31 18");
        line.pass(1);
        assertEquals("", line.takeHex());
        assertEquals("06 02 80 02 00 B2 10 3F 13", ask("02 00 01 00 32 16 12"));
        assertEquals("06 02 80 02 00 B2 10 3F 13", ask("02 02 00 03 02 00 01 00 32 16 12"));
        assertEquals(NOT_PERMITTED, ask(Bytes.hex(new Telegram(0, new byte[] {0x55}).toBytes())));
    }

    @Test
    public void answersComeWithinTheListedTimes() {
        for (Baud baud : Baud.values()) {
            power(Variant.V100_QUARTER, baud.getRate(), false, Identity.LMS200_30106);
            line.host("02 00 02 00 30 01 31 18");
            double end = line.now;
            line.pass(0.2);
            assertTrue("ACK after " + (line.times.get(0) - end), line.times.get(0) - end <= 0.06);
            double wait = line.times.get(1) - line.times.get(0);
            assertTrue("scan after " + wait, wait <= 0.06 + 10.0 / baud.getRate());
        }
    }

    @Test
    public void thePowerSwitchEndsAStreamAt500000Baud() {
        assertEquals(MODE_OK, ask("02 00 02 00 20 48 58 08"));
        line.host("02 00 02 00 20 24 34 08");
        line.pass(1);
        assertEquals(500000, lms.getBaud());
        lms.powerOff();
        line.now += 100;
        line.clearOutput();
        line.take();
        lms.powerOn(line.now);
        assertEquals(9600, lms.getBaud());
        line.host("02 00 01 00 31 15 12");
        line.pass(4.9);
        assertEquals("it starts", "", line.takeHex());
        line.pass(0.2);
        assertEquals("02 80 17 00 90 4C 4D 53 32 30 30 3B 33 30 31 30 36 33 3B 56 30 32 2E 31 30 20 10 63 5E", line.takeHex());
        line.pass(5);
        assertEquals("no stream", "", line.takeHex());
        assertTrue(ask("02 00 02 00 30 01 31 18").startsWith("06 02 80 6E 01 B0"));
    }

    @Test
    public void withoutPowerAnLms200ForgetsTheVariantButNoConfigurationAndPermanentBaudRate() {
        ask("02 00 02 00 20 40 50 08");
        ask("02 00 02 00 66 01 9D 4E");
        ask("02 00 05 00 3B 64 00 64 00 1D 0F");
        ask(INSTALLATION);
        ask("02 00 23 00 77 00 00 70 00 00 04 01 00 00 02 02" + ZEROS + " 02 00 94 8A");
        lms.powerOff();
        lms.powerOn(line.now);
        line.pass(6);
        assertEquals(38400, lms.getBaud());
        assertTrue(ask("02 00 01 00 74 50 12").startsWith("06 02 80 24 00 F4 00 00 70 00 00 04 01"));
        assertTrue("180 degrees", ask("02 00 02 00 30 01 31 18").startsWith("06 02 80 6E 01 B0"));
    }

    /** A driver is restarted in mid-stream: it gets its ACK in time at every moment, and whole telegrams after it. */
    @Test
    public void aScanOnTheLineDoesNotHoldUpAnAck() {
        for (int phase = 0; phase < 40; phase++) {
            power(Variant.V180_HALF, 38400, false, Identity.LMS200_30106);
            line.host("02 00 02 00 20 24 34 08");
            line.pass(1 + phase * 0.0073);
            line.host(ON_REQUEST);
            line.pass(0.05);
            byte[] sent = line.take();
            assertEquals("phase " + phase, Telegram.ACK, sent[sent.length - 1]);
            line.pass(1);
            assertEquals("phase " + phase, MODE_OK.substring(3), line.takeHex());
            assertTrue(ask("02 00 01 00 31 15 12").startsWith("06 02 80 9A 00 B1"));
        }
    }

    @Test
    public void anAnsweredScanIsNeverBrokenOff() {
        power(Variant.V180_HALF, 38400, false, Identity.LMS200_30106);
        line.host("02 00 02 00 30 01 31 18");
        line.pass(0.1);
        line.host("02 00 01 00 31 15 12");
        line.pass(1);
        String all = line.takeHex();
        assertTrue(all, all.startsWith("06 02 80 D6 02 B0"));
        assertEquals("both replies whole", 3 * (1 + 733 + 161) - 1 - 3, all.length());
    }

    @Test
    public void aStreamGoesOnAfterAQuestion() {
        power(Variant.V180_HALF, 38400, false, Identity.LMS200_30106);
        line.host("02 00 02 00 20 24 34 08");
        line.pass(1);
        line.host("02 00 01 00 31 15 12");
        line.pass(0.2);
        line.take();
        line.pass(2);
        assertTrue("about 4.7 a second", line.take().length > 8 * 732);
    }
}
