// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.util.Objects;

/** State of one pin of a device, as text for users. Immutable, any thread. */
public final class PinState {
    /** Label of the pin: {@code A0}. */
    public final String pin;
    /** Component on the pin and purpose: {@code leftEye (volts)}. */
    public final String wired;
    /** Pin mode: {@code input}. */
    public final String mode;
    /** Value of the pin: {@code 1.62 V}, {@code high}, {@code 50 %}, {@code 1472 us}. */
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
