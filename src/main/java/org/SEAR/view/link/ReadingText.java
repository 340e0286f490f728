package org.SEAR.view.link;

import java.util.Arrays;
import java.util.Locale;
import org.SEAR.sensors.ColorReading;
import org.SEAR.sensors.DistanceReading;
import org.SEAR.sensors.GpsFix;
import org.SEAR.sensors.ImuReading;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.OdometerReading;
import org.SEAR.sensors.VectorReading;

/** Readings as the window shows them. */
final class ReadingText {
    private static final double TENTHS = 10;
    private static final double HUNDREDTHS = 100;

    private ReadingText() {
    }

    /** Length of each beam, metres, infinite where nothing was hit; null for a reading of a sensor without beams. */
    static double[] beams(Object reading) {
        if (reading instanceof LidarScan) {
            return ((LidarScan) reading).ranges();
        }
        if (reading instanceof DistanceReading) {
            DistanceReading distance = (DistanceReading) reading;
            double[] lengths = new double[distance.getPattern().size()];
            Arrays.fill(lengths, Double.POSITIVE_INFINITY);
            if (distance.getLine() >= 0) {
                double[] hit = distance.getHitPoint();
                lengths[distance.getLine()] = Math.sqrt(square(hit[0] - distance.getPose().x) + square(hit[1] - distance.getPose().y)
                    + square(hit[2] - distance.getPose().z));
            }
            return lengths;
        }
        return null;
    }

    private static double square(double value) {
        return value * value;
    }

    /**
     * In words, with unit.
     *
     * @param unit of the sensor's type, for readings that are plain numbers, or what True says
     */
    static String words(Object reading, String unit) {
        if (reading instanceof LidarScan) {
            return words((LidarScan) reading);
        }
        if (reading instanceof DistanceReading) {
            DistanceReading distance = (DistanceReading) reading;
            return distance.isReturn() ? format("%.3f m", distance.getDistance()) : "nothing in range";
        }
        if (reading instanceof GpsFix) {
            GpsFix fix = (GpsFix) reading;
            return format("%.6f, %.6f deg, %.1f m", fix.getLatitude(), fix.getLongitude(), fix.getAltitude());
        }
        if (reading instanceof OdometerReading) {
            return format("%.3f m", ((OdometerReading) reading).getMetres());
        }
        if (reading instanceof ImuReading) {
            ImuReading imu = (ImuReading) reading;
            return format("yaw %.1f, pitch %.1f, roll %.1f deg", imu.getYaw(), imu.getPitch(), imu.getRoll());
        }
        if (reading instanceof ColorReading) {
            ColorReading color = (ColorReading) reading;
            return format("red %.0f, green %.0f, blue %.0f", color.getRed(), color.getGreen(), color.getBlue());
        }
        if (reading instanceof VectorReading) {
            VectorReading vector = (VectorReading) reading;
            return (format("%.2f, %.2f, %.2f ", hundredths(vector.getX()), hundredths(vector.getY()), hundredths(vector.getZ())) + unit).trim();
        }
        if (reading instanceof Boolean) {
            return ((Boolean) reading ? "" : "not ") + unit;
        }
        if (reading instanceof Double) {
            return (format("%.1f ", Math.rint((Double) reading * TENTHS) / TENTHS + 0.0) + unit).trim();
        }
        return String.valueOf(reading);
    }

    /** Rounded, and never a negative zero. */
    private static double hundredths(double value) {
        return Math.rint(value * HUNDREDTHS) / HUNDREDTHS + 0.0;
    }

    private static String words(LidarScan scan) {
        double nearest = Double.POSITIVE_INFINITY;
        int hits = 0;
        for (int i = 0; i < scan.size(); i++) {
            nearest = Math.min(nearest, scan.range(i));
            hits += scan.range(i) < Double.POSITIVE_INFINITY ? 1 : 0;
        }
        return hits == 0 ? "nothing in range" : format("nearest %.2f m, %.0f of %.0f beams hit", nearest, (double) hits, (double) scan.size());
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
