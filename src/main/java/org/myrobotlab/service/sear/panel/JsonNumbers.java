// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.geometry.Pose;
import org.myrobotlab.service.sear.readings.EulerAngles;

/** Numbers, points and poses, rounded for panels. */
final class JsonNumbers {
    private static final double FINE = 1e4;
    /** Resolution of numbers: seven digits of a degree are a centimetre on Earth. */
    private static final double FINEST = 1e8;
    private static final double ANGLE = 1e3;

    private JsonNumbers() {
    }

    /** Returns points, rounded. */
    static double[][] points(double[][] exact) {
        return Arrays.stream(exact).map(JsonNumbers::point).toArray(double[][]::new);
    }

    /** Returns a point, rounded. */
    static double[] point(double[] exact) {
        return point(exact, FINE);
    }

    static double[] point(double[] exact, double per) {
        return new double[] {rounded(exact[0], per), rounded(exact[1], per), rounded(exact[2], per)};
    }

    /** Returns a reading's numbers; null for NaN and infinity. */
    static List<Double> numbers(double[] exact) {
        List<Double> numbers = new ArrayList<>(exact.length);
        for (double number : exact) {
            numbers.add(Double.isNaN(number) || Double.isInfinite(number) ? null
                : Double.valueOf(rounded(number, FINEST)));
        }
        return numbers;
    }

    /** Returns a pose as {x, y, z, rx, ry, rz}, metres and degrees. */
    static double[] numbers(Pose pose) {
        double[] angles = EulerAngles.degrees(pose);
        return new double[] {rounded(pose.x, FINE), rounded(pose.y, FINE), rounded(pose.z, FINE),
            rounded(angles[0], ANGLE), rounded(angles[1], ANGLE), rounded(angles[2], ANGLE)};
    }

    /** Returns the nearest multiple of 1 / {@code per}; 0 for NaN and infinity. */
    static double rounded(double value, double per) {
        return Double.isNaN(value) || Double.isInfinite(value) ? 0 : Math.round(value * per) / per;
    }
}
