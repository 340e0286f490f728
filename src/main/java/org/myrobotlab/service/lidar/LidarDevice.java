// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import org.myrobotlab.service.link.SerialLink;

/** A scanner behind any protocol. Any thread; never blocks: requests are queued. */
public interface LidarDevice {
    /** Sets the device's port. Must be called first. */
    void attach(SerialLink link);

    /** Takes bytes from the port. */
    void receive(byte[] bytes);

    /** Checks time-outs. */
    void tick();

    /** Forgets requests and state after the port was closed. */
    void clear();

    /** Returns the last scan; null before the first. */
    RangeScan getLastScan();

    /** Queries the device's settings: unit, field of view, and whether it already streams. */
    void learn();

    /**
     * Changes the baud rate of the device, then of the port.
     *
     * @param baud a legal rate of the model, see {@link LidarModels#checkedBaud}
     */
    void setBaud(int baud);

    /**
     * Sets the field of view. A device with fixed steps uses the nearest one it has.
     *
     * @param spread degrees from first to last value
     * @param resolution degrees between two values
     * @throws IllegalArgumentException with the legal values
     */
    void setVariant(int spread, double resolution);

    /**
     * Sets the unit of the raw values.
     *
     * @throws IllegalArgumentException if the device lacks the unit
     */
    void setUnit(boolean millimetres);

    /** Requests one scan. Does nothing while streaming. */
    void singleScan();

    /** Starts or stops continuous scans. */
    void setStreaming(boolean on);
}
