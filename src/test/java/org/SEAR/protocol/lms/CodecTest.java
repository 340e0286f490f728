// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import org.SEAR.Bytes;
import org.SEAR.Golden;
import org.junit.Test;

/** Payloads and codes of the LMS2xx, as printed in SICK's telegram listing. */
public class CodecTest {
    private static final Golden LMS = Golden.of("lms200");
    private static final String ZEROS = " 00".repeat(21);

    private static void request(String frame, LmsPayload payload) {
        assertEquals(frame, Bytes.hex(Telegram.request(payload).toBytes()));
    }

    private static void reply(String frame, LmsPayload payload) {
        assertEquals(frame, Bytes.hex(new Telegram(Integer.parseInt(frame.substring(3, 5), 16), payload.toBytes())
            .toBytes()));
    }

    @Test
    public void requestsAreThoseOfTheListing() {
        request(LMS.get("reset"), LmsCommand.RESET.request());
        request(LMS.get("ask for the status"), LmsCommand.STATUS.request());
        request(LMS.get("ask for errors"), LmsCommand.ERRORS.request());
        request(LMS.get("ask for the type"), LmsCommand.TYPE.request());
        request(LMS.get("ask for the configuration"), LmsCommand.GET_CONFIGURATION.request());
        request(LMS.get("stream all scans"), LmsCommand.MODE.request().add(OperatingMode.STREAM_ALL));
        request(LMS.get("scans on request"), LmsCommand.MODE.request().add(OperatingMode.ON_REQUEST));
        request(LMS.get("stream partial scans"), LmsCommand.MODE.request().add(OperatingMode.STREAM_PARTIAL));
        request(LMS.get("diagnosis, without a password"), LmsCommand.MODE.request().add(OperatingMode.DIAGNOSTIC));
        request(LMS.get("stream means of 5 scans"), LmsCommand.MODE.request().add(OperatingMode.STREAM_MEAN).add(5));
        request(LMS.get("stream values 27 to 299"), LmsCommand.MODE.request().add(OperatingMode.STREAM_RANGE).word(27)
            .word(299));
        request(LMS.get("installation, with the password SICK_LMS"),
            LmsCommand.MODE.request().add(OperatingMode.INSTALLATION).text(OperatingMode.PASSWORD));
        request(LMS.get("ask for a scan"), LmsCommand.SCAN.request().add(1));
        request(LMS.get("ask for the mean of 2 scans"), LmsCommand.MEAN.request().add(2));
        request(LMS.get("ask for values 1 to 361"), LmsCommand.RANGE.request().word(1).word(361));
        request(LMS.get("keep the baud rate"), LmsCommand.PERMANENT_BAUD.request().add(1));
        request(LMS.get("define no field"), LmsCommand.PIXELS.request().word(0).word(0));
    }

    @Test
    public void repliesAreThoseOfTheListingAndOfARealDevice() {
        reply(LMS.get("it resets itself"), LmsCommand.RESET.reply().add(StatusByte.OK));
        reply(LMS.get("hello of an LMS200 with V02.10"),
            new LmsPayload(LmsCommand.POWER_ON).text("LMS200;301063;V02.10 ").add(StatusByte.OK));
        reply(LMS.get("mode changed"), LmsCommand.MODE.reply().add(0).add(StatusByte.OK));
        reply(LMS.get("mode changed, of the device with address 1"), LmsCommand.MODE.reply().add(0).add(StatusByte.OK));
        reply(LMS.get("mode not changed"), LmsCommand.MODE.reply().add(2).add(StatusByte.OK));
        reply(LMS.get("not permitted"), new LmsPayload(LmsCommand.NOT_PERMITTED).add(StatusByte.OK));
        reply(LMS.get("no errors"), LmsCommand.ERRORS.reply().add(StatusByte.OK));
        reply(LMS.get("type of the recorded LMS200 with V02.19"),
            LmsCommand.TYPE.reply().text("LMS200;S18063;V02.19 ").add(StatusByte.OK));
        reply(LMS.get("the baud rate is kept"), LmsCommand.PERMANENT_BAUD.reply().word(1).add(StatusByte.OK));
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
        String[] frames = {LMS.get("9600 baud"), LMS.get("19200 baud"), LMS.get("38400 baud"), LMS.get("500000 baud")};
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
        String[] frames = {LMS.get("100 degrees, each"), LMS.get("100 degrees, each half"),
            LMS.get("100 degrees, each quarter"), LMS.get("180 degrees, each"), LMS.get("180 degrees, each half")};
        String[] replies = {LMS.get("100 degrees, each: done"), LMS.get("100 degrees, each half: done"),
            LMS.get("100 degrees, each quarter: done"), LMS.get("180 degrees, each: done"),
                LMS.get("180 degrees, each half: done")};
        for (Variant variant : Variant.values()) {
            request(frames[variant.ordinal()], LmsCommand.VARIANT.request().word(variant.getSpread())
                .word(variant.getResolution()));
            reply(replies[variant.ordinal()], LmsCommand.VARIANT.reply().add(1).word(variant.getSpread())
                .word(variant.getResolution()).add(StatusByte.OK));
            assertEquals(variant, Variant.of(variant.getSpread(), variant.getResolution()));
            assertEquals(variant, Variant.ofDegrees(variant.getSpread(), variant.getResolution() / 100.0));
        }
        assertNull("not offered by an LMS200", Variant.of(180, 25));
        assertNull(Variant.ofDegrees(180, 0.25));
    }

    @Test
    public void configurationsAreThoseOfTheListing() {
        Configuration millimetres = Configuration.ofFactory();
        request("02 00 23 00 77 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 11 88",
            LmsCommand.SET_CONFIGURATION.request().bytes(millimetres.toBytes()));
        request("02 00 23 00 77 00 00 70 00 00 00 00 00 00 02 02" + ZEROS + " 02 00 41 B8",
            LmsCommand.SET_CONFIGURATION.request().bytes(millimetres.withMillimetres(false).toBytes()));
        reply("02 80 24 00 F4 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 10 3C FB",
            LmsCommand.GET_CONFIGURATION.reply().bytes(millimetres.toBytes()).add(StatusByte.OK));
        reply("02 80 25 00 F7 01 00 00 70 00 00 00 01 00 00 02 02" + ZEROS + " 02 00 10 C5 7A",
            LmsCommand.SET_CONFIGURATION.reply().add(1).bytes(millimetres.toBytes()).add(StatusByte.OK));
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
    public void aShortConfigurationIsInvalid() {
        Configuration.of(new Telegram(0x80, new byte[20]), 1);
    }

    @Test
    public void theCountWordHasNumberUnitAndPart() {
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
        int[][] modes = {{0, 8191, 8183}, {1, 8191, 8183}, {2, 8191, 8183}, {3, 16383, 16375}, {4, 16383, 16375},
            {5, 32767, 32759},
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
