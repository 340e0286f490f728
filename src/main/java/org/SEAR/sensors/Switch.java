// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

/**
 * A reading that is true or false, for example of a contact. The unit of its sensor type is the word for true:
 * {@code pressed}. Immutable; any thread.
 */
public final class Switch implements Reading {
    private final boolean on;

    /** @param on whether it is closed */
    public Switch(boolean on) {
        this.on = on;
    }

    public boolean isOn() {
        return on;
    }

    @Override
    public double[] numbers() {
        return new double[] {on ? 1 : 0};
    }

    @Override
    public Object value() {
        return on;
    }

    @Override
    public String words(double[] kept, String unit) {
        return kept[0] == 1 ? unit : "not " + unit;
    }

    /** A closed switch connects the pin to ground. */
    @Override
    public double volts() {
        return on ? 0 : Double.NaN;
    }

    @Override
    public String toString() {
        return String.valueOf(on);
    }
}
