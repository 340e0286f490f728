package org.SEAR.record;

import java.util.Arrays;
import java.util.List;
import org.SEAR.sensors.ColorReading;
import org.SEAR.sensors.DistanceReading;
import org.SEAR.sensors.GpsFix;
import org.SEAR.sensors.ImuReading;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.OdometerReading;
import org.SEAR.sensors.VectorReading;

/** Readings as numbers over time. A scan is its nearest distance, infinity where nothing is in range; True is 1. Any thread. */
final class Numbers {
    private static final List<String> AXES = Arrays.asList("x", "y", "z");
    private static final double[] NONE = {};

    private Numbers() {
    }

    /** What the numbers of a reading with so many of them are called. */
    static String name(int index, int size) {
        return size == 1 ? "" : size == 3 ? "." + AXES.get(index) : "." + (index + 1);
    }

    /** The numbers; none for what is no number. */
    static double[] of(Object reading) {
        if (reading instanceof Number) {
            return new double[] {((Number) reading).doubleValue()};
        }
        if (reading instanceof Boolean) {
            return new double[] {(Boolean) reading ? 1 : 0};
        }
        if (reading instanceof DistanceReading) {
            return new double[] {((DistanceReading) reading).getDistanceOrRange()};
        }
        if (reading instanceof LidarScan) {
            return new double[] {Arrays.stream(((LidarScan) reading).ranges()).min().orElse(Double.POSITIVE_INFINITY)};
        }
        if (reading instanceof OdometerReading) {
            return new double[] {((OdometerReading) reading).getMetres()};
        }
        if (reading instanceof GpsFix) {
            GpsFix fix = (GpsFix) reading;
            return new double[] {fix.getLatitude(), fix.getLongitude(), fix.getAltitude()};
        }
        if (reading instanceof VectorReading) {
            VectorReading vector = (VectorReading) reading;
            return new double[] {vector.getX(), vector.getY(), vector.getZ()};
        }
        if (reading instanceof ColorReading) {
            ColorReading color = (ColorReading) reading;
            return new double[] {color.getRed(), color.getGreen(), color.getBlue()};
        }
        if (reading instanceof ImuReading) {
            ImuReading imu = (ImuReading) reading;
            return new double[] {imu.getYaw(), imu.getPitch(), imu.getRoll()};
        }
        return NONE;
    }
}
