// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.lms;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import org.SEAR.Bytes;
import org.SEAR.Golden;
import org.SEAR.devices.FakeContext;
import org.SEAR.devices.FakeScanner;
import org.SEAR.protocol.lms.Baud;
import org.SEAR.protocol.lms.Identity;
import org.SEAR.protocol.lms.Telegram;
import org.SEAR.protocol.lms.Variant;
import org.junit.Before;
import org.junit.Test;

/** The LMS200 compared with SICK's telegram listing and recordings of a real one. */
public class Lms200Test {
    private static final Golden LMS = Golden.of("lms200");
    private static final String ON_REQUEST = LMS.get("scans on request");
    private static final String INSTALLATION = LMS.get("installation, with the password SICK_LMS");
    private static final String MODE_OK = "06 " + LMS.get("mode changed");
    private static final String NOT_PERMITTED = "06 " + LMS.get("not permitted");
    private static final String ZEROS = new String(new char[21]).replace("\0", " 00");
    private static final String REAL_STATUS = LMS.get("status of the recorded LMS200");
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
        String[][] rates = {{LMS.get("19200 baud"), "19200"}, {LMS.get("38400 baud"), "38400"},
            {LMS.get("500000 baud"), "500000"},
            {LMS.get("9600 baud"), "9600"}};
        for (String[] rate : rates) {
            assertEquals(MODE_OK, ask(rate[0]));
            assertEquals(Integer.parseInt(rate[1]), lms.getBaud());
        }
    }

    /** The mirror turns 75 times per second, one degree in 37 us, and measures half degrees in the second turn. */
    @Test
    public void beamsAreMeasuredOneAfterAnother() {
        ask(LMS.get("100 degrees, each half"));
        ask(LMS.get("ask for a scan"));
        double last = scanner.times.get(200).get(0) + Variant.TURN;
        assertEquals("a scan ends with a pair of turns", 0, Math.IEEEremainder(last, 2 * Variant.TURN), 1e-9);
        for (int beam = 0; beam <= 200; beam++) {
            double expected = last - (beam % 2 == 0 ? Variant.TURN : 0) - (200 - beam) * Variant.TURN / 720;
            assertEquals("beam " + beam, expected, scanner.times.get(beam).get(0), 1e-9);
        }
    }

    @Test
    public void wrongBaudTelegramsOfTheOldDriverWorkOnlyIfLenient() {
        assertEquals("15", ask(LMS.get("19200 baud of the old driver, with a wrong checksum")));
        assertEquals("15", ask(LMS.get("38400 baud of the old driver, with a wrong checksum")));
        assertEquals(9600, lms.getBaud());
        power(Variant.V180_1, 9600, true, Identity.LMS200_30106);
        assertEquals(MODE_OK, ask(LMS.get("38400 baud of the old driver, with a wrong checksum")));
        assertEquals(38400, lms.getBaud());
        assertEquals("15", ask(LMS.get("ask for a scan, its checksum wrong")));
    }

    @Test
    public void variantsAreSwitchedOrRefused() {
        String[][] variants = {{"100 degrees, each", "101"}, {"100 degrees, each half", "201"},
            {"100 degrees, each quarter", "401"},
            {"180 degrees, each", "181"}, {"180 degrees, each half", "361"}};
        for (String[] variant : variants) {
            assertEquals("06 " + LMS.get(variant[0] + ": done"), ask(LMS.get(variant[0])));
            assertEquals("06 " + LMS.get("refused, " + variant[0] + ", go on"),
                ask(LMS.get("180 degrees, each quarter, which there is not")));
            line.host(LMS.get("ask for a scan"));
            line.pass(1);
            assertEquals(Integer.parseInt(variant[1]) * 2 + 11, line.take().length);
        }
    }

    @Test
    public void typeErrorsAndPermanentBaud() {
        assertEquals("06 " + LMS.get("type of an LMS200 with V02.10"), ask(LMS.get("ask for the type")));
        assertEquals("06 " + LMS.get("no errors"), ask(LMS.get("ask for errors")));
        assertEquals("06 " + LMS.get("the baud rate is kept"), ask(LMS.get("keep the baud rate")));
        assertTrue(ask(LMS.get("begin with 9600 baud")).startsWith("06 02 80 04 00 E6 00 00 10"));
        power(Variant.V180_1, 9600, false, REAL);
        assertEquals("06 " + LMS.get("type of the recorded LMS200 with V02.19"), ask(LMS.get("ask for the type")));
    }

    @Test
    public void resetGreetsAtTheSpeedOfPowerOn() {
        ask(LMS.get("38400 baud"));
        line.host(LMS.get("reset"));
        line.pass(1);
        assertEquals("06 " + LMS.get("it resets itself"), line.takeHex());
        assertEquals(9600, lms.getBaud());
        line.pass(10);
        assertEquals(LMS.get("hello of an LMS200 with V02.10"), line.takeHex());
        ask(LMS.get("38400 baud"));
        ask(LMS.get("keep the baud rate"));
        ask(LMS.get("reset"));
        assertEquals(38400, lms.getBaud());
    }

    @Test
    public void powerOnTelegramOfTheRealDevice() {
        power(Variant.V180_1, 9600, false, REAL);
        line.host(LMS.get("reset"));
        line.pass(10);
        assertTrue(line.takeHex().endsWith(LMS.get("hello of the recorded LMS200 with V02.19")));
    }

    @Test
    public void configurationIsReadAndWritten() {
        assertEquals("06 02 80 24 00 F4 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 10 3C FB",
            ask(LMS.get("ask for the configuration")));
        String centimetres = "02 00 23 00 77 00 00 70 00 00 00 00 00 00 02 02" + ZEROS + " 02 00 41 B8";
        assertEquals(NOT_PERMITTED, ask(centimetres));
        assertEquals(MODE_OK, ask(INSTALLATION));
        assertEquals("06 02 80 25 00 F7 01 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 10 C5 7A",
            ask("02 00 23 00 77 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 11 88"));
        assertTrue(ask(centimetres).endsWith("65 1A"));
        assertEquals("06 02 80 24 00 F4 00 00 70 00 00 00 00 00 00 02 02" + ZEROS + " 02 00 10 9C 9B",
            ask(LMS.get("ask for the configuration")));
        assertTrue(ask("02 00 23 00 77 00 00 70 00 00 04 01 00 00 02 02" + ZEROS + " 02 00 94 8A").endsWith("CF 7F"));
        assertTrue(ask(LMS.get("ask for the configuration")).endsWith("36 FE"));
        assertTrue(ask("02 00 23 00 77 00 00 70 00 00 06 01 00 00 02 02" + ZEROS + " 02 00 D4 4B")
            .startsWith("06 02 80 25 00 F7 01"));
        String full = LMS.get("write the configuration of the quick manual, whole");
        assertTrue(ask(full).startsWith("06 02 80 25 00 F7 01 00 00 46"));
        assertTrue(ask(LMS.get("define no field")).startsWith("06 02 80 03 00 FC 01 10"));
        assertEquals(MODE_OK, ask(ON_REQUEST));
    }

    /**
     * CARMEN, ARIA, OpenDLV and scripts for the LMS291 write 32 bytes. The telegrams are from SICK's quick manual and
     * its mode 4.
     */
    @Test
    public void aConfigurationOf32BytesKeepsTheRest() {
        ask(INSTALLATION);
        assertTrue(ask(LMS.get("write the configuration of the quick manual, whole"))
            .startsWith("06 02 80 25 00 F7 01"));
        String answer = ask("02 00 21 00 77 00 00 00 00 00 00 01 00 00 02 02" + ZEROS + " FC 7E");
        assertTrue(answer, answer.startsWith("06 02 80 25 00 F7 01 00 00 00 00 00 00 01 00 00 02 02" + ZEROS
            + " 02 00 10"));
        assertTrue(ask("02 00 21 00 77 00 00 70 00 00 04 01 00 00 02 02" + ZEROS + " 84 72")
            .startsWith("06 02 80 25 00 F7 01 00 00 70 00 00 04"));
        assertTrue(ask(LMS.get("ask for the configuration")).endsWith("36 FE"));
        assertEquals(MODE_OK, ask(ON_REQUEST));
        scanner.world = beam -> beam == 90 ? 11.75 : Double.POSITIVE_INFINITY;
        byte[] scan = Bytes.bytes(ask(LMS.get("ask for a scan")));
        assertEquals(11750, scan[8 + 180] & 0xFF | (scan[8 + 181] & 0xFF) << 8);
        assertEquals("nothing hit in 16 m", 16383, scan[8] & 0xFF | (scan[9] & 0xFF) << 8);
    }

    @Test
    public void otherLengthsOfConfigurationAreRefused() {
        ask(INSTALLATION);
        String before = ask(LMS.get("ask for the configuration"));
        for (int size : new int[] {0, 31, 33, 35}) {
            byte[] payload = new byte[size + 1];
            payload[0] = 0x77;
            String answer = ask(Bytes.hex(new Telegram(0, payload).toBytes()));
            assertTrue(size + ": " + answer, answer.startsWith("06 02 80 25 00 F7 00"));
        }
        assertEquals(before, ask(LMS.get("ask for the configuration")));
    }

    @Test
    public void aWrongPasswordIsRefused() {
        assertEquals("06 " + LMS.get("wrong password"), ask(LMS.get("installation, with a wrong password")));
        assertEquals(MODE_OK, ask(LMS.get("diagnosis, without a password")));
        assertEquals("scans are not for diagnostic mode", NOT_PERMITTED, ask(LMS.get("ask for a scan")));
    }

    @Test
    public void statusIsThatOfTheRealDevice() {
        power(Variant.V180_HALF, 38400, false, REAL);
        ask(INSTALLATION);
        ask("02 00 23 00 77 00 00 70 00 00 04 01 00 00 02 02" + ZEROS + " 02 00 94 8A");
        ask(ON_REQUEST);
        assertEquals("06 " + REAL_STATUS, ask(LMS.get("ask for the status")));
    }

    @Test
    public void scansAreRightToLeftInMillimetres() {
        scanner.world = beam -> beam == 0 ? 0 : beam == 1 ? 0.001 : beam == 2 ? 8.183 : beam == 3 ? 100
            : beam == 4 ? 8.182 : Double.POSITIVE_INFINITY;
        byte[] scan = Bytes.bytes(ask(LMS.get("ask for a scan")));
        assertEquals("06 02 80 6E 01 B0 B5 40 00 00 01 00 F7 1F F7 1F F6 1F FF 1F", Bytes.hex(Arrays.copyOf(scan, 20)));
    }

    @Test
    public void fullFramesAsComputedByHand() {
        scanner.world = beam -> Double.POSITIVE_INFINITY;
        assertTrue(ask(LMS.get("ask for a scan")).endsWith("FF 1F 10 B9 E2"));
        power(Variant.V180_HALF, 9600, false, Identity.LMS200_30106);
        assertTrue(ask(LMS.get("ask for a scan")).endsWith("FF 1F 10 24 3E"));
        scanner.world = beam -> 1;
        assertTrue(ask(LMS.get("ask for a scan")).endsWith("E8 03 10 55 F1"));
        scanner.world = beam -> beam / 1000.0;
        assertTrue(ask(LMS.get("ask for a scan")).endsWith("68 01 10 31 93"));
        centimetres(Variant.V100_1, "60 E9", Double.POSITIVE_INFINITY);
        centimetres(Variant.V180_1, "8C 7E", Double.POSITIVE_INFINITY);
        centimetres(Variant.V100_HALF, "CA AD", Double.POSITIVE_INFINITY);
        centimetres(Variant.V100_QUARTER, "04 B1", Double.POSITIVE_INFINITY);
        centimetres(Variant.V180_1, "A0 F1", 10);
        scanner.world = beam -> beam / 100.0;
        assertTrue(ask(LMS.get("ask for a scan")).endsWith("B4 00 10 D5 D8"));
    }

    private void centimetres(Variant variant, String crc, double metres) {
        power(variant, 9600, false, Identity.LMS200_30106);
        scanner.world = beam -> metres;
        ask(INSTALLATION);
        ask("02 00 23 00 77 00 00 70 00 00 00 00 00 00 02 02" + ZEROS + " 02 00 41 B8");
        ask(ON_REQUEST);
        String answer = ask(LMS.get("ask for a scan"));
        assertTrue(answer, answer.endsWith("10 " + crc));
    }

    @Test
    public void partsOfAScan() {
        scanner.world = beam -> (beam + 1) / 1000.0;
        assertTrue(ask(LMS.get("ask for every second value")).startsWith("06 02 80 BA 00 B0 5B 40 01 00 03 00 05 00"));
        assertTrue(ask(LMS.get("ask for every 20th value")).startsWith("06 02 80 18 00 B0 0A 40 01 00 15 00"));
        assertTrue(ask(LMS.get("ask for the least vertical distance")).startsWith("06 02 80 06 00 B0 01 40"));
        assertTrue(ask(LMS.get("ask for the taught contour")).startsWith("06 02 80 6E 01 B0 B5 40 FF 1F"));
        assertTrue(ask(LMS.get("ask for interlaced scans")).startsWith("06 02 80 6E 01 B0 B5 60 01 00"));
        assertTrue(ask(LMS.get("ask for the mean of 2 scans")).startsWith("06 02 80 6F 01 B6 02 B5 40 01 00"));
        assertEquals("values 1 to 361 are not there with one degree", NOT_PERMITTED,
            ask(LMS.get("ask for values 1 to 361")));
        ask(LMS.get("180 degrees, each half"));
        assertTrue(ask(LMS.get("ask for values 1 to 361"))
            .startsWith("06 02 80 DA 02 B7 01 00 69 01 69 41 01 00 02 00"));
        assertTrue(ask(LMS.get("ask for interlaced scans")).contains(" B0 B4 70 02 00 04 00"));
    }

    @Test
    public void indicesFollowTheValuesIfAskedFor() {
        ask(INSTALLATION);
        ask("02 00 23 00 77 00 00 70 00 07 00 01 00 00 02 02" + ZEROS + " 02 00 DE 4E");
        ask(ON_REQUEST);
        byte[] first = Bytes.bytes(ask(LMS.get("ask for a scan")));
        byte[] second = Bytes.bytes(ask(LMS.get("ask for a scan")));
        assertEquals(375, first.length);
        assertEquals(first[first.length - 4] + 1, second[second.length - 4]);
    }

    @Test
    public void itsOwnAddressWorksBesideTheBroadcast() {
        power(Variant.V180_1, 9600, false, new Identity("LMS200;301063;V02.06 ", "00000000", 1));
        assertEquals("06 " + LMS.get("mode changed, of the device with address 1"), ask(ON_REQUEST));
        line.host(Bytes.hex(new Telegram(1, new byte[] {0x32}).toBytes()));
        line.pass(1);
        assertTrue(line.takeHex().startsWith("06 02 81 02 00 B2 10"));
        line.host(Bytes.hex(new Telegram(2, new byte[] {0x32}).toBytes()));
        line.pass(1);
        assertArrayEquals(new byte[0], line.take());
    }

    @Test
    public void aPauseAbortsATelegramAndTheNextIsAnswered() {
        line.host("02 00 02 00 30");
        line.pass(0.1);
        line.host("01 31 18");
        line.pass(1);
        assertEquals("", line.takeHex());
        assertEquals("06 " + LMS.get("no errors"), ask(LMS.get("ask for errors")));
        assertEquals("06 " + LMS.get("no errors"), ask("02 02 00 03 02 00 01 00 32 16 12"));
        assertEquals(NOT_PERMITTED, ask(Bytes.hex(new Telegram(0, new byte[] {0x55}).toBytes())));
    }

    @Test
    public void answersComeWithinTheListedTimes() {
        for (Baud baud : Baud.values()) {
            power(Variant.V100_QUARTER, baud.getRate(), false, Identity.LMS200_30106);
            line.host(LMS.get("ask for a scan"));
            double end = line.now;
            line.pass(0.2);
            assertTrue("ACK after " + (line.times.get(0) - end), line.times.get(0) - end <= 0.06);
            double wait = line.times.get(1) - line.times.get(0);
            assertTrue("scan after " + wait, wait <= 0.06 + 10.0 / baud.getRate());
        }
    }

    @Test
    public void thePowerSwitchEndsAStreamAt500000Baud() {
        assertEquals(MODE_OK, ask(LMS.get("500000 baud")));
        line.host(LMS.get("stream all scans"));
        line.pass(1);
        assertEquals(500000, lms.getBaud());
        lms.powerOff();
        line.now += 100;
        line.clearOutput();
        line.take();
        lms.powerOn(line.now);
        assertEquals(9600, lms.getBaud());
        line.host(LMS.get("ask for the status"));
        line.pass(4.9);
        assertEquals("it starts", "", line.takeHex());
        line.pass(0.2);
        assertEquals(LMS.get("hello of an LMS200 with V02.10"), line.takeHex());
        line.pass(5);
        assertEquals("no stream", "", line.takeHex());
        assertTrue(ask(LMS.get("ask for a scan")).startsWith("06 02 80 6E 01 B0"));
    }

    @Test
    public void withoutPowerAnLms200ForgetsTheVariantButNoConfigurationAndPermanentBaudRate() {
        ask(LMS.get("38400 baud"));
        ask(LMS.get("keep the baud rate"));
        ask(LMS.get("100 degrees, each"));
        ask(INSTALLATION);
        ask("02 00 23 00 77 00 00 70 00 00 04 01 00 00 02 02" + ZEROS + " 02 00 94 8A");
        lms.powerOff();
        lms.powerOn(line.now);
        line.pass(6);
        assertEquals(38400, lms.getBaud());
        assertTrue(ask(LMS.get("ask for the configuration")).startsWith("06 02 80 24 00 F4 00 00 70 00 00 04 01"));
        assertTrue("180 degrees", ask(LMS.get("ask for a scan")).startsWith("06 02 80 6E 01 B0"));
    }

    /** A driver restarts in mid-stream: at every moment it gets its ACK in time, and whole telegrams afterwards. */
    @Test
    public void aScanOnTheLineDoesNotDelayAnAck() {
        for (int phase = 0; phase < 40; phase++) {
            power(Variant.V180_HALF, 38400, false, Identity.LMS200_30106);
            line.host(LMS.get("stream all scans"));
            line.pass(1 + phase * 0.0073);
            line.host(ON_REQUEST);
            line.pass(0.05);
            byte[] sent = line.take();
            assertEquals("phase " + phase, Telegram.ACK, sent[sent.length - 1]);
            line.pass(1);
            assertEquals("phase " + phase, MODE_OK.substring(3), line.takeHex());
            assertTrue(ask(LMS.get("ask for the status")).startsWith("06 02 80 9A 00 B1"));
        }
    }

    @Test
    public void anAnsweredScanIsNeverAborted() {
        power(Variant.V180_HALF, 38400, false, Identity.LMS200_30106);
        line.host(LMS.get("ask for a scan"));
        line.pass(0.1);
        line.host(LMS.get("ask for the status"));
        line.pass(1);
        String all = line.takeHex();
        assertTrue(all, all.startsWith("06 02 80 D6 02 B0"));
        assertEquals("both replies whole", 3 * (1 + 733 + 161) - 1 - 3, all.length());
    }

    @Test
    public void aStreamContinuesAfterAQuery() {
        power(Variant.V180_HALF, 38400, false, Identity.LMS200_30106);
        line.host(LMS.get("stream all scans"));
        line.pass(1);
        line.host(LMS.get("ask for the status"));
        line.pass(0.2);
        line.take();
        line.pass(2);
        assertTrue("about 4.7 a second", line.take().length > 8 * 732);
    }
}
