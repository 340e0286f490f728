package org.SEAR.devices.imu;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.sensors.ImuReading;

/**
 * The frames of a Razor 9DOF: angles in degrees; accelerations negated, 256 for 9.81 m/s^2 (raw 250); the magnetic field as 100 (raw 600) for all of
 * it; rates of turn in the gyroscope's units of 0.06957 degrees a second. Binary numbers are floats, the low byte first.
 */
final class RazorFrames {
    static final int AXES = 3;
    private static final double STANDARD_GRAVITY = 9.81;
    private static final double GRAVITY = 256;
    private static final double RAW_GRAVITY = 250;
    private static final double FIELD = 100;
    private static final double RAW_FIELD = 600;
    private static final double GYRO_DEGREES = 0.06957;
    /** Range of the accelerometer, 2 g, and of the gyroscope. */
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

    /** Angles, accelerations and rates of turn, these in rad/s, as text. */
    static byte[] motion(ImuReading reading) {
        double[] values = new double[3 * AXES];
        System.arraycopy(angles(reading), 0, values, 0, AXES);
        for (int i = 0; i < AXES; i++) {
            values[AXES + i] = acceleration(reading, i);
            values[2 * AXES + i] = reading.getRate(i);
        }
        return line("#YPRAG=", values);
    }

    /** All three sensors as they are read, or with their calibration applied. */
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
            byte[] part = binary ? floats(values[i]) : line("#" + "AMG".charAt(i) + "-" + (raw ? "R=" : "C="), values[i]);
            bytes.write(part, 0, part.length);
        }
        return bytes.toByteArray();
    }

    /** One sensor's values as it reads them: 0 acceleration, 1 magnetic field, 2 rates of turn. */
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
