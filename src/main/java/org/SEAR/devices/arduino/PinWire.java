// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.arduino;

/** The electrical connection of one pin. Simulation thread. */
interface PinWire {
    /** Voltage that it puts on the pin, V; NaN if it does not drive the pin. */
    default double volts() {
        return Double.NaN;
    }

    /**
     * Sets the board's output to the pin.
     *
     * @param level mean share of the supply voltage; NaN if the board does not drive the pin, see {@link #pull}
     */
    default void drive(double level) {
    }

    /**
     * Makes the pin an input. A pull-up resistor is too weak for a light but enough for a driver's inputs.
     *
     * @param up whether its pull-up is on
     */
    default void pull(boolean up) {
        drive(Double.NaN);
    }

    /** @param micros length of the board's servo pulses to the pin; 0 for none */
    default void pulse(int micros) {
    }

    /**
     * Delay between a pulse at this pin and its echo at another pin, or at the same.
     *
     * @return seconds, +infinity without an echo; NaN if the pins don't belong to one sensor
     */
    default double echo(PinWire listened) {
        return Double.NaN;
    }

    /** Whether a pulse at this pin makes a range sensor answer at another pin, or at the same. */
    default boolean triggers(PinWire listened) {
        return false;
    }

    /** The encoder with this wire as a track; null for other wires. */
    default Encoder track() {
        return null;
    }

    /** Level of this track at a count of its encoder. */
    default boolean isHigh(long counts) {
        return false;
    }

    /** The encoder with this first track and the given second track; null if they don't belong to one encoder. */
    default Encoder encoder(PinWire second) {
        return null;
    }

    /** Component and purpose of the wire, as text for users. */
    String describe();

    /** Counts of an encoder since the start. */
    @FunctionalInterface
    interface Encoder {
        /** Counts up forward and down in reverse. */
        long counts();
    }
}
