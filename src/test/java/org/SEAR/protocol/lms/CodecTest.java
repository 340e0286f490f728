package org.SEAR.protocol.lms;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import org.SEAR.Bytes;
import org.junit.Test;

/** Payloads and codes of the LMS2xx as SICK's telegram listing prints them. */
public class CodecTest {
    private static final String ZEROS = " 00".repeat(21);

    private static void request(String frame, LmsPayload payload) {
        assertEquals(frame, Bytes.hex(Telegram.request(payload).toBytes()));
    }

    private static void reply(String frame, LmsPayload payload) {
        assertEquals(frame, Bytes.hex(new Telegram(Integer.parseInt(frame.substring(3, 5), 16), payload.toBytes()).toBytes()));
    }

    @Test
    public void requestsAreThoseOfTheListing() {
        request("02 00 01 00 10 34 12", LmsCommand.RESET.request());
        request("02 00 01 00 31 15 12", LmsCommand.STATUS.request());
        request("02 00 01 00 32 16 12", LmsCommand.ERRORS.request());
        request("02 00 01 00 3A 1E 12", LmsCommand.TYPE.request());
        request("02 00 01 00 74 50 12", LmsCommand.GET_CONFIGURATION.request());
        request("02 00 02 00 20 24 34 08", LmsCommand.MODE.request().add(OperatingMode.STREAM_ALL));
        request("02 00 02 00 20 25 35 08", LmsCommand.MODE.request().add(OperatingMode.ON_REQUEST));
        request("02 00 02 00 20 2A 3A 08", LmsCommand.MODE.request().add(OperatingMode.STREAM_PARTIAL));
        request("02 00 02 00 20 10 00 08", LmsCommand.MODE.request().add(OperatingMode.DIAGNOSTIC));
        request("02 00 03 00 20 26 05 79 3E", LmsCommand.MODE.request().add(OperatingMode.STREAM_MEAN).add(5));
        request("02 00 06 00 20 27 1B 00 2B 01 FF FE", LmsCommand.MODE.request().add(OperatingMode.STREAM_RANGE).word(27).word(299));
        request("02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5",
            LmsCommand.MODE.request().add(OperatingMode.INSTALLATION).text(OperatingMode.PASSWORD));
        request("02 00 02 00 30 01 31 18", LmsCommand.SCAN.request().add(1));
        request("02 00 02 00 36 02 3E 1E", LmsCommand.MEAN.request().add(2));
        request("02 00 05 00 37 01 00 69 01 EB 75", LmsCommand.RANGE.request().word(1).word(361));
        request("02 00 02 00 66 01 9D 4E", LmsCommand.PERMANENT_BAUD.request().add(1));
        request("02 00 05 00 7C 00 00 00 00 8F C4", LmsCommand.PIXELS.request().word(0).word(0));
    }

    @Test
    public void repliesAreThoseOfTheListingAndOfARealDevice() {
        reply("02 80 02 00 91 10 79 30", LmsCommand.RESET.reply().add(StatusByte.OK));
        reply("02 80 17 00 90 4C 4D 53 32 30 30 3B 33 30 31 30 36 33 3B 56 30 32 2E 31 30 20 10 63 5E",
            new LmsPayload(LmsCommand.POWER_ON).text("LMS200;301063;V02.10 ").add(StatusByte.OK));
        reply("02 80 03 00 A0 00 10 16 0A", LmsCommand.MODE.reply().add(0).add(StatusByte.OK));
        reply("02 81 03 00 A0 00 10 36 1A", LmsCommand.MODE.reply().add(0).add(StatusByte.OK));
        reply("02 80 03 00 A0 02 10 12 08", LmsCommand.MODE.reply().add(2).add(StatusByte.OK));
        reply("02 80 02 00 92 10 7F 33", new LmsPayload(LmsCommand.NOT_PERMITTED).add(StatusByte.OK));
        reply("02 80 02 00 B2 10 3F 13", LmsCommand.ERRORS.reply().add(StatusByte.OK));
        reply("02 80 17 00 BA 4C 4D 53 32 30 30 3B 53 31 38 30 36 33 3B 56 30 32 2E 31 39 20 10 85 6A",
            LmsCommand.TYPE.reply().text("LMS200;S18063;V02.19 ").add(StatusByte.OK));
        reply("02 80 04 00 E6 01 00 10 CD FC", LmsCommand.PERMANENT_BAUD.reply().word(1).add(StatusByte.OK));
    }

