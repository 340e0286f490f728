// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.IMU;
import org.SEAR.POJOs.Noise;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** Attitude, acceleration and rotation in axes forward, right and down; an unrotated robot looks east. */
public class ImuSensorTest {
    private static final double G = 9.81;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static ImuReading read(ScriptedTruth truth) {
        ImuSensor sensor = new ImuSensor(new IMU("imu"), 1);
        truth.advance(sensor).advance(sensor);
        return sensor.read(truth);
    }

    private static void assertAngles(double yaw, double pitch, double roll, ImuReading reading) {
        assertEquals(0, Math.IEEEremainder(yaw - reading.getYaw(), 360), 1e-9);
        assertEquals(pitch, reading.getPitch(), 1e-9);
        assertEquals(roll, reading.getRoll(), 1e-9);
    }

    @Test
    public void yawIsClockwisePitchUpRollToTheRight() {
        assertAngles(90, 0, 0, read(new ScriptedTruth()));
        assertAngles(0, 0, 0, read(new ScriptedTruth().at(0, 0, 0, 0, 90, 0)));
        assertAngles(90, 20, 0, read(new ScriptedTruth().at(0, 0, 0, -20, 0, 0)));
        assertAngles(90, 0, 30, read(new ScriptedTruth().at(0, 0, 0, 0, 0, 30)));
    }

    @Test
    public void atRestTheFirmwareDerivesItsAnglesFromGravity() {
        for (double[] turn : new double[][] {{0, 0, 0}, {-20, 0, 0}, {0, 0, 30}, {-20, 77, 0}, {10, -40, 25}}) {
            ImuReading reading = read(new ScriptedTruth().at(0, 0, 0, turn[0], turn[1], turn[2]));
            double x = -reading.getAcceleration(0);
            double y = -reading.getAcceleration(1);
            double z = -reading.getAcceleration(2);
            assertEquals(G, Math.sqrt(x * x + y * y + z * z), 1e-9);
            assertEquals(reading.getPitch(), Math.toDegrees(-Math.atan2(x, Math.hypot(y, z))), 1e-9);
            assertEquals(reading.getRoll(), Math.toDegrees(Math.atan2(y, z)), 1e-9);
        }
    }

    /** The tilt compensation published with the firmware. */
    @Test
    public void theFieldGivesTheYaw() {
        for (double[] turn : new double[][] {{0, 0, 0}, {-20, 0, 0}, {0, 0, 30}, {-20, 77, 0}, {10, -40, 25}}) {
            ScriptedTruth truth = new ScriptedTruth().at(0, 0, 0, turn[0], turn[1], turn[2]);
            truth.earth = new Earth(new GeoOrigin(35.3, 200, -80.7), MagneticModel.standard());
            ImuReading reading = read(truth);
            double roll = Math.toRadians(reading.getRoll());
            double pitch = Math.toRadians(reading.getPitch());
            double x = reading.getField(0) * Math.cos(pitch) + reading.getField(1) * Math.sin(roll) * Math.sin(pitch)
                + reading.getField(2) * Math.cos(roll) * Math.sin(pitch);
            double y = reading.getField(1) * Math.cos(roll) - reading.getField(2) * Math.sin(roll);
            assertEquals(0, Math.IEEEremainder(reading.getYaw() - Math.toDegrees(Math.atan2(-y, x)), 360), 1e-9);
        }
    }

    @Test
    public void aTurnToTheLeftIsNegativeDownwards() {
        ImuReading reading = read(new ScriptedTruth().turning(0, 0.5, 0));
        assertEquals(-0.5, reading.getRate(2), 1e-12);
        assertEquals(0, reading.getRate(0), 1e-12);
    }

    @Test
    public void noiseIsThatOfTheAngles() {
        IMU imu = new IMU("imu");
        imu.setNoise(new Noise(2));
        ImuSensor sensor = new ImuSensor(imu, 1);
        ScriptedTruth truth = new ScriptedTruth();
        double squares = 0;
        for (int i = 0; i < 1000; i++) {
            truth.advance(sensor);
            double error = sensor.read(truth).getYaw() - 90;
            squares += error * error;
            assertEquals(-G, sensor.read(truth).getAcceleration(2), 1e-9);
        }
        assertEquals(2, Math.sqrt(squares / 1000), 0.2);
    }

    @Test
    public void aMissingOriginIsReported() {
        String warning = new ImuSensor(new IMU("imu"), 1).warnings(new ScriptedTruth()).get(0);
        assertTrue(warning, warning.startsWith("imu imu shows true north"));
    }
}
