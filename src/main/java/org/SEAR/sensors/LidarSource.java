package org.SEAR.sensors;

/**
 * A LIDAR whose spread and resolution its device chooses by telegram; the LIDAR's sensor is one. Simulation thread only.
 */
public interface LidarSource {
    /**
     * A scan at the present step with another fan than the object's own. Same noise and same rules as the sensor's own reading; a pure function
     * of the truth, the step and the fan.
     *
     * @param spreadDegrees from the rightmost to the leftmost beam, centred on the forward axis, (0, 360]
     * @param resolutionDegrees between two beams; spread / resolution + 1 beams
     * @return ranges up to the range of the sensor's object
     */
    LidarScan scan(Truth truth, double spreadDegrees, double resolutionDegrees);

    /**
     * Says which {@link #scan} will be asked for next, so that it can be made beside those of others. Nothing depends on whether it comes true.
     *
     * @param time from when on, simulated seconds; what was expected before is forgotten
     */
    default void expect(double time, double spreadDegrees, double resolutionDegrees) {
    }
}
