package org.myrobotlab.service.lidar;

import org.myrobotlab.service.link.SerialLink;

/** What the LIDAR service needs of a scanner, whichever protocol it speaks. Any thread; never blocks: what is asked is sent in its turn. */
public interface LidarDevice {
    /** Gives the device its port. Before anything else. */
    void attach(SerialLink link);

    /** Bytes from the port. */
    void receive(byte[] bytes);

    /** Lets time-outs pass. */
    void tick();

    /** The port was closed. */
    void clear();

    /** The last scan; null before the first. */
    RangeScan getLastScan();

    /** Asks the device what it is set to: unit, fan, and whether it streams already. */
    void learn();

    /**
     * Tells the device to talk at another rate and follows it.
     *
     * @param baud a legal one of the model, see {@link LidarModels#checkedBaud}
     */
    void setBaud(int baud);

    /**
     * Sets the fan, to the nearest that the device has where it has steps of its own.
     *
     * @param spread degrees from first to last value
     * @param resolution degrees between two values
     * @throws IllegalArgumentException that names the legal ones
     */
    void setVariant(int spread, double resolution);

    /**
     * Sets the unit of the raw values.
     *
     * @throws IllegalArgumentException if the device can't
     */
    void setUnit(boolean millimetres);

    /** Asks for one scan. While streaming the next one comes anyway. */
    void singleScan();

    /** Starts or stops scan after scan. */
    void setStreaming(boolean on);
}
