package org.SEAR.devices;

import java.util.Objects;

/** A pin of a device, in words for people. Immutable, any thread. */
public final class PinState {
    /** What is printed beside it: {@code A0}. */
    public final String pin;
    /** The component that hangs on it and what for: {@code leftEye (volts)}. */
    public final String wired;
    /** What it is set to: {@code input}. */
    public final String mode;
    /** What is there: {@code 1.62 V}, {@code high}, {@code 50 %}, {@code 1472 us}. */
    public final String value;

    public PinState(String pin, String wired, String mode, String value) {
        this.pin = pin;
        this.wired = wired;
        this.mode = mode;
        this.value = value;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof PinState && pin.equals(((PinState) other).pin) && wired.equals(((PinState) other).wired)
            && mode.equals(((PinState) other).mode) && value.equals(((PinState) other).value);
    }

    @Override
    public int hashCode() {
        return Objects.hash(pin, wired, mode, value);
    }

    @Override
    public String toString() {
        return pin + " " + wired + ": " + mode + ", " + value;
    }
}
