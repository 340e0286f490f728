// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.util.List;

/**
 * Firmware of a simulated device on a serial line: bytes in, bytes out (through {@link DeviceContext#send}), without
 * threads or MyRobotLab. Simulation thread only. Time is simulated seconds and decreases only at a {@link #reset}.
 */
public interface SerialDevice {
    /** Baud rate of the device's UART, bits per second. */
    int getBaud();

    /** Whether its line is USB or a network, on which the host's baud rate does not matter. */
    default boolean hearsEveryBaud() {
        return false;
    }

    /**
     * Whether its UART receives bytes of a host's baud rate and the host receives its bytes. By default only with equal
     * rates.
     *
     * @param hostBaud bits per second
     */
    default boolean matches(int hostBaud) {
        return hostBaud == getBaud();
    }

    /**
     * Whether it answers immediately while time stands still (lock-step or pause). Its host waits by the computer's
     * clock, and may itself be the program that advances time. Any thread; never changes.
     */
    default boolean answersAtOnce() {
        return false;
    }

    /**
     * Receives a complete byte.
     *
     * @param value 0 to 255
     * @param time end of its stop bit
     */
    void receive(int value, double time);

    /** Name of the device with its article: {@code "an LMS200"}. */
    default String title() {
        return "this device";
    }

    /** Whether it boots, so that incoming bytes are lost. */
    default boolean isStarting() {
        return false;
    }

    /** Receives a byte at another baud rate than the device's: a framing error. */
    void receiveGarbage(double time);

    /**
     * The last program has closed its network connection. Devices on a serial cable don't notice.
     *
     * @param time simulated seconds
     */
    default void portClosed(double time) {
    }

    /**
     * A program has opened its closed line. Devices without a DTR line, which signals this on a real cable, don't
     * notice.
     *
     * @param time simulated seconds
     */
    default void opened(double time) {
    }

    /**
     * A program has opened its line while time stands still. Devices with {@link #answersAtOnce} boot immediately and
     * identify themselves.
     *
     * @param time simulated seconds
     */
    default void openedAtOnce(double time) {
        opened(time);
    }

    /** Runs the device's timers up to a time. */
    void advance(double time);

    /**
     * Time of its next timed action that must not wait for the end of the step in real time, because hosts note when
     * its output arrives; simulated seconds. Infinity, the default, for devices whose timed output may wait.
     */
    default double nextAction() {
        return Double.POSITIVE_INFINITY;
    }

    /** Sets the state of a simulation's start: factory settings, on for a long time. */
    void reset();

    /** Switches its power off; what it moves stops. Nothing is called until {@link #powerOn}. */
    void powerOff();

    /**
     * Switches its power on again. Volatile settings are as at the start. It boots as long, and with the same output,
     * as the real device.
     *
     * @param time simulated seconds, from which its timers continue
     */
    void powerOn(double time);

    /** Whether it accepts drive commands now, so that its host drives the robot. */
    default boolean takesDriveCommands() {
        return false;
    }

    /** Its connected pins with their current state; empty for a device without pins. */
    default List<PinState> pinStates() {
        return List.of();
    }

    /** Status as text for users, for example {@code "OI mode: safe"}. */
    String status();
}
