// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.imu;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.sensors.ImuReading;

/**
 * Frames of a Razor 9DOF. Angles are in degrees. Accelerations are negated, 256 for 9.81 m/s^2 (raw 250). The magnetic
 * field's magnitude is 100 (raw 600). Turn rates have the gyroscope's unit of 0.06957 degrees per second. Binary
 * numbers are floats, low byte first.
 */
final class RazorFrames {
    static final int AXES = 3;
    private static final double STANDARD_GRAVITY = 9.81;
    private static final double GRAVITY = 256;
    private static final double RAW_GRAVITY = 250;
    private static final double FIELD = 100;
    private static final double RAW_FIELD = 600;
    private static final double GYRO_DEGREES = 0.06957;
    /** Range of the accelerometer, 2 g; the next one is the gyroscope's, in its units. */
    private static final double MAX_ACCELERATION = 2 * GRAVITY;
    private static final double MAX_RATE = 32767;

    private RazorFrames() {
    }

    static byte[] angles(ImuReading reading, boolean binary) {
        double[] angles = angles(reading);
        return binary ? floats(angles) : line("#YPR=", angles);
    }

    private static double[] angles(ImuReading reading) {
        return new double[] {reading.getYaw(), reading.getPitch(), reading.getRoll()};
    }

    /** Angles in degrees, accelerations, and turn rates in rad/s, as text. */
    static byte[] motion(ImuReading reading) {
        double[] values = new double[3 * AXES];
        System.arraycopy(angles(reading), 0, values, 0, AXES);
        for (int i = 0; i < AXES; i++) {
            values[AXES + i] = acceleration(reading, i);
            values[2 * AXES + i] = reading.getRate(i);
        }
        return line("#YPRAG=", values);
    }

    /** All three sensors, raw or calibrated. */
    static byte[] sensors(ImuReading reading, boolean raw, boolean binary) {
        double[][] values = {new double[AXES], new double[AXES], new double[AXES]};
        for (int i = 0; i < AXES; i++) {
            double measured = Math.rint(acceleration(reading, i) * RAW_GRAVITY / GRAVITY);
            double field = Math.rint(reading.getField(i) * RAW_FIELD);
            values[0][i] = raw ? measured : measured * GRAVITY / RAW_GRAVITY;
            values[1][i] = raw ? field : field * FIELD / RAW_FIELD;
            values[2][i] = clamp(Math.rint(Math.toDegrees(reading.getRate(i)) / GYRO_DEGREES), MAX_RATE);
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (int i = 0; i < AXES; i++) {
            byte[] part = binary ? floats(values[i])
                : line("#" + "AMG".charAt(i) + "-" + (raw ? "R=" : "C="), values[i]);
            bytes.write(part, 0, part.length);
        }
        return bytes.toByteArray();
    }

    /** Raw values of one sensor: 0 acceleration, 1 magnetic field, 2 turn rates. */
    static double[] raw(ImuReading reading, int sensor) {
        ByteBuffer floats = ByteBuffer.wrap(sensors(reading, true, true)).order(ByteOrder.LITTLE_ENDIAN);
        double[] values = new double[AXES];
        for (int i = 0; i < AXES; i++) {
            values[i] = floats.getFloat(Float.BYTES * (AXES * sensor + i));
        }
        return values;
    }

    private static double acceleration(ImuReading reading, int axis) {
        return clamp(-reading.getAcceleration(axis) / STANDARD_GRAVITY * GRAVITY, MAX_ACCELERATION);
    }

    private static double clamp(double value, double most) {
        return Math.max(-most, Math.min(most, value)) + 0.0;
    }

    private static byte[] floats(double[] values) {
        ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (double value : values) {
            bytes.putFloat((float) value);
        }
        return bytes.array();
    }

    private static byte[] line(String head, double[] values) {
        StringBuilder text = new StringBuilder(head);
        for (int i = 0; i < values.length; i++) {
            text.append(i == 0 ? "" : ",").append(Nmea.number(values[i], 2));
        }
        return text.append("\r\n").toString().getBytes(StandardCharsets.US_ASCII);
    }
}
