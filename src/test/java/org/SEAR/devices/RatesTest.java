// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Function;
import org.SEAR.Bytes;
import org.SEAR.devices.gps.GpsModel;
import org.SEAR.devices.gps.Mt3301;
import org.SEAR.devices.gps.NeoM8n;
import org.SEAR.devices.imu.Razor;
import org.SEAR.devices.oi.OiModel;
import org.SEAR.devices.oi.RoombaFirmware;
import org.SEAR.devices.rplidar.RplidarA1;
import org.SEAR.devices.scip.Hokuyo;
import org.SEAR.protocol.lidar.LidarModel;
import org.SEAR.protocol.scip.HokuyoModel;
import org.SEAR.sensors.GpsFix;
import org.SEAR.sensors.ImuReading;
import org.SEAR.simulator.Simulation;
import org.junit.Test;

/** Over 100 s each device sends at the rate of its data sheet or command, and never by more than a step off. */
public class RatesTest {
    private static final double SECONDS = 100;
    private static final double TOLERANCE = 0.001;

    /** @param commands hexadecimal, or text in quotes */
    private static void check(double hertz, Function<FakeContext, SerialDevice> maker, String... commands) {
        FakeContext line = new FakeContext();
        FakeScanner scanner = new FakeScanner();
        scanner.world = beam -> 1;
        line.sensor = scanner;
        SerialDevice device = line.attach(maker.apply(line));
        line.pass(1);
        for (String command : commands) {
            line.host(command.startsWith("'")
                ? Bytes.hex(command.substring(1).getBytes(StandardCharsets.ISO_8859_1)) : command);
            line.pass(0.5);
        }
        line.pass(1);
        line.take();
        line.pass(SECONDS);
        List<Double> times = line.messages;
        String name = device.title() + " at " + hertz + " Hz: ";
        assertTrue(name + times.size(), times.size() > 2);
        int last = times.size() - 1;
        double period = (times.get(last) - times.get(0)) / last;
        assertEquals(name + "mean", 1 / hertz, period, TOLERANCE / hertz);
        for (int i = 0; i <= last; i++) {
            assertEquals(name + "message " + i, times.get(0) + i * period, times.get(i), Simulation.STEP);
        }
    }

    private static GpsFix fix() {
        return new GpsFix(33.61, -80.865, 182.5, 0, 0, FakeContext.EPOCH);
    }

    /** A receiver's interval is a whole number of milliseconds. */
    @Test
    public void receivers() {
        for (double hertz : new double[] {0.3, 1, 3, 4.9, 5}) {
            check(1000.0 / Math.round(1000 / hertz), line -> {
                line.reading = fix();
                return new Mt3301(GpsModel.MT3301, 115200, hertz, 0, line);
            });
            check(1000.0 / Math.round(1000 / hertz), line -> {
                line.reading = fix();
                return new NeoM8n(115200, hertz, 0, line);
            });
        }
    }

    @Test
    public void robotsAndUnits() {
        check(1 / 0.015, line -> new RoombaFirmware(OiModel.CREATE, 57600, true, line), "80 94 01 07");
        check(50, line -> {
            line.reading = new ImuReading(new double[] {1, 2, 3}, new double[3], new double[3], new double[] {1, 0, 0});
            return new Razor(57600, line);
        });
    }

    @Test
    public void scanners() {
        check(1 / (2 * 0.01332), org.SEAR.devices.lms.Devices::lms200,
            "02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5", "02 00 02 00 20 48 58 08", "02 00 02 00 20 24 34 08");
        check(10, line -> new Hokuyo(HokuyoModel.URG_04LX, HokuyoModel.USB, line), "'MD0044072501000\n");
        check(10.0 / 3, line -> new Hokuyo(HokuyoModel.URG_04LX, HokuyoModel.USB, line), "'MD0044072501200\n");
        check(40, line -> new Hokuyo(HokuyoModel.UTM_30LX, HokuyoModel.USB, line), "'MD0000108001000\n");
        check(125, line -> new RplidarA1(1, 0.15, line), "A5 20");
        check(50, line -> org.SEAR.devices.cola.Devices.scanner(LidarModel.LMS111, line),
            "'\u0002sEN LMDscandata 1\u0003");
        check(15, line -> org.SEAR.devices.cola.Devices.scanner(LidarModel.TIM561, line),
            "'\u0002sEN LMDscandata 1\u0003");
    }

    /** MrlComm reads a pin when more than the whole milliseconds of a period have passed, as its source has it. */
    @Test
    public void boards() {
        check(1 / 0.019, line -> org.SEAR.devices.arduino.Devices.uno(true, line), "C0 01 F4 0E 02");
        for (int millis : new int[] {1, 7, 10, 100}) {
            check(1000.0 / millis, line -> org.SEAR.devices.arduino.Devices.uno(true, line),
                String.format("C0 01 F4 0E 02 F0 7A %02X %02X F7", millis & 0x7F, millis >> 7));
        }
    }
}
