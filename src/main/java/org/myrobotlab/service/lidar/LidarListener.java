// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import org.myrobotlab.service.lidar.requests.DriverEvents;

/** Receives events of a LIDAR, on the port's reader thread. */
public interface LidarListener extends DriverEvents {
    void scan(RangeScan scan);

    void streaming(boolean on);

    /**
     * Called with the field of view that the device reports.
     *
     * @param spread degrees from first to last value
     * @param resolution degrees between values
     */
    void scanMode(double spread, double resolution);

    void unit(boolean millimetres);
}
