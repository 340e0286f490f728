// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

/**
 * The cable between a device and the host port. Each byte takes 10 bits of simulated time, in both directions.
 * {@link #write}, {@link #setHostBaud}, {@link #open}, {@link #hangUp} and the counters: any thread; the rest:
 * simulation thread.
 */
public interface SerialLine {
    /** Receives the bytes that have left the device. Simulation thread. */
    interface Sink {
        /**
         * @param bytes in order; the array belongs to the receiver
         * @param starts ascending indices of bytes that begin a message; the bytes before the first one continue a
         * message
         */
        void receive(byte[] bytes, int[] starts);
    }

    /** Name of the sensor or dynamics object with this device. */
    String getObjectName();

    /**
     * Kind of that object: its class of the object grammar, for example {@code LIDAR}, {@code GPS}, {@code Dynamics}.
     */
    String getObjectType();

    /** Name of the device's port. */
    String getUartPort();

    /** Name of the host's port. */
    String getUserPort();

    /** Whether the device has power; without power it neither receives nor sends. */
    boolean isPowered();

    /** Present baud rate of the device's UART. */
    int getDeviceBaud();

    /** Whether the host's baud rate does not matter, see {@link SerialDevice#hearsEveryBaud}. */
    boolean hearsEveryBaud();

    /** A program has opened the host port; devices that can notice get {@link SerialDevice#opened}. Any thread. */
    void open();

    /**
     * The last program has closed the host port; devices that can notice get {@link SerialDevice#portClosed}. Any
     * thread.
     */
    void hangUp();

    /**
     * Sets the baud rate of the host port. Both directions carry garbage while it differs from the device's. 0
     * (default): always the device's.
     */
    void setHostBaud(int baud);

    /**
     * Writes bytes from the host to the line. They start at the next step, or immediately if the clock paces the
     * simulation. While time stands still, a device with {@link SerialDevice#answersAtOnce} gets them immediately. Any
     * thread.
     */
    void write(byte[] bytes);

    /** Sets the receiver of the device's bytes; called in the outputs phase of a step, and between steps. */
    void setSink(Sink sink);

    /** Number of host bytes that have not reached the device yet. */
    int getWaiting();

    /** Total number of bytes accepted by {@link #write}. */
    long getWritten();

    /** Total number of bytes given to the sink. */
    long getDelivered();
}