    @Test
    public void eachCommandIsFoundByItsByte() {
        for (LmsCommand command : LmsCommand.values()) {
            assertEquals(command, LmsCommand.of(command.getCode()));
        }
        assertNull(LmsCommand.of(0x55));
        assertEquals(0x91, LmsCommand.RESET.getReply());
        assertEquals(0xF7, LmsCommand.SET_CONFIGURATION.getReply());
    }

    @Test
    public void speedsHaveTheirTelegramsAndTheirStatusWords() {
        String[] frames = {"02 00 02 00 20 42 52 08", "02 00 02 00 20 41 51 08", "02 00 02 00 20 40 50 08", "02 00 02 00 20 48 58 08"};
        int[] rates = {9600, 19200, 38400, 500000};
        int[] words = {0x8067, 0x8033, 0x8019, 0x8001};
        for (int i = 0; i < rates.length; i++) {
            Baud baud = Baud.ofRate(rates[i]);
            request(frames[i], LmsCommand.MODE.request().add(baud.getMode()));
            assertEquals(baud, Baud.ofMode(baud.getMode()));
            assertEquals(words[i], baud.getStatusWord());
            assertEquals(rates[(i + 1) % rates.length], Baud.after(rates[i]).getRate());
        }
        assertNull(Baud.ofRate(57600));
        assertNull(Baud.ofMode(OperatingMode.ON_REQUEST));
        assertEquals(Baud.B9600, Baud.after(57600));
    }

    @Test
    public void variantsHaveTheirTelegrams() {
        String[] frames = {"02 00 05 00 3B 64 00 64 00 1D 0F", "02 00 05 00 3B 64 00 32 00 B1 59", "02 00 05 00 3B 64 00 19 00 E7 72",
            "02 00 05 00 3B B4 00 64 00 97 49", "02 00 05 00 3B B4 00 32 00 3B 1F"};
        String[] replies = {"02 80 07 00 BB 01 64 00 64 00 10 4F BD", "02 80 07 00 BB 01 64 00 32 00 10 17 10",
            "02 80 07 00 BB 01 64 00 19 00 10 BB 46", "02 80 07 00 BB 01 B4 00 64 00 10 5B 30", "02 80 07 00 BB 01 B4 00 32 00 10 03 9D"};
        for (Variant variant : Variant.values()) {
            request(frames[variant.ordinal()], LmsCommand.VARIANT.request().word(variant.getSpread()).word(variant.getResolution()));
            reply(replies[variant.ordinal()], LmsCommand.VARIANT.reply().add(1).word(variant.getSpread()).word(variant.getResolution())
                .add(StatusByte.OK));
            assertEquals(variant, Variant.of(variant.getSpread(), variant.getResolution()));
            assertEquals(variant, Variant.ofDegrees(variant.getSpread(), variant.getResolution() / 100.0));
        }
        assertNull("not offered by an LMS200", Variant.of(180, 25));
        assertNull(Variant.ofDegrees(180, 0.25));
    }

    @Test
    public void configurationsAreThoseOfTheListing() {
        Configuration millimetres = Configuration.ofFactory();
        request("02 00 23 00 77 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 11 88", LmsCommand.SET_CONFIGURATION.request()
            .bytes(millimetres.toBytes()));
        request("02 00 23 00 77 00 00 70 00 00 00 00 00 00 02 02" + ZEROS + " 02 00 41 B8", LmsCommand.SET_CONFIGURATION.request()
            .bytes(millimetres.withMillimetres(false).toBytes()));
        reply("02 80 24 00 F4 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 10 3C FB", LmsCommand.GET_CONFIGURATION.reply()
            .bytes(millimetres.toBytes()).add(StatusByte.OK));
        reply("02 80 25 00 F7 01 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 10 C5 7A", LmsCommand.SET_CONFIGURATION.reply().add(1)
            .bytes(millimetres.toBytes()).add(StatusByte.OK));
        assertEquals(1000, millimetres.getUnitsPerMetre());
        assertEquals(100, millimetres.withMillimetres(false).getUnitsPerMetre());
    }

