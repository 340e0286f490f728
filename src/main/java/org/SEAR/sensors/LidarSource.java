// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

/**
 * A LIDAR whose device chooses spread and resolution by telegram; implemented by the LIDAR's sensor. Simulation thread
 * only.
 */
public interface LidarSource {
    /**
     * Returns a scan at the current step with a spread and resolution other than the object's. It has the same noise
     * and rules as the sensor's own reading. A pure function of truth, step and parameters.
     *
     * @param spreadDegrees from the rightmost to the leftmost beam, centred on the forward axis, (0, 360]
     * @param resolutionDegrees between two beams; spread / resolution + 1 beams
     * @return ranges up to the range of the sensor's object
     */
    LidarScan scan(Truth truth, double spreadDegrees, double resolutionDegrees);

    /**
     * Returns the range of a beam of a scan at the time at which the scanner measures that beam. It differs from the
     * scan's range only if the sensor or an obstacle has moved between that time and the scan. Their poses at the time
     * are interpolated between steps; at most one step after the current one they continue at the same speed.
     *
     * @param scan of the last two seconds
     * @param beam 0 (rightmost) to scan.size() - 1
     * @param time simulated seconds, within the last two seconds
     * @return metres along the beam, +infinity without a hit
     */
    default double range(Truth truth, LidarScan scan, int beam, double time) {
        return scan.range(beam);
    }

    /**
     * Announces the next {@link #scan}, so that it can be measured in parallel with others. The announcement does not
     * affect readings.
     *
     * @param time earliest time of the scan, simulated seconds; replaces an earlier announcement
     */
    default void expect(double time, double spreadDegrees, double resolutionDegrees) {
    }
}
