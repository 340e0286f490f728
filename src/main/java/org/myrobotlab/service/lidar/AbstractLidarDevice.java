package org.myrobotlab.service.lidar;

import org.SEAR.protocol.lidar.LidarModel;
import org.myrobotlab.service.lidar.requests.DeviceLine;
import org.myrobotlab.service.link.SerialLink;

/**
 * What is the same for all scanners: their port and its driver, the last scan, and whether they stream. Any thread; never blocks.
 *
 * @param <D> talks to the scanner
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

    /** The one that talks to the scanner at a port. */
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

    /** Whether it streams, as far as it has told. */
    final boolean isStreaming() {
        return streaming;
    }

    /** It has begun, or ended, to stream. */
    final void streams(boolean on) {
        streaming = on;
        listener.streaming(on);
    }

    /** Sets the unit of a scanner that has but one. */
    final void setOnlyUnit(boolean millimetres, LidarModel model) {
        if (!millimetres) {
            throw new IllegalArgumentException(model.withArticle() + " measures in millimetres, legal: setToMM()");
        }
        listener.unit(true);
    }
}
