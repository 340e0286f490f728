package org.SEAR.devices;

/**
 * The firmware of a simulated device at the end of a serial line: bytes in, bytes out (through {@link DeviceContext#send}), no threads, no MRL.
 * Simulation thread only; time is simulated seconds and never runs backwards but for {@link #reset}.
 */
public interface SerialDevice {
    /** The speed the device's UART is set to, bits a second. */
    int getBaud();

    /**
     * A byte has arrived whole.
     *
     * @param value 0 to 255
     * @param time when its stop bit ended
     */
    void receive(int value, double time);

    /** A byte came at another speed than the device's: a framing error. */
    void receiveGarbage(double time);

    /** Lets the device's own timers run up to a time. */
    void advance(double time);

    /** Power off and on. */
    void reset();

    /** Whether it takes commands that move its robot now, so that who sends them drives. */
    default boolean takesDriveCommands() {
        return false;
    }

    /** State in words for people, for example {@code "OI mode: safe"}. */
    String status();
}