    @Test
    public void aConfigurationIsReadAsItIsWritten() {
        byte[] frame = Bytes.bytes("F4 00 00 70 00 07 04 01 00 00 02 02" + ZEROS + " 02 00 10");
        Configuration read = Configuration.of(new Telegram(0x80, frame), 1);
        assertTrue(read.isLegal());
        assertTrue(read.isMillimetres());
        assertTrue(read.isSendingIndices());
        assertEquals(MeasuringMode.FIELDS_16_A_B, read.getMode());
        assertArrayEquals(Arrays.copyOfRange(frame, 1, 35), read.toBytes());
        frame[6] = 0x3F;
        assertFalse("reflectivity instead of distances", Configuration.of(new Telegram(0x80, frame), 1).isLegal());
    }

    @Test(expected = IllegalArgumentException.class)
    public void aShortConfigurationIsNone() {
        Configuration.of(new Telegram(0x80, new byte[20]), 1);
    }

    @Test
    public void theCountWordTellsNumberUnitAndPart() {
        assertEquals(0x00B5, CountWord.whole(181, 0).toWord());
        assertEquals(0x4169, CountWord.whole(361, 1).toWord());
        assertEquals(0x70B4, CountWord.partial(180, 1, 2).toWord());
        CountWord read = CountWord.of(0x70B4);
        assertEquals(180, read.getCount());
        assertEquals(1, read.getUnit());
        assertEquals(2, read.getQuarter());
    }

    @Test
    public void measuringModesHaveTheirBitsAndTheirOverflows() {
        int[][] modes = {{0, 8191, 8183}, {1, 8191, 8183}, {2, 8191, 8183}, {3, 16383, 16375}, {4, 16383, 16375}, {5, 32767, 32759},
            {6, 32767, 32759}, {0x0F, 32767, 32759}};
        for (int[] row : modes) {
            MeasuringMode mode = MeasuringMode.of(row[0]);
            assertEquals(row[0], mode.getCode());
            assertEquals(row[1], mode.encode(Double.POSITIVE_INFINITY, 1000));
            assertEquals(row[2], mode.encode(79, 1000));
            assertEquals(row[2] - 1, mode.encode((row[2] - 1) / 1000.0, 1000));
            assertEquals(1235, mode.encode(1.2346, 1000));
            assertEquals(123, mode.encode(1.2346, 100));
            assertEquals(row[1], mode.getDistance(0xFFFF));
            assertEquals(1235, mode.getDistance(1235 | row[1] + 1));
        }
        assertNull(MeasuringMode.of(0x3F));
    }

    @Test
    public void operatingModesThatSendByThemselvesAreKnown() {
        assertTrue(OperatingMode.isStream(OperatingMode.STREAM_ALL));
        assertTrue(OperatingMode.isStream(OperatingMode.STREAM_PARTIAL));
        assertFalse(OperatingMode.isStream(OperatingMode.ON_REQUEST));
        assertFalse(OperatingMode.isStream(OperatingMode.INSTALLATION));
        assertFalse(OperatingMode.isStream(OperatingMode.DIAGNOSTIC));
    }

    @Test
    public void statusBytesOfARealDeviceAreNoErrors() {
        assertFalse(StatusByte.isError(0x10));
        assertFalse(StatusByte.isError(0x11));
        assertTrue(StatusByte.isError(0x13));
        assertTrue(StatusByte.isPolluted(0x90));
        assertFalse(StatusByte.isPolluted(0x10));
    }
}
