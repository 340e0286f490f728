package org.SEAR.devices.arduino;

/** What hangs on a pin, as electricity sees it. Simulation thread. */
interface PinWire {
    /** Volts that it puts on the pin; NaN if it leaves the pin alone. */
    default double volts() {
        return Double.NaN;
    }

    /**
     * What the board puts on the pin from now on.
     *
     * @param level share of the supply, as a mean over its pulses; NaN if the board leaves the pin alone, as an input does, see {@link #pull}
     */
    default void drive(double level) {
    }

    /**
     * The pin is an input from now on. A pull-up resistor is too weak for a light and enough for a driver's inputs.
     *
     * @param up whether its pull-up is on
     */
    default void pull(boolean up) {
        drive(Double.NaN);
    }

    /** @param micros length of the servo pulses that the board puts on the pin from now on; 0 for none */
    default void pulse(int micros) {
    }

    /**
     * How long the echo takes that this pin's pulse brings to another pin, or to itself.
     *
     * @return seconds, +infinity if none comes; NaN if the two don't belong together
     */
    default double echo(PinWire listened) {
        return Double.NaN;
    }

    /** The encoder whose first track this is and whose second one the other; null if they don't belong together. */
    default Encoder encoder(PinWire second) {
        return null;
    }

    /** In words for people: the component and what the wire is for. */
    String describe();

    /** Counts of an encoder since the start. */
    @FunctionalInterface
    interface Encoder {
        /** Up forward, down in reverse. */
        long counts();
    }
}
