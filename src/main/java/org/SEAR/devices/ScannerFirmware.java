package org.SEAR.devices;

import org.SEAR.sensors.LidarSource;

/** What is the same for all scanners: what they measure with, what they do later, and what garbage and a power cut do to them. */
public abstract class ScannerFirmware implements SerialDevice {
    protected final DeviceContext context;
    /** Measures the scans. */
    protected final LidarSource source;
    /** What it has to do later. */
    protected final EventQueue events = new EventQueue();

    /**
     * A scanner at the end of a cable.
     *
     * @param model with its article
     * @throws IllegalArgumentException unless the context's sensor is a {@link LidarSource}
     */
    protected ScannerFirmware(String model, DeviceContext context) {
        if (!(context.sensor() instanceof LidarSource)) {
            throw new IllegalArgumentException(model + " needs a LIDAR to scan with, not " + context.sensor());
        }
        this.context = context;
        this.source = (LidarSource) context.sensor();
    }

    /** Forgets the request that has come in part. */
    protected abstract void forgetRequest();

    @Override
    public final void receiveGarbage(double time) {
        advance(time);
        forgetRequest();
    }

    @Override
    public void advance(double time) {
        events.runUntil(time);
    }

    @Override
    public final void powerOff() {
        events.clear();
    }
}
