// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Random;
import java.util.function.Function;
import org.SEAR.Bytes;
import org.SEAR.Fuzz;
import org.SEAR.Slow;
import org.SEAR.devices.gps.GpsModel;
import org.SEAR.devices.gps.Mt3301;
import org.SEAR.devices.gps.NeoM8n;
import org.SEAR.devices.imu.Hmc6352;
import org.SEAR.devices.imu.Razor;
import org.SEAR.devices.lms.Devices;
import org.SEAR.devices.oi.OiModel;
import org.SEAR.devices.oi.RoombaFirmware;
import org.SEAR.devices.rplidar.RplidarA1;
import org.SEAR.devices.scip.Hokuyo;
import org.SEAR.protocol.lidar.LidarModel;
import org.SEAR.protocol.scip.HokuyoModel;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;
import org.SEAR.sensors.GpsFix;
import org.SEAR.sensors.ImuReading;
import org.SEAR.sensors.Quantity;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Random bytes with whole commands among them never stop a device; {@link Fuzz} has their number. */
@Category(Slow.class)
public class FuzzTest {
    /** Limit of warnings: each command of a device warns once for each of a few causes. */
    private static final int MOST_WARNINGS = 200;
    private static final int BLOCK = 1000;
    private static final double MAX_SECONDS_BEHIND = 30;

    /**
     * Feeds random bytes in which those that begin or fill the device's commands are frequent.
     * @param flush ends any unfinished command; null for power off and on
     */
    private void fuzz(Function<FakeContext, SerialDevice> maker, int[] likely, String flush, String probe,
        String answer) {
        Random random = new Random(Fuzz.SEED);
        FakeContext line = new FakeContext();
        line.reading = new GpsFix(1, 2, 3, 0, 0, 0);
        SerialDevice device = line.attach(maker.apply(line));
        for (int done = 0; done < Fuzz.BYTES; done += BLOCK) {
            for (int i = 0; i < BLOCK; i++) {
                line.host(random.nextInt(3) == 0 ? likely[random.nextInt(likely.length)] : random.nextInt(256));
            }
            line.pass(random.nextDouble() * 0.05);
            line.take();
            String where = "seed " + Fuzz.SEED + " after " + done + " bytes, " + device.status();
            assertTrue(where + ": output queue", (line.lineFreeAt() - line.now) < MAX_SECONDS_BEHIND);
            if (done % (BLOCK * 50) == 0) {
                if (flush == null) {
                    line.restart();
                } else {
                    line.host(flush);
                    line.pass(MAX_SECONDS_BEHIND);
                    line.take();
                }
                line.host(probe);
                line.pass(3);
                assertTrue(where + ": " + probe, line.takeHex().contains(answer));
            }
        }
        assertTrue("warnings: " + line.warnings.size(), line.warnings.size() < MOST_WARNINGS);
    }

    @Test
    public void lms200() {
        fuzz(Devices::lms200, Bytes.ints("02 00 02 00 05 20 24 25 30 01 3B 77 26 36 37"), null, "02 00 01 00 32 16 12",
            "06 02 80 02 00 B2 10 3F 13");
    }

    @Test
    public void lms200AnswersWithoutPowerOff() {
        Random random = new Random(Fuzz.SEED);
        FakeContext line = new FakeContext();
        SerialDevice device = line.attach(Devices.lms200(line));
        for (int round = 0; round < 200; round++) {
            for (int i = 0; i < 300; i++) {
                line.host(random.nextInt(256));
            }
            line.pass(0.1);
            line.take();
            line.host("02 00 01 00 32 16 12");
            line.pass(1);
            assertTrue("seed " + Fuzz.SEED + " round " + round + " " + device.status(), line.takeHex()
                .contains("06 02 80 02 00 B2 10 3F 13"));
        }
    }

    @Test
    public void scannersWithCola() {
        for (LidarModel model : new LidarModel[] {LidarModel.LMS111, LidarModel.TIM561}) {
            int[] likely = Bytes.ints("02 02 02 02 03 00 00 09 73 52 4E 20 53 54 6C 6D 73 3A");
            fuzz(line -> org.SEAR.devices.cola.Devices.scanner(model, line), likely, null,
                "02 02 02 02 00 00 00 07 73 4D 4E 20 52 75 6E 19", "73 41 4E 20 52 75 6E 20 01");
        }
    }

    /** Whole requests with random values, which random bytes hardly ever form. */
    @Test
    public void requestsOfColaWithRandomValues() {
        Random random = new Random(Fuzz.SEED);
        String[] requests = {"sMN SetAccessMode 3 F4724744", "sMN mLMPsetscancfg", "sWN LMPoutputRange 1",
            "sWN LMDscandatacfg 1 0 0 1 0 0 0 0 0 0",
            "sRN LMDscandata", "sEN LMDscandata", "sMN LMCstartmeas", "sMN LMCstandby", "sWN LocationName", "sRN STlms",
                "sMN mEEwriteall"};
        String[] values = {"0", "1", "+1", "1388", "9C4", "+2500", "-450000", "FFF92230", "225510", "DBBA0", "FFFFFFFF",
            "+99999", "x", "3"};
        FakeContext line = new FakeContext();
        SerialDevice device = line.attach(org.SEAR.devices.cola.Devices.scanner(LidarModel.LMS111, line));
        for (int i = 0; i < Fuzz.BYTES / 100; i++) {
            StringBuilder text = new StringBuilder(requests[random.nextInt(requests.length)]);
            for (int more = random.nextInt(6); more > 0; more--) {
                text.append(' ').append(values[random.nextInt(values.length)]);
            }
            line.hostText("\u0002" + text + "\u0003");
            line.pass(0.002);
            assertTrue("seed " + Fuzz.SEED + ", " + text + " at " + device.status(), line.take().length > 0);
        }
    }

