package org.SEAR.sensors;

/** Three numbers along the sensor's axes (without rotation the body's: +x left, +y up, +z forward); NaN when the reading dropped out. Immutable. */
public final class VectorReading implements Reading {
    private static final int DIGITS = 3;

    private final double x;
    private final double y;
    private final double z;

    /** In the unit of its sensor. */
    public VectorReading(double x, double y, double z) {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    /** Along, or counter-clockwise about, the axis to the left. */
    public double getX() {
        return x;
    }

    /** Along, or counter-clockwise about, the axis upwards. */
    public double getY() {
        return y;
    }

    /** Along, or counter-clockwise about, the axis forward. */
    public double getZ() {
        return z;
    }

    @Override
    public double[] numbers() {
        return new double[] {x, y, z};
    }

    @Override
    public Object value() {
        return toString();
    }

    @Override
    public String words(double[] kept, String unit) {
        return ReadingWords.withUnit(ReadingWords.fixed(kept, DIGITS), unit);
    }

    /** As scripts get it: {@code "0.0,9.81,0.0"}. */
    @Override
    public String toString() {
        return x + "," + y + "," + z;
    }
}
