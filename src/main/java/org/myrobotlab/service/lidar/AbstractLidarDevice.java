// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import org.SEAR.protocol.lidar.LidarModel;
import org.myrobotlab.service.lidar.requests.DeviceLine;
import org.myrobotlab.service.link.SerialLink;

/**
 * The parts common to all scanners: port, driver, last scan and streaming state. Any thread; never blocks.
 *
 * @param <D> type of the driver
 */
abstract class AbstractLidarDevice<D extends LidarDriver<?>> implements LidarDevice {
    final LidarListener listener;
    private SerialLink link;
    private D driver;
    private volatile boolean streaming;
    private volatile RangeScan lastScan;

    AbstractLidarDevice(LidarListener listener) {
        this.listener = listener;
    }

    /** Creates the driver of the scanner at a port. */
    abstract D driverAt(DeviceLine line);

    final D driver() {
        return driver;
    }

    final SerialLink link() {
        return link;
    }

    @Override
    public final void attach(SerialLink newLink) {
        link = newLink;
        driver = driverAt(DeviceLine.of(newLink));
    }

    @Override
    public final void receive(byte[] bytes) {
        driver.receive(bytes);
    }

    @Override
    public final void tick() {
        driver.tick();
    }

    @Override
    public void clear() {
        driver.clear();
        streaming = false;
    }

    @Override
    public final RangeScan getLastScan() {
        return lastScan;
    }

    final void keep(RangeScan scan) {
        lastScan = scan;
    }

    /** Returns whether the scanner streams, according to its last report. */
    final boolean isStreaming() {
        return streaming;
    }

    /** Called when the scanner has started or stopped streaming. */
    final void streams(boolean on) {
        streaming = on;
        listener.streaming(on);
    }

    /** Sets the unit of a scanner that only measures in millimetres. */
    final void setOnlyUnit(boolean millimetres, LidarModel model) {
        if (!millimetres) {
            throw new IllegalArgumentException(model.withArticle() + " measures in millimetres, legal: setToMM()");
        }
        listener.unit(true);
    }
}
