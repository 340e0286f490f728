// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.IMU;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.Serial;
import org.myrobotlab.service.ServiceFolder;

/** A compass and an inertial measurement unit at their ports on a rotated robot, as used by services and programs. */
public class AttitudePortsTest {
    private static final String COMPASS_PORT = "/dev/SEAR_Compass_01";
    private static final String IMU_PORT = "/dev/SEAR_IMU_01";
    private static final int TRIES = 200;

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();
    private SEAR sear;

    @Before
    public void start() {
        new Floor("floor", 20, 20);
        SEARrobot robot = Robots.create2("create");
        robot.rotate(0, 33, 0);
        robot.addComponent(new GPS("receiver", 35.3, 200, -80.7));
        Compass compass = new Compass("north", true);
        compass.setPorts("/dev/my_Compass_01", COMPASS_PORT);
        robot.addComponent(compass);
        robot.addComponent(new IMU("razor", "/dev/my_IMU_01", IMU_PORT));
        sear = (SEAR) Runtime.start("testSear", "SEAR");
        sear.startSimulation();
        sear.simSleep(1);
    }

    /** Request and decoding are those of Listing 9; MyRobotLab's publishByte is now called publishRX. */
    @Test
    public void listingNineReadsTheHeading() throws Exception {
        Serial serial = (Serial) Runtime.start("serial", "Serial");
        Heard heard = (Heard) Runtime.start("heading", "Heard");
        serial.addListener("publishRX", "heading", "onValue");
        serial.connect(COMPASS_PORT, 9600, 8, 1, 0);
        serial.write(0x8E);
        serial.write(0x2F);
        sear.simSleep(0.1);
        List<Object> bytes = heard.await(2);
        int result = ((((Number) bytes.get(0)).intValue() & 0xff) << 8) + (((Number) bytes.get(1)).intValue() & 0xff);
        double expected = sear.getCompassResult("north");
        assertEquals(0, Math.IEEEremainder(result / 10.0 - expected, 360), 0.25001);
        Runtime.releaseService("serial");
        Runtime.releaseService("heading");
    }

    @Test
    public void aProgramReadsTheAngles() throws Exception {
        int number = sear.exportTcp(IMU_PORT, 0);
        try (Socket program = new Socket(InetAddress.getLoopbackAddress(), number)) {
            double[] angles = angles(program);
            double[] expected = Arrays.stream(sear.getReading("razor").toString().split(","))
                .mapToDouble(Double::parseDouble).toArray();
            assertArrayEquals(expected, angles, 0.02);
            assertEquals("as the compass", 0, Math.IEEEremainder(sear.getCompassResult("north") - angles[0],
                360), 0.02);
            sear.power("razor", false);
            sear.simSleep(0.5);
            sear.power("razor", true);
            program.getOutputStream().write("#o0#s42".getBytes(StandardCharsets.US_ASCII));
            assertTrue(read(program, "#SYNCH42\r\n").endsWith("#SYNCH42\r\n"));
        }
    }

    /** Returns the angles of the first whole line. */
    private double[] angles(Socket program) throws Exception {
        String text = read(program, "\r\n#YPR=");
        read(program, "\r\n");
        String line = read(program, "\r\n");
        assertTrue(text + line, line.startsWith("#YPR="));
        return Arrays.stream(line.substring(5).trim().split(",")).mapToDouble(Double::parseDouble).toArray();
    }

    /** Returns the received text up to an ending, while time passes. */
    private String read(Socket program, String end) throws Exception {
        InputStream in = program.getInputStream();
        program.setSoTimeout(50);
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < TRIES && text.indexOf(end) < 0; i++) {
            sear.simSleep(0.05);
            try {
                for (int value = in.read(); value >= 0; value = in.read()) {
                    text.append((char) value);
                    if (text.indexOf(end) >= 0) {
                        return text.toString();
                    }
                }
            } catch (SocketTimeoutException e) {
                assertTrue(text.toString(), i < TRIES - 1);
            }
        }
        return text.toString();
    }
}
