package org.SEAR.devices;

import java.util.List;

/**
 * The firmware of a simulated device at the end of a serial line: bytes in, bytes out (through {@link DeviceContext#send}), no threads, no MRL.
 * Simulation thread only; time is simulated seconds and never runs backwards but for {@link #reset}.
 */
public interface SerialDevice {
    /** The speed the device's UART is set to, bits a second. */
    int getBaud();

    /** Whether its line is USB or a network, so that who is at the other end is understood whatever baud rate it sets. */
    default boolean hearsEveryBaud() {
        return false;
    }

    /**
     * Whether it hears and answers in no time while time stands still, in lock-step or a pause: who talks to it waits for the answer by the
     * computer's clock, and may be the one who makes time pass. Any thread; never changes.
     */
    default boolean answersAtOnce() {
        return false;
    }

    /**
     * A byte has arrived whole.
     *
     * @param value 0 to 255
     * @param time when its stop bit ended
     */
    void receive(int value, double time);

    /** What it is, with its article: {@code "an LMS200"}. */
    default String title() {
        return "this device";
    }

    /** Whether it boots, so that bytes are lost. */
    default boolean isStarting() {
        return false;
    }

    /** A byte came at another speed than the device's: a framing error. */
    void receiveGarbage(double time);

    /**
     * The last program has left the other end of its network connection. Who has a serial cable doesn't notice.
     *
     * @param time simulated seconds
     */
    default void portClosed(double time) {
    }

    /**
     * A program has opened the other end of its line, which nobody had open. Who has no DTR line, by which it shows on a real cable, doesn't notice.
     *
     * @param time simulated seconds
     */
    default void opened(double time) {
    }

    /**
     * The same while time stands still, for who {@link #answersAtOnce}: it boots in no time and says who it is.
     *
     * @param time simulated seconds
     */
    default void openedAtOnce(double time) {
        opened(time);
    }

    /** Lets the device's own timers run up to a time. */
    void advance(double time);

    /** Everything as at the start of a simulation: delivered from the factory, with its power on since long. */
    void reset();

    /** Its power is switched off: what it moves stands still. Until {@link #powerOn} it is asked for nothing. */
    void powerOff();

    /**
     * Its power is switched on again: what it forgets without power is as at its start, and it boots as long, and with the words, as the real one.
     *
     * @param time simulated seconds, from which its timers go on
     */
    void powerOn(double time);

    /** Whether it takes commands that move its robot now, so that who sends them drives. */
    default boolean takesDriveCommands() {
        return false;
    }

    /** Its pins that something is wired to, as they are now; empty for what has none. */
    default List<PinState> pinStates() {
        return List.of();
    }

    /** State in words for people, for example {@code "OI mode: safe"}. */
    String status();
}
