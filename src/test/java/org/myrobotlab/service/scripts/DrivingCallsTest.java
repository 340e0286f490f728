// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.scripts;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.FarEnd;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.Serial;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;

/** The driving calls and the calls for any sensor, on a small world in lock-step. */
public class DrivingCallsTest {
    /** Half of the track width of the test's robot, m. */
    private static final double HALF_TRACK = 0.129;

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private Path folder;
    private SEAR sear;

    @Before
    public void start() {
        folder = TestWorld.build(temporary.getRoot().toPath());
        sear = (SEAR) Runtime.start("drivingSear", "SEAR");
        sear.startSimulation();
        sear.simSleep(1);
    }

    private static double wrapped(double degrees) {
        return degrees - 360 * Math.rint(degrees / 360);
    }

    @Test
    public void straightOnAndBack() {
        sear.driveStraight(0.3);
        sear.simSleep(2);
        sear.driveStraight("roomba", 0);
        sear.simSleep(0.5);
        assertEquals(0.6, sear.getPose("roomba")[2], 0.01);
        assertEquals("it looks east", 90, sear.getCompassResult("compass"), 0.5);
        sear.driveStraight(-0.3);
        sear.simSleep(2);
        sear.driveStraight(0);
        sear.simSleep(0.5);
        assertEquals(0, sear.getPose("roomba")[2], 0.01);
    }

    /** The heading is 90 - ry, as in the page about the calls. */
    @Test
    public void aSpinToTheLeftMakesRyGrowAndTheHeadingShrink() {
        sear.spin(45);
        sear.simSleep(2);
        sear.spin("roomba", 0);
        sear.simSleep(0.5);
        double[] pose = sear.getPose("roomba");
        assertEquals(90, pose[4], 2);
        assertEquals(0, Math.hypot(pose[0], pose[2]), 0.01);
        assertEquals(wrapped(90 - pose[4]), sear.getCompassResult("compass"), 0.01);
        sear.spin(-90);
        sear.simSleep(2);
        sear.spin(0);
        sear.simSleep(0.5);
        assertEquals(-90, sear.getPose("roomba")[4], 3);
    }

    @Test
    public void twoWheelSpeedsMakeACircle() {
        sear.setWheelSpeeds(0.1, 0.3);
        sear.simSleep(4);
        double turned = Math.toRadians(sear.getPose("roomba")[4]);
        assertEquals((0.3 - 0.1) / (2 * HALF_TRACK) * 4, turned < 0 ? turned + 2 * Math.PI : turned, 0.06);
        sear.setWheelSpeeds("roomba", 0, 0);
        sear.simSleep(0.5);
        double[] stood = sear.getPose("roomba");
        sear.simSleep(1);
        assertArrayEquals(Arrays.copyOf(stood, 3), Arrays.copyOf(sear.getPose("roomba"), 3), 1e-3);
    }

    /** Forwards and backwards, to both sides: ry grows by the turn rate, and the circle has its radius. */
    @Test
    public void aSpeedAndATurnRateAreHeld() {
        double[][] velocities = {{0.2, 30}, {0.2, -30}, {-0.2, 30}, {0, -45}, {0.3, 0}};
        for (double[] velocity : velocities) {
            sear.driveVelocity(velocity[0], velocity[1]);
            sear.simSleep(1);
            double[] from = sear.getPose("roomba");
            sear.simSleep(2);
            double[] to = sear.getPose("roomba");
            String what = Arrays.toString(velocity);
            assertEquals(what, 2 * velocity[1], wrapped(to[4] - from[4]), 2);
            double turn = Math.toRadians(velocity[1]);
            double chord = velocity[1] == 0 ? 2 * velocity[0] : 2 * velocity[0] / turn * Math.sin(turn);
            assertEquals(what, Math.abs(chord), Math.hypot(to[0] - from[0], to[2] - from[2]), 0.01);
            sear.driveVelocity("roomba", 0, 0);
            sear.simSleep(0.5);
        }
        double[] stood = sear.getPose("roomba");
        sear.simSleep(1);
        assertArrayEquals(Arrays.copyOf(stood, 3), Arrays.copyOf(sear.getPose("roomba"), 3), 1e-3);
        assertTrue(refused(() -> sear.driveVelocity(0.1, 4000)).contains(
            "driveVelocity: turn rate is 4000.0, legal: -3600.0 to 3600.0 degrees per second"));
        assertTrue(refused(() -> sear.driveVelocity(Double.NaN, 0)).contains("driveVelocity: speed is NaN"));
    }

