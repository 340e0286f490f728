// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.file.Path;
import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Wheel;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.raycast.BeamScene;
import org.SEAR.simulator.Simulation;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/**
 * The whole path from objects to bytes: a LIDAR on a robot among rotated boxes, cylinders and cones answers LMS200
 * telegrams. Each value is compared with ray marching through distance functions.
 */
public class LidarTelegramsTest {
    private static final long SEED = 20261121;
    private static final int WORLDS = 3;
    private static final int OBJECTS = 24;
    private static final double RANGE = 8.191;
    private static final int NOTHING_HIT = 8191;
    private static final int TOO_FAR = 8183;
    private static final String SINGLE_SCAN = "02 00 02 00 30 01 31 18";
    /** Request, number of values, first angle from the forward axis in degrees, degrees between values. */
    private static final Object[][] VARIANTS = {
        {"02 00 05 00 3B 64 00 64 00 1D 0F", 101, -50.0, 1.0},
        {"02 00 05 00 3B B4 00 64 00 97 49", 181, -90.0, 1.0},
        {"02 00 05 00 3B 64 00 32 00 B1 59", 201, -50.0, 0.5},
        {"02 00 05 00 3B B4 00 32 00 3B 1F", 361, -90.0, 0.5},
        {"02 00 05 00 3B 64 00 19 00 E7 72", 401, -50.0, 0.25}};

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private final ByteArrayOutputStream received = new ByteArrayOutputStream();

    @Before
    public void projectHere() {
        System.setProperty("sear.project", folder.getRoot().toPath().resolve("SEARproject").toString());
    }

    @After
    public void projectAnywhere() {
        System.clearProperty("sear.project");
    }

    @Test
    public void everyBeamOfEveryVariantIsWithinAMillimetreOfExactGeometry() throws Exception {
        Random random = new Random(SEED);
        int hits = 0;
        int misses = 0;
        for (int world = 0; world < WORLDS; world++) {
            MarchedWorld marched = build(random);
            try (Simulation simulation = Simulation.load(Path.of(System.getProperty("sear.project")), SEED)) {
                SerialLine line = simulation.getLines().get(0);
                line.setSink((bytes, starts) -> received.write(bytes, 0, bytes.length));
                run(simulation, 2);
                Pose scanner = simulation.getPose("scanner");
                for (Object[] variant : VARIANTS) {
                    ask(simulation, line, (String) variant[0], 16);
                    int count = (Integer) variant[1];
                    byte[] reply = ask(simulation, line, SINGLE_SCAN, 11 + 2 * count);
                    for (int i = 0; i < count; i++) {
                        double angle = Math.toRadians((Double) variant[2] + i * (Double) variant[3]);
                        double[] direction = scanner.rotate(Math.sin(angle), 0, Math.cos(angle));
                        double exact = marched.march(new double[] {scanner.x, scanner.y, scanner.z}, direction, RANGE,
                            BeamScene.WORLD);
                        int value = (reply[7 + 2 * i] & 0xFF | (reply[8 + 2 * i] & 0xFF) << 8) & 0x1FFF;
                        String beam = "seed " + SEED + ", world " + world + ", " + count + " values, beam " + i;
                        if (exact == Double.POSITIVE_INFINITY) {
                            assertEquals(beam, NOTHING_HIT, value);
                            misses++;
                        } else if (exact * 1000 < TOO_FAR - 1) {
                            assertEquals(beam, exact * 1000, value, 1 + 0.5);
                            hits++;
                        }
                    }
                }
            }
        }
        assertTrue(hits + " beams hit, " + misses + " did not", hits > 500 && misses > 500);
    }

    /** Requests like CARMEN's and others': 32 bytes of configuration with measuring mode 4 (16 m) and 6 (32 m). */
    @Test
    public void aPostBeyondEightMetresIsMeasuredInTheModesOfSixteenAndThirtyTwo() throws Exception {
        String zeros = " 00".repeat(21);
        String[] modes = {"02 00 21 00 77 00 00 70 00 00 04 01 00 00 02 02" + zeros + " 84 72",
            "02 00 21 00 77 00 00 70 00 00 06 01 00 00 02 02" + zeros + " D4 42"};
        new Floor("floor", 60, 60, false).move(0, 0, 0);
        new Cylinder("post", 0.25, 3, 0).move(12, 1.5, 0);
        LIDAR lidar = new LIDAR("scanner", 80, 180, 1, 0, 0.5, 0, 0, 90, 0);
        lidar.setPorts("/dev/uart", "/dev/user");
        carrier(0).addComponent(lidar);
        try (Simulation simulation = Simulation.load(Path.of(System.getProperty("sear.project")), SEED)) {
            SerialLine line = simulation.getLines().get(0);
            line.setSink((bytes, starts) -> received.write(bytes, 0, bytes.length));
            run(simulation, 2);
            ask(simulation, line, "02 00 02 00 20 40 50 08", 9);
            for (int i = 0; i < modes.length; i++) {
                ask(simulation, line, "02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5", 9);
                assertEquals(1, ask(simulation, line, modes[i], 43)[5]);
                ask(simulation, line, "02 00 02 00 20 25 35 08", 9);
                byte[] scan = ask(simulation, line, SINGLE_SCAN, 372);
                int nothing = i == 0 ? 16383 : 32767;
                int hit = 0;
                for (int beam = 0; beam <= 180; beam++) {
                    int value = scan[7 + 2 * beam] & 0xFF | (scan[8 + 2 * beam] & 0xFF) << 8;
                    assertTrue("beam " + beam + " reads " + value, value == nothing || beam >= 87 && beam <= 93
                        && value >= 11749 && value < 12000);
                    hit += value == nothing ? 0 : 1;
                }
                assertEquals("beams on a post of half a metre", 3, hit);
                assertEquals(11750, scan[7 + 180] & 0xFF | (scan[8 + 180] & 0xFF) << 8, 2);
            }
        }
    }

