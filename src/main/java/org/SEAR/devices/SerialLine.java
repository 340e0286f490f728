package org.SEAR.devices;

/**
 * The cable between a device and the user's port. Bytes take 10 bits of simulated time each, in both directions.
 * {@link #write}, {@link #setHostBaud}, {@link #open}, {@link #hangUp} and the counters may be called from any thread; the rest is the
 * simulation thread's.
 */
public interface SerialLine {
    /** Receives the bytes that have left the device. Simulation thread. */
    interface Sink {
        /** @param bytes in order; the array is the receiver's */
        void receive(byte[] bytes);
    }

    /** Name of the sensor or dynamics object whose device sits here. */
    String getObjectName();

    /** Kind of that object: its class of the object grammar, for example {@code LIDAR}, {@code GPS}, {@code Dynamics}. */
    String getObjectType();

    /** Port name of the device's end. */
    String getUartPort();

    /** Port name of the user's end. */
    String getUserPort();

    /** Whether the device has power; without, it hears and says nothing. */
    boolean isPowered();

    /** The speed that the device's UART is set to now. */
    int getDeviceBaud();

    /** Whether the device understands the user's end at any speed, see {@link SerialDevice#hearsEveryBaud}. */
    boolean hearsEveryBaud();

    /** A program has opened the user's end; the device notices where a real one does, see {@link SerialDevice#opened}. Any thread. */
    void open();

    /** The last program has left the user's end; the device notices where a real one does, see {@link SerialDevice#portClosed}. Any thread. */
    void hangUp();

    /** Speed of the user's end; the device takes and gives garbage while it is another than its own. 0 (default): the device's own, always. */
    void setHostBaud(int baud);

    /**
     * Hands bytes from the user's end to the line. They are on their way from the next step on, or from now on if the simulation goes by the clock;
     * while time stands still, a device that {@link SerialDevice#answersAtOnce} gets them now. Any thread.
     */
    void write(byte[] bytes);

    /** Where bytes from the device go; called in the outputs phase of a step, and between steps. */
    void setSink(Sink sink);

    /** Bytes from the user's end that have not reached the device yet. */
    int getWaiting();

    /** Bytes ever written by {@link #write}. */
    long getWritten();

    /** Bytes ever given to the sink. */
    long getDelivered();
}
