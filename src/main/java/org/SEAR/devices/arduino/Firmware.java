// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

/**
 * A program on the board. It can access only pins and its serial line. Simulation thread; times are simulated seconds.
 */
interface Firmware {
    /**
     * Starts the program after power-on or a reset; all pins are inputs.
     *
     * @param silent whether it started long ago, so that its first messages have been sent already
     */
    void setUp(double time, boolean silent);

    /** @param value 0 to 255 */
    void receive(int value, double time);

    /** Runs its loop up to a time. */
    void advance(double time);

    /** See {@link org.SEAR.devices.SerialDevice#answersAtOnce}. */
    default boolean answersAtOnce() {
        return false;
    }

    /**
     * Sends the messages immediately that follow a start by themselves later. For programs that {@link #answersAtOnce}.
     */
    default void introduce() {
    }

    /** Status as text for users. */
    String status();

    /** Access of a program to its board. */
    interface Host {
        Pins pins();

        /** Puts bytes on the serial line. */
        void send(byte[] bytes, double time);

        /** Notes a command that the program knows and that can't be meant for another device. */
        void understood();

        /** Baud rate of the line. */
        int getBaud();

        /** Time when the last queued byte has left the line. */
        double lineFreeAt();

        /**
         * Keeps the program busy until a time. Bytes that arrive meanwhile wait in the board's buffer of 64; further
         * bytes are lost.
         */
        void busy(double until);

        /** Shows a warning to the user, see {@link org.SEAR.devices.DeviceContext#warn(String, String)}. */
        void warn(String cause, String message);
    }
}
