// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import org.SEAR.sensors.LidarSource;

/** Common part of all scanners' firmware: source of scans, timed actions, garbage and power-off. */
public abstract class ScannerFirmware implements SerialDevice {
    protected final DeviceContext context;
    /** Measures the scans. */
    protected final LidarSource source;
    /** Timed actions. */
    protected final EventQueue events = new EventQueue();

    /**
     * Creates the firmware of a scanner at the end of a cable.
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

    /** Discards a partly received request. */
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
    public final double nextAction() {
        return events.next();
    }

    @Override
    public final void powerOff() {
        events.clear();
    }
}
