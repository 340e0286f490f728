// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.imu;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.SEAR.devices.FakeContext;
import org.SEAR.sensors.ImuReading;
import org.junit.Before;
import org.junit.Test;

/** The frames, as described in the firmware's list of commands. */
public class RazorTest {
    private static final Pattern NUMBERS = Pattern.compile("#(YPR|YPRAG|[AMG]-[CR])=((-?\\d+\\.\\d\\d,?)+)");
    private static final double G = 9.81;

    private FakeContext line;
    private Razor razor;

    @Before
    public void power() {
        line = new FakeContext();
        line.reading = reading(-142.283, -5.378, 33.516);
        razor = line.attach(new Razor(57600, line));
        line.pass(0.5);
        line.take();
    }

    private static ImuReading reading(double yaw, double pitch, double roll) {
        return new ImuReading(new double[] {yaw, pitch, roll}, new double[] {0.5 * G, 0, -G},
            new double[] {0, Math.toRadians(-10), Math.toRadians(90)}, new double[] {0.6, 0, 0.8});
    }

    /** Returns the numbers of a line of text. */
    private static double[] numbers(String kind, String text) {
        Matcher matcher = NUMBERS.matcher(text);
        assertTrue(text, matcher.matches());
        assertEquals(kind, matcher.group(1));
        return Arrays.stream(matcher.group(2).split(",")).mapToDouble(Double::parseDouble).toArray();
    }

    private static float[] floats(byte[] bytes, int from, int count) {
        float[] values = new float[count];
        ByteBuffer.wrap(bytes, from, 4 * count).order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer().get(values);
        return values;
    }

    private byte[] one(String commands) {
        line.hostText("#o0");
        line.pass(0.1);
        line.take();
        line.hostText(commands + "#f");
        line.pass(0.1);
        return line.take();
    }

    @Test
    public void anglesAsTextFiftyTimesASecond() {
        line.pass(1);
        String[] lines = line.takeText().split("\r\n");
        assertEquals(50, lines.length, 1);
        assertEquals("#YPR=-142.28,-5.38,33.52", lines[0]);
        assertArrayEquals(new double[] {-142.28, -5.38, 33.52}, numbers("YPR", lines[20]), 0);
    }

    @Test
    public void anglesAsFloatsWithASyncToken() {
        line.hostText("#o0");
        line.take();
        line.hostText("#ob#o1#sX7");
        line.pass(0.5);
        byte[] bytes = line.take();
        String text = new String(bytes, java.nio.charset.StandardCharsets.ISO_8859_1);
        int start = text.indexOf("#SYNCHX7\r\n") + 10;
        assertTrue(text, start >= 10);
        assertEquals("whole frames", 0, (bytes.length - start) % 12);
        assertTrue(bytes.length > 200);
        assertArrayEquals(new float[] {-142.283f, -5.378f, 33.516f}, floats(bytes, start + 12, 3), 1e-3f);
    }

    @Test
    public void framesOnRequest() {
        assertEquals("#YPR=-142.28,-5.38,33.52\r\n", new String(one("#ot")));
        line.pass(1);
        assertEquals("", line.takeText());
        line.hostText("#o1");
        line.pass(1);
        assertTrue(line.takeText().length() > 1000);
    }

    /**
     * At rest, gravity is 256 downwards and the field has length 100. 90 degrees a second are 1294 units of the
     * gyroscope.
     */
    @Test
    public void theSensorsWithTheirCalibration() {
        String[] lines = new String(one("#osct")).split("\r\n");
        assertEquals(3, lines.length);
        assertArrayEquals(new double[] {-128, 0, 256}, numbers("A-C", lines[0]), 1);
        assertArrayEquals(new double[] {60, 0, 80}, numbers("M-C", lines[1]), 0.2);
        assertArrayEquals(new double[] {0, -144, 1294}, numbers("G-C", lines[2]), 0.5);
        byte[] bytes = one("#osbb");
        assertEquals(72, bytes.length);
        assertArrayEquals(new float[] {-125, 0, 250, 360, 0, 480, 0, -144, 1294}, floats(bytes, 0, 9), 0);
        assertArrayEquals(new float[] {-128, 0, 256, 60, 0, 80, 0, -144, 1294}, floats(bytes, 36, 9), 0.01f);
        assertEquals(36, one("#osrb").length);
        assertEquals("#A-R=-125.00,0.00,250.00", new String(one("#osrt")).split("\r\n")[0]);
        assertEquals(6, new String(one("#osbt")).split("\r\n").length);
    }

    @Test
    public void anglesAndMotionForRos() {
        assertArrayEquals(new double[] {-142.28, -5.38, 33.52, -128, 0, 256, 0, -0.17, 1.57},
            numbers("YPRAG", new String(one("#ox")).trim()), 0);
    }

    @Test
    public void theCalibrationOfEachSensor() {
        assertEquals("accel x,y,z (min/max) = -125.00/-125.00  0.00/0.00  250.00/250.00\r\n", new String(one("#oc")));
        line.reading = new ImuReading(new double[3], new double[] {G, 0, -G}, new double[3], new double[] {1, 0, 0});
        line.hostText("#f");
        line.pass(0.1);
        assertEquals("accel x,y,z (min/max) = -250.00/-125.00  0.00/0.00  250.00/250.00\r\n", line.takeText());
        assertEquals("magn x,y,z (min/max) = 600.00/600.00  0.00/0.00  0.00/0.00\r\n", new String(one("#on")));
        assertEquals("gyro x,y,z (current/average) = 0.00/0.00  0.00/0.00  0.00/0.00\r\n", new String(one("#on")));
    }

    @Test
    public void thePowerSwitchRestartsIt() {
        line.hostText("#ob#o0");
        razor.powerOff();
        razor.powerOn(line.now);
        line.take();
        line.pass(0.1);
        assertTrue(line.takeText().startsWith("#YPR="));
    }

    @Test
    public void aDroppedReadingRepeatsThePreviousOne() {
        line.reading = reading(Double.NaN, Double.NaN, Double.NaN);
        line.pass(0.1);
        assertTrue(line.takeText().startsWith("#YPR=-142.28"));
    }
}
