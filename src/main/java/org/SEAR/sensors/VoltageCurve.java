// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.List;
import org.SEAR.POJOs.VoltagePoint;

/**
 * Output voltage of a triangulating infrared sensor by distance. Between two points of the data sheet the voltage is
 * linear in 1 / distance, as for triangulation. It is constant nearer than the first and further than the last point.
 * Immutable.
 */
final class VoltageCurve {
    private final double[] nearness;
    private final double[] volts;

    /** @param points nearest first; empty for a sensor without such an output */
    VoltageCurve(List<VoltagePoint> points) {
        nearness = points.stream().mapToDouble(point -> 1 / point.getDistance()).toArray();
        volts = points.stream().mapToDouble(VoltagePoint::getVolts).toArray();
    }

    /**
     * Returns volts; NaN without a curve.
     *
     * @param distance metres, +infinity without an object
     */
    double at(double distance) {
        if (volts.length == 0) {
            return Double.NaN;
        }
        double near = 1 / distance;
        int next = 0;
        while (next < volts.length && near < nearness[next]) {
            next++;
        }
        if (next == 0 || next == volts.length) {
            return volts[Math.min(next, volts.length - 1)];
        }
        if (nearness[next - 1] == Double.POSITIVE_INFINITY) {
            return volts[next];
        }
        double share = (nearness[next - 1] - near) / (nearness[next - 1] - nearness[next]);
        return volts[next - 1] + share * (volts[next] - volts[next - 1]);
    }
}
