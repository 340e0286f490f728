package org.myrobotlab.service.lidar;

import org.myrobotlab.service.lidar.requests.DriverEvents;

/** Takes what happens at a LIDAR; called on the port's reader thread. */
public interface LidarListener extends DriverEvents {
    void scan(RangeScan scan);

    void streaming(boolean on);

    /**
     * The fan as the device told it.
     *
     * @param spread degrees from first to last beam
     * @param resolution degrees between beams
     */
    void scanMode(double spread, double resolution);

    void unit(boolean millimetres);
}
