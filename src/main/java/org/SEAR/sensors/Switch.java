package org.SEAR.sensors;

/** A reading that is true or false, as of a contact; the unit of its sensor's type is what true says: {@code pressed}. Immutable, any thread. */
public final class Switch implements Reading {
    private final boolean on;

    /** @param on whether it is closed */
    public Switch(boolean on) {
        this.on = on;
    }

    /** Whether it is closed. */
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

    /** Closed it joins the pin to ground. */
    @Override
    public double volts() {
        return on ? 0 : Double.NaN;
    }

    @Override
    public String toString() {
        return String.valueOf(on);
    }
}