    @Test
    public void hokuyos() {
        for (HokuyoModel model : HokuyoModel.values()) {
            fuzz(line -> hokuyo(model, line),
                Bytes.ints("0A 0A 4D 44 47 53 30 30 30 34 34 37 32 35 31 42 4D 56 50 49 51 54 52 43 48 0D 3B"), null,
                Bytes.hex("\nBM\n".getBytes(StandardCharsets.US_ASCII)), "42 4D 0A 30 30 50 0A 0A");
        }
    }

    @Test
    public void rplidar() {
        fuzz(line -> {
            scanner(line);
            return new RplidarA1(1, 0.15, line);
        }, Bytes.ints("A5 A5 A5 20 21 25 40 50 52 59 82 05 00 22 F0 02"), null, "A5 52",
            "A5 5A 03 00 00 00 06 00 00 00");
    }

    private static void scanner(FakeContext line) {
        FakeScanner scanner = new FakeScanner();
        scanner.world = beam -> 1 + beam / 100.0;
        line.sensor = scanner;
    }

    private static SerialDevice hokuyo(HokuyoModel model, FakeContext line) {
        scanner(line);
        return new Hokuyo(model, model.isUsbOnly() ? HokuyoModel.USB : 115200, line);
    }

    @Test
    public void roombas() {
        for (OiModel model : OiModel.values()) {
            String flush = model == OiModel.CREATE ? null : new String(new char[600]).replace("\0", "80");
            fuzz(line -> new RoombaFirmware(model, 57600, true, line),
                Bytes.ints("80 82 83 84 89 8E 94 95 98 99 9B 9C 9E 8C 8D 01 00 07"), flush, "80 8E 03", " 0A 8E");
        }
    }

    @Test
    public void mt3301() {
        fuzz(line -> new Mt3301(GpsModel.MT3301, 38400, 1, 0, line),
            Bytes.ints("24 50 4D 54 4B 32 30 31 34 2C 2A 0D 0A"),
            "0D 0A", Bytes.hex("$PMTK000*32\r\n".getBytes(StandardCharsets.US_ASCII)),
                "50 4D 54 4B 30 30 31 2C 30 2C 33");
    }

    /**
     * Whole frames are rare among random bytes. A frame may silence the device, so the test switches the power off
     * before the probe.
     */
    @Test
    public void neoM8n() {
        fuzz(line -> new NeoM8n(9600, 1, 0, line), Bytes.ints("B5 62 06 01 00 08 09 04 0A F0 07 03 14"), null,
            "B5 62 0A 04 00 00 0E 34", "B5 62 0A 04 FA 00");
    }

    /** Whole frames with random payloads. */
    @Test
    public void neoM8nInWholeFrames() {
        Random random = new Random(Fuzz.SEED);
        FakeContext line = new FakeContext();
        line.reading = new GpsFix(1, 2, 3, 0, 0, 0);
        NeoM8n device = line.attach(new NeoM8n(9600, 1, 0, line));
        UbxMessage[] messages = UbxMessage.values();
        for (int bytes = 0; bytes < Fuzz.BYTES / 4; bytes += 20) {
            byte[] payload = new byte[new int[] {0, 1, 2, 3, 4, 6, 8, 12, 13, 20}[random.nextInt(10)]];
            random.nextBytes(payload);
            if (payload.length > 0 && random.nextBoolean()) {
                payload[0] = 1;
            }
            for (byte each : new UbxFrame(messages[random.nextInt(messages.length)], payload).toBytes()) {
                line.host(each & 0xFF);
            }
            line.take();
            if (bytes % 50000 == 0) {
                line.restart();
                line.host("B5 62 0A 04 00 00 0E 34");
                assertTrue("seed " + Fuzz.SEED + " " + device.status(), line.takeHex().contains("B5 62 0A 04 FA 00"));
            }
        }
    }

    @Test
    public void hmc6352() {
        fuzz(line -> {
            line.reading = new Quantity(90);
            return new Hmc6352(9600, line);
        }, Bytes.ints("41 53 57 43 45 4C 47 67 77 72 8E 2F 74"), null, "41", "03 84");
    }

    @Test
    public void arduinos() {
        for (boolean firmata : new boolean[] {true, false}) {
            int[] likely = Bytes.ints(firmata ? "F0 F7 F4 E0 90 C0 D0 75 61 6B 79 6F 70 7A F9 00 01 04 03"
                : "AA AA AA 02 03 04 1E 1A 1B 23 2F 30 29 04 0A 01");
            fuzz(line -> org.SEAR.devices.arduino.Devices.uno(firmata, line), likely, null, firmata ? "F9" : "AA 01 02",
                firmata ? "F9 02 05" : "AA 02 09 02");
        }
    }

    @Test
    public void razor() {
        fuzz(line -> {
            line.reading = new ImuReading(new double[3], new double[3], new double[3], new double[3]);
            return new Razor(57600, line);
        }, Bytes.ints("23 6F 73 62 74 72 63 30 31 66 6E 65 78 6F 23"), null, "23 73 41 42",
            "23 53 59 4E 43 48 41 42 0D 0A");
    }
}
