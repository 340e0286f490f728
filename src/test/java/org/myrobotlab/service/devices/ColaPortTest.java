// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.Slow;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.Serial;
import org.myrobotlab.service.ServiceFolder;

/**
 * A network scanner at its exported TCP port: ranges, a stream, and the state after a program that ends without notice.
 */
@Category(Slow.class)
public class ColaPortTest {
    private static final int KILLS = 20;
    private static final int FIRST_VALUE = 26;

    @Rule
    public final ServiceFolder folder = new ServiceFolder();
    private SEAR sear;
    private int port;

    @Before
    public void start() throws IOException {
        System.setProperty("sear.speed", "1");
        new Floor("floor", 20, 20);
        new Box("ahead", 6, 0.2, 1, 0).move(0, 0.5, 3);
        SEARrobot robot = new SEARrobot("stand");
        robot.addComponent(new Dynamics("drive", 4, 0, 0.1, 0, 0, 0, 0));
        for (double[] at : new double[][] {{-0.2, 0, 1}, {0.2, 0, 1}, {0, 0.2, 0}, {0, -0.2, 0}}) {
            robot.addWheel(new Wheel("wheel" + at[0] + at[1], 0.1, 0.03, (int) at[2], at[0], 0, at[1]));
        }
        LIDAR lidar = new LIDAR("scanner");
        lidar.setModel("LMS111");
        lidar.setPorts("/dev/my_Lidar01", "/dev/SEAR_LIDAR_01");
        lidar.move(0, 0.3, 0);
        robot.addComponent(lidar);
        sear = (SEAR) Runtime.start("sear", "SEAR");
        sear.startSimulation();
        port = sear.exportTcp("/dev/SEAR_LIDAR_01", 0);
        sear.simSleep(1);
    }

    private static void send(Socket socket, String telegram) throws IOException {
        socket.getOutputStream().write(("\u0002" + telegram + "\u0003").getBytes(StandardCharsets.US_ASCII));
        socket.getOutputStream().flush();
    }

    private static String receive(Socket socket) throws IOException {
        InputStream in = socket.getInputStream();
        assertEquals(2, in.read());
        StringBuilder text = new StringBuilder();
        for (int b = in.read(); b != 3; b = in.read()) {
            assertTrue("the connection ended", b >= 0);
            text.append((char) b);
        }
        return text.toString();
    }

    private Socket connect() throws IOException {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(60000);
        return socket;
    }

    @Test
    public void aScanEqualsTheScriptCall() throws Exception {
        try (Socket socket = connect()) {
            send(socket, "sRN LMDscandata");
            String[] scan = receive(socket).split(" ");
            float[] expected = sear.getLidarResult("scanner");
            assertEquals(expected.length, Integer.parseInt(scan[25], 16));
            int seen = 0;
            for (int i = 0; i < expected.length; i++) {
                int millimetres = Integer.parseInt(scan[FIRST_VALUE + i], 16);
                assertEquals("beam " + i, expected[i] < 20 ? expected[i] * 1000 : 0, millimetres, 0.51);
                seen += millimetres > 0 ? 1 : 0;
            }
            assertTrue(seen + " beams hit the box", seen > 100);
        }
    }

    /** A network has no baud rate: any setting of the port works. */
    @Test
    public void aSerialServiceReadsItAtAnyBaudRate() throws Exception {
        sear.endExport("/dev/SEAR_LIDAR_01");
        Heard heard = (Heard) Runtime.start("heard", "Heard");
        sear.addListener("publishStatus", "heard", "onStatus");
        Serial serial = (Serial) Runtime.start("plain", "Serial");
        serial.connect("/dev/SEAR_LIDAR_01", 9600, 8, 1, 0);
        serial.addListener("publishRX", "heard", "onValue");
        String answer = "\u0002sRA SCdevicestate 1\u0003";
        serial.write("\u0002sRN SCdevicestate\u0003".getBytes(StandardCharsets.US_ASCII));
        StringBuilder text = new StringBuilder();
        heard.await(answer.length()).forEach(value -> text.append((char) (int) (Integer) value));
        assertEquals(answer, text.toString());
        assertEquals("no warning of a wrong rate", "[]", heard.getStatuses().toString());
        Runtime.releaseService("plain");
        Runtime.releaseService("heard");
    }

    @Test
    public void eachProgramStartsInTheDefaultState() throws Exception {
        for (int kill = 0; kill < KILLS; kill++) {
            try (Socket socket = connect()) {
                send(socket, "sWN LMPoutputRange 1 1388 0 1B7740");
                assertEquals("kill " + kill + ": not logged in", "sFA A", receive(socket));
                send(socket, "sMN SetAccessMode 03 F4724744");
                assertEquals("sAN SetAccessMode 1", receive(socket));
                send(socket, "sEN LMDscandata 1");
                assertEquals("sEA LMDscandata 1", receive(socket));
                for (int i = 0; i < 3; i++) {
                    assertTrue(receive(socket).startsWith("sSN LMDscandata 1 1 "));
                }
                socket.setSoLinger(true, 0);
            }
        }
    }
}