    @Test
    public void theLastCallOrCommandCounts() throws Exception {
        Serial serial = (Serial) Runtime.start("drivingSerial", "Serial");
        serial.connect(TestWorld.ROOMBA_PORT, 57600, 8, 1, 0);
        serial.write(FarEnd.bytes("80 83 89 00 C8 80 00"));
        sear.simSleep(1);
        sear.driveStraight(-0.2);
        sear.simSleep(2);
        assertTrue("backwards", sear.getPose("roomba")[2] < 0);
        serial.write(FarEnd.bytes("89 00 C8 80 00"));
        sear.simSleep(2);
        assertTrue("forwards again", sear.getPose("roomba")[2] > 0);
    }

    @Test
    public void anySensorIsReadWithItsUnit() {
        assertEquals(sear.getDistanceResult("ping"), (Double) sear.getReading("ping"), 0);
        assertArrayEquals(sear.getLidarResult("scanner"), (float[]) sear.getReading("scanner"), 0);
        assertArrayEquals(sear.getGpsResult("receiver"), (double[]) sear.getReading("receiver"), 0);
        assertEquals(sear.getAccelResult("accel"), sear.getReading("accel"));
        String[][] units = {{"ping", "m"}, {"scanner", "m"}, {"receiver", "deg, deg, m"}, {"compass", "deg"},
            {"accel", "m/s2"}, {"gyro", "rad/s"}};
        for (String[] unit : units) {
            assertEquals(unit[0], unit[1], sear.getSensorUnit(unit[0]));
        }
    }

    private static String refused(Runnable call) {
        return assertThrows(IllegalArgumentException.class, call::run).getMessage();
    }

    @Test
    public void illegalArgumentsAreReportedWithTheLegalRange() {
        assertEquals("driveStraight: speed is NaN, legal: -100.0 to 100.0 m/s",
            refused(() -> sear.driveStraight(Double.NaN)));
        assertEquals("spin: speed is 1.0E9, legal: -3600.0 to 3600.0 degrees per second",
            refused(() -> sear.spin(1e9)));
        assertEquals("setWheelSpeeds: right is -101.0, legal: -100.0 to 100.0 m/s",
            refused(() -> sear.setWheelSpeeds(0, -101)));
        assertEquals("drive: radius is NaN, legal: metres, + to the left, 0 or infinity",
            refused(() -> sear.drive(1, Double.NaN)));
        assertEquals("there is no robot \"rover\"; robots: roomba", refused(() -> sear.spin("rover", 10)));
        assertTrue(refused(() -> sear.getReading("pong")).contains("ping"));
        assertTrue(refused(() -> sear.getSensorUnit("pong")).contains("ping"));
        assertTrue(sear.isSimulating());
    }

    @Test
    public void aRobotWithoutTheAbilityReportsIt() throws Exception {
        sear.stopSimulation();
        Path robot = folder.resolve("robot/roomba.xml");
        String whole = Files.readString(robot);
        Files.writeString(robot, whole.replace("<type>1</type>", "<type>0</type>"));
        sear.startSimulation();
        assertTrue(refused(() -> sear.driveStraight(1)).startsWith("robot roomba has no driven wheels: "));
        sear.stopSimulation();
        Files.writeString(robot, whole.replace("<x>-0.129</x>", "<x>0</x>").replace("<x>0.129</x>", "<x>0</x>"));
        sear.startSimulation();
        assertTrue(refused(() -> sear.spin(10)).startsWith("robot roomba can't turn in place: "));
    }
}