    /** Makes random objects away from the robot, the same in both worlds. */
    private MarchedWorld build(Random random) {
        MarchedWorld marched = new MarchedWorld();
        new Floor("floor", 30, 30, false).move(0, 0, 0);
        for (int i = 0; i < OBJECTS; i++) {
            double a = 0.1 + 0.5 * random.nextDouble();
            double b = 0.1 + 0.5 * random.nextDouble();
            double c = 0.1 + 0.5 * random.nextDouble();
            Shape object = i % 3 == 0 ? new Box("object" + i, 2 * a, 2 * c, 2 * b, 0)
                : i % 3 == 1 ? new Cylinder("object" + i, a, 2 * b, 0) : new Cone("object" + i, a, 2 * b, 0);
            int shape = i % 3 == 0 ? marched.box(a, b, c, BeamScene.WORLD)
                : i % 3 == 1 ? marched.cylinder(a, b, BeamScene.WORLD) : marched.cone(a, b, BeamScene.WORLD);
            double bearing = 2 * Math.PI * random.nextDouble();
            double distance = 1.5 + 6 * random.nextDouble();
            double[] turned = {360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble()};
            double height = 0.5 + random.nextDouble();
            object.move(distance * Math.cos(bearing), height, distance * Math.sin(bearing));
            object.rotate(turned[0], turned[1], turned[2]);
            marched.move(shape, Pose.ofDegrees(distance * Math.cos(bearing), height, distance * Math.sin(bearing),
                turned[0], turned[1], turned[2]));
        }
        marched.scene.commit();
        robot(random);
        return marched;
    }

    private static SEARrobot carrier(double turned) {
        SEARrobot robot = new SEARrobot("carrier");
        robot.addComponent(new Dynamics("drive", 4, 60, 0.3, 0.4, 1000, 0.1, 0, 0.1, 0, 0, turned, 0));
        robot.addComponent(new Cylinder("body", 0.17, 0.08, 4));
        for (double[] at : new double[][] {{-0.16, 0, 1}, {0.16, 0, 1}, {0, 0.16, 0}, {0, -0.16, 0}}) {
            Wheel wheel = new Wheel("wheel" + robot.getWheels().size(), 0.038, 0.03, (int) at[2]);
            wheel.move(at[0], 0, at[1]);
            robot.addWheel(wheel);
        }
        return robot;
    }

    private static void robot(Random random) {
        SEARrobot robot = carrier(360 * random.nextDouble());
        LIDAR lidar = new LIDAR("scanner");
        lidar.setPorts("/dev/uart", "/dev/user");
        lidar.setRange(RANGE);
        lidar.setBaud(38400);
        lidar.move(0.05, 0.3 + 0.4 * random.nextDouble(), -0.02);
        lidar.rotate(20 * random.nextDouble() - 15, 360 * random.nextDouble(), 10 * random.nextDouble());
        robot.addComponent(lidar);
    }

    /**
     * Sends a request and returns the reply telegram without its ACK.
     * @param length of the reply telegram, bytes
     */
    private byte[] ask(Simulation simulation, SerialLine line, String request, int length) {
        received.reset();
        String[] hex = request.split(" ");
        byte[] bytes = new byte[hex.length];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) Integer.parseInt(hex[i], 16);
        }
        line.write(bytes);
        for (int step = 0; step < 120 && received.size() < 1 + length; step++) {
            simulation.step();
        }
        byte[] answer = received.toByteArray();
        assertTrue(request + " was answered by " + answer.length + " bytes", answer.length >= 2 && answer[0] == 6);
        return java.util.Arrays.copyOfRange(answer, 1, answer.length);
    }

    private static void run(Simulation simulation, double seconds) {
        while (simulation.getTime() < seconds) {
            simulation.step();
        }
    }
}
