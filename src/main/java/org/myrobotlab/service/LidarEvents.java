// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import org.myrobotlab.service.lidar.LidarListener;
import org.myrobotlab.service.lidar.RangeScan;

/** Passes a device's events to its service, and thus to MyRobotLab. */
final class LidarEvents implements LidarListener {
    private final LIDAR service;

    LidarEvents(LIDAR service) {
        this.service = service;
    }

    @Override
    public void scan(RangeScan scan) {
        service.onScan(scan);
    }

    @Override
    public void streaming(boolean on) {
        service.onStreaming(on);
    }

    @Override
    public void baud(int baud) {
        service.onBaud(baud);
    }

    @Override
    public void scanMode(double spread, double resolution) {
        service.onScanMode(spread, resolution);
    }

    @Override
    public void unit(boolean millimetres) {
        service.onUnit(millimetres);
    }

    @Override
    public void error(String message) {
        service.error("%s", message);
    }

    @Override
    public void info(String message) {
        service.info("%s", message);
    }
}
