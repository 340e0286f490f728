// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.Noise;
import org.SEAR.project.ProjectRule;
import org.junit.Rule;
import org.junit.Test;

/** Accelerometer and gyroscope on scripted motions. */
public class InertialSensorsTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static final double GRAVITY = 9.81;

    private static Accelerometer accelerometer(double bandwidth, boolean gravity) {
        Accelerometer parameters = new Accelerometer("accel", bandwidth);
        parameters.setGravity(gravity);
        return parameters;
    }

    private static void assertVector(String why, double x, double y, double z, VectorReading reading,
        double tolerance) {
        assertEquals(why, x, reading.getX(), tolerance);
        assertEquals(why, y, reading.getY(), tolerance);
        assertEquals(why, z, reading.getZ(), tolerance);
    }

    private static void assertVector(double x, double y, double z, VectorReading reading, double tolerance) {
        assertVector("", x, y, z, reading, tolerance);
    }

    @Test
    public void atRestThereIsNothingOrGravity() {
        AccelerometerSensor plain = new AccelerometerSensor(accelerometer(60, false), 1);
        AccelerometerSensor proper = new AccelerometerSensor(accelerometer(60, true), 1);
        ScriptedTruth truth = new ScriptedTruth();
        for (int i = 0; i < 10; i++) {
            truth.advance(plain, proper);
            assertEquals("0.0,0.0,0.0", plain.read(truth).toString());
            assertEquals("0.0,9.81,0.0", proper.read(truth).toString());
        }
    }

    @Test
    public void onARampGravityPullsBackwards() {
        AccelerometerSensor proper = new AccelerometerSensor(accelerometer(60, true), 1);
        ScriptedTruth truth = new ScriptedTruth().at(0, 0, 0, -20, 0, 0).advance(proper).advance(proper);
        double up = Math.toRadians(20);
        assertVector(0, GRAVITY * Math.cos(up), GRAVITY * Math.sin(up), proper.read(truth), 1e-9);
        AccelerometerSensor plain = new AccelerometerSensor(accelerometer(60, false), 1);
        truth.advance(plain);
        truth.moving(0, -2 * Math.sin(up) * ScriptedTruth.STEP, -2 * Math.cos(up) * ScriptedTruth.STEP).advance(plain);
        assertVector(0, 0, -2, plain.read(truth), 1e-9);
    }

    @Test
    public void inFreeFallProperAccelerationIsZero() {
        AccelerometerSensor plain = new AccelerometerSensor(accelerometer(20, false), 1);
        AccelerometerSensor proper = new AccelerometerSensor(accelerometer(20, true), 1);
        ScriptedTruth truth = new ScriptedTruth().at(0, 100, 0, 0, 77, 0);
        for (int i = 0; i < 20; i++) {
            truth.moving(0, -GRAVITY * truth.time(), 0).advance(plain, proper);
        }
        assertVector(0, -GRAVITY, 0, plain.read(truth), 1e-9);
        assertVector(0, 0, 0, proper.read(truth), 1e-9);
    }

    @Test
    public void inATurnItIsSpeedSquaredOverRadius() {
        for (double bandwidth : new double[] {60, 10, 1}) {
            AccelerometerSensor sensor = new AccelerometerSensor(accelerometer(bandwidth, false), 1);
            ScriptedTruth truth = new ScriptedTruth();
            double speed = 0.5;
            double radius = 0.5;
            for (int i = 0; i < 200; i++) {
                double angle = speed / radius * (truth.time() + ScriptedTruth.STEP);
                truth.at(0, 0, 0, 0, Math.toDegrees(angle), 0)
                    .moving(speed * Math.sin(angle), 0, speed * Math.cos(angle)).advance(sensor);
            }
            assertVector(speed * speed / radius, 0, 0, sensor.read(truth), 0.02 * speed * speed / radius);
            assertEquals("no acceleration along the path", 0, sensor.read(truth).getZ(), 1e-6);
        }
    }

    @Test
    public void theWindowIsOneOverTheBandwidth() {
        AccelerometerSensor sensor = new AccelerometerSensor(accelerometer(10, false), 1);
        ScriptedTruth truth = new ScriptedTruth();
        for (int i = 0; i < 10; i++) {
            truth.advance(sensor);
        }
        truth.moving(0, 0, 1).advance(sensor);
        for (int i = 0; i < 6; i++) {
            assertVector(0, 0, 10, sensor.read(truth), 1e-9);
            truth.advance(sensor);
        }
        assertVector(0, 0, 0, sensor.read(truth), 1e-9);
    }

    @Test
    public void offTheCentreASpinIsFelt() {
        Accelerometer parameters = accelerometer(60, false);
        parameters.move(0, 0, 0.2);
        parameters.rotate(0, 90, 0);
        AccelerometerSensor sensor = new AccelerometerSensor(parameters, 1);
        ScriptedTruth truth = new ScriptedTruth();
        double rate = 2;
        for (int i = 0; i < 30; i++) {
            truth.at(0, 0, 0, 0, Math.toDegrees(rate * i * ScriptedTruth.STEP), 0).turning(0, rate, 0).advance(sensor);
        }
        double inwards = rate * rate * 0.2;
        assertVector("the centre lies to the left of a sensor that sits in front and looks left", inwards, 0, 0,
            sensor.read(truth), 0.02 * inwards);
    }

    @Test
    public void theGyroscopeAnswersBodyRates() {
        GyroscopeSensor sensor = new GyroscopeSensor(new Gyroscope("gyro", 60), 1);
        ScriptedTruth truth = new ScriptedTruth().at(0, 0, 0, 0, 90, 0).turning(1, 2, 3).advance(sensor);
        assertVector(-3, 2, 1, sensor.read(truth), 1e-12);
        Gyroscope turned = new Gyroscope("gyro", 60);
        turned.rotate(0, 90, 0);
        GyroscopeSensor mounted = new GyroscopeSensor(turned, 1);
        truth.at(0, 0, 0, 0, 0, 0).advance(mounted);
        assertVector(-3, 2, 1, mounted.read(truth), 1e-12);
    }

    @Test
    public void resetForgetsTheWindowAndTheDrift() {
        Accelerometer parameters = accelerometer(5, false);
        parameters.setNoise(new Noise().setDrift(1).setWhite(0.1));
        AccelerometerSensor used = new AccelerometerSensor(parameters, 7);
        String first = run(used);
        used.reset();
        assertEquals(first, run(used));
        assertEquals(first, run(new AccelerometerSensor(parameters, 7)));
        assertTrue(!first.equals(run(new AccelerometerSensor(parameters, 8))));
    }

    private static String run(AccelerometerSensor sensor) {
        ScriptedTruth truth = new ScriptedTruth();
        StringBuilder all = new StringBuilder();
        for (int i = 0; i < 50; i++) {
            truth.moving(i, -i * i, 1).advance(sensor);
            all.append(sensor.read(truth)).append('\n');
        }
        return all.toString();
    }

    @Test
    public void aDropOutIsNotANumber() {
        Accelerometer parameters = accelerometer(60, false);
        parameters.setNoise(new Noise().setDropout(1));
        assertEquals("NaN,NaN,NaN", new AccelerometerSensor(parameters, 1).read(new ScriptedTruth()).toString());
    }
}
